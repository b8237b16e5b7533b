#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests --let (values for the lets of a script) and --language (its texts in another language) of all commands.
#   let_test.sh PROGRAM
. "$(dirname -- "$0")/support.sh" || exit 3

cat >a.bx <<'END'
size 64x36
range 1f 3f
let size = 2
let title = "One"
let at = 12f
let shade = #ff0000
let way = (1 2 3)
let turn = 90deg
create ball sphere radius=size color=shade position=way
create word text text=title
set ball.rotation.z turn
at at hide ball
END
value() { # TARGET OPTION…
  local target=$1
  shift
  "$program" eval a.bx "$target" "$@" 2>&1
}
is 'without an option the script decides' "$(value ball.radius | awk '{ print $NF }')" 2
is 'a number' "$(value ball.radius --let size=5 | awk '{ print $NF }')" 5
is 'a formula' "$(value ball.radius --let 'size=2*3' | awk '{ print $NF }')" 6
is 'a formula of another let' "$(value ball.radius --let 'at=3f' --let 'size=1/4' | awk '{ print $NF }')" 0.25
has 'a text without quotes' "$(value word.text --let 'title=The "end"')" 'The \"end\"'
has 'a text in quotes' "$(value word.text --let 'title="2*3"')" '"2*3"'
has 'a text that looks like a number' "$(value word.text --let title=12)" '"12"'
has 'a vector' "$(value ball.position --let 'way=(4 5 6)')" '(4 5 6)'
has 'a colour' "$(value ball.color --let shade=lime --json)" '[0,1,0]'
has 'an angle' "$(value ball.rotation.z --let turn=0.25turn --json)" '1.57'
is 'a time' "$(value ball.display --at 13f --let at=14f | awk '{ print $NF }')" on

check 'a name that is misspelt' 1 "--let siez=3: the script has no 'let siez'" eval a.bx ball.radius --let siez=3
has 'has its nearest' "$said" "did you mean 'size'"
check 'a wrong type' 1 '--let size=gold: that is a colour, and the script has a number' eval a.bx --let size=gold
has 'and the place of the let' "$said" 'a.bx:3:5'
check 'a time for a number' 1 'that is a time, and the script has a number' eval a.bx --let size=24f
check 'no value' 1 '--let at=:' eval a.bx --let at=
check 'what is not read whole' 1 '--let size=3 4: there is more behind the value' eval a.bx --let 'size=3 4'
check 'more lines' 1 '--let size=' check a.bx --let $'size=3\nhide ball'
check 'no name' 2 'is not NAME=VALUE' eval a.bx --let size
check 'twice' 2 "'size' is given twice" eval a.bx --let size=1 --let size=2
printf 'create a sphere\n' >none.bx
check 'a script without lets' 1 'it has no `let` at all' eval none.bx --let size=1

# Each command that reads a script.
check 'check' 1 "no 'let siez'" check a.bx --let siez=3
check 'frame' 0 '' frame a.bx -o a.png --let size=9
"$program" frame a.bx -o b.png
verdict 'another picture' "$(cmp -s a.png b.png || echo yes)" 'the same'
check 'render' 0 '3 frames' render a.bx -o a.gif --let size=9
check 'export' 0 '' export a.bx -o a.glb --let size=9
check 'plot' 0 '' plot a.bx ball.radius -o a.svg --let size=9
check 'contacts' 1 "no 'let siez'" contacts a.bx --let siez=3
check 'play' 1 "no 'let siez'" play a.bx --terminal --let siez=3
check 'tidy leaves the text as it is' 0 'let size = 2' tidy a.bx --let size=3
printf 'at 1f ball.radius 7\n' >a.expect
check 'test' 0 '' test a.bx --let size=7
check 'shell' 0 "no 'let siez'" shell a.bx --let siez=3
has 'studio' "$("$program" studio --help)" '--let'
printf 'let size = 3\ncreate other sphere radius=size\n' >part.bx
printf 'use part.bx\nlet more = size\n' >whole.bx
has 'a let of a used file' "$("$program" eval whole.bx other.radius --let size=8)" 8
printf 'let a = 1\nlet again a = a+1\ncreate b sphere radius=a\n' >again.bx
has 'let again goes on from there' "$("$program" eval again.bx b.radius --let a=5)" 6

# ---- language
cat >film.bx <<'END'
language "de.po"
create a text text="Hello"
create b text text="Two\nlines of \"words\""
create c text text="Stays"
a.text
  1f "Hello"
  12f "Good bye"
