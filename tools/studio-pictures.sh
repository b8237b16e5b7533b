#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Makes the pictures of docs/studio.md: the window, dark and light, each of its panels, and the export dialog.
#   tools/studio-pictures.sh PROGRAM
root=$(cd -P -- "$(dirname -- "$0")/.." && pwd)
[ $# = 1 ] || { sed -n '6s/^# *//p' "$0"; exit 2; }
program=$(realpath -- "$1")
folder=$(mktemp -d) && trap 'rm -r "$folder"' EXIT
cp -r "$root/examples" "$folder/films" || exit 1

# picture NAME FILM OPTION…: makes a picture of 256 colors. The studio runs the lines of standard input first.
picture() {
  local name=$1 film=$2
  shift 2
  cat >"$folder/session.txt"
  (cd "$folder/films" && "$program" studio "$film.bx" --discard --session ../session.txt --screenshot ../full.png "$@") || exit 1
  ffmpeg -v error -y -i "$folder/full.png" -filter_complex 'split[a][b]; [a]palettegen=reserve_transparent=0[p]; [b][p]paletteuse=dither=sierra2_4a' \
    "$root/docs/pictures/$name.png" || exit 1
}

said='describe ball
at 40f hand.scale (1.3 1 0.75)
move hand.position 75f..75f by 5f'
picture studio grab --at 40f --select '{hand,ball}' --size 1600x1000 <<<"$said"
picture studio-light walk --at 60f --select man/right/knee/foot --size 1600x1000 --light <<<'set man/body.color tomato
at 60f note "the right foot comes down"'
picture studio-viewport grab --panel picture --layout picture --at 34f --select hand --size 1000x720 </dev/null
picture studio-outliner walk --panel outliner --at 1f --select 'man/{left,right}/knee' --size 320x480 </dev/null
picture studio-timeline grab --panel timeline --at 40f --size 1000x120 <<<'at 20f note "it takes the ball"'
picture studio-sheet grab --panel sheet --at 40f --select '{hand,ball}' --size 1000x300 </dev/null
picture studio-columns grab --panel columns --at 20f --select '{hand,ball}' --size 1000x420 </dev/null
picture studio-curves bounce --panel curves --at 30f --select ball --size 1000x340 </dev/null
picture studio-properties grab --panel properties --at 40f --select hand --size 460x600 </dev/null
picture studio-console grab --panel console --at 40f --size 620x340 <<<"$said
eval ball.world.y at 80f"
picture studio-script grab --panel script --at 40f --select hand --size 720x560 <<<"$said"
picture studio-controls grab --panel live --select ball --size 400x320 <<<'dial /fader/1 to ball.radius
dial /fader/2 to hand.scale.y'
picture studio-server grab --panel server --size 400x460 </dev/null
picture studio-export grab --panel export </dev/null
picture studio-new grab --panel new </dev/null
