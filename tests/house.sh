#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Checks the rules of the house: no room (folder of src/) includes a lower room, public headers include no third party,
# every file has its licence and its format, every item of tests/coverage.txt has a test, all links of the pages have a
# target, and the texts are plain.
# shows: C106
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." || exit 3
rooms=(base syntax algebra track scene program procedure exchange language commands editor compare export render film playback lsp server app studio)
passed=0 failed=0
# verdict WHAT FINDINGS: passes if FINDINGS is empty.
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
# A public header names its room ("// Room: scene") and is implemented there. A header of base may have no source file.
declare -A level public
for i in "${!rooms[@]}"; do level[${rooms[i]}]=$i; done
for header in include/betwixt/*.h; do
  room=$(sed -n 's/^[/ *]*Room: \([a-z]*\)$/\1/p' "$header")
  public[${header##*/}]=${level[${room:-none}]-99}
  verdict "$header names no known room" "$([ -n "${level[${room:-none}]-}" ] || echo "Room: $room")"
  verdict "$header is not implemented in $room" "$([ "$room" = base ] ||
    grep -qrE "include \"betwixt/${header##*/}\"" "src/$room" $(grep -lx "// Room: $room" include/betwixt/*) || echo "$header")"
done
verdict "a room includes the public header of a lower one" "$(
  grep -rnE '^\s*#\s*include\s*["<]betwixt/' src include | while IFS=: read -r file line include; do
    header=${include#*betwixt/} header=${header%%[\">]*} room=${file#src/}
    here=${level[${room%%/*}]-${public[${file##*/}]}}
    [ "${public[$header]-99}" -le "$here" ] || echo "$file:$line: $header"
  done
)"
verdict "a room that is not in the list of this script" \
  "$(find src -mindepth 1 -maxdepth 1 | grep -vxE "src/($(IFS='|' && printf '%s' "${rooms[*]}"))")"
verdict "a room includes by a path that goes up" "$(grep -rnE '^\s*#\s*include\s*"[^"]*\.\./' src include)"
# Headers of the standard library have no dot and no slash in their names.
verdict "a public header includes a third party" \
  "$(grep -rnE '^\s*#\s*include' include | grep -vE 'include\s*(<[a-z0-9_]+>|<stddef\.h>|"betwixt/[a-z_]+\.h")')"
verdict "using namespace in a header" "$(grep -rnE '^\s*using namespace' --include='*.h' src include)"
# Two types of one name are the same to the linker, which may call the function of one for the other.
verdict "two types of one name in one namespace" "$(
  find src include -name '*.h' | while read -r file; do
    space=$(sed -n 's/^namespace \([a-z_:]*\) {$/\1/p' "$file" | head -n 1)
    sed -nE "s/^(struct|class) ([A-Za-z0-9]+)( final)?( : .*)? \{.*/$space \2/p" "$file"
  done | sort | uniq -d
)"
# Headers that take long to compile are included only once.
verdict "only one file includes the library of command lines" \
  "$(grep -rlE '^\s*#\s*include\s*<CLI/' src | grep -vx src/app/command_line.cpp)"
verdict "only three files include the library for JSON" \
  "$(grep -rlE '^\s*#\s*include\s*<nlohmann/' src | grep -vxE 'src/(server/aim_host\.h|export/json\.h|exchange/table_json\.cpp)')"
verdict "a script that is not executable" "$(find tests tools clients -name '*.sh' ! -perm -u+x ! -name setup.sh ! -name support.sh ! -name timed.sh ! -name counts.sh)"
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
# Checks only the files that have changed since all were formatted correctly.
laid_out=build/laid-out
begun=$(mktemp)
changed=(-newer "$laid_out")
[ "$laid_out" -nt .clang-format ] || changed=()
verdict "a file that is not formatted by .clang-format (tools/format.sh does it)" "$(
  find include src python tests bench web -type f \( -name '*.h' -o -name '*.cpp' \) "${changed[@]}" -print0 |
    xargs -0 -r -n 50 -P "$(nproc)" clang-format --dry-run 2>&1 | sed -nE 's/^([^: ]+):[0-9]+:.*/\1/p' | sort -u
)"
[ "$failed" != 0 ] || { mkdir -p build && mv "$begun" "$laid_out"; }
rm -f "$begun"
verdict "a file of src with more than 400 lines (catalogues of texts may be longer)" \
  "$(find src -type f ! -name "*.po" -exec wc -l {} + | awk '$1 > 400 && $2 != "total" { print $2 ": " $1 }')"
verdict "a link of a page without a target (tests/links.py)" "$(python3 tests/links.py)"
installed=$(mktemp -d)
cmake -DSOURCE="$PWD" -DFOLDER="$installed" -DEXAMPLES="$PWD/examples" -P cmake/docs.cmake >/dev/null 2>&1
verdict "a link of an installed page without a target" "$(BETWIXT_PAGES=$installed python3 tests/links.py)"
rm -r "$installed"
verdict "phrases that are hard to read (tests/plain_words.py)" "$(python3 tests/plain_words.py)"
verdict "items without a test (tests/coverage.txt)" "$(tools/coverage.sh --check 2>&1)"
printf '%d passed, %d failed\n' "$passed" "$failed"
[ "$failed" = 0 ]
