#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests `betwixt algebra`: frames against numbers computed by hand, counts of operations, and its errors.
#   algebra_test.sh PROGRAM
. "$(dirname -- "$0")/support.sh" || exit 3

algebra() { out=$("$program" algebra "$@" 2>err </dev/null); code=$?; err=$(<err); }
refused() { # NAME CODE TEXT ARGUMENT…
  local name=$1 wanted=$2 text=$3
  shift 3
  algebra "$@"
  verdict "$name" "$([ $code = "$wanted" ] && [[ $err == *"$text"* ]] && [ -z "$out" ] && echo yes)" "exit code $code, said: $err$out"
}
# Checks that each number of $out equals that of the list, within 1e-12.
same() { # NAME NUMBER…
  local name=$1 got
  shift
  got=$(tr -c '0-9.e+-' ' ' <<<"$out")
  verdict "$name" "$(awk -v got="$got" -v wanted="$*" 'BEGIN {
    n = split(got, a); m = split(wanted, b); ok = n == m
    for (i = 1; i <= m; ++i) ok = ok && a[i] - b[i] < 1e-12 && b[i] - a[i] < 1e-12
    exit !ok }' && echo yes)" "$got is not $*"
}

# A rolling wheel: the lowest point of the rim moves along a cycloid, and comes down again half a turn later.
algebra 'T(8 0) R(-1turn @ 0 1)' --steps 4 --points '0,0 0,2'
is 'a wheel' $code 0
same 'its frames' 0 0 0 0 2  1 1 1 3 1  2 4 2 4 0  3 7 1 5 1  4 8 0 8 2
algebra 'T(8 0) R(-1turn @ 0 1)' --steps 4 --at 2,0,-4,8,1.5 --points 0,0
same 'frames in the order asked, beyond the ends and between' 2 4 2  0 0 0  -4 -8 0  8 16 0  1.5 2.29289321881345 1.70710678118655
algebra 'S(4 0.25)' --steps 2 --points=-1,8
same 'the exponential law' 0 -1 8  1 -2 4  2 -4 2
algebra 'S(4 -1 linear)' --steps 2 --points=-1,8
same 'the linear law' 0 -1 8  1 -2.5 0  2 -4 -8
algebra 'R(90deg axis x) T(0 0 2)' --steps 1 --points 0,1,0
same 'in space' 0 0 1 0  1 0 -2 1
algebra 'T(1 2) S(2)' --inverse --steps 1 --at 1 --points 5,6
is 'the inverse' "$(head -n 1 <<<"$out")" 'S(0.5) T(-1 -2)'
is 'undoes' "$(tail -n 1 <<<"$out")" '1       2 2'
algebra '' --steps 1
same 'the empty string' 0 1 0  1 1 0
algebra --css 'translate(8px, 0) rotate(90deg)' --steps 1 --points 1,0
is 'a list of CSS' "$(head -n 1 <<<"$out")" 'T(8 0) R(90deg)'
is 'its end' "$(tail -n 1 <<<"$out")" '1       8 1'
algebra --css 'rotate(90deg)' --origin 50,50 --steps 1 --at 1 --points 60,50
is 'about its origin' "$(tail -n 1 <<<"$out")" '1       50 60'
algebra 'T(8 0) R(90deg @ 1 2)' --to-css
is 'as CSS' "$out" $'from translate(0px, 0px) translate(1px, 2px) rotate(0deg) translate(-1px, -2px)\nto translate(8px, 0px) translate(1px, 2px) rotate(90deg) translate(-1px, -2px)'
for method in matrix geometric best; do
  algebra 'T(8 0) R(-1turn @ 0 1)' --steps 300 --at 75,150,300 --points 0,0 --method $method
  same "by $method" 75 1 1  150 4 2  300 8 0
done
algebra 'S(2 3 linear) R(180deg)' --steps 2 --method geometric --points 1,0
has 'right at the end only' "$err" 'this method is exact only at the end of the motion'
# (g - 1) k/N times the chord between the positions of a point before and after the rotation, by complex numbers.
algebra 'S(-3 2 @ 5 -5 linear) R(0.9turn)' --steps 240 --method geometric --at 240 --points -9.93,1.17
has 'how far beside' "$err" 'in between the error is up to 42.9206366272655'
algebra 'R(24turn) T(24 0)' --method differences --at 7 --points 1,0
same 'turns that are whole at each step' 7 8 0
algebra 'R(180deg) T(1 0)' --steps 1 --method differences --at 1 --points 1,0
same 'one step' 1 -2 0
algebra 'R(123456789.12345turn)' --steps 1 --at 1
same 'a fraction of many turns' 1 0.7139596077037439 0.7001868883144814
algebra 'R(1e15turn @ 3 4)' --steps 8 --points 1,2 --at 3,8
same 'very many turns' 3 1 2  8 1 2

