#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# aim_test.sh PROGRAM: a host in C makes every call of betwixt/aim.h to a server. When it has disconnected, its
# animations continue, and the server's history is a film. The same calls in Python give the same history.
# shows: C16 C35 C36 C37 C38 C39 C40 C66 C73 C88 C97 C101
root=$(cd -- "$(dirname -- "$0")/../.." && pwd)
. "$(dirname -- "$0")/support.sh" || exit 3
yes() { [ "$1" = 0 ] && echo yes; }
cc -Wall -Wextra -Werror -I "$root/include" -c "$root/tests/app/aim_host.c" -o host.o &&
  c++ -std=c++20 -DFMT_SHARED -I "$root/include" -I "$root/src" host.o "$root"/src/server/aim*.cpp "$root"/src/syntax/*.cpp -lfmt -lm -o host
verdict 'a host is built from C' "$(yes $?)" ''
begin --socket "$work/s" --save history.bx
./host "$work/s" >answers 2>&1
verdict 'every call is answered as it should be' "$(yes $?)" "$(cat answers)"
end
is 'the server ends when it is told to' "$code" 0
"$program" check history.bx >checked 2>&1
verdict 'its history is a script' "$(yes $?)" "$(cat checked)"
has 'what the host said stands in the history' "$(cat history.bx)" 'every 1t by matrix('
begin --socket "$work/s" --save python.bx
PYTHONPATH=$root/clients/python PYTHONDONTWRITEBYTECODE=1 timeout 60 python3 "$root/tests/app/aim_host.py" "$work/s" >answers 2>&1
is 'the same calls in Python' "$?$(cat answers)" 0
end
# Only the ticks of the commands may differ.
timeless() { sed -E 's/\b[0-9]+t animate/NOW animate/; s/^at [0-9]+t/at NOW/; s/(since|from|until) [0-9]+t/\1 THEN/g' "$1"; }
is 'and the same history' "$(timeless python.bx)" "$(timeless history.bx)"
summary
