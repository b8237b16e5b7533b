#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests `betwixt lsp` through its pipes, as an editor uses it.
#   lsp_test.sh PROGRAM
here=$(cd -- "$(dirname -- "$0")" && pwd)
. "$here/support.sh" || exit 3

timeout 120 python3 "$here/lsp_cases.py" "$program" "$work" >cases
is 'all cases were tried' $? 0
while IFS=$'\t' read -r name got why; do verdict "$name" "$got" "$why"; done <cases

summary
