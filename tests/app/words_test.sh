#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests `betwixt words`: formats, scratch voices, the alignment of a text to recordings, captions. A voice of espeak-ng
# says when each word is spoken, to a millisecond; the alignment of its recording must find that again.
#   words_test.sh PROGRAM
. "$(dirname -- "$0")/support.sh" || exit 3

# ---- Formats, without other programs
printf '0 0.5 We\n0.5 1.25 begin.\n' >a.words
printf 'WEBVTT\n\n00:01.000 --> 00:09.000\nin time\n' >a.vtt
check 'a format becomes lines' 0 '1.000 4.000 in' words a.vtt
check 'and a file' 0 'b.words: 2 words, 9.0 s' words a.vtt -o b.words
is 'the file' "$(cat b.words)" $'1.000 4.000 in\n4.000 9.000 time'
printf '0 1 a\nx\n' >bad.words
check 'an error has its place' 1 "bad.words:2:1: 'x' is not a time in seconds" words bad.words
check 'a recording without a text' 2 'the text of a.wav is missing' words a.wav
check 'nothing' 2 'a recording is missing' words
check 'a voice without a text to say' 2 '--voice and --speed are for a voice that is made' words a.wav --text a.words --voice en
check 'no such text' 1 "there is no file 'none.txt'" words a.wav --text none.txt -o c.words
mkdir empty
said=$(PATH=$work/empty "$program" words a.wav --text a.words -o c.words 2>&1)
is 'without pocketsphinx' $? 3
has 'it tells how to install it' "$said" 'sudo apt-get install pocketsphinx pocketsphinx-en-us'

# ---- Captions of a film: a second of silence is its sound
ffmpeg -loglevel error -f lavfi -i anullsrc=r=16000:cl=mono -t 4 a.wav
cat >film.bx <<'FILM'
rate 24
range 1f 48f
film flat
create voice sound file="a.wav" words="a.words" at=0.5s
captions on voice
FILM
check 'captions of a film' 0 'film.srt: 1 caption' words film.bx
is 'SRT' "$(cat film.srt)" $'1\n00:00:00,500 --> 00:00:02,150\nWe begin.'
check 'a film with captions' 0 '' render film.bx -o film.mp4 --size 64x36 --captions film.vtt
is 'WebVTT' "$(cat film.vtt)" $'WEBVTT\n\n00:00:00.500 --> 00:00:02.000\nWe begin.'
is 'the text track of .mp4' "$(ffmpeg -loglevel error -i film.mp4 -map 0:s -f srt - | head -3)" $'1\n00:00:00,500 --> 00:00:02,000\nWe begin.'
check 'a part of it' 0 '' render film.bx -o part.webm --size 64x36 --frames 25f..48f
# Opus begins 14 ms before the sound does.
is 'the text track of .webm' "$(ffmpeg -loglevel error -i part.webm -map 0:s -f srt - | head -3)" $'1\n00:00:00,014 --> 00:00:01,014\nWe begin.'
check 'no such captions' 2 'captions are a .vtt or a .srt' render film.bx -o film.mp4 --captions film.txt
printf '0 3 %s\n' "$(head -c 10000 /dev/zero | tr '\0' w)" >a.words
check 'a caption of 10,000 letters' 0 'film.srt: 238 captions' words film.bx
check 'and its picture' 0 '' frame film.bx --at 24f -o long.png --size 64x36

# ---- Voices and alignment
if ! command -v espeak-ng >/dev/null || ! command -v pocketsphinx_batch >/dev/null; then
  echo 'words_test.sh: without espeak-ng, pocketsphinx and pocketsphinx-en-us, alignment is not tested'
  summary
  exit
