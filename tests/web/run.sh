#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests pages in a browser without a window (chromium, or the program that the variable BROWSER names).
#   run.sh PROGRAM [NAME…]    runs all tests, or only tests/web/NAME_test.py
folder=$(cd -P -- "$(dirname -- "$0")" && pwd)
[ $# -gt 0 ] || { sed -n 6p "$0" | cut -c 3- >&2; exit 2; }
program=$(realpath -- "$1")
shift
if ! command -v "${BROWSER:-chromium}" >/dev/null; then
  echo 'left out: there is no browser (apt-get install chromium)'
  echo '0 passed, 0 failed'
  exit 0
fi
passed=0 failed=0
[ $# -gt 0 ] || set -- $(cd "$folder" && printf '%s\n' *_test.py | sed 's/_test\.py$//')
for name; do
  said=$(PYTHONDONTWRITEBYTECODE=1 timeout 600 python3 "$folder/${name}_test.py" "$program" 2>&1)
  printf '%s\n' "$said" | grep -vE '^[0-9]+ passed, [0-9]+ failed$' | sed "s/^/$name: /"
  counts=$(printf '%s\n' "$said" | sed -nE 's/^([0-9]+) passed, ([0-9]+) failed$/\1 \2/p' | tail -n 1)
  [ -n "$counts" ] || counts="0 1"
  passed=$((passed + ${counts% *})) failed=$((failed + ${counts#* }))
done
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
