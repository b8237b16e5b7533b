#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# The imaging server under abuse: random bytes, half commands, lines of a gigabyte, crowds, strangers without a token, lines
# and code that take long, damaged files, pipes, clients killed in mid-command. All the time one well-behaved host looks
# whether its frames come when they should, whether its answers are right, and how long it waits for them; before that, alone.
# Once a minute frames themselves take long for a while, then the abuse rests, and what the server's memory holds then is
# printed: it fails where that grows steadily.
#   tools/abuse.sh [MINUTES] [PROGRAM]
#   tools/abuse.sh lines [FROM-TO] [PROGRAM]
# With `lines` it is one hostile line after the other, each said to a server of its own, and then at other doors: how many
# frames were missed, how long another host waited, how long the end took after SIGTERM, the most memory, and whether the
# film is the same after a restart. FROM-TO are numbers of lines in abuse_cases.py, such as 1-20.
root=$(cd -P -- "$(dirname -- "$0")/.." && pwd)
export PYTHONPATH=$root/clients/python PYTHONDONTWRITEBYTECODE=1
ulimit -n 8192 2>/dev/null
what=$1
[ "$what" != lines ] || shift
program=$(realpath -- "${2:-$root/build/release/bin/betwixt}")
[ "$what" != lines ] || exec python3 "$root/tools/abuse_lines.py" "$program" "${1:--}"
exec python3 "$root/tools/abuse.py" "$program" "${1:-10}"
