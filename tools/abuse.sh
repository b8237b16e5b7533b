#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests the imaging server among hostile clients. They send random bytes, half commands and lines of a gigabyte; they
# connect by the hundred or without a token; they send slow lines and code, and name damaged files and pipes; they are
# killed in mid-command. A well-behaved host checks all the time that its frames come on time and that its answers are
# right, and measures how long it waits for them. Before the abuse it measures the same alone. Once a minute the frames
# themselves take long for some seconds. Then the abuse pauses, and the test prints the server's memory. It fails if the
# memory keeps growing.
#   tools/abuse.sh [MINUTES] [PROGRAM]
#   tools/abuse.sh lines [FROM-TO] [PROGRAM]
# `lines` sends each hostile line of abuse_cases.py to a server of its own, and gives hostile input to other commands of
# the program. It prints how many frames were missed, how long another host waited, how long the server took to end
# after SIGTERM, its peak memory, and whether the film is the same after a restart. FROM-TO are numbers of lines in
# abuse_cases.py, such as 1-20.
root=$(cd -P -- "$(dirname -- "$0")/.." && pwd)
export PYTHONPATH=$root/clients/python PYTHONDONTWRITEBYTECODE=1
ulimit -n 8192 2>/dev/null
what=$1
[ "$what" != lines ] || shift
program=$(realpath -- "${2:-$root/build/release/bin/betwixt}")
[ "$what" != lines ] || exec python3 "$root/tools/abuse_lines.py" "$program" "${1:--}"
exec python3 "$root/tools/abuse.py" "$program" "${1:-10}"
