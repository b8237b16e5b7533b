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
root=$(cd -P -- "$(dirname -- "$0")/.." && pwd)
minutes=${1:-10} program=$(realpath -- "${2:-$root/build/release/bin/betwixt}")
export PYTHONPATH=$root/clients/python PYTHONDONTWRITEBYTECODE=1
ulimit -n 8192 2>/dev/null
exec python3 "$root/tools/abuse.py" "$program" "$minutes"
