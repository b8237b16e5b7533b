#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# betwixt algebra from outside: frames against figures worked out by hand, counts, what it refuses and how it says so.
#   algebra_test.sh PROGRAM
. "$(dirname -- "$0")/support.sh" || exit 3

algebra() { out=$("$program" algebra "$@" 2>err </dev/null); code=$?; err=$(<err); }
refused() { # NAME CODE TEXT ARGUMENT…
  local name=$1 wanted=$2 text=$3
  shift 3
  algebra "$@"
  verdict "$name" "$([ $code = "$wanted" ] && [[ $err == *"$text"* ]] && [ -z "$out" ] && echo yes)" "exit code $code, said: $err$out"
}
# Whether each number of $out is that of the list, within 1e-12.
same() { # NAME NUMBER…
  local name=$1 got
  shift
  got=$(tr -c '0-9.e+-' ' ' <<<"$out")
  verdict "$name" "$(awk -v got="$got" -v wanted="$*" 'BEGIN {
    n = split(got, a); m = split(wanted, b); ok = n == m
    for (i = 1; i <= m; ++i) ok = ok && a[i] - b[i] < 1e-12 && b[i] - a[i] < 1e-12
    exit !ok }' && echo yes)" "$got is not $*"
}

# A rolling wheel: the rim's lowest point goes along a cycloid, and comes down again half a turn later.
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
has 'right at the end only' "$err" 'meets the motion at its end, and leaves it in between'

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

refused 'no motion' 1 'motion:1:8: error: a motion is a string of T(…), R(…) and S(…)' 'T(1 0) X(2)'
has 'with a caret' "$err" '         ^'
refused 'no unit' 1 'an angle needs its unit: 90' 'R(90)'
refused 'no in-betweens' 1 'a scaling by -1 has no in-betweens' 'S(-1 1)'
refused 'no steps' 2 '0 steps lead nowhere' 'T(1 0)' --steps 0
refused 'no number' 2 "--at: 'x' is no number" 'T(1 0)' --at x
refused 'no point' 2 "--points: '1' is no point" 'T(1 0)' --points 1
refused 'no method' 2 "'fast' is no method" 'T(1 0)' --method fast
refused 'no half step of a method' 2 'a method goes from step to step, and 0.5 is none' 'T(1 0)' --method best --at 0.5
refused 'no object' 1 "there is no object 'sun' here" 'R(1turn @ sun)'
refused 'not differences' 1 'no one matrix makes all steps of this motion' 'R(1turn) T(1 0)' --method differences
refused 'not geometric' 1 'the geometric method has no scheme for TST' 'T(1 0) S(2 linear) T(1 0)' --method geometric
refused 'not in space' 1 'this motion leaves the plane' 'T(1 0 1)' --method best
refused 'no inverse' 1 'under the linear law what undoes it is no such motion' 'S(2 linear)' --inverse
refused 'too many steps' 2 "'99999999999999999999' is no whole number of steps" 'T(1 0)' --steps 99999999999999999999
refused 'no points' 2 '--points: there is no point' 'T(1 0)' --points ''
refused 'a lesson as JSON' 2 '--json excludes --lesson' 'T(1 0)' --lesson x.html --json
refused 'a lesson as a plot' 1 'a lesson is a .html, not "x.svg"' 'T(1 0)' --lesson x.svg
refused 'no origin' 2 "--origin: 'x' is no point" 'rotate(90deg)' --css --origin x
refused 'counts in space' 1 'operations are counted in the plane only' 'T(1 0 1)' --count
refused 'no CSS of growth' 1 'S' 'S(2)' --to-css
refused 'no CSS' 1 'motion:1:1: error:' --css 'skew(10deg)'
summary
