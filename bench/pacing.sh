#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Measures how evenly the imaging server makes frames at 120 Hz beside four busy processes, while its host is stopped
# (SIGSTOP), for each class of scheduling. Compares with a loop that the host runs itself (clear; rotate; draw).
#   bench/pacing.sh [PROGRAM] [FRAMES]
root=$(cd -P -- "$(dirname -- "$0")/.." && pwd)
program=$(realpath -- "${1:-$root/build/release/bin/betwixt}") frames=${2:-10000}
export PYTHONPATH=$root/clients/python PYTHONDONTWRITEBYTECODE=1
exec python3 "$root/bench/pacing.py" "$program" "$frames"
