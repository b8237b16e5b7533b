#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Compares imported SVG drawings with pictures of rsvg-convert.
#   svg_test.sh PROGRAM
tests=$(realpath -- "$(dirname -- "$0")")
. "$tests/support.sh" || exit 3
export LC_ALL=C.UTF-8

pixels() { ffmpeg -v error -i "$1" -f rawvideo -pix_fmt rgb24 - >"$2"; } # PICTURE FILE

# same NAME FILE WIDTHxHEIGHT: checks that at most 1 in 100 pixels differs.
same() {
  cp "$2" drawing.svg
  printf '%s\n' "size $3" 'film flat' 'background white' 'samples 16' 'create d scene file="drawing.svg"' \
    'create eye camera height=1 position=(0 0 10)' >film.bx
  "$program" frame film.bx --at 1f -o ours.png >said 2>&1 || cat said
  rsvg-convert -b white -w "${3%x*}" -h "${3#*x}" drawing.svg -o theirs.png
  pixels ours.png ours.rgb && pixels theirs.png theirs.rgb
  is "$1" "$(python3 "$tests/svg_pixels.py" ours.rgb theirs.rgb "${3%x*}")" well
}
for drawing in "$tests"/../drawings/*.svg "$tests"/../../examples/drawings/*.svg; do
  size=$(head -c 2000 "$drawing" | tr '\n' ' ' | sed -E 's/.*<svg[^>]* width="([0-9]+)" height="([0-9]+)".*/\1x\2/')
  same "$(basename "$drawing") looks as elsewhere" "$drawing" "$size"
done
summary
