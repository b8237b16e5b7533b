#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Makes web pages of the gallery and the tutorial in which all films play and can be edited: build/pages/gallery.html
# and build/pages/tutorial.html.
#   tools/pages.sh [PROGRAM [FOLDER]]    the default of PROGRAM is ./betwixt, which first builds the player for pages
root=$(cd -P -- "$(dirname -- "$0")/.." && pwd)
program=${1:-$root/betwixt} folder=${2:-$root/build/pages}
mkdir -p "$folder" || exit 3
films=()
while read -r name; do films+=("$root/examples/$name.bx"); done < <(sed -nE 's/^## ([a-z-]+)$/\1/p' "$root/docs/gallery.md")
"$program" web "${films[@]}" -o "$folder/gallery.html" --link --title 'Gallery' || exit
python3 "$root/tools/tutorial_page.py" "$program" "$folder/tutorial.html"
