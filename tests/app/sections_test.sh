#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests what subcommands make of sections, steps and descriptions: chapters, parts of films, PDF, talks.
#   sections_test.sh PROGRAM
. "$(dirname -- "$0")/support.sh" || exit 3
cat >talk.bx <<'BX'
size 160x90
range 1f 73f
create ball sphere
section intro for 1s
  step "The ball" note="Say hello"
  at 1f ball.position (-2 0 0) linear
  at 1f describe "A ball < a box"
section "proof"
BX
"$program" check talk.bx >/dev/null 2>&1; is "a quoted name is no name" "$?" 1
sed -i '$d' talk.bx
cat >>talk.bx <<'BX'
section proof for 2s speed=1
  at 1f ball.position (2 0 0) linear
  at 25f step "Grüße – 步"
  at 25f describe "It goes on"
  at 49f ball.position (0 2 0)
BX
"$program" check talk.bx >/dev/null 2>&1; is "the film is good" "$?" 0

for film in film.mp4 film.webm film.mov; do
  "$program" render talk.bx -o $film >/dev/null 2>&1
  is "chapters of $film" "$(ffprobe -v error -show_chapters -of csv=p=0 $film |
    python3 -c 'import sys; print(*(f"{float(w[3]):.3f}-{float(w[5]):.3f} {w[6]}" for w in (l.strip().split(",") for l in sys.stdin)))')" \
    "0.000-1.000 intro 1.000-3.000 proof"
done
frames() { ffprobe -v error -count_frames -select_streams v -show_entries stream=nb_read_frames -of csv=p=0 "$1"; }
"$program" render talk.bx --section intro -o part.mp4 >/dev/null 2>&1
is "a section ends before the next one begins" "$(frames part.mp4)" 24
"$program" render talk.bx --section proof -o part.mp4 >/dev/null 2>&1
is "the last section has its last frame" "$(frames part.mp4)" 49
has "an unknown section" "$("$program" render talk.bx --section prof -o part.mp4 2>&1)" "did you mean 'proof'?"
is "edges are times" "$("$program" eval talk.bx --at proof.start,proof.end-1s ball.position --json | grep -o '"at":"[^"]*","seconds":[0-9.]*' | tr '\n' ' ')" \
  '"at":"proof.start","seconds":1 "at":"proof.end-1s","seconds":2 '

"$program" render talk.bx -o talk.pdf >said 2>&1; is "a PDF is made" "$?" 0
has "it has a page for each step" "$(cat said)" "2 pages"
python3 - <<'PY' >pdf-said
import re
data = open("talk.pdf", "rb").read()
# Every entry of the table points at its object.
table = data[int(re.search(rb"startxref\n(\d+)", data)[1]):]
places = [int(line[:10]) for line in table.split(b"\n")[3:] if line.endswith(b" n ")]
print(all(data[at:].startswith(b"%d 0 obj" % (k + 1)) for k, at in enumerate(places)), len(places),
      data.count(b"/Type /Page "), data.count(b"\xff\xd8\xff"), "Grüße – 步".encode("utf-16-be").hex().upper().encode() in data)
PY
is "the PDF's table is right" "$(cat pdf-said)" "True 12 2 2 True"
printf 'create ball sphere\n' >none.bx
"$program" render none.bx -o none.pdf >said 2>&1; is "no steps, no PDF" "$?" 1
has "it says how to write one" "$(cat said)" 'at 24f step'
[ ! -e none.pdf ]; is "and leaves no file" "$?" 0

"$program" render talk.bx -o film.mp4 --descriptions film.vtt >/dev/null 2>&1
is "descriptions as WebVTT" "$(cat film.vtt)" "WEBVTT

00:00:00.000 --> 00:00:02.000
A ball &lt; a box

00:00:02.000 --> 00:00:03.042
It goes on"

# A talk. Each key's picture is there within a frame (41.7 ms), forwards and backwards; on a loaded machine, three.
if command -v Xvfb xdotool >/dev/null; then
  Xvfb -displayfd 3 -screen 0 640x360x24 3>display >/dev/null 2>&1 &
  server=$!
  for _ in $(seq 50); do [ -s display ] && break; sleep 0.1; done
  export DISPLAY=:$(cat display)
  "$program" present talk.bx --notes terminal --stats >notes 2>stats &
  talk=$!
  window=$(timeout 20 xdotool search --sync --name talk | head -n 1)
  sleep 2
  for key in Right Right Left Right Right End Home b b Left; do xdotool key --window "$window" $key; sleep 0.5; done
  xdotool key --window "$window" q
  wait $talk; is "the talk ends" "$?" 0
  has "notes" "$(cat notes)" "Say hello"
  has "the count" "$(cat notes)" "2 / 3  Grüße"
  has "all keys have a picture" "$(cat stats)" "from key to picture: 10 keys"
  worst=$(sed -nE 's/.*median ([0-9]+).*/\1/p' stats)
  [ "${worst:-999}" -le 125 ]; is "pictures come at once ($(cat stats))" "$?" 0
  kill $server
fi
summary