fi
cat >talk.txt <<'TEXT'
We begin with a square. It has four sides of the same length, and every corner is a right angle.
Now draw a line from one corner to the opposite corner. This line is called the diagonal. It cuts the square into two triangles, and both triangles have the same area.
How long is the diagonal? The answer was known in ancient times. Take a second square and build it on the diagonal of the first one. If you count the triangles, you will find that the new square contains four of them, while the old square contains only two.
So the area of the large square is twice the area of the small square. Suppose that each side of the small square has length one. Then its area is one, and the area of the large square must be two. The side of the large square is the diagonal of the small one, and therefore the diagonal is the square root of two.
This number cannot be written as a fraction. Nobody can write down all of its digits, because they never end and they never repeat. People say that the discovery was kept secret for many years. Today every student learns it in school, and every computer knows how to find as many digits as you want.
That is the story of a simple square.
TEXT
tr '\n' ' ' <talk.txt | sed 's/, and /,\nand /g; s/\. \(Take\|Suppose\|Nobody\|It\) /.\n\1 /g' >slow.txt # pauses elsewhere
check 'a voice' 0 'talk.words: 227 words' words --say talk.txt --speed 160 -o talk.wav
check 'a slower voice' 0 'slow.words: 227 words' words --say slow.txt --speed 123 -o slow.wav
"$program" words --say talk.txt --speed 160 -o again.wav >/dev/null
is 'a voice is always the same' "$(cmp talk.wav again.wav && cmp talk.words again.words && echo same)" same
check 'a variant that is not there' 2 "espeak-ng has no voice 'en+zz'" words --say talk.txt --voice en+zz -o x.wav
printf 'film flat\ncreate voice sound say="One square." voice="en-gb-scotland"\ncaptions on voice\nrange 1f voice.end\n' >said.bx
check 'a film that says a text' 0 'said.srt: 1 caption' words said.bx
check 'and is heard' 0 '' render said.bx -o said.mov --size 64x36
verdict 'its sound is not silence' "$(ffmpeg -hide_banner -i said.mov -af volumedetect -f null - 2>&1 | sed -n 's/.*max_volume: -\([0-9]\)\..*/yes/p')" 'silence'
check 'a voice that is not there' 2 "espeak-ng has no voice 'xx'" words --say talk.txt --voice xx -o x.wav

cat >errors.py <<'PYTHON'
# Prints in milliseconds the median and the worst error of two lists of times, or of the starts of two files of words.
import json, statistics, sys
def read(path):
    return json.load(open(path)) if path.endswith(".json") else [float(line.split()[0]) for line in open(path)]
a, b = read(sys.argv[1]), read(sys.argv[2])
assert len(a) == len(b) > 200, (len(a), len(b))
errors = sorted(1000 * abs(x - y) for x, y in zip(a, b))
print(f"median {statistics.median(errors):.0f}, worst {errors[-1]:.0f}")
sys.exit(not (statistics.median(errors) <= 30 and errors[-1] <= 150))
PYTHON
cat >marks.py <<'PYTHON'
# Writes a film with a mark at each word of a text, and where those marks must be for a file of exact times.
import json, re, sys
script, times, exact = {}, [], [line.split(None, 2) for line in open(sys.argv[1])]
seen, rows = {}, []
for start, _, word in exact:
    key = re.sub("[^a-z]", "", word.lower())
    seen[key] = seen.get(key, 0) + 1
    rows.append(f'voice:"{key}"#{seen[key]}')
print('create voice sound file="voice.wav" words="voice.words"\nrange 1f voice.end\ncreate b box')
print("b.position.x\n" + "".join(f"  {row}  {i}\n" for i, row in enumerate(rows)), end="")
json.dump(rows, open("rows.json", "w"))
PYTHON
python3 marks.py talk.words >marks.bx
for one in talk slow; do
  cp $one.words exact.words
  check "$one: alignment" 0 'found.words: 227 words' words $one.wav --text talk.txt -o found.words
  got=$(python3 errors.py exact.words found.words)
  verdict "$one: the errors of alignment" "$([ $? = 0 ] && echo yes)" "$got"
  # Not a line of the script changes, and each mark is at its word.
  cp $one.wav voice.wav
  cp found.words voice.words
  check "$one: the film" 0 'no errors' check marks.bx
  python3 - "$program" >found.json <<'PYTHON'
import json, subprocess, sys
rows = json.load(open("rows.json"))
said = subprocess.run([sys.argv[1], "eval", "marks.bx", "--json", "--at", ",".join(rows), "b.position.x"], capture_output=True, text=True)
print(json.dumps([t["seconds"] for t in json.loads(said.stdout)["times"]]))
PYTHON
  got=$(python3 errors.py exact.words found.json)
  verdict "$one: the marks of the film" "$([ $? = 0 ] && echo yes)" "$got"
done
sed 's/^How long.*/Nothing of that kind was ever said here by anybody at all./' talk.txt >wrong.txt
check 'a text that is not spoken' 0 'perhaps the text is not what is spoken' words talk.wav --text wrong.txt -o wrong.words
printf '\xff' >bytes.txt
check 'no text' 1 'not UTF-8' words talk.wav --text bytes.txt -o x.words
check 'a silent recording' 1 'is silent' words a.wav --text talk.txt -o x.words
printf 'In 1984 Betwixt had twenty-one naïve co-authors & no UNESCO.\n' >odd.txt
"$program" words --say odd.txt -o odd.wav >/dev/null
check 'words that are in no dictionary' 0 '9 words' words odd.wav --text odd.txt -o odd.words
summary
