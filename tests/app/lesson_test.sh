#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests the files of lessons: they are complete, need no other files, and have the string of the motion. Also tests
# strings of which no lesson can be made. tests/web/lesson_test.py tests lessons in a browser. Here one word takes the
# place of the engine.
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
mkdir web
echo 'const engine = "the engine";' >web/player.js
export BETWIXT_PLAYER=$PWD/web/player.js

lesson 'T(5 3)   R(1rad@1 4)' --steps 24 --points '1,0 2,3'
is 'a lesson' $code 0
has 'the string as it is written' "$page" '"text":"T(5 3) R(1rad @ 1 4)","steps":24,"points":[[1,0,0],[2,3,0]]'
has 'the string in its field' "$page" '>T(5 3) R(1rad @ 1 4)</textarea>'
is 'the engine, once' "$(count 'the engine";')" 1

# The file is complete and needs no others.
for word in 'http:' 'https:' 'src=' ' href=' 'url(' '@import' '{{' '}}</'; do is "no $word" "$(count "$word")" 0; done
for tag in html head body main section table thead tbody figure figcaption header style h1 h2 h3 p ol ul div textarea; do
  is "every <$tag> ends" "$(grep -oE "<$tag[ >]" page.html | wc -l)" "$(count "</$tag>")"
done
is 'its scripts' "$(count '</script')" 3
has 'its end' "$(tail -n 1 page.html)" '</html>'
has 'its title' "$page" '<title>T(5 3) R(1rad @ 1 4)'

lesson 'R(90deg @ 0 0 0 axis x)'
is 'in space' $code 0
lesson ''
is 'no factors' $code 0
has 'no factors, said' "$page" '<title>no factors'
# An older lesson is replaced.
lesson 'R(90deg)' && has 'written anew' "$page" '<title>R(90deg)'
is 'nothing is left beside it' "$(find . -type f | sort)" "./page.html
./web/player.js"

refused 'no motion' '' 'Q(1)'
refused 'a name that is none' '' 'R(1turn @ </script>)'
refused 'with the place of the mistake' '      ^' 'T(1 1 R(1turn)'
refused 'far out in space' 'too far away' 'T(0 0 1e12)'
refused 'too far out' 'too far away' 'T(1e12 0)'
refused 'far out in between' 'too far away' 'S(1e6) S(1e6)'
refused 'too many factors' '65 factors are too many' "$(printf 'T(1 1) %.0s' {1..65})"
refused 'no steps' 'the number of steps must be at least 1, not 0' --steps 0 'T(1 1)'
refused 'too many steps' 'the limit is 2000' --steps 2001 'T(1 1)'
BETWIXT_PLAYER=/nowhere/player.js refused 'no engine' './betwixt web' 'T(1 1)'
for path in page.pdf page.html.png page html page.html/ .html; do
  said=$("$program" algebra --lesson "$path" 'T(1 1)' 2>&1)
  verdict "$path is no page" "$([ $? != 0 ] && [[ $said == *"a lesson must be a .html file, not \"$path\""* ]] && echo yes)" "$said"
done
is 'nothing is written' "$(find . -type f)" ./web/player.js
"$program" algebra --lesson page.HTM 'T(1 1)' && has 'another ending' "$(tail -n 1 page.HTM)" '</html>'
rm -f page.HTM
said=$("$program" algebra --lesson nowhere/page.html 'T(1 1)' 2>&1)
verdict 'no such folder' "$([ $? != 0 ] && [[ $said == *nowhere* ]] && echo yes)" "$said"
is 'nothing is left' "$(find . -type f)" ./web/player.js
summary
