#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests `betwixt render --each`: one film for each row of a table, in parallel, and what remains after a kill.
#   each_test.sh PROGRAM
. "$(dirname -- "$0")/support.sh" || exit 3

cat >invite.bx <<'END'
size 64x36
range 1f 4f
film flat
let name = "Nobody"
let size = 1
let shade = red
create a circle radius=size color=shade
create b text text=name
END
each() { "$program" render invite.bx --each "$@" 2>&1; }
made() { (cd "${1:-out}" 2>/dev/null && ls) | tr '\n' ' '; }

# Quotes, commas, a line end within a cell, CRLF, a mark of the byte order, a column that is only for names.
printf '\xef\xbb\xbfname,size,file\r\n"Ada, Countess",1,ada\r\n"Bo ""B"" b",2.5,bo\r\n"two\nlines",3,zoë/..\r\n' >guests.csv
check 'three films' 0 '3 films made' render invite.bx --each guests.csv -o 'out/{file}.gif'
is 'with safe names' "$(made)" 'ada.gif bo.gif zoë-.gif '
is 'of the right pictures' "$("$program" render invite.bx -o one.gif --let 'name=Bo "B" b' --let size=2.5 >/dev/null 2>&1; cmp one.gif out/bo.gif 2>&1)" ''
before=$(stat -c %y out/ada.gif)
check 'again, nothing is made' 0 '0 films made, 3 already there' render invite.bx --each guests.csv -o 'out/{file}.gif'
sed -i 's/2\.5/2.6/' guests.csv
check 'a changed row' 0 '1 film made, 2 already there' render invite.bx --each guests.csv -o 'out/{file}.gif'
is 'the others stay' "$(stat -c %y out/ada.gif)" "$before"
truncate -s 20 out/ada.gif
check 'a film that was cut short' 0 '1 film made, 2 already there' render invite.bx --each guests.csv -o 'out/{file}.gif'
check 'other options' 0 '3 films made' render invite.bx --each guests.csv -o 'out/{file}.gif' --size 32x18
check 'and again' 0 '3 already there' render invite.bx --each guests.csv -o 'out/{file}.gif' --size 32x18
sleep 0.02 && touch invite.bx
check 'a changed script' 0 '3 films made' render invite.bx --each guests.csv -o 'out/{file}.gif' --size 32x18
check 'numbers of rows' 0 '1 film made' render invite.bx --each guests.csv -o 'rows/{row}.gif' --rows 2
is 'are those of the table' "$(made rows)" '2.gif '
for part in 1/2 2/2; do each guests.csv -o 'part/{row}.gif' --part $part >/dev/null; done
is 'all parts are the whole' "$(made part)" '1.gif 2.gif 3.gif '

# Cells are values, never code.
printf 'name\tsize\n=1+1\t4\n"; create evil sphere\t5\n' >cells.tsv
check 'a quote that begins a cell' 1 'cells.tsv:3:1: error: this quotation mark is never closed' render invite.bx --each cells.tsv -o 'c/{row}.gif'
printf 'name;size;shade\n=1+1;2*3;red\nx;sqrt(4);red\ny;2;"red\ncreate evil sphere"\nz;;red\nw;1;teal\n' >cells.csv
said=$(each cells.csv -o 'c/{name}.gif')
is 'some fail' $? 1
has 'a formula' "$said" "cells.csv:2: c/=1+1.gif failed: invite.bx:5:5: error: cells.csv:2:6: size is '2*3': that is not a number"
has 'a call' "$said" "cells.csv:3:3: size is 'sqrt(4)'"
has 'a line of the language' "$said" "cells.csv:4:5: shade is"
has 'an empty cell' "$said" 'the cell is empty'
has 'the sum' "$said" '1 film made, 4 failed'
is 'the good one is there' "$(made c)" 'w.gif '
said=$(each cells.csv -o 'c/{name}.gif' --json 2>/dev/null)
is 'as JSON' "$(python3 -c 'import json, sys; d = json.load(sys.stdin); print(d["ok"], d["made"], d["kept"], d["failed"], [f["line"] for f in d["failures"]])' <<<"$said")" 'False 0 1 4 [2, 3, 4, 6]'

