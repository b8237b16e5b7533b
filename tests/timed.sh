# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Source this file. timed NAME: records the time since the last call, for the list of the slowest that ./test prints.
timed_last=${EPOCHREALTIME/[.,]/}
timed() {
  local now=${EPOCHREALTIME/[.,]/} took
  took=$((now - timed_last)) timed_last=$now
  [ -z "${BETWIXT_TIMES-}" ] ||
    printf '%d.%03d\t%s: %s\n' $((took / 1000000)) $((took / 1000 % 1000)) "${0##*/}" "$1" >>"$BETWIXT_TIMES"
}
