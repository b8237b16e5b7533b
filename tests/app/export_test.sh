#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests the command `betwixt export`: its messages and errors. tests/peers checks its files with other programs.
#   export_test.sh PROGRAM
tests=$(realpath -- "$(dirname -- "$0")")
. "$tests/support.sh" || exit 3
export LC_ALL=C.UTF-8

# Prints counts of a JSON file: nodes, channels, and the like.
ask() { python3 -c 'import json, sys; f = json.load(open(sys.argv[1])); print(eval(sys.argv[2]))' "$1" "$2"; }

cat >film.bx <<'BX'
rate 24
range 1f 49f
create hand group
create finger box position=(1 0 0)
couple finger to hand
create ball sphere color=red
create word text text="on"
hand.rotation.z
  1f   0deg
  49f  90deg
ball.position
  1f   (0 0 0)  linear
  25f  (3 0 0)  cut (5 0 0) linear
  49f  (5 2 0)
ball.color
  1f   red
  49f  blue
word.display
  1f   on
  13f  off
set ball.radius 0.5
BX
check 'a film goes out' 0 'objects, ' export film.bx -o a.gltf
is 'what is coupled is below it' "$(ask a.gltf '[n["name"] for n in f["nodes"] if n.get("children")]')" "['hand', 'word']"
is 'colours are keys of materials' "$(ask a.gltf 'f["extensionsUsed"]')" "['KHR_animation_pointer']"
is 'the rest of it' "$(ask a.gltf 'f["scenes"][0]["extras"]["frames"]')" 49
check 'as few keys as there can be' 0 'objects, ' export film.bx -o few.gltf --keys cubic
is 'what is hidden has steps' "$(ask few.gltf '[f["animations"][0]["samplers"][c["sampler"]]["interpolation"] for c in f["animations"][0]["channels"] if c["target"]["path"] == "scale"]')" "['STEP']"
check 'one object, and what it hangs on' 0 '2 objects' export film.bx finger -o f.gltf
is 'all programs play what is written where nobody says more' "$(ask a.gltf 'sorted({s["interpolation"] for s in f["animations"][0]["samplers"]})')" "['LINEAR']"
is 'nothing else' "$(ask f.gltf '[n["name"] for n in f["nodes"]]')" "['hand', 'finger']"
check 'the same as USD' 0 '2 objects' export film.bx finger -o f.usda
verdict 'nothing else there' "$(grep -q '"ball"' f.usda || echo yes)" "$(grep 'def Xform' f.usda)"
python3 -c 'import wave; w = wave.open("hum.wav", "wb"); w.setparams((1, 2, 8000, 0, "NONE", "")); w.writeframes(bytes(16000))'
cat >around.bx <<'BX'
ground on
sky on
background gray
fog gray from 1 to 20
contact on
exposure 1
create s box
create w text text="on"
create hum sound file="hum.wav"
create eye camera position=(0 0 9) f-stop=2 shutter=90deg
at 1f note "here"
BX
cat >flat.bx <<'BX'
film flat
create s rectangle
BX
# One sentence for each loss, and none for features that the film does not use.
for file in around.glb around.usda; do
  "$program" export around.bx -o $file 2>said.txt
  for what in 'the background is' 'fog is' 'the sky and its light are' 'the ground is' 'the film has no lights; Betwixt' 'ambient light is' \
    'shadows are' 'contact shading is' 'the exposure is' '(shutter) is' '(aperture) is' 'sounds are' 'notes are' \
    'texts are written as shapes'; do
    is "$file: $what told of" "$(grep -cF "notice: " said.txt) $(grep -cF "$what" said.txt)" '14 1'
  done
done
check 'a drawing loses its background' 0 'the background is left out' export flat.bx -o flat.glb
is 'and nothing else' "$(grep -c notice <<<"$said")" 1
check 'patterns' 0 '3 objects' export film.bx '{ball,word,hand}' -o f.gltf
check 'keys of each frame' 0 '100 % of one a frame' export film.bx hand -o b.gltf --keys baked
check 'a part of the film' 0 'objects' export film.bx -o p.gltf --frames 25f..49f
is 'begins at its beginning' "$(ask p.gltf 'f["scenes"][0]["extras"]["first_frame"]')" 25.0
check 'a coarse one has fewer keys' 0 'objects' export film.bx -o c.gltf --tolerance 0.1

check 'no ending' 2 'has no file extension that says what to make' export film.bx -o film
check 'another ending' 2 '".glbb" is not an export format' export film.bx -o film.glbb
verdict 'the near one' "$([[ $said == *"did you mean '.glb'"* && $said == *'known extensions: .glb .gltf'* ]] && echo yes)" "$said"
check 'a film is another command' 2 'to make a film: betwixt render' export film.bx -o film.mp4
check 'no such object' 1 "did you mean 'ball'" export film.bx bal -o x.glb
check 'a target that is no object' 1 "'ball.position' is not an object" export film.bx ball.position -o x.glb
check 'no such folder' 2 'nowhere' export film.bx -o nowhere/x.glb
check 'no such way' 2 'linear' export film.bx -o x.glb --keys lineer
check 'no tolerance' 2 '--tolerance: it is a number from 1e-9 to 1, not "0"' export film.bx -o x.glb --tolerance 0
check 'words for a tolerance' 2 'not "1mm"' export film.bx -o x.glb --tolerance 1mm
check 'a file that is there' 2 'a.gltf' export film.bx -o a.gltf --no-overwrite
check 'a film without end' 2 'are too many; the limit is 1000000' export <(echo 'range 1f 5000000f') -o x.glb
check 'a broken script' 1 'error' export <(echo 'creat ball') -o x.glb
check 'no script' 1 'none.bx' export none.bx -o x.glb
is 'nothing is left of what failed' "$(ls x.glb .*.glb* 2>/dev/null)" ''
check 'an empty film' 0 '0 objects' export <(echo 'rate 24') -o empty.gltf
summary
