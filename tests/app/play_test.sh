#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests the sound during playback.
#   play_test.sh PROGRAM
# The sound device is ALSA's file plug-in: it writes the samples to a file, faster than real time.
. "$(dirname -- "$0")/support.sh" || exit 3
command -v script >/dev/null || { summary; exit; }

cat >device.conf <<'CONF'
pcm.null { type null }
pcm.!default { type file slave.pcm "null" file "played.raw" format "raw" }
CONF
# 2 s of sound in which no two parts are equal.
cat >sounds.py <<'PY'
import array, math, struct, sys

def sample(k):
    return 0.5 * math.sin(k * k * 1e-6) + 0.1

if sys.argv[1] == "make":
    data = array.array("f", (s for k in range(96000) for s in (sample(k), -sample(k)))).tobytes()
    head = b"WAVEfmt " + struct.pack("<IHHIIHH", 16, 3, 2, 48000, 48000 * 8, 8, 32) + b"data" + struct.pack("<I", len(data))
    open("tone.wav", "wb").write(b"RIFF" + struct.pack("<I", len(data) + len(head)) + head + data)
    sys.exit()

played = array.array("f")
played.frombytes(open("played.raw", "rb").read())
pairs = len(played) // 2
if sys.argv[1] == "silent":
    print("silent" if pairs > 4800 and not any(played) else f"{pairs} pairs, not silent")
    sys.exit()

# The expected sound of the film below: half as loud, from frame 7 on, with a fade-in of 0.2 s. The arguments are its
# length and whether it repeats.
length, loops = int(sys.argv[2]), sys.argv[3:] == ["again"]
def film(k):
    if loops: k %= length
    own = k - 12000
    return 0.5 * min(1, own / 9600) * sample(own) if 0 <= own and k < length else 0
if pairs < (2 if loops else 1) * length: sys.exit(f"{pairs} pairs only")
begins = next((i for i in range(pairs) if played[2 * i]), pairs) - 12001
if abs(begins) > 2400: sys.exit(f"{begins} pairs late")
for i in range(max(begins, 0), pairs):
    want = film(i - begins)
    if abs(played[2 * i] - want) > 1e-6 or abs(played[2 * i + 1] + want) > 1e-6:
        sys.exit(f"pair {i}: {played[2 * i]}, not {want}")
print("in step")
PY
python3 sounds.py make
cat >film.bx <<'BX'
rate 24
range 1f 24f
create ball sphere
create eye camera position=(0 0 10)
create tone sound file="tone.wav" at=7f gain=0.5 fade-in=0.2s
BX
grep -v tone film.bx >still.bx
plays() { # FILE OPTIONS…
  rm -f played.raw
  TERM=xterm ALSA_CONFIG_PATH=$work/device.conf script -qec "$program play $* --size 32x18 </dev/null" shown >/dev/null 2>&1 </dev/null
  code=$?
}

# On a busy machine the program may stop for more than 0.1 s. Then a part of the sound is missing, as it should be. So
# the test may try again.
for try in {1..10}; do
  plays film.bx
  heard=$(python3 sounds.py film 48000 2>&1)
  [ "$heard" = 'in step' ] && break
done
is 'a film that plays' "$code" 0
is 'is heard, to the sample' "$heard" 'in step'
verdict 'it has a device' "$(grep -qa 'no sound device' shown || echo yes)" 'it says that it has none'
plays film.bx --mute
is 'muted' "$(python3 sounds.py silent 2>&1)" silent
verdict 'it says so' "$(grep -qa ' muted' shown && echo yes)" "$(tail -c 300 shown)"
plays still.bx
verdict 'without sounds no device is opened' "$([ -e played.raw ] || echo yes)" 'it wrote something'

# Repeats until q is pressed. m mutes.
for try in {1..10}; do
  rm -f played.raw shown keys
  mkfifo keys
  TERM=xterm COLUMNS=80 LINES=24 ALSA_CONFIG_PATH=$work/device.conf \
    script -qec "$program play film.bx --loop --size 32x18" shown <keys >/dev/null 2>&1 &
  playing=$!
  exec 7>keys
  for _ in {1..1200}; do # two seconds of the film, at eight bytes a pair
    [ "$(stat -c %s played.raw 2>/dev/null || echo 0)" -gt $((48000 * 8 * 21 / 10)) ] && break
    sleep 0.05
  done
  cp played.raw loop.raw
  printf m >&7
  for _ in {1..1200}; do
    grep -qa ' muted' shown && break
    sleep 0.05
  done
  printf q >&7
  exec 7>&-
  wait "$playing"
  code=$?
  verdict 'm mutes' "$(grep -qa ' muted' shown && echo yes)" "$(tail -c 300 shown)"
  truncate -s $((48000 * 8 * 2)) loop.raw
  mv loop.raw played.raw
  heard=$(python3 sounds.py film 48000 again 2>&1)
  [ "$heard" = 'in step' ] && break
done
is 'a film that plays again and again' "$code" 0
is 'goes on from its start, to the sample' "$heard" 'in step'

# Without a sound device only the status line tells it.
echo 'pcm.!default { type hw card 31 }' >device.conf
plays film.bx
is 'it plays without a device' "$code" 0
verdict 'it says that it has none' "$(grep -qa 'no sound device' shown && echo yes)" "$(tail -c 300 shown)"
verdict 'nothing else does' "$(grep -qai 'alsa\|pcm' shown || echo yes)" "$(grep -ai 'alsa\|pcm' shown | head -c 300)"
plays still.bx
verdict 'where nothing is to be heard, neither does it' "$(grep -qa 'sound device' shown || echo yes)" "$(tail -c 300 shown)"
summary
