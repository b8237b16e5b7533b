#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# run.sh BUILD: installs the build into an empty folder and uses it as another project would.
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
folder=$(mktemp -d) passed=0 failed=0
trap 'rm -rf "$folder"' EXIT
. "$here/../timed.sh"
verdict() {
  timed "$1"
  if [ "$2" = "$3" ]; then
    passed=$((passed + 1))
  else
    printf 'FAILED %s: expected %s, got %s\n' "$1" "$3" "$2"
    failed=$((failed + 1))
  fi
}

cmake --install "$1" --prefix "$folder/to" >"$folder/log" 2>&1 || tail -n 5 "$folder/log"
# Moves the installation: no file may depend on its folder.
mv "$folder/to" "$folder/prefix"
for file in bin/betwixt bin/betwixt-farm libexec/betwixt/betwixt-parser include/betwixt/language.h share/man/man1/betwixt.1 share/bash-completion/completions/betwixt \
  lib/pkgconfig/betwixt.pc share/doc/libbetwixt-dev/examples/still.cpp share/doc/betwixt/guide/events.md share/doc/betwixt/pictures/bounce.gif \
  share/zsh/site-functions/_betwixt share/fish/vendor_completions.d/betwixt.fish share/doc/betwixt/LICENSE \
  share/betwixt/examples/bounce.bx share/betwixt/python/betwixt_client.py; do
  verdict "is installed: $file" "$(ls "$folder/prefix/$file" 2>&1)" "$folder/prefix/$file"
done
{ cmake -S "$here" -B "$folder/build" -G Ninja -DCMAKE_PREFIX_PATH="$folder/prefix" && cmake --build "$folder/build"; } \
  >"$folder/log" 2>&1 || grep -v '^-- ' "$folder/log" | tail -n 30
verdict "a stranger's program" "$("$folder/build/stranger" 2>&1)" "2 4 -1
ball.position
1f
25f linear"
# The example of the package and of README.md, without CMake.
verdict "README.md shows the example" "$(sed 1,2d "$here/../../packaging/example/still.cpp" | python3 -c 'import sys; print(sys.stdin.read() in open(sys.argv[1]).read())' "$here/../../README.md")" True
libraries=$(PKG_CONFIG_PATH="$folder/prefix/lib/pkgconfig" pkg-config --cflags --libs betwixt 2>&1)
# shellcheck disable=SC2086 # it is several words
g++ "$folder/prefix/share/doc/libbetwixt-dev/examples/still.cpp" -o "$folder/still" $libraries >"$folder/log" 2>&1 || tail -n 5 "$folder/log"
verdict "the example, with pkg-config" "$(cd "$folder" && cp prefix/share/betwixt/examples/bounce.bx . && ./still && file -b still.png | cut -c 1-25)" "PNG image data, 640 x 360"
verdict "the installed program" \
  "$("$folder/prefix/bin/betwixt" eval "$folder/prefix/share/betwixt/examples/bounce.bx" --at 12f ball.position.y --json |
    sed -E 's/.*"ball.position.y":([^}]*).*/\1/')" "1"
# Files that crash the parser process. It is found wherever the folder was moved. Without it, valid files are still
# read.
{ printf '; FBX 7.4.0 project file\n' && printf 'A: {%.0s' {1..50000}; } >"$folder/deep.fbx"
printf 'create m mesh file="deep.fbx"\n' >"$folder/deep.bx"
verdict "a damaged mesh" "$("$folder/prefix/bin/betwixt" check "$folder/deep.bx" 2>&1 | grep -o 'is damaged.*')" \
  "is damaged: the program that reads it crashed"
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >"$folder/good.obj"
printf 'create m mesh file="good.obj"\n' >"$folder/good.bx"
verdict "a mesh without a parser" "$(BETWIXT_PARSER=/none "$folder/prefix/bin/betwixt" check "$folder/good.bx" >/dev/null 2>&1 && echo fine)" fine
verdict "the installed client" "$(cd / && PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$folder/prefix/share/betwixt/python \
  python3 -c 'import betwixt_client; print(betwixt_client.__file__)' 2>&1)" "$folder/prefix/share/betwixt/python/betwixt_client.py"
verdict "the manual page" "$(groff -man -ww -z "$folder/prefix/share/man/man1/betwixt.1" 2>&1)" ""
# The manual page and the completions know all options of --help.
prefix=$folder/prefix
for command in render play frame eval plot check tidy algebra shell; do
  for option in $("$prefix/bin/betwixt" "$command" --help | grep -oE -- '--[a-z-]+' | sort -u); do
    for file in man/man1/betwixt.1 bash-completion/completions/betwixt zsh/site-functions/_betwixt \
      fish/vendor_completions.d/betwixt.fish; do
      [ "$option" != --help ] || continue
      verdict "$command $option is in $file" \
        "$(sed 's/\\-/-/g; s/-l \([a-z]\)/--\1/g' "$prefix/share/$file" | grep -oF -m 1 -e "$option" | head -n 1)" "$option"
    done
  done
done
printf '%d passed, %d failed\n' "$passed" "$failed"
[ "$failed" = 0 ]