# The in-betweens of a browser between two lists, and lists that are no motion.
algebra --css 'translateX(10px) rotate(0deg)' --to 'translateX(30px) rotate(720deg)' --steps 4 --at 1 --points 1,0
same 'two lists' 1 14 0
algebra --css 'rotate(720deg)' --to 'scale(3)' --steps 2 --at 1 --points 1,0
same 'two lists that differ' 1 2 0
has 'say so' "$err" 'the lists differ from function 1 on, so matrices are blended and whole turns are lost'
algebra --css 'rotateX(90deg)' --to 'rotateY(90deg)' --steps 2 --at 0
has 'two axes' "$err" 'function 1 rotates about two axes, so it takes the short way and whole turns are lost'
algebra --css 'matrix(1, 1, 0, 0, 0, 0)' --to 'none' --steps 4 --at 1,2 --points 1,0
same 'a flat matrix' 1 1 1  2 1 0
has 'jumps' "$err" 'one list applies up to half way, then the other'
algebra --css 'skewX(45deg)' --steps 1 --at 1 --points 0,2
same 'a skew' 1 2 2
algebra --css 'perspective(100px) translateZ(50px)' --steps 2 --points 10,0,0 --at 0,2
same 'a perspective' 0 10 0 0  2 20 0 100
algebra --css 'translate(50%, calc(25% + 1in))' --size 200,40 --steps 1 --at 1 --points 0,0
is 'of a size' "$(tail -n 1 <<<"$out")" '1       100 106'
algebra --css 'scale(2)' --to 'scale(3)' --under 'scale(2)' --steps 1 --at 0,1 --points 1,0
same 'added' 0 4 0  1 6 0
algebra --css 'scale(2)' --to 'scale(3)' --under 'scale(2)' --accumulate --steps 1 --at 0,1 --points 1,0
same 'accumulated' 0 3 0  1 4 0
algebra --css 'scale(1)' --to 'scale(3)' --origin 10,0 --steps 1 --at 1 --points 11,0 --json
is 'as JSON' "$out" '{"steps":1,"frames":[{"k":1,"points":[[13,0]],"matrix":[3,0,0,0,0,3,0,0,0,0,1,0,-20,0,0,1]}]}'

# The symbolic matrix, derived by hand.
algebra 'T(5 3) R(1rad @ 1 4)' --symbols
is 'in letters' "$out" '  c2  -s2  u1 + (1 - c2) x2 + s2 y2
  s2  c2   v1 - s2 x2 + (1 - c2) y2

  u1 = 5 t
  v1 = 3 t
  c2 = cos(1rad t)
  s2 = sin(1rad t)
  x2 = 1
  y2 = 4'
algebra 'S(2 @ 0 0 1)  R(90deg axis y)' --symbols --json
is 'in letters, in space, as JSON' "$out" '{"motion":"S(2 @ 0 0 1) R(90deg axis 0 1 0)","matrix":[["g1 c2","0","g1 s2","0"],["0","g1","0","0"],["-g1 s2","0","g1 c2","(1 - g1) z1"]],"letters":[{"name":"g1","factor":1,"means":"2^t"},{"name":"z1","factor":1,"means":"1"},{"name":"c2","factor":2,"means":"cos(90deg t)"},{"name":"s2","factor":2,"means":"sin(90deg t)"}]}'
algebra '' --symbols
is 'no letters' "$out" '  1  0  0
  0  1  0'

algebra 'T(5 3) R(1rad @ 1 4)' --json --steps 2 --at 0,2 --points 1,4 --count
verdict 'JSON' "$(python3 - "$out" <<'P' && echo yes
import json, sys
d = json.loads(sys.argv[1])
assert d["steps"] == 2 and [f["k"] for f in d["frames"]] == [0, 2]
assert d["frames"][0]["points"] == [[1, 4]] and d["frames"][1]["points"] == [[6, 7]]
c = d["count"]
assert c["row"] == "TR" and c["paper"]["matrix"] == {"per_point": 8, "besides": 18, "functions": 0}
m = c["methods"]
assert (m["matrix"]["ours"]["per_point"], m["matrix"]["ours"]["besides"]) == (8, 6)
assert m["matrix"]["measured"] == m["matrix"]["ours"] and m["best"]["measured"]["besides"] == 2
assert "do not commute" in m["differences"]["error"]
P
)" "$out"
algebra 'R(1rad @ 1 4) S(2 3 @ 5 2)' --count
has 'counts' "$out" 'matrix       8Np + 31         8Np + 16     8Np + 16'
has 'counts by the linear law' "$out" 'geometric: with the scalings by the linear law'
has 'counts of the source' "$out" 'geometric    16Np             16Np         16Np'
has 'counts before' "$out" 'matrix       35               2Np + 33, 20 f            0'
has 'counts afterwards' "$out" 'geometric    6Np + 6          6Np + 9, 3 f              2Np'
algebra 'T(1 0) R(1rad)' --count
verdict 'no law without a scaling' "$([[ $out != *'linear law'* ]] && echo yes)" "$out"
algebra 'R(1rad) R(1rad @ 1 0) R(1rad @ 2 0)' --count
has 'arms' "$out" 'row R…R, n = 3 of'
algebra 'S(2 3 linear) R(180deg)' --count --steps 2 --points 1,0
has 'counts, and how far beside' "$out" 'geometric: exact only at the end; in between the error is up to 1.118033988749895'

