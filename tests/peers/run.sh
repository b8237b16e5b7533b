#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests exported files with the programs that read them. npm installs these programs into build/peers.
#   run.sh PROGRAM [NAME…]    runs all tests, or only tests/peers/NAME.py
#   run.sh --install          only installs the programs
root=$(cd -P -- "$(dirname -- "$0")/../.." && pwd)
. "$root/tools/setup.sh"
. "$root/tests/counts.sh"
program=$1 peers=$root/build/peers
shift
command -v npm >/dev/null || need "$root/tools/peers-packages.txt"
mkdir -p "$peers" && cp -u "$root"/tests/peers/* "$peers" || exit 3
if ! cmp -s "$peers/package-lock.json" "$peers/node_modules/.installed"; then
  (cd "$peers" && npm ci --ignore-scripts --no-audit --no-fund >npm.log 2>&1) || {
    tail -n 5 "$peers/npm.log"
    echo "left out: npm cannot install what these tests ask"
    echo "0 passed, 0 failed"
    exit 0
  }
  # The file is a module but not marked as one, which older versions of node need.
  python3 - "$peers/node_modules/tinyusdz/package.json" <<'PY'
import json, sys
package = json.load(open(sys.argv[1]))
package["type"] = "module"
json.dump(package, open(sys.argv[1], "w"))
PY
  cp "$peers/package-lock.json" "$peers/node_modules/.installed"
fi
[ "$program" != --install ] || exit 0
program=$(realpath -- "$program")
[ $# -gt 0 ] || set -- gltf usda lottie drawings looks colors web typescript editor
passed=0 failed=0
for script; do count "" /usr/bin/python3 "$root/tests/peers/$script.py" "$program" "$peers"; done
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
