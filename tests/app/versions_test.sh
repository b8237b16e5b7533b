#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# versions_test.sh PROGRAM: films of older versions still load, and have the values that the tests of those versions
# demanded (docs/compatibility.md).
program=$(realpath -- "$1")
cd -- "$(dirname -- "$0")/../versions" || exit 3
said=$("$program" test . 2>&1)
status=$?
films=$(find . -name '*.expect' | wc -l)
[ "$status" = 0 ] && [ "$films" -ge 4 ] && { echo "$films passed, 0 failed"; exit; }
printf '%s\n%d passed, 1 failed\n' "$said" 0
exit 1
