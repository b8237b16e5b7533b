#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests `betwixt test`: values and pictures that films must have.
#   golden_test.sh PROGRAM
. "$(dirname -- "$0")/support.sh" || exit 3

mkdir -p films/below
cat >films/a.bx <<'FILM'
rate 24
range 1f 24f
create ball sphere color=red
create lamp light position=(5 10 8)
create eye camera position=(0 0 30)
ball.position
  1f  (0 0 0)  linear
  25f (24 0 0)
FILM
cp films/a.bx films/below/b.bx
cat >films/a.expect <<'EXPECT'
# halfway
at 13f ball.position (12 0 0)
at 13f ball.position.x 12.4 within 0.5
at 13f ball.color red   # still
at 1f ball.position (0 0 0) within 0
size 64x36
frame 1f "a-1.png"
EXPECT
echo 'at 1f ball.position (0 0 0)' >films/below/b.expect
check 'a picture that is not there' 1 'a-1.png' test films
check 'update' 0 'films/a-1.png written' test films --update
check 'again' 0 '2 films, 6 checks, 0 failed' test films
check 'nothing to write' 0 '' test films --update
is 'it is not written again' "$(grep -c written <<<"$said")" 0
check 'one film' 0 '1 film, 1 check, 0 failed' test films/below/b.bx
is 'the size' "$("$program" frame films/a.bx --at 1f --size 64x36 -o a.png 2>/dev/null; cmp a.png films/a-1.png && echo same)" same
sed -i 's/25f (24 0 0)/25f (26 0 0)/; s/1f  (0 0 0)/1f  (1 0 0)/' films/a.bx
check 'values that differ' 1 'films/a.expect:2: ball.position at 13f: expected (12 0 0), found (13.5 0 0)' test films
has 'a picture that differs' "$said" 'films/a.expect:7: a-1.png at 1f: expected within 2, found'
is 'pictures beside it' "$(ls films/a-1.found.png films/a-1.difference.png | wc -l)" 2
is 'a line for each' "$(grep -c '^films/a.expect' <<<"$said")" 4
sed -i 's/25f (26 0 0)/25f (24 0 0)/; s/1f  (1 0 0)/1f  (0 0 0)/' films/a.bx
check 'right again' 0 '0 failed' test films
is 'the pictures are gone' "$(ls films | grep -c found)" 0
echo 'at 1f ball.position' >films/below/b.expect
check 'a line that is wrong' 1 'films/below/b.expect:1: at needs a time, a target and a value' test films
echo 'at 1f bal.position (0 0 0)' >films/below/b.expect
check 'a name that is wrong' 1 "b.expect:1: " test films
has 'its correction' "$said" "did you mean 'ball'?"
cat >films/below/b.expect <<'EXPECT'
at 1f ball.rotation.z 45deg within 0.1deg
at 1f ball.rotation.z 0.7 within 0.1
at 1f ball.position.x 4 with 0.1
EXPECT
check 'angles that are wrong' 1 'b.expect:1: ball.rotation.z at 1f: expected 45deg within 0.0017' test films
has 'an angle without a unit' "$said" 'b.expect:2: ball.rotation.z at 1f: expected 0.7: an angle needs a unit'
has 'a word that is wrong' "$said" "'with 0.1' is not expected: did you mean 'within'?"
echo 'set ball.rotation.z 45.05deg' >>films/below/b.bx
echo 'at 1f ball.rotation.z 45deg within 0.1deg' >films/below/b.expect
check 'an angle that is near' 0 '0 failed' test films
echo 'at 1f ball.rotation.z 45deg within' >films/below/b.expect
check 'no number' 1 'within needs a number or an angle' test films
echo 'at 1f bal.position (0 0 0)' >films/below/b.expect
echo 'create ball spere' >films/below/b.bx
check 'a film that is wrong' 1 'films/below/b.bx:1: ' test films
check 'no such folder' 2 'no file .expect' test nowhere
summary
