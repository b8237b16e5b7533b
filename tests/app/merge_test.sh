#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests `betwixt merge`: its files and exit codes, conflicts, and texts that do not read.
#   merge_test.sh PROGRAM
. "$(dirname -- "$0")/support.sh" || exit 3

cat >base.bx <<'FILM'
# a film
rate 24
create ball sphere color=red   # the hero
create lamp light
ball.position
  1f   (0 10 0)
  12f  (4 1 0)    linear   # hits
  24f  (8 10 0)
FILM
sed 's/color=red/color=gold/; s/12f  (4 1 0)/13f  (4 1 0)/' base.bx >mine.bx
sed 's/create lamp/create sun/; s/(0 10 0)/(0 11 0)/; $a ball.radius\n  1f 1' base.bx >theirs.bx
check 'both' 0 '' merge base.bx mine.bx theirs.bx -o merged.bx
is 'the result' "$(cat merged.bx)" '# a film
rate 24
create ball sphere color=gold   # the hero
create sun light
ball.position
  1f   (0 11 0)
  13f  (4 1 0)    linear   # hits
  24f  (8 10 0)
ball.radius
  1f 1'
cp mine.bx before.bx
check 'mine gets the result' 0 '' merge base.bx mine.bx theirs.bx
is 'there it is' "$(cmp mine.bx merged.bx && echo same)" same
cp before.bx mine.bx
check 'to standard output' 0 'create sun light' merge base.bx mine.bx theirs.bx -o -

sed 's/color=red/color=blue/; /24f/d' base.bx >theirs.bx
sed -i 's/24f  (8 10 0)/24f  (8 9 0)/' mine.bx
check 'conflicts' 1 '2 conflicts' merge base.bx mine.bx theirs.bx -o merged.bx
has 'a value' "$said" 'mine.bx:4: conflict: ball.color: mine: gold; theirs: blue'
has 'its line' "$said" 'write: set ball.color blue'
has 'beside mine' "$(cat merged.bx)" 'color=gold   # the hero
# conflict: theirs: set ball.color blue'
has 'an event' "$(cat merged.bx)" '  24f  (8 9 0)
  # conflict: theirs: clear ball.position 24f'
sed '/ball/d; /^  /d' base.bx >theirs.bx
check 'they removed what I changed' 1 'conflict: ball: mine: sphere; theirs: removed' merge base.bx mine.bx theirs.bx -o merged.bx
has 'said in the language' "$(cat merged.bx)" '# conflict: theirs: remove ball'
check 'I removed what they changed' 1 'conflict: ball' merge base.bx theirs.bx mine.bx -o merged.bx
has 'nothing is lost' "$(cat merged.bx)" '(8 9 0)'
sed 's/ball/star/g' base.bx >theirs.bx
sed 's/ball/moon/g' base.bx >mine.bx
check 'two names' 1 'renamed to star' merge base.bx mine.bx theirs.bx -o merged.bx
has 'mine stays' "$(cat merged.bx)" '# conflict: theirs: rename moon star'

# A text that does not read.
sed 's/sphere/spere/' base.bx >mine.bx
sed 's/color=red/color=gold/' base.bx >theirs.bx
check 'an error: by lines' 1 'merged by lines: mine has an error: line 3' merge base.bx mine.bx theirs.bx -o merged.bx
has 'with the usual marks' "$(cat merged.bx)" '<<<<<<< mine'
check 'no file' 2 'none.bx' merge base.bx none.bx theirs.bx
is 'it is not made' "$(ls none.bx 2>&1 | grep -c 'No such')" 1
summary
