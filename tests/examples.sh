#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# examples.sh PROGRAM: renders every example small; each film must hold as many frames as its range says.
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
program=$1 folder=$(mktemp -d) passed=0 failed=0
trap 'rm -rf "$folder"' EXIT
for script in "$root"/examples/*.bx; do
  name=$(basename "$script" .bx) film=$folder/$name.mp4
  # `range 1f 72f`; the range ends before a comment.
  expected=$(sed -nE 's/^range +([0-9]+)f +([0-9]+)f.*/\2-\1+1/p' "$script" | tail -n 1)
  if ! "$program" render "$script" -o "$film" --size 320x180 >"$folder/said" 2>&1; then
    said=$(tail -n 5 "$folder/said")
  else
    said=$(ffprobe -v error -select_streams v -count_frames -show_entries stream=nb_read_frames,width,height -of csv=p=0 "$film")
    [ "$said" != "320,180,$((${expected:-0}))" ] || said=
  fi
  if [ -z "$said" ]; then
    passed=$((passed + 1))
  else
    printf 'FAILED %s: expected 320,180,%s (width, height, frames)\n%s\n' "$name" "$((${expected:-0}))" "$said"
    failed=$((failed + 1))
  fi
done
printf '%d passed, %d failed\n' "$passed" "$failed"
[ "$failed" = 0 ]
