#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Kills servers and shells, and cuts their journals: a short run of tools/kills.py.
#   log_test.sh PROGRAM [ROUNDS] [SEED]
# shows: G22
root=$(cd -- "$(dirname -- "$0")/../.." && pwd)
. "$(dirname -- "$0")/support.sh" || exit 3
exec python3 "$root/tools/kills.py" "$program" "${2:-8}" "${3:-1}"