algebra --css 'perspective(100px) translateZ(200px)' --steps 4 --points 0,0
has 'behind the eye' "$out" '4       behind the eye'
has 'before it' "$out" '1       0 0 57.14285714285714'
algebra --css 'perspective(100px) translateZ(200px)' --steps 2 --points '0,0 0,0,-200' --at 2 --json
has 'behind the eye as JSON' "$out" '"points":[null,[0,0,0]]'
algebra --css 'translate(2em, 10vw)' --font-size 20 --viewport 300,200 --steps 1 --points 0,0
has 'units of the page' "$out" '1       40 30'

refused 'no motion' 1 'motion:1:8: error: expected a string of T(…), R(…) and S(…) here' 'T(1 0) X(2)'
has 'with a caret' "$err" '         ^'
refused 'no unit' 1 'an angle needs its unit: 90' 'R(90)'
refused 'no in-betweens' 1 'a scaling by -1 has no in-between values' 'S(-1 1)'
refused 'no steps' 2 'the number of steps must be at least 1, not 0' 'T(1 0)' --steps 0
refused 'no number' 2 "--at: 'x' is not a number" 'T(1 0)' --at x
refused 'no point' 2 "--points: '1' is not a point" 'T(1 0)' --points 1
refused 'no method' 2 "not 'fast'" 'T(1 0)' --method fast
refused 'no half step of a method' 2 'methods need whole steps, not 0.5' 'T(1 0)' --method best --at 0.5
refused 'no object' 1 "there is no object 'sun' here" 'R(1turn @ sun)'
refused 'not differences' 1 'no single matrix makes all steps of this motion' 'R(1turn) T(1 0)' --method differences
refused 'not geometric' 1 'the geometric method does not support TST' 'T(1 0) S(2 linear) T(1 0)' --method geometric
refused 'not in space' 1 'this motion leaves the plane' 'T(1 0 1)' --method best
refused 'no inverse' 1 'the inverse of a scaling by the linear law is not a motion' 'S(2 linear)' --inverse
refused 'too many steps' 2 "'99999999999999999999' is not a whole number" 'T(1 0)' --steps 99999999999999999999
refused 'no points' 2 '--points: a point is missing' 'T(1 0)' --points ''
refused 'a lesson as JSON' 2 '--json excludes --lesson' 'T(1 0)' --lesson x.html --json
refused 'a lesson as a plot' 1 'a lesson must be a .html file, not "x.svg"' 'T(1 0)' --lesson x.svg
refused 'no origin' 2 "--origin: 'x' is not a point" 'rotate(90deg)' --css --origin x
refused 'lists in letters' 2 'these lists are not a motion; only their frames can be printed' --css none --to 'scale(2)' --symbols
refused 'too long in letters' 1 'has more than 64 terms' "$(printf 'R(1rad @ 1 2) %.0s' {1..12})" --symbols
refused 'counts in space' 1 'operations can be counted only in the plane' 'T(1 0 1)' --count
refused 'no CSS of growth' 1 'S' 'S(2)' --to-css
refused 'no CSS' 1 'motion:1:8: error:' --css 'skew(10em)'
refused 'no CSS at the end' 1 "to:1:1: error: 'spin' is not a CSS transform" --css 'none' --to 'spin(1deg)'
refused 'no CSS without its size' 1 'use px, or give the size of the element, to which percentages refer' --css 'translateX(5%)'
refused 'no font size' 1 'use px, or give the font size' --css 'translateX(5em)'
refused 'no viewport' 1 'use px, or give the size of the viewport' --css 'translateX(5vmin)'
refused 'no number' 2 "--font-size: 'big' is not a number" --css 'translateX(5em)' --font-size big
refused 'no size of a viewport' 2 "--viewport: '5' is not a size" --css 'translateX(5vw)' --viewport 5
refused 'no size' 2 "--size: '5' is not a size" --css 'translateX(5%)' --size 5
refused 'no method for lists' 2 'these lists are not a motion; only their frames can be printed' --css none --to 'scale(2)' --count
refused 'beyond all numbers' 1 'frame 48: a position is not finite' 'S(1e300)' --at 48
refused 'beyond all numbers as JSON' 1 'frame 1: a position is not finite' 'T(1e300 0) S(1e300)' --steps 1 --at 1 --json --points 1e300,0
refused 'beyond all numbers by steps' 1 'a position is not finite' 'S(1e300)' --method best --at 48
refused 'too many turns' 1 "'1e16turn' has more than 9007199254740992 turns" 'R(1e16turn)'
summary
