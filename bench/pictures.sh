#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# pictures.sh [TIMES]: 200 spheres in Betwixt and in Blender's Workbench, in turns; see README.md.
here=$(cd -P -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
times=${1:-5} frames=48
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
command -v blender >/dev/null || { echo "pictures.sh: blender is missing: apt-get install blender" >&2; exit 3; }
"$here/../betwixt" --version >&2 || exit 3
program=$here/../build/release/bin/betwixt

# note WHAT SECONDS: one measurement, in milliseconds a frame.
note() { awk -v s="$2" -v n=$frames 'BEGIN { print 1000 * s / n }' >>"$folder/$1"; }

# timed COMMAND…: its wall-clock seconds in $wall, what it said in $folder/said.
timed() {
  local begun=$EPOCHREALTIME
  "$@" >"$folder/said" 2>&1 || { cat "$folder/said" >&2; exit 3; }
  wall=$(awk -v a="$begun" -v b="$EPOCHREALTIME" 'BEGIN { print b - a }')
}

# betwixt_film SCRIPT NAME SAMPLES
betwixt_film() {
  timed "$program" render "$here/$1" -o "$folder/a.mp4" --size 960x540 --samples "$3" --stats
  # painting P s (… ms a frame), encoding E s (…), in all A ms a frame
  read -r painting encoding all < <(sed -nE \
    's/.*painting .*\(([0-9.]+) ms.*encoding .*\(([0-9.]+) ms.*in all ([0-9.]+) ms.*/\1 \2 \3/p' "$folder/said")
  echo "$painting" >>"$folder/$2-$3.pictures"
  echo "$encoding" >>"$folder/$2-$3.encoding"
  echo "$all" >>"$folder/$2-$3.film"
  [ "$2" != betwixt ] || note "$2-$3.process" "$wall"
}

# workbench MODE SAMPLES
workbench() {
  timed blender -b -P "$here/spheres_blender.py" -- "$1" "$2" "$folder/b.mp4"
  note "workbench-$2.$1" "$(sed -nE 's/^SECONDS frames 48 spheres 200 seconds //p' "$folder/said")"
  [ "$1" != film ] || note "workbench-$2.process" "$wall"
}

for ((i = 0; i < times; i++)); do
  for samples in 8 5 OFF; do
    for mode in pictures film; do
      betwixt_film spheres.bx betwixt 4
      betwixt_film spheres.bx betwixt 1
      workbench $mode $samples
    done
  done
  betwixt_film ../examples/menagerie.bx menagerie 4
  printf '.' >&2
done
echo >&2

# summary WHAT: minimum and median.
summary() { sort -n "$folder/$1" | awk '{ v[NR] = $1 } END { print v[1], v[int((NR + 1) / 2)] }'; }
echo "b.mp4: $(ffprobe -v error -count_frames -show_entries stream=codec_name,width,height,nb_read_frames -of csv=p=0 "$folder/b.mp4")"
printf '%-28s %9s %9s   %s\n' "ms a frame, 960x540" minimum median "times betwixt's (minimum, median)"
# row WHAT [OWN]: beside our own where given.
row() {
  read -r least median < <(summary "$1")
  read -r own_least own_median < <(summary "${2:-$1}")
  awk -v w="$1" -v o="${2-}" -v a="$least" -v b="$median" -v c="$own_least" -v d="$own_median" 'BEGIN {
    printf "%-28s %9.1f %9.1f", w, a, b
    if (o != "") printf "   %4.1f %4.1f  (%s)", a / c, b / d, o
    print ""
  }'
}
for samples in 4 1; do
  for what in pictures encoding film process; do row betwixt-$samples.$what; done
done
for samples in 8 5 OFF; do
  own=betwixt-4
  [ $samples != OFF ] || own=betwixt-1
  for what in pictures film process; do row workbench-$samples.$what $own.$what; done
done
for what in pictures encoding film; do row menagerie-4.$what; done
