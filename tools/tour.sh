#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Makes the pictures of docs/tour/tour.bx, a tour of the studio of two minutes. They show a film that grows line by
# line.
#   tools/tour.sh PROGRAM [OUT.mp4]   makes the pictures, and with OUT.mp4 also the movie
root=$(cd -P -- "$(dirname -- "$0")/.." && pwd)
[ $# = 1 ] || [ $# = 2 ] || { sed -n '6s/^# *//p' "$0"; exit 2; }
program=$(realpath -- "$1")
tour=$root/docs/tour
folder=$(mktemp -d) && trap 'rm -r "$folder"' EXIT
cp "$tour/begin.bx" "$folder/film.bx"
export QT_SCALE_FACTOR=1.125

# picture NAME STEPS TIME OPTION…: makes a picture of the studio at that time. The studio runs the first STEPS lines of
# lines.txt before, then the lines of standard input.
picture() {
  local name=$1 steps=$2 at=$3
  shift 3
  { head -n "$steps" "$tour/lines.txt" && cat; } >"$folder/session.txt"
  (cd "$folder" && "$program" studio film.bx --discard --session session.txt --screenshot full.png --at "$at" "$@") || exit 1
  ffmpeg -v error -y -i "$folder/full.png" -filter_complex \
    'split[a][b]; [a]palettegen=max_colors=64:reserve_transparent=0[p]; [b][p]paletteuse=dither=none' \
    -pred none -compression_level 9 "$tour/pictures/$name.png" || exit 1
}
window() { picture "$@" --size 1280x720; }

mkdir -p "$tour/pictures"
window all 18 44f --select ball </dev/null
for ((f = 1; f < 96; f += 4)); do picture "play$f" 18 "${f}f" --layout picture --size 1280x720 </dev/null; done
window new0 0 1f </dev/null
window new1 1 1f --select ball </dev/null
window new3 3 1f --select ball </dev/null
window drag0 3 12f --select ball </dev/null
n=0
for place in '-4.6 1.2' '-4 2.3' '-3.6 3' '-3.4 3.4'; do
  window "drag$((++n))" 3 12f --select ball <<<"at 12f ball.position ($place 0)"
done
window grow1 5 20f --select ball </dev/null
window grow2 6 30f --select ball </dev/null
window grow3 7 40f --select ball </dev/null
window move1 7 40f --select ball <<<'move ball.position 20f..40f by 2f'
window move2 8 40f --select ball </dev/null
picture curves0 8 34f --select ball --panel curves --size 1000x420 </dev/null
picture curves1 8 34f --select ball --panel curves --size 1000x420 <<<'at 34f ball.position (-0.4 2.8 0)'
picture curves2 9 34f --select ball --panel curves --size 1000x420 </dev/null
window text0 9 34f --select ball </dev/null
window text1 9 34f --select ball <<<'rewrite 7..7 "create ball sphere radius=0.6 color=gold"'
window text2 9 34f --select ball <<<'rewrite 7..7 "create ball sphere radius=0.65 color=gold"'
window text3 10 34f --select ball </dev/null
window hand1 11 44f --select hand </dev/null
window hand2 15 44f --select hand </dev/null
window hand3 16 44f --select ball </dev/null
window hand4 17 66f --select ball </dev/null
window hand5 18 66f --select ball </dev/null
window hand6 18 80f --select ball </dev/null
window time1 19 44f --select '{ball,hand}' </dev/null
window time2 20 44f --select '{ball,hand}' </dev/null
picture export 18 1f --panel export </dev/null
[ $# = 1 ] || "$program" render "$tour/tour.bx" -o "$2"
