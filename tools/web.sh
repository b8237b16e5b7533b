#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# web.sh: builds the engine for web pages (build/web/betwixt.js and betwixt.wasm), the player and the other files that
# contain it. tools/web-packages.txt lists the packages that it needs.
set -e
root=$(cd -P -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
out=$root/build/web
mkdir -p "$out"
"$root/tools/web-sources.sh" "$out/sources"
export NODE_PATH=/usr/share/nodejs
version=$(sed -nE 's/^project\(betwixt VERSION ([0-9.]+).*/\1/p' "$root/CMakeLists.txt")
[ -f "$out/build.ninja" ] || emcmake cmake -G Ninja -S "$root/web" -B "$out" -DCMAKE_BUILD_TYPE=None \
  -DBETWIXT_VERSION="$version" >"$out/log" 2>&1 || { cat "$out/log" >&2; exit 3; }
ninja -C "$out" "$@"
python3 "$root/web/put_together.py" "$out" "$version"
