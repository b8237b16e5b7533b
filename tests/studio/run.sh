#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# The studio's tests: panels without a display, and a real window on a display of its own with a real mouse and keys.
#   run.sh BUILD [TEST…]
build=$(realpath -- "${1:?usage: run.sh BUILD [TEST…]}")
here=$(cd -P -- "$(dirname -- "$0")" && pwd)
shift
passed=0 failed=0
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export XDG_CONFIG_HOME=$folder XDG_DATA_HOME=$folder XDG_RUNTIME_DIR=$folder BETWIXT_PARSER=$build/bin/betwixt-parser
chmod 700 "$folder"
[ $# -gt 0 ] || set -- "$build"/bin/studio_*_test
for test in "$@"; do
  case $test in */*) ;; *) test=$build/bin/studio_$test ;; esac
  (cd "$folder" && QT_QPA_PLATFORM=offscreen timeout 300 "$test" >"$folder/log" 2>&1)
  status=$?
  counts=$(sed -nE 's/^Totals: ([0-9]+) passed, ([0-9]+) failed.*/\1 \2/p' "$folder/log" | tail -n 1)
  : "${counts:=0 1}"
  [ "$status" = 0 ] || { grep -E '^(FAIL|QFATAL|   )' "$folder/log" || tail -n 20 "$folder/log"; }
  [ "$status" = 0 ] || [ "${counts#* }" != 0 ] || counts="${counts% *} 1"
  passed=$((passed + ${counts% *})) failed=$((failed + ${counts#* }))
done
printf '%d passed, %d failed\n' "$passed" "$failed"
[ "$failed" = 0 ]
