#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Lessons as files: whole, by themselves, with the right numbers; what none can be made of. How they look and work, in a
# browser: tools/lesson-check.sh.
#   lesson_test.sh PROGRAM
. "$(dirname -- "$0")/support.sh" || exit 3

lesson() { said=$("$program" algebra --lesson page.html "$@" 2>&1 </dev/null); code=$?; page=$(cat page.html 2>/dev/null); }
refused() { # NAME TEXT ARGUMENT…: nothing is written, and TEXT is said
  local name=$1 text=$2
  shift 2
  rm -f page.html
  lesson "$@"
  verdict "$name" "$([ $code != 0 ] && [[ $said == *"$text"* ]] && [ ! -e page.html ] && echo yes)" "exit code $code, said: $said"
}
count() { grep -oF -- "$1" page.html | wc -l; }
# What the page says about a method.
method() { grep -oE "\{\"name\":\"$1\",[^{]*" page.html; }

# Figures of the source's first table; ours worked out by hand.
lesson 'T(5 3) R(1rad @ 1 4)'
is 'a lesson' $code 0
has 'matrix' "$(method matrix)" '"step":"8Np + 6"'
has 'geometric' "$(method geometric)" '"step":"8Np + 2"'
has 'differences' "$(method differences)" 'a way and a turn do not commute'
has 'best' "$(method best)" '"step":"6Np + 2"'
has 'as printed' "$page" '"printed":{"step":"8Np + 18","before":"12"'
has 'printed before and after' "$page" '"printed":{"step":"8Np + 2","before":"2Np + 4","after":"2Np"'
has 'the other way' "$page" '"kind":"root"'

# Needs nothing else, and is whole.
for word in 'http' 'src=' 'href=' 'url(' '@import' '{{' '}}</'; do is "no $word" "$(count "$word")" 0; done
for tag in html head body main section table thead tbody figure figcaption header style h1 h2 p ol div span; do
  is "every <$tag> ends" "$(grep -oE "<$tag[ >]" page.html | wc -l)" "$(count "</$tag>")"
done
is 'its scripts' "$(count '</script')" 2
has 'its end' "$(tail -n 1 page.html)" '</html>'
has 'its title' "$page" '<title>T(5 3) R(1rad @ 1 4)'

# The frames: half of a way, half of a half turn, the root of a growth.
lesson 'T(2 0)'
has 'half of a way' "$page" '[1.0,0.0,0.0,1.0,1.0,0.0]'
has 'nothing else to tell' "$page" '"paths":[]'
lesson 'S(4 9)'
has 'half of a growth' "$page" '[2.0,0.0,0.0,3.0,0.0,0.0]'
has 'the other law' "$page" '"kind":"law"'
has 'the source counts the linear law' "$(method 'geometric, linear law')" '"step":"2Np"'
lesson 'S(2 0.5 @ 1 1) R(180deg)'
has 'no root' "$page" '"kind":"no root"'
has 'the end only' "$page" '"kind":"scheme","base":"linear"'
lesson ''
is 'no factors' $code 0
has 'no factors, said' "$page" 'no scheme for no factors'
# A lesson of before is replaced.
lesson 'R(90deg)' && has 'written anew' "$page" '<title>R(90deg)'
is 'nothing is left beside it' "$(find . -type f | wc -l)" 1

refused 'no motion' '' 'Q(1)'
refused 'a name that is none' '' 'R(1turn @ </script>)'
refused 'in space' 'leaves the plane' 'R(90deg @ 0 0 0 axis x)'
refused 'too far out' 'too far out' 'T(1e12 0)'
refused 'far out in between' 'too far out' 'S(1e6) S(1e6)'
refused 'too many factors' '65 factors are too many' "$(printf 'T(1 1) %.0s' {1..65})"
refused 'no steps' '0 steps lead nowhere' --steps 0 'T(1 1)'
for path in page.pdf page.html.png page html page.html/ .html; do
  said=$("$program" algebra --lesson "$path" 'T(1 1)' 2>&1)
  verdict "$path is no page" "$([ $? != 0 ] && [[ $said == *"a lesson is a .html, not \"$path\""* ]] && echo yes)" "$said"
done
is 'nothing is written' "$(find . -type f | wc -l)" 0
"$program" algebra --lesson page.HTM 'T(1 1)' && has 'another ending' "$(tail -n 1 page.HTM)" '</html>'
rm -f page.HTM
said=$("$program" algebra --lesson nowhere/page.html 'T(1 1)' 2>&1)
verdict 'no such folder' "$([ $? != 0 ] && [[ $said == *nowhere* ]] && echo yes)" "$said"
is 'nothing is left' "$(find . -type f | wc -l)" 0
summary
