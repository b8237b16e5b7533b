#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# compare.sh: makes the scenes of the tests and the numbers of three.js again, and lists differences from the
# repository.
root=$(cd -P -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
peers=$root/build/peers scenes=$root/tests/commands/data/scenes
for program in node npm python3; do
  command -v "$program" >/dev/null || { echo "there is no $program" >&2; exit 3; }
done
mkdir -p "$peers" && cp "$root"/tests/peers/{package.json,package-lock.json,scenes.mjs} "$peers" && cd "$peers" || exit 3
npm ci --no-audit --no-fund >npm.log 2>&1 || { cat npm.log >&2; exit 3; }
/usr/bin/python3 "$root/tests/peers/scenes.py" || exit 3
node scenes.mjs "$scenes"/{skin,morph,cubic,step}.glb "$root/examples/meshes/figure.glb" "$scenes/bones.bvh" >three.txt || exit 3
if cmp -s three.txt "$scenes/three.txt"; then
  echo "three.js has everything where the tests say"
else
  echo "three.js has it elsewhere: compare $peers/three.txt with $scenes/three.txt" >&2
  exit 1
fi
