#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# The gallery and the tutorial as pages in which all films play and can be edited: build/pages/gallery.html, tutorial.html.
#   tools/pages.sh [PROGRAM [FOLDER]]    ./betwixt is the program if none is said; it builds what plays first
root=$(cd -P -- "$(dirname -- "$0")/.." && pwd)
program=${1:-$root/betwixt} folder=${2:-$root/build/pages}
mkdir -p "$folder" || exit 3
films=()
while read -r name; do films+=("$root/examples/$name.bx"); done < <(sed -nE 's/^## ([a-z-]+)$/\1/p' "$root/docs/gallery.md")
"$program" web "${films[@]}" -o "$folder/gallery.html" --link --title 'Gallery' || exit
python3 "$root/tools/tutorial_page.py" "$program" "$folder/tutorial.html"
