#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests pages in a browser without a window (chromium, or the program that the variable BROWSER names).
#   run.sh PROGRAM [NAME…]    runs all tests, or only tests/web/NAME_test.py
folder=$(cd -P -- "$(dirname -- "$0")" && pwd)
. "$folder/../counts.sh"
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
  count "$name: " env PYTHONDONTWRITEBYTECODE=1 timeout 600 python3 "$folder/${name}_test.py" "$program"
done
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
