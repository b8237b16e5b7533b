# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Helpers of the tests of the command line. Each test sources this file with its own arguments; $program is the first of
# them. The test then runs in an empty folder, $work. It is removed at the end, with all files next to it whose names
# begin with its name and a dot. A test ends with `summary`.
set -u
program=$(realpath -- "${1:?which program?}") || exit 3
[ -x "$program" ] || { echo "there is no program $program" >&2; exit 3; }
work=$(mktemp -d)
trap 'umount "$work/disk" 2>/dev/null; rm -rf "$work" "$work".*' EXIT # $work/disk: a small disk, where one was mounted
. "$(dirname -- "${BASH_SOURCE[0]}")/../timed.sh"
cd "$work" || exit 3
passed=0 failed=0

verdict() { # NAME yes|… EXPLANATION
  timed "$1"
  if [ "$2" = yes ]; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    printf 'FAILED %s: %s\n' "$1" "$3"
  fi
}
is() { verdict "$1" "$([ "$2" = "$3" ] && echo yes)" "'$2' is not '$3'"; }                       # NAME VALUE WANTED
has() { verdict "$1" "$([[ $2 == *"$3"* ]] && echo yes)" "'$3' is not in: $(tail -c 600 <<<"$2")"; } # NAME TEXT PART
# Runs the program, and keeps its output and its exit code.
check() { # NAME EXIT-CODE TEXT ARGUMENT…
  local name=$1 code=$2 text=$3
  shift 3
  said=$("$program" "$@" 2>&1 </dev/null)
  local got=$?
  verdict "$name" "$([ $got = "$code" ] && [[ $said == *"$text"* ]] && echo yes)" "exit code $got (not $code?), said: $said"
}
begin() { # OPTIONS…: a server, once it listens
  : >log
  "$program" serve "$@" 2>log &
  server=$!
  for _ in {1..200}; do
    grep -q '^serving at' log && return
    kill -0 $server 2>/dev/null || break
    sleep 0.05
  done
  cat log >&2
}
end() { # [SIGNAL]
  kill "-${1:-TERM}" $server
  wait $server
  code=$?
}
# Prints the line that ./test reads, and fails if a check has failed.
summary() {
  printf '%d passed, %d failed\n' "$passed" "$failed"
  [ "$failed" = 0 ]
}
