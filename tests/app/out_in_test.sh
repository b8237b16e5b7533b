#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Exports films as glTF and imports them again. The motion must be the same, and a second export must give the same keys
# and numbers.
#   out_in_test.sh PROGRAM
tests=$(realpath -- "$(dirname -- "$0")")
. "$tests/support.sh" || exit 3
export LC_ALL=C.UTF-8

keys() { "$program" export "$1" -o "$2" --keys cubic 2>&1 | sed -nE 's/.*, ([0-9]+) keys.*/\1/p'; } # FILE OUT
numbers() { "$program" eval "$1" --at 0.3s,0.71s,1.234s,1.9s,2.5s "$2" 2>/dev/null | grep -oE 'matrix\(.*' | tr -c '0-9.e\n-' ' '; }
# apart BOUND A B: succeeds if any two numbers differ by more than BOUND.
apart() {
  paste -d '\n' <(tr -s ' ' '\n' <<<"$2") <(tr -s ' ' '\n' <<<"$3") | awk -v most="$1" '
    NR % 2 { a = $1 } NR % 2 == 0 && $1 != "" { n++; d = a - $1; if (d > most || -d > most) far = 1 }
    END { print n < 80 || far ? "apart" : "well" }'
}

# there_and_back EXAMPLE OBJECT: exports an example, imports it, and compares the motion of the object.
there_and_back() {
  local first second third
  first=$(keys "$tests/../../examples/$1.bx" one.glb)
  echo 'create it scene file="one.glb"' >one.bx
  second=$(keys one.bx two.glb)
  echo 'create it scene file="two.glb"' >two.bx
  third=$(keys two.bx three.glb)
  is "$1: as many keys go out the third time as the second" "$third" "$second"
  is "$1: no more than the first time" "$((second <= first))" 1
  is "$1: $2 is within the tolerance" "$(apart 1e-4 "$(numbers "$tests/../../examples/$1.bx" "$2.world")" \
    "$(numbers one.bx "it/$2.world")")" well
  "$program" export "$tests/../../examples/$1.bx" -o straight.glb 2>/dev/null
  echo 'create it scene file="straight.glb"' >straight.bx
  is "$1: $2 is within the tolerance of straight keys" "$(apart 1e-3 "$(numbers "$tests/../../examples/$1.bx" "$2.world")" \
    "$(numbers straight.bx "it/$2.world")")" well
  is "$1: $2 stays there" "$(apart 1e-6 "$(numbers one.bx "it/$2.world")" "$(numbers two.bx "it/it-$2.world")")" well
}
there_and_back bounce ball
there_and_back grab ball
there_and_back clockwork big
summary
