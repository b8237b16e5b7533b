#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests videos in films: which of their pictures is shown when, in all orders, and what is wrong with a file.
#   video_test.sh PROGRAM
here=$(realpath -- "$(dirname -- "$0")")
. "$(dirname -- "$0")/support.sh" || exit 3
# A video whose pictures say their numbers: a column for each bit, white or black.
numbered() { # FILE PICTURES OPTIONS…
  local file=$1 count=$2
  shift 2
  ffmpeg -v error -y -f lavfi -i color=black:size=128x64:rate=24 -frames:v "$count" \
    -vf "geq=lum='235*mod(floor(N/pow(2,floor(X/16))),2)':cb=128:cr=128" -pix_fmt yuv420p "$@" "$file"
}
numbered code.mp4 200 -c:v libx264 -bf 3 -g 60
ffmpeg -v error -y -i code.mp4 -c copy code.mkv
cat >film.bx <<'BX'
film flat
rate 24
size 128x64
range 1f..150f
create eye camera position=(0 0 10) height=2
BX
film() { # LINES: film.bx with these lines is now.bx
  { cat film.bx; printf '%s\n' "$1"; } >now.bx
}
shown() { # OPTIONS…: the numbers in the pictures of now.bx
  rm -rf out && mkdir out
  "$program" render now.bx "$@" -o 'out/%04d.png' >said 2>&1 || cat said
  python3 "$here/video_numbers.py" out
}
expected() { python3 -c "print(*[$1 for f in range($2)])"; }

for file in code.mp4 code.mkv; do
  film "create clip video file=\"$file\" at=12f height=2"
  is "each picture of $file is shown once" "$(shown)" "$(expected 'max(0, f - 11)' 150)"
done
one=$(cat out/*.png | md5sum)
shown --jobs 4 >/dev/null
is "the same bytes by four threads" "$(cat out/*.png | md5sum)" "$one"
for f in 100 20 99; do
  "$program" frame now.bx --at ${f}f -o one.png
  is "the same bytes for frame $f alone" "$(md5sum <one.png)" "$(md5sum <"out/$(printf %04d $f).png")"
done

film 'create clip video file="code.mp4" height=2 from=10f until=13f loop=on'
is "a part in a loop" "$(shown --frames 1f..8f)" "$(expected '10 + f % 3' 8)"
film 'create clip video file="code.mp4" height=2 speed=-2'
is "backwards" "$(shown --frames 1f..6f)" "$(expected '199 - 2 * f' 6)"
film $'create clip video file="code.mp4" height=2\nat 1f clip.time 0s linear\nat 25f clip.time 4s linear\nat 49f clip.time 3s'
is "time is a track" "$(shown --frames 1f..49f)" "$(expected '4 * f if f <= 24 else 120 - f' 49)"
film $'create wall rectangle size=(4 2) texture="code.mp4" texture-at=3f texture-speed=0.5'
is "a texture" "$(shown --frames 1f..9f)" "$(expected 'max(0, f - 2) // 2' 9)"
film $'create wall plane size=(4 2) texture="code.mp4"\nat 4f wall.texture "code.mkv"'
is "a texture changes its file" "$(shown --frames 2f..6f)" "$(expected 'f + 1' 5)"
film $'create clip video file="code.mp4" height=2 at=1f\nset eye.shutter 180deg'
is "with a shutter" "$(shown --frames 40f..44f)" "$(expected 'f + 39' 5)"

film $'define speed number\ncreate clip video file="code.mp4" height=2 speed=3\ncreate ball sphere display=off speed=7'
is "a film may have a function speed of its own" "$(shown --frames 1f..4f)" "$(expected '3 * f' 4)"
has "it has its value" "$("$program" eval now.bx --at 2f ball.speed)" 7
check "a film with a video is good" 0 "" check now.bx
check "a missing file" 1 "there is no file" check <(film 'create clip video file="none.mp4"'; cat now.bx)
for bad in 'create clip video' 'create clip video file="film.bx"' 'create clip video file="sound.wav"' \
  'create clip video file="cut.mp4"' 'create clip sphere normal-map="code.mp4"' 'create clip movie file="code.mp4"' \
  'create clip video file="../code.mp4"' 'create clip video file="code.mp4" speed=2000'; do
  ffmpeg -v error -y -f lavfi -i sine=duration=1 sound.wav
  head -c 5000 code.mp4 >cut.mp4
  film "$bad"
  said=$("$program" check now.bx 2>&1)
  case $bad in
    *'video') want='a video needs its file' ;;
    *sound.wav*) want='sound.wav is broken or not a video: it has no pictures' ;;
    *film.bx* | *cut.mp4*) want='is broken or not a video' ;;
    *normal-map*) want='only the texture can be one' ;;
    *movie*) want='create clip video file=' ;;
    *../*) want='outside' ;;
    *) want='speed' ;;
  esac
  has "$bad" "$said" "$want"
  has "$bad has its place" "$said" 'now.bx:6:'
done

film 'create clip video file="code.mp4" height=2'
# What plays films in pages is built by another test, so one line stands for it here.
echo 'const engine = "the engine";' >player.js
BETWIXT_PLAYER=$PWD/player.js "$program" web now.bx -o page.html >said 2>&1
is "a page is made" "$?" 0
has "it has the pictures" "$(cat page.html)" '"code.mp4.pictures": "'
"$program" export now.bx -o now.glb >said 2>&1
has "glTF has a still" "$(cat said)" 'videos become still pictures'
"$program" export now.bx -o now.svg >said 2>&1
has "SVG leaves it out" "$(cat said)" "left out: the textures of 'clip'"
summary
