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

betwixt_film() {
  timed "$program" render "$here/spheres.bx" -o "$folder/a.mp4" --size 960x540 --stats
  note betwixt.process "$wall"
  # painting P s (… ms a frame), encoding E s (…), in all A ms a frame
  sed -nE 's/.*painting .*\(([0-9.]+) ms.*encoding .*\(([0-9.]+) ms.*in all ([0-9.]+) ms.*/\1 \2 \3/p' "$folder/said" >"$folder/parts"
  read -r painting encoding all <"$folder/parts"
  echo "$painting" >>"$folder/betwixt.pictures"
  echo "$encoding" >>"$folder/betwixt.encoding"
  echo "$all" >>"$folder/betwixt.film"
}

# workbench MODE SAMPLES
workbench() {
  timed blender -b -P "$here/spheres_blender.py" -- "$1" "$2" "$folder/b.mp4"
  note "workbench-$2.$1" "$(sed -nE 's/^SECONDS frames 48 spheres 200 seconds //p' "$folder/said")"
  [ "$1" != film ] || note "workbench-$2.process" "$wall"
}

for ((i = 0; i < times; i++)); do
  betwixt_film
  workbench film 8
  betwixt_film
  workbench pictures 8
  betwixt_film
  workbench pictures 5
  betwixt_film
  workbench pictures OFF
  printf '.' >&2
done
echo >&2

# summary WHAT: minimum and median.
summary() { sort -n "$folder/$1" | awk '{ v[NR] = $1 } END { print v[1], v[int((NR + 1) / 2)] }'; }
for film in a b; do
  echo "$film.mp4: $(ffprobe -v error -count_frames -show_entries stream=codec_name,width,height,nb_read_frames -of csv=p=0 "$folder/$film.mp4")"
done
printf '%-36s %9s %9s   %s\n' "ms a frame, 200 spheres, 960x540" minimum median "times betwixt (minimum, median)"
row() {
  read -r least median < <(summary "$1")
  read -r own_least own_median < <(summary "betwixt.${1##*.}")
  awk -v w="$1" -v a="$least" -v b="$median" -v c="$own_least" -v d="$own_median" \
    'BEGIN { printf "%-36s %9.1f %9.1f   %.1f %.1f\n", w, a, b, a / c, b / d }'
}
for what in betwixt.{pictures,encoding,film,process} workbench-{8,5,OFF}.pictures workbench-8.{film,process}; do row "$what"; done