create d circle
create e circle position=(5 0 0)
label d "Hello"
connect d to e label="Good bye"
create f axes x-title="time"
create g code text="Hello"
END
cat >de.po <<'END'
# A comment
msgid ""
msgstr "Content-Type: text/plain; charset=UTF-8\n"

#: film.bx:2
msgid "Hello"
msgstr "Grüß "
"Gott"

msgid "Two\nlines of \"words\""
msgstr ""
"Zwei\n"
"Zeilen"

#, fuzzy
msgid "Stays"
msgstr "Bleibt"

msgid "time"
msgstr "Zeit"

msgid "Good bye"
msgstr "Auf Wiedersehen"
END
texts() { "$program" eval film.bx "$@" 2>&1; }
has 'a text' "$(texts a.text)" 'Grüß Gott'
has 'of two lines' "$(texts b.text)" 'Zwei\nZeilen'
has 'a guess is no translation' "$(texts c.text)" 'Stays'
has 'an event' "$(texts a.text --at 12f)" 'Auf Wiedersehen'
has 'a label' "$(texts d-label.text)" 'Grüß Gott'
has 'the title of an axis' "$(texts f.x-title)" 'Zeit'
has 'of the option: none' "$(texts a.text --language '')" 'Hello'
printf 'msgid "Hello"\r\nmsgstr "Salut"\r\n' >fr.po
has 'of the option: another' "$(texts a.text --language fr.po)" 'Salut'
sed 1d film.bx >plain.bx
has 'an option alone' "$("$program" eval plain.bx a.text --language fr.po)" 'Salut'
check 'a missing catalogue of the option' 1 'no.po' eval plain.bx --language no.po
check 'all texts as a template' 0 '' check plain.bx --po film.pot
is 'each once, with its place' "$(grep -A1 '^#:' film.pot | grep -v '^--')" "$(printf '#: plain.bx:1\nmsgid "Hello"\n#: plain.bx:2\nmsgid ""\n#: plain.bx:3\nmsgid "Stays"\n#: plain.bx:6\nmsgid "Good bye"\n#: plain.bx:11\nmsgid "time"')"
command -v msgfmt >/dev/null && is 'gettext reads it' "$(msgfmt -c -o /dev/null film.pot 2>&1 | grep -v 'header field' | grep -c error)" 0
check 'a catalogue with translations is kept' 2 'already exists and has translations' check film.bx --po de.po
wrong() { # NAME TEXT ERROR
  printf '%b' "$2" >wrong.po
  printf 'language "wrong.po"\ncreate a text text="Hello"\n' >wrong.bx
  check "$1" 1 "$3" check wrong.bx
  has "$1: the place in the script" "$said" 'wrong.bx:1:'
}
wrong 'no msgstr' 'msgid "a"\n\nmsgid "b"\nmsgstr "c"\n' 'wrong.po:1: this msgid has no msgstr'
wrong 'twice' 'msgid "a"\nmsgstr "b"\n\nmsgid "a"\nmsgstr "c"\n' 'wrong.po:4: the text "a" is translated twice'
wrong 'not closed' 'msgid "a\nmsgstr "b"\n' 'wrong.po:1: a text in quotes is missing'
wrong 'another word' 'msgid "a"\nmsgstr "b"\nmgsid "c"\n' 'wrong.po:3: expected msgid, msgstr'
wrong 'a backslash' 'msgid "a"\nmsgstr "\\q"\n' 'wrong.po:2: a backslash here has no meaning'
wrong 'plurals' 'msgid "a"\nmsgid_plural "as"\n' "wrong.po:2: 'msgid_plural' has no meaning"
wrong 'no UTF-8' 'msgid "a"\nmsgstr "\\xff"\n' 'wrong.po'
printf 'create a text text="Hello"\nlanguage "de.po"\n' >late.bx
check 'too late' 1 'late.bx:2:' check late.bx
has 'says where' "$said" 'must come before the first text'
printf 'language "de.po"\ndefine caption text "Hello"\ncreate a text\nset a.caption "Hello"\n' >own.bx
has 'functions of your own stay as they are' "$("$program" eval own.bx a.caption)" '"Hello"'
printf 'language "no.po"\n' >film2.bx
check 'no such catalogue' 1 'film2.bx:1:' check film2.bx
summary
