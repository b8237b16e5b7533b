#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# The rules of the house: no room includes a lower one, public headers include no third party, every file has its licence
# and its layout, every item has a test, the links of the pages lead somewhere, and the prose is plain.
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." || exit 3
rooms=(base syntax algebra track scene program procedure exchange language commands editor export render film playback lsp server app studio)
passed=0 failed=0
# verdict WHAT FINDINGS: passes where there are no findings.
verdict() {
  if [ -z "$2" ]; then
    passed=$((passed + 1))
  else
    printf 'FAILED %s\n%s\n' "$1" "$2"
    failed=$((failed + 1))
  fi
}
files() { find include src python tests bench web -type f \( -name '*.h' -o -name '*.cpp' \); }

for i in "${!rooms[@]}"; do
  lower=$(IFS='|' && printf '%s' "${rooms[*]:i+1}")
  [ -n "$lower" ] || continue
  verdict "src/${rooms[i]} includes a lower room" \
    "$(grep -rnE "^\s*#\s*include\s*[<\"](\.\./|src/)*($lower)/" "src/${rooms[i]}")"
done
# A public header says its room ("// Room: scene"), and is made there; what base needs may stand in the header alone.
declare -A level public
for i in "${!rooms[@]}"; do level[${rooms[i]}]=$i; done
for header in include/betwixt/*.h; do
  room=$(sed -n 's/^[/ *]*Room: \([a-z]*\)$/\1/p' "$header")
  public[${header##*/}]=${level[${room:-none}]-99}
  verdict "$header says no room of the house" "$([ -n "${level[${room:-none}]-}" ] || echo "Room: $room")"
  verdict "$header is not made in $room" "$([ "$room" = base ] ||
    grep -qrE "include \"betwixt/${header##*/}\"" "src/$room" $(grep -lx "// Room: $room" include/betwixt/*) || echo "$header")"
done
verdict "a room includes the public header of a lower one" "$(
  grep -rnE '^\s*#\s*include\s*["<]betwixt/' src include | while IFS=: read -r file line include; do
    header=${include#*betwixt/} header=${header%%[\">]*} room=${file#src/}
    here=${level[${room%%/*}]-${public[${file##*/}]}}
    [ "${public[$header]-99}" -le "$here" ] || echo "$file:$line: $header"
  done
)"
verdict "a room that the house does not know" \
  "$(find src -mindepth 1 -maxdepth 1 | grep -vxE "src/($(IFS='|' && printf '%s' "${rooms[*]}"))")"
verdict "a room includes by a path that goes up" "$(grep -rnE '^\s*#\s*include\s*"[^"]*\.\./' src include)"
# Headers of the standard have no dot and no slash in their names.
verdict "a public header includes a third party" \
  "$(grep -rnE '^\s*#\s*include' include | grep -vE 'include\s*(<[a-z0-9_]+>|<stddef\.h>|"betwixt/[a-z_]+\.h")')"
verdict "using namespace in a header" "$(grep -rnE '^\s*using namespace' --include='*.h' src include)"
# Two of one name are one to whoever links them, and what is made for the one is done to the other.
verdict "two types of one name in one namespace" "$(
  find src include -name '*.h' | while read -r file; do
    space=$(sed -n 's/^namespace \([a-z_:]*\) {$/\1/p' "$file" | head -n 1)
    sed -nE "s/^(struct|class) ([A-Za-z0-9]+)( final)?( : .*)? \{.*/$space \2/p" "$file"
  done | sort | uniq -d
)"
# What is dear to include is included once.
verdict "one file sees the library of command lines" \
  "$(grep -rlE '^\s*#\s*include\s*<CLI/' src | grep -vx src/app/command_line.cpp)"
verdict "two files see the library for JSON" \
  "$(grep -rlE '^\s*#\s*include\s*<nlohmann/' src | grep -vxE 'src/(server/aim_host\.h|export/json\.h)')"
verdict "a script that cannot be called" "$(find tests tools clients -name '*.sh' ! -perm -u+x ! -name setup.sh ! -name support.sh ! -name timed.sh)"
verdict "a file without its licence" "$(
  files | while read -r file; do
    [ "$(head -n 2 "$file")" = "// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0" ] || echo "$file"
  done
  find betwixt test .ci tools cmake python tests bench CMakeLists.txt -type f \
    \( -name '*.sh' -o -name '*.cmake' -o -name '*.py' -o -name CMakeLists.txt -o ! -name '*.*' \) |
    while read -r file; do
      head -n 3 "$file" | grep -q '^# SPDX-License-Identifier: Apache-2.0$' || echo "$file"
    done
)"
# Of the files that have changed since all were in order.
laid_out=build/laid-out
begun=$(mktemp)
changed=(-newer "$laid_out")
[ "$laid_out" -nt .clang-format ] || changed=()
verdict "a file that is not laid out as .clang-format says (tools/format.sh does it)" "$(
  find include src python tests bench web -type f \( -name '*.h' -o -name '*.cpp' \) "${changed[@]}" -print0 |
    xargs -0 -r -n 50 -P "$(nproc)" clang-format --dry-run 2>&1 | sed -nE 's/^([^: ]+):[0-9]+:.*/\1/p' | sort -u
)"
[ "$failed" != 0 ] || { mkdir -p build && mv "$begun" "$laid_out"; }
rm -f "$begun"
verdict "a link of a page that leads nowhere (tests/links.py)" "$(python3 tests/links.py)"
verdict "turns of phrase that are hard to read (tests/plain_words.py)" "$(python3 tests/plain_words.py)"
verdict "what the tests show" "$(tools/coverage.sh --check 2>&1)"
printf '%d passed, %d failed\n' "$passed" "$failed"
[ "$failed" = 0 ]