wrong() { # NAME TABLE ERROR [OUT]
  local out=${4-'w/{name}.gif'}
  printf '%b' "$2" >t.csv
  check "$1" "${5:-1}" "$3" render invite.bx --each t.csv -o "$out"
  is "$1: nothing is made" "$(made w)" ''
}
wrong 'a ragged row' 'name,size\na,1\nb\n' 't.csv:3:1: error: this row has 1 cell, but there are 2 columns'
wrong 'a long row' 'name,size\na,1,7\n' 't.csv:2:5: error: this row has 3 cells'
wrong 'two films of one name' 'name,size\na,1\nA,2\n' 't.csv:3:1: error: two films would have the name w/A.gif'
wrong 'an empty name' 'name,size\n,1\n' 't.csv:2:1: error: the film has no name'
wrong 'an unknown column' 'name,size\na,1\n' "t.csv:1:1: error: there is no column 'nam', which -o names" 'w/{nam}.gif'
has 'its nearest' "$said" "did you mean 'name'"
wrong 'no column of the script' 'nama,x\na,1\n' "no column has the name of a 'let'" 'w/{x}.gif'
wrong 'no column in the name' 'name\na\n' 'all films would have one name' 'w/film.gif'
wrong 'two columns of one name' 'name,name\na,b\n' "t.csv:1:6: error: two columns are called 'name'"
wrong 'an open quote' 'name\n"a\n' 't.csv:2:1: error: this quotation mark is never closed'
wrong 'behind a quote' 'name\n"a"b\n' 't.csv:2:4: error: there is more behind the closing quotation mark'
wrong 'no UTF-8' 'name\na\xffb\n' 't.csv:2:2: error'
wrong 'an empty table' '' 't.csv:1:1: error: the table is empty'
wrong 'pictures' 'name\na\n' 'not numbered pictures' 'w/{name}-%04d.png' 2
check 'no table' 1 'no.csv' render invite.bx --each no.csv -o 'w/{name}.gif'
check 'no name for films' 2 'needs a name' render invite.bx --each guests.csv
check 'a .pdf' 2 'makes films, and no .pdf' render invite.bx --each guests.csv -o 'w/{row}.pdf'
printf 'shade\nrgb(1 0.5 0)\nhsv(30deg 1 1)\n#fc0\n' >shades.csv
printf 'let shade = gold\nrange 1f 2f\nfilm flat\ncreate b rectangle color=shade\n' >shade.bx
check 'cells of colors' 0 '3 films made' render shade.bx --each shades.csv -o 's/{row}.gif' --size 32x18
printf 'shade\nrgb(1 0.5*1 0)\n' >shades.csv
check 'a formula in a color' 1 'cells of tables are values' render shade.bx --each shades.csv -o 's/{row}.gif' --size 32x18
check 'a wrong part' 2 'is not a part such as 3/8' render invite.bx --each guests.csv -o 'w/{row}.gif' --part 3/2
check 'rows without a table' 2 '' render invite.bx --rows 1..2
check 'a let of both' 2 'give the same value' render invite.bx --each guests.csv -o 'w/{row}.gif' --let size=2
printf 'name\n' >none.csv
check 'a table without rows' 0 '0 films made' render invite.bx --each none.csv -o 'w/{name}.gif'

# Killed in the middle: no half film, and the second call makes the rest.
{ echo name,size; for i in {1..40}; do echo "n$i,$i"; done; } >forty.csv
"$program" render invite.bx --each forty.csv -o 'k/{name}.gif' >/dev/null 2>&1 &
for _ in {1..200}; do [ "$(ls k 2>/dev/null | wc -l)" -ge 5 ] && break; sleep 0.05; done
kill -9 $!
wait $! 2>/dev/null
some=$(ls k | wc -l)
verdict 'some are there' "$([ "$some" -ge 5 ] && [ "$some" -lt 40 ] && echo yes)" "$some"
verdict 'all of them whole' "$(for f in k/*.gif; do ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of csv=p=0 "$f"; done | sort -u | tr '\n' ' ' | sed 's/^4 $/yes/')" 'no'
said=$(each forty.csv -o 'k/{name}.gif')
has 'the second call goes on' "$said" 'already there'
is 'all are there' "$(ls k | wc -l)" 40
is 'and no remains' "$(ls -A k | grep -vc -e '^n.*gif$' -e '^\.n.*gif\.made$')" 0
summary
