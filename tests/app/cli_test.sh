#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests the commands render, frame, plot and play: exit codes, messages, and the files that they leave.
#   cli_test.sh PROGRAM
# shows: G8 G13 G36 G56 G89 G91
. "$(dirname -- "$0")/support.sh" || exit 3

# check NAME EXIT-CODE TEXT ARGUMENT…: runs the program. Its output must contain TEXT, a fixed string.
check() {
  local name=$1 code=$2 text=$3
  shift 3
  said=$("$program" "$@" 2>&1 </dev/null)
  local got=$?
  verdict "$name" "$([ $got = "$code" ] && [[ ${said,,} == *"${text,,}"* ]] && echo yes)" "exit code $got (not $code?), said: $said"
}
frames() { ffprobe -v error -count_frames -select_streams v:0 -show_entries stream=nb_read_frames -of csv=p=0 "$1" | tr -d ,; }
leftovers() { find . -name '.*partial*' | wc -l; }

cat >bounce.bx <<'BX'
rate 24
range 1f 12f
create ball   sphere radius=1 color=gold
create eye    camera position=(4 5 30) look-at=(4 5 0)
ball.position
  1f   (0 10 0)
  12f  (4 1 0)    linear
  24f  (8 10 0)   ease-in=4f ease-out=4f
at 6f note "falling"
set ball.radius 1
at 4f ball.radius 1 hold
at 8f ball.radius 2
BX
printf 'create ball spere\nbell.colour\n  1f gold\n' >wrong.bx
: >empty.bx
head -c 4096 /dev/urandom >binary.bx
small="--size 64x48 --samples 1"

# Options and arguments.
printf 'create s{1..12} box\ncreate ball sphere\nset s*.color red\n' >many.bx
printf 'create b box\nuse part.bx\n' >whole.bx
printf '# a part\nset b.position.x = """\n  local a = 1\n  return nobody.x\n"""\n' >part.bx
check 'the line of code in a file that is used' 1 "part.bx:4:3: error: b.position.x: the procedure \"local a = 1 …\" gives no value: attempt" check whole.bx
printf 'create b{1..17} sphere\nset b*.radius = "i + nobody.x"\n' >seventeen.bx
check 'one line that is wrong for many is said once' 1 'likewise 16 others: b2.radius, b3.radius, b4.radius, b5.radius, …' check seventeen.bx
check 'and counted once' 1 '1 error, 0 warnings' check seventeen.bx
rm seventeen.bx
check 'check says how many' 0 'many.bx:3:1: notice: 12 objects' check -v many.bx
check 'where that is asked' 0 'many.bx: no errors, 13 objects, 24 frames' check many.bx
is 'else not' "$("$program" check many.bx 2>&1)" 'many.bx: no errors, 13 objects, 24 frames'
check 'no command' 2 'Usage:'
check 'help' 0 'betwixt render examples/bounce.bx -o bounce.mp4' --help
check 'version' 0 'betwixt ' --version
check 'unknown command' 2 "did you mean 'render'?" rendre bounce.bx
check 'a script is no command' 2 'betwixt play bounce.bx' bounce.bx
check 'a film is made in a file' 2 'betwixt: error: the shell needs a file' shell -
check 'and worked on in one' 2 'betwixt: error: the studio needs a file' studio -
check 'unknown option' 2 "did you mean '--size'?" render bounce.bx -o a.mp4 --siz 3x4
check 'a film of the usual name' 0 'bounce.mp4' render bounce.bx $small --frames 1..2
is 'a film of the usual name is there' "$(ls bounce.mp4 2>&1; rm -f bounce.mp4)" bounce.mp4
check 'a picture of the usual name and time' 0 'bounce.png' frame bounce.bx $small
is 'it is the first frame' "$("$program" frame bounce.bx --at 1f -o first.png $small && cmp first.png bounce.png && echo same; rm -f first.png bounce.png)" same
is 'values at the usual time' "$("$program" eval bounce.bx ball.position --json)" "$("$program" eval bounce.bx --at 1f ball.position --json)"
is 'which is where the film begins' "$(printf 'range 4f 9f\ncreate b box\nb.position.x\n  1f 0 linear\n  9f 8\n' | "$program" eval - b.position.x)" 'b.position.x  3'
verdict 'it says the commit, if there is one' "$("$program" --version | grep -qxE 'betwixt [0-9.]+( \([0-9a-f]{7,}\))?' && echo yes)" "$("$program" --version)"
check 'errors of the call say so' 2 "betwixt: error: no such command 'rendre'" rendre bounce.bx
check 'so do others' 2 'betwixt: error: a film cannot have the extension' render bounce.bx -o a.mp5

is 'its progress is JSON' "$("$program" render bounce.bx $small --progress -o told.gif 2>&1 >/dev/null | python3 -c '
import json, sys
told = [json.loads(line) for line in sys.stdin if line.startswith("{")]
print({line["frames"] for line in told}, all(0 <= line["done"] <= 12 for line in told))'; rm -f told.gif)" '{12} True'

# Standard input and output.
is 'a script from standard input' "$("$program" check - <bounce.bx)" "$("$program" check bounce.bx | sed 's/^bounce.bx/<stdin>/')"
is 'its errors have places' "$("$program" check - <wrong.bx 2>&1 | head -n 1)" "$("$program" check wrong.bx 2>&1 | head -n 1 | sed 's/^wrong.bx/<stdin>/')"
is 'values of it' "$("$program" eval - --at 8f ball.radius <bounce.bx)" "$("$program" eval bounce.bx --at 8f ball.radius)"
is 'its canonical form' "$("$program" tidy - <bounce.bx)" "$("$program" tidy bounce.bx)"
check 'which is not put back' 2 'betwixt: error: standard input cannot be rewritten' tidy - --write
"$program" frame bounce.bx --at 6f -o there.png $small
is 'a picture to standard output' "$("$program" frame - --at 6f -o - $small <bounce.bx | md5sum)" "$(md5sum <there.png)"
is 'it is what goes there by itself' "$("$program" frame - --at 6f $small <bounce.bx | md5sum)" "$(md5sum <there.png)"
is 'a film to standard output' "$("$program" render - -o -.gif --frames 1f..3f $small <bounce.bx 2>/dev/null | head -c 6)" GIF89a
is 'motion too' "$("$program" export - -o -.glb <bounce.bx 2>/dev/null | head -c 4)" glTF
check 'whose ending has to be said' 2 'betwixt: error: the format is missing' export bounce.bx -o -
is 'nothing else is left' "$(ls -A | grep -c '^-')" 0
rm there.png

# The encoding of films and pictures.
"$program" frame bounce.bx --at 6f -o fine.jpg --quality 100 $small && "$program" frame bounce.bx --at 6f -o poor.jpg --quality 5 $small
is 'a JPEG' "$(head -c 3 fine.jpg | od -An -tx1)" ' ff d8 ff'
verdict 'of more bytes where more is kept' "$([ "$(stat -c %s fine.jpg)" -gt "$(stat -c %s poor.jpg)" ] && echo yes)" "$(ls -l *.jpg)"
is 'of that size' "$(ffprobe -v error -show_entries stream=width,height -of csv=p=0 poor.jpg)" 64,48
rm fine.jpg poor.jpg
check 'quality is of JPEG' 2 '--quality is for .jpg' frame bounce.bx -o a.png --quality 50
for q in 0 101 x; do check "quality $q" 2 '--quality' render bounce.bx -o a.mp4 --quality $q; done
check 'a GIF has none' 2 'betwixt: error: --quality has no effect on a.gif' render bounce.bx -o a.gif --quality 50
check 'numbered pictures neither' 2 '--codec has no effect' render bounce.bx -o a-%d.png --codec h264
check 'a codec that is not there' 2 "betwixt: error: .mp4 has no codec 'vp9'
  it has h264, h265, av1" render bounce.bx -o a.mp4 --codec vp9
codec() { ffprobe -v error -select_streams v:0 -show_entries stream=codec_name -of csv=p=0 "$1"; }
check 'another codec' 0 '' render bounce.bx -o a.mp4 $small --codec h265 --quality 40
is 'the film has it' "$(codec a.mp4)" hevc
"$program" render bounce.bx -o fine.webm $small --quality 95 2>/dev/null && "$program" render bounce.bx -o poor.webm $small --quality 5 2>/dev/null
verdict 'quality takes bytes' "$([ "$(stat -c %s fine.webm)" -gt "$(stat -c %s poor.webm)" ] && echo yes)" "$(ls -l *.webm)"
check 'another rate' 0 '6 frames in' render bounce.bx -o a.mp4 $small --fps 12
is 'the film has it too' "$(ffprobe -v error -select_streams v:0 -show_entries stream=r_frame_rate -of csv=p=0 a.mp4)" 12/1
for f in 0 x 24fps 1e9; do check "rate '$f'" 2 'is not a rate such as 24' render bounce.bx -o a.mp4 --fps $f; done
rm a.mp4 fine.webm poor.webm
# More colours and more light.
tags() { ffprobe -v error -select_streams v:0 -show_entries stream=pix_fmt,color_transfer,color_primaries -of csv=p=0 "$1"; }
wide='--size 64x64 --frames 1f..2f'
check 'a film in pq' 0 '2 frames' render bounce.bx -o a.mp4 $wide --colors pq
is 'it says so' "$(tags a.mp4)" yuv420p10le,smpte2084,bt2020
check 'pictures in hlg' 0 '2 frames' render bounce.bx -o h-%d.png $wide --colors hlg
check 'missing ones in pq' 2 'h-1.png has its colors in hlg, not in pq' render bounce.bx -o h-%d.png $wide --colors pq --missing
check 'missing ones in hlg' 0 'already' render bounce.bx -o h-%d.png $wide --colors hlg --missing
check 'join them' 0 '2 frames' join h-%d.png -o b.mp4 --colors hlg
is 'the film is in hlg' "$(tags b.mp4)" yuv420p10le,arib-std-b67,bt2020
check 'the plan has 16 bits' 0 '"bits":16' render bounce.bx -o a.mp4 $wide --colors pq --plan
check 'one picture in p3' 0 '' frame bounce.bx -o p.png --size 64x64 --colors p3
is 'it says so too' "$(grep -ac cICP p.png)" 1
check 'light in rec2020' 0 '' frame bounce.bx -o p.exr --size 64x64 --colors rec2020
check 'no such colors' 2 "--colors: rec709 not in {srgb,p3,rec2020,pq,hlg}" render bounce.bx -o a.mp4 --colors rec709
check 'a GIF has sRGB' 2 '--colors pq: .gif has the colors of sRGB only' render bounce.bx -o a.gif --colors pq
check 'so has a PDF' 2 '.pdf has the colors of sRGB only' render bounce.bx -o a.pdf --colors p3
check 'and a JPEG' 2 'JPEG has the colors of sRGB only' frame bounce.bx -o a.jpg --colors p3
check 'OpenEXR has light' 2 'OpenEXR has light without limit' render bounce.bx -o a-%d.exr --colors pq
check 'H.264 has 8 bits' 2 'h264 has 8 bits here' render bounce.bx -o a.mp4 --colors pq --codec h264
check 'join to a GIF' 2 '.gif has the colors of sRGB only' join h-%d.png -o a.gif --colors hlg
rm a.mp4 b.mp4 h-?.png p.png p.exr

# Colours.
is 'no colours but on a terminal' "$("$program" check wrong.bx 2>&1 | grep -c $'\x1b')" 0
is 'unless they are asked for' "$("$program" check --color always wrong.bx 2>&1 | head -n 1)" $'\x1b[1mwrong.bx:1:13: \x1b[0m\x1b[1;31merror:\x1b[0m'" ${none-}$("$program" check wrong.bx 2>&1 | head -n 1 | sed 's/^[^ ]* error: //')"
if command -v script >/dev/null; then
  on_terminal() { env "$@" TERM=xterm script -qec "$program check wrong.bx" /dev/null </dev/null | grep -c $'\x1b\[1;31m'; }
  verdict 'on a terminal there are' "$([ "$(on_terminal -u NO_COLOR)" -gt 0 ] && echo yes)" 'none'
  is 'not where nobody wants any' "$(on_terminal NO_COLOR=1)" 0
fi
check 'a word that is none of these' 2 'is not auto, always or never' check --color maybe bounce.bx

check 'the version, in short' 0 'betwixt ' -V
check 'no script' 2 'FILE' render -o a.mp4
check 'one word too many' 2 "'more'" render bounce.bx more -o a.mp4
for c in render frame plot play; do check "help of $c" 0 "betwixt $c examples/bounce.bx" $c --help; done
for s in 0x5 5 axb 64x 64x48x 99999x5 -5x5; do check "size '$s'" 2 'is not a size such as 1280x720' render bounce.bx -o a.mp4 --size="$s"; done
check 'samples' 2 '3 samples per pixel cannot be drawn' render bounce.bx -o a.mp4 --samples 3
check 'samples' 2 '--samples' render bounce.bx -o a.mp4 --samples 5000
check 'too many of them' 2 'samples' frame bounce.bx --at 6f -o traced.png --samples 4097 --style traced
check 'jobs' 2 '--jobs' render bounce.bx -o a.mp4 --jobs -1
check 'style' 2 'cubist' render bounce.bx -o a.mp4 --style cubist
check 'ending' 2 "did you mean '.mp4'?" render bounce.bx -o a.mp5
check 'no ending' 2 'has no file extension' render bounce.bx -o film
check 'picture without a number' 2 'frame-%04d.png' render bounce.bx -o a.png
check 'no such folder' 2 'there is no folder nowhere' render bounce.bx -o nowhere/a.mp4
check 'segment' 2 'is not a time' render bounce.bx -o a.mp4 --frames x
check 'one frame' 0 '"frames":1' render bounce.bx -o a.mp4 --frames 3 --plan
check 'segment backwards' 2 'ends before it begins' render bounce.bx -o a.mp4 --frames 9..3
check 'segment of nonsense' 2 '--frames:' render bounce.bx -o a.mp4 --frames 1q..2q
check 'too many frames' 2 'too many' render bounce.bx -o a.mp4 --frames 1f..99999999f
check 'time' 2 '--at:' frame bounce.bx --at soon -o a.png
check 'picture ending' 2 'one picture must be a .png' frame bounce.bx --at 1f -o a.gif
check 'plot ending' 2 'a plot must be a .svg' plot bounce.bx ball.position -o a.png
check 'plot of nobody' 1 'bal' plot bounce.bx bal.position -o a.svg
check 'play without a terminal' 2 'play needs a terminal' play bounce.bx --terminal

# The input.
check 'no such script' 1 "betwixt: error: there is no file 'none.bx'" render none.bx -o a.mp4
check 'script with errors' 1 'wrong.bx:1:' render wrong.bx -o a.mp4
has 'all its errors' "$said" wrong.bx:2:
check 'binary script' 1 'binary.bx' render binary.bx -o a.mp4
is 'nothing was made of these' "$(ls -A | tr '\n' ' ')" 'binary.bx bounce.bx empty.bx many.bx part.bx whole.bx wrong.bx '

# Errors that appear only in frames: `check` reports them too.
cat >procs.bx <<'BX'
range 1f 200f
create a sphere
procedure broken twerper lua "nothing.x"
a.radius
  1f 1 broken
  9f 2
at 150f a.position.x = "lost.x"
BX
check 'check looks at frames' 1 "procs.bx:3:31: error: the twerper 'broken' returned no number" check procs.bx
has 'and says the target' "$said" 'a.position.x: the procedure "lost.x" gives no value'
has 'each once' "$said" '2 errors, 0 warnings'
check 'render stops before the first picture' 1 'procs.bx:7:25: error: a.position.x: the procedure "lost.x"' render procs.bx -o procs.gif
verdict 'and makes nothing' "$([ ! -e procs.gif ] && echo yes)" 'it is there'
check 'unless it is to go on' 0 'procs.bx:7:25: warning: a.position.x' render procs.bx --frames 149f..151f --size 64x36 --keep-going -o procs.gif
verdict 'and makes the film' "$([ -s procs.gif ] && echo yes)" 'it is not there'
check 'frame stops too' 1 'that code: --keep-going' frame procs.bx --at 150f -o procs.png
check 'and goes on where that is wanted' 0 '' frame procs.bx --at 150f --size 64x36 --keep-going -o procs.png
printf 'create a sphere\na.radius\n  1f 1 bspline\n  9f 4 smooth\n  17f 1\n' >torn.bx
check 'a torn spline is noticed' 0 'a.radius jumps at 9f, where bspline meets another twerper' check torn.bx
printf 'create a sphere\nset a.radius = "(function() while true do end end)()"\nrange 1f 5000f\n' >slow.bx
SECONDS=0
check 'check ends soon' 1 'stopped: it took more than' check slow.bx
verdict 'within seconds' "$([ $SECONDS -lt 8 ] && echo yes)" "$SECONDS s"
rm torn.bx procs.bx slow.bx procs.gif procs.png
check 'help of a subcommand' 0 'betwixt render examples/bounce.bx' help render
check 'help of a word that is also a subcommand' 0 'plot, a kind of object' help plot
has 'its subcommand' "$said" 'draws values against time'
check 'help alone' 0 '  contacts ' help
check 'help alone says where to go on' 0 'betwixt help WORD explains a word of the language' help
check 'help of a word' 0 'usage: copy TARGET' help copy
check 'help of a filter' 0 'filter ball.position wobble' help wobble
check 'help of no word' 2 "did you mean 'wobble'?" help wobbel

cat >idle.bx <<'BX'
animate wind every 1t by rotate(90deg, z)
create ball sphere
set ball.environments (wnid)
create box box
set box.transform rotate(90deg, z)
BX
check 'an environment that nobody animates' 0 "idle.bx:3:1: notice: 'ball' is in the environment 'wnid', which no line animates
  set ball.environments (wnid)
  ^~~~~~~~~~~~~~~~~~~~~~~~~~~~
  did you mean 'wind'?" check idle.bx
check 'what is as good as 0 is 0' 0 'matrix(0 -1 0 0 1 0 0 0 0 0 1 0 0 0 0 1)' eval idle.bx box.world --at 1f
check 'but not in JSON' 0 'e-16' eval idle.bx box.world --at 1f --json

# Films.
for e in mp4 webm gif apng; do
  check "$e" 0 '12 frames in' render bounce.bx -o film.$e $small
  is "frames of $e" "$(frames film.$e)" 12
done
check 'stats' 0 'ms a frame' render bounce.bx -o film.mp4 $small --stats --jobs 2
stages=$(grep -cE '^  (tracks|procedures|environments|hierarchy|looks|gather|draw|read back|other|encode) +[0-9]+\.[0-9]{3}$' <<<"$said")
is 'stats say where the time of a frame went' "$stages" 10
sizes() { sed -nE 's/^([0-9]+) events; bytes: document ([0-9]+) .*, program ([0-9]+) .*/\1 \2 \3/p' <<<"$said"; }
read -r events document code < <(sizes)
is 'stats count events' "$events" 5
verdict 'stats say what document and program take' "$([ "$document" -gt $((5 * 64)) ] && [ "$code" -gt $((5 * 17)) ] && echo yes)" "$said"
check 'stats of evaluating' 0 'a frame after it, in ms:' eval bounce.bx --at 1f,2f,9f ball.position --stats
is 'stats of evaluating say where the time went' "$(grep -cE '^  (tracks|procedures|environments|hierarchy|looks|other) +[0-9]+\.[0-9]{3}$' <<<"$said")" 12
is 'stats stay out of the answer' "$("$program" eval bounce.bx --at 1f ball.position --json --stats 2>/dev/null)" "$("$program" eval bounce.bx --at 1f ball.position --json 2>/dev/null)"
check 'stats by another name' 2 "did you mean '--stats'?" eval bounce.bx --at 1f --statz
check 'part by frames' 0 '5 frames in' render bounce.bx -o part.mp4 $small --frames 3f..7f
check 'part by bare numbers' 0 '5 frames in' render bounce.bx -o part.mp4 $small --frames 3..7
check 'part by seconds' 0 '7 frames in' render bounce.bx -o part.mp4 $small --frames 0s..0.25s
check 'one frame' 0 '1 frame in' render bounce.bx -o part.gif $small --frames 3f..3f
check 'samples of light that is followed' 0 '' frame bounce.bx --at 6f -o traced.png --size 64x48 --samples 3 --style traced
check 'samples as needed, with their grain' 0 '' frame bounce.bx --at 6f -o traced.png --size 64x48 --samples auto --denoise off --style traced
check 'a denoiser' 2 'maybe' frame bounce.bx --at 6f -o traced.png --denoise maybe
# The script's size and samples, unless the command line has others.
printf 'size 48x32\nsamples 1\n%s\n' "$(cat bounce.bx)" > sized.bx
pixels() { od -An -t u1 -j 16 -N 8 "$1" | awk '{ print $4 + 256 * $3 "x" $8 + 256 * $7 }'; }
check "the script's size" 0 '' frame sized.bx --at 10f -o sized.png
is "the script's size, seen" "$(pixels sized.png)" 48x32
check 'the command line wins' 0 '' frame sized.bx --at 10f -o sized.png --size 40x20
is 'the command line wins, seen' "$(pixels sized.png)" 40x20
check 'a film of that size' 0 '1 frame in' render sized.bx --frames 3..3 -o sized-%d.png
is 'a film of that size, seen' "$(pixels sized-3.png)" 48x32
rm sized.bx sized.png sized-3.png
check 'pictures' 0 '3 frames in' render bounce.bx -o p-%03d.png $small --frames 9..11
is 'pictures have the numbers of their frames' "$(ls p-*)" $'p-009.png\np-010.png\np-011.png'
check 'frame' 0 '' frame bounce.bx --at 10f -o one.png $small
verdict 'frame and film make the same picture' "$(cmp -s one.png p-010.png && echo yes)" 'they differ'
check 'no overwriting' 2 'film.mp4 already exists' render bounce.bx -o film.mp4 $small --no-overwrite
check 'no overwriting a picture' 2 'one.png already exists' frame bounce.bx --at 1f -o one.png $small --no-overwrite
check 'an empty script is a film' 0 'frames in' render empty.bx -o empty.gif $small

# The plan of a film.
plan() { "$program" render "$@" --plan 2>&1; }
is 'a plan' "$(plan bounce.bx -o plan.mp4)" '{"first":1,"frames":12,"rate":"24","width":1280,"height":720,"bits":8,"alpha":false,"sound":false}'
is 'a plan of a part' "$(plan bounce.bx -o plan-%d.png --size 64x48 --frames 0.125s..)" '{"first":4,"frames":9,"rate":"24","width":64,"height":48,"bits":8,"alpha":false,"sound":false}'
printf 'rate 30000/1001\nrange 10.5f 20f\ncreate b box\n' >between.bx
is 'a plan between two frames' "$(plan between.bx -o plan.gif $small)" '{"first":10.5,"frames":10,"rate":"30000/1001","width":64,"height":48,"bits":8,"alpha":false,"sound":false}'
{ cat bounce.bx && echo 'background transparent'; } >clear.bx
is 'a plan of what is clear' "$(plan clear.bx -o plan.mov $small)" '{"first":1,"frames":12,"rate":"24","width":64,"height":48,"bits":16,"alpha":true,"sound":false}'
check 'a plan of nothing' 1 "did you mean 'sphere'?" render wrong.bx -o plan.mp4 --plan
check 'a plan of no film' 2 'a film cannot have the extension' render bounce.bx -o plan.mp5 --plan
check 'a plan of no style' 2 'shaded' render bounce.bx -o plan.mp4 --plan --style shadet
check 'a plan of samples' 2 '7 samples per pixel cannot be drawn' render bounce.bx -o plan.mp4 --plan --samples 7
check 'a plan for nowhere' 2 'nowhere' render bounce.bx -o nowhere/plan.mp4 --plan
verdict 'plans make nothing' "$(compgen -G '*plan*' >/dev/null || echo yes)" 'something'

# Missing pictures, and joined pictures.
check 'all pictures' 0 '12 frames in' render bounce.bx -o m-%02d.png $small --frames 1..12 --missing
sha256sum m-*.png >whole.sums
check 'nothing is missing' 0 '0 frames in' render bounce.bx -o m-%02d.png $small --frames 1..12 --missing
has 'what was there is counted' "$said" '12 already were there'
touch -d 2001-01-01 m-*.png
rm m-03.png m-04.png
truncate -s -20 m-07.png
printf x | dd of=m-09.png bs=1 seek=100 conv=notrunc status=none
cp one.png m-11.png && "$program" frame bounce.bx --at 11f -o m-11.png --size 32x24 2>/dev/null
mv m-12.png kept.png
check 'holes' 1 "3 of 12 pictures are missing or broken: 3-4, 12" join m-%02d.png -o joined.mp4 --frames 1..12 --rate 24
check 'a hole in the middle' 1 '2 of 11 pictures are missing or broken: 3-4' join m-%02d.png -o joined.mp4
mv kept.png m-12.png
cp m-01.png m-03.png && cp m-01.png m-04.png
check 'other ones' 1 'have another size: 11' join m-%02d.png -o joined.mp4
check 'other ones are not made anew' 2 'm-11.png has 32x24 pixels, not' render bounce.bx -o m-%02d.png $small --frames 1..12 --missing
check 'nor are those of other bits' 2 'm-01.png has 8 bits a channel, not 16' render bounce.bx -o m-%02d.png $small --frames 1..4 --missing --bits 16
cp m-01.png m-11.png
check 'broken ones' 1 '2 of 12 pictures are missing or broken: 7, 9' join m-%02d.png -o joined.mp4
has 'how they are made' "$said" 'betwixt render SCRIPT -o m-%02d.png --missing'
check 'over themselves' 2 'would overwrite its own pictures' join m-%02d.png -o m-%02d.png
verdict 'nothing was made of them' "$([ ! -e joined.mp4 ] && echo yes)" 'a film'
rm m-03.png m-04.png m-11.png
check 'what is missing' 0 '5 frames in' render bounce.bx -o m-%02d.png $small --frames 1..12 --missing
verdict 'as if it had never been missing' "$(sha256sum --quiet -c whole.sums >/dev/null 2>&1 && echo yes)" 'other pictures'
is 'the others were left alone' "$(find . -name 'm-*.png' ! -newermt 2001-01-02 | wc -l)" 7
check 'join' 0 '12 frames in' join m-%02d.png -o joined.mp4
check 'the same film' 0 '12 frames in' render bounce.bx -o direct.mp4 $small
verdict 'join makes what render makes' "$(cmp -s joined.mp4 direct.mp4 && echo yes)" 'they differ'
check 'its rate' 0 '12 frames in' join m-%02d.png -o joined.mp4 --rate 30000/1001
is 'its rate, seen' "$(ffprobe -v error -select_streams v:0 -show_entries stream=r_frame_rate -of csv=p=0 joined.mp4 | tr -d ,)" 30000/1001
check 'a part' 0 '3 frames in' join m-%02d.png -o joined.gif --frames 2..4
check 'no such pictures' 1 'there are no pictures' join nothing-%d.png -o joined.mp4
check 'no such folder' 1 'there is no folder nowhere' join nowhere/m-%d.png -o joined.mp4
check 'no pictures' 2 'is not a name of numbered pictures' join film.mp4 -o joined.mp4
check 'no number' 2 'of numbered pictures needs one number' join m.png -o joined.mp4
check 'no rate' 2 "'0' is not a rate" join m-%02d.png -o joined.mp4 --rate 0
check 'no range' 2 "'4..2' is not a range of numbers" join m-%02d.png -o joined.mp4 --frames 4..2
check 'no shutter' 2 "'' is not a shutter time" frame bounce.bx --at 1f -o m.png $small --shutter ''
check 'a shutter of nothing' 0 '' frame bounce.bx --at 1f -o m.png $small --shutter 0
check 'missing of a film' 2 '--missing is only for numbered pictures' render bounce.bx -o film.mp4 $small --missing
check 'missing, and nothing overwritten' 2 '--missing excludes --no-overwrite' render bounce.bx -o m-%02d.png --missing --no-overwrite
rm m-*.png whole.sums joined.* direct.mp4
is 'no progress bar without a terminal' "$("$program" render bounce.bx -o film.gif $small 2>&1 | grep -c $'\r')" 0

# Plots.
check 'plot' 0 '' plot bounce.bx ball.position ball.radius -o plot.svg
is 'plot is XML with four curves' "$(grep -c 'stroke-linejoin="round"' plot.svg)" 4
is 'a cut is drawn as a gap' "$(grep -c 'stroke-dasharray' plot.svg)" 1
is 'plot has a dot for each event' "$(grep -c '<circle' plot.svg)" 8
check 'plot of a part' 0 '' plot bounce.bx 'ball.position.y' -o plot.svg --frames 2f..4f
check 'plot of a matrix' 2 'has no numbers to plot' plot bounce.bx ball.world -o world.svg
check 'plot of an object' 0 '' plot bounce.bx ball -o ball.svg

# Sound.
ffmpeg -v error -y -f lavfi -i "aevalsrc='0.8*sin(3000*t)*lt(mod(t,0.25),0.01)':s=44100:d=9" ticks.wav
printf 'rate 24\nrange 1f 48f\ncreate s sound file="ticks.wav" at=13f\ncreate b box\nset b.size.x = "1 + value(\x27s.onsets\x27)"\n' >sound.bx
check 'a film with sound' 0 '48 frames in' render sound.bx -o sound.mp4 $small
is 'it has both' "$(ffprobe -v error -show_entries stream=codec_name,duration -of csv=p=0 sound.mp4)" $'h264,2.000000\naac,2.000000'
# The times of sounds in milliseconds: a tick every quarter of a second, beginning at half a second.
heard() {
  ffmpeg -v error -i "$1" -f s16le -ac 1 -ar 8000 - | od -An -v -td2 -w2 |
    awk '{ if (($1 > 4000 || $1 < -4000) && NR - last > 400) { printf "%s%d", sep, NR / 8; sep = " "; last = NR } }'
}
near() { awk -v a="$1" -v b="$2" 'BEGIN { n = split(a, x, " "); m = split(b, y, " "); ok = n == m; for (i = 1; i <= n; ++i) if (x[i] - y[i] > 2 || y[i] - x[i] > 2) ok = 0; print ok ? "yes" : "" }'; }
verdict 'each tick in its place' "$(near "$(heard sound.mp4)" '500 750 1000 1250 1500 1750')" "$(heard sound.mp4)"
check 'a part of it' 0 '24 frames in' render sound.bx -o part.mp4 $small --frames 16..39
verdict 'cut where the part is' "$(near "$(heard part.mp4)" '125 375 625 875')" "$(heard part.mp4)"
check 'webm' 0 '48 frames in' render sound.bx -o sound.webm $small
verdict 'heard in a webm' "$(near "$(heard sound.webm)" '500 750 1000 1250 1500 1750')" "$(heard sound.webm)"
"$program" render sound.bx -o s-%d.png $small >/dev/null 2>&1
check 'joined with sound' 0 '48 frames in' join s-%d.png -o joined.mp4 --sound sound.bx
verdict 'as if it had been rendered' "$(cmp -s sound.mp4 joined.mp4 && echo yes)" 'they differ'
check 'a part joined with sound' 0 '24 frames in' join s-%d.png -o joined.mp4 --frames 16..39 --sound sound.bx
verdict 'as if it had been rendered in part' "$(cmp -s part.mp4 joined.mp4 && echo yes)" 'they differ'
sed 's/rate 24/rate 25/' sound.bx >other.bx
check 'the rate of the sounds' 0 '48 frames in' join s-%d.png -o other.mp4 --sound other.bx
is 'the rate of the sounds, seen' "$(ffprobe -v error -select_streams v:0 -show_entries stream=r_frame_rate -of csv=p=0 other.mp4 | tr -d ,)" 25/1
check 'another rate' 0 'its sounds will be out of sync' join s-%d.png -o other.mp4 --sound other.bx --rate 24
check 'no sound in a gif' 2 '--sound: joined.gif cannot have sound' join s-%d.png -o joined.gif --sound sound.bx
check 'no script of sounds' 1 'nobody.bx' join s-%d.png -o joined.mp4 --sound nobody.bx
rm s-*.png joined.mp4
check 'who has no sound says so' 0 'silent.gif cannot have sound; .mp4, .webm and .mov can' render sound.bx -o silent.gif $small --frames 1..3
check 'what can be asked' 0 's.onsets  3' eval sound.bx --at 26f s.onsets
check 'and be used' 0 'b.size.x  4' eval sound.bx --at 26f b.size.x
check 'silence before it' 0 's.loudness  0' eval sound.bx --at 1f s.loudness
said=$(PATH=/nowhere "$program" check sound.bx 2>&1)
has 'without ffmpeg' "$said" 'sounds need the program ffmpeg, which is not installed'
mkdir -p below && printf 'create s sound file="../ticks.wav"\n' >below/out.bx
check 'a sound of elsewhere' 1 "'../ticks.wav' is outside the script's folder" check below/out.bx
head -c 3000 /dev/urandom >noise.wav && printf 'create s sound file="noise.wav"\n' >noise.bx
check 'noise' 1 'noise.wav is broken or not a sound' check noise.bx
printf 'create s sound\n' >noise.bx
check 'no file' 1 'a sound needs its file' check noise.bx
rm -rf below sound.* part.mp4 silent.gif ticks.wav noise.*

# Failures of the machine.
ln -s "$(command -v true)" ./true
said=$(PATH=$work "$program" render bounce.bx -o gone.mp4 $small 2>&1)
is 'without ffmpeg' "$?" 3
has 'without ffmpeg, what to do' "$said" 'sudo apt-get install ffmpeg'
mkdir bin && printf '#!/bin/sh\nhead -c 9000 >/dev/null\nkill -9 $$\n' >bin/ffmpeg && chmod +x bin/ffmpeg
said=$(PATH=$work/bin:$PATH "$program" render bounce.bx -o gone.mp4 $small 2>&1)
is 'ffmpeg is killed' "$?" 3
has 'ffmpeg is killed, in words' "$said" 'signal 9'
# TeX formulas, with fake programs latex and dvisvgm.
printf 'create f text tex="x^2"\n' >formula.bx
printf '#!/bin/sh\n: >formula.dvi\n' >bin/latex && chmod +x bin/latex
cat >bin/dvisvgm <<'END'
#!/bin/sh
echo "<svg><rect width='72' height='72'/><rect x='72' y='62' width='10' height='10'/></svg>" >formula.svg
END
chmod +x bin/dvisvgm
said=$(PATH=$work/bin:$PATH "$program" check formula.bx 2>&1)
is 'a formula without --tex' "$?" 0
printf 'create f text tex="\\\\newcommand"\n' >unknown.bx
said=$(PATH=$work/bin:$PATH "$program" check unknown.bx 2>&1)
has 'what only LaTeX knows, what to do' "$said" '--tex lets LaTeX typeset it'
said=$(PATH=$work/bin:$PATH "$program" frame formula.bx --tex --at 1f -o formula.png --size 64x48 2>&1)
is 'a formula with --tex' "$? $said" '0 '
said=$(PATH=$work "$program" check formula.bx --tex 2>&1)
is 'a formula without latex' "$?" 1
has 'a formula without latex, what to do' "$said" 'sudo apt-get install texlive-latex-base dvisvgm'
mkdir disk
if mount -t tmpfs -o size=4k tmpfs disk 2>/dev/null; then
  for o in film.mp4 film.gif 'p%d.png'; do
    check "disk full: $o" 3 'no space left' render bounce.bx -o "disk/$o" --size 640x480
    is "disk full: $o leaves nothing" "$(ls -A disk)" ''
  done
  check 'disk full: a picture' 3 'disk' frame bounce.bx --at 3f -o disk/a.png --size 1280x720
  is 'disk full: no picture' "$(ls -A disk)" ''
  umount disk
fi
for signal in INT TERM; do
  for o in stop.mp4 stop.gif stop-%d.png; do
    "$program" render bounce.bx -o $o $small --frames 1f..1000000f 2>said &
    pid=$!
    for _ in $(seq 1200); do [ "$(leftovers)" -gt 0 ] && break; sleep 0.05; done
    sleep 0.2
    kill -$signal $pid
    wait $pid
    is "$signal stops $o" "$?" 130
    has "$signal says so" "$(<said)" "betwixt: stopped; $o was not made"
  done
done
is 'nothing of them is left' "$(ls -A | grep -c -e stop -e gone)" 0
is 'no partial files' "$(leftovers)" 0

# In a terminal.
if command -v script >/dev/null; then
  script -qec "'$program' play bounce.bx --terminal --size 64x48 </dev/null" played >/dev/null </dev/null
  is 'play ends by itself where nobody can press a key' "$?" 0
  verdict 'play puts the screen back' "$(tail -c 200 played | grep -q $'\e\[?25h\e\[?1049l' && echo yes)" "$(tail -c 100 played | od -c | tail -8)"
  verdict 'play tells the note' "$(grep -q '"falling"' played && echo yes)" 'no note'
  printf 'range 1f 3f\ncreate b sphere\nat 2f note "one"\nat 2f note "two"\nat 2.5f note "three"\n' >notes.bx
  { cat notes.bx; echo 'notes off'; } >off.bx
  script -qec "'$program' play notes.bx --size 16x9 </dev/null" played >/dev/null </dev/null
  verdict 'play tells all notes' "$(grep -q '"one" "two"' played && grep -q '"three"' played && echo yes)" 'not all'
  script -qec "'$program' play off.bx --size 16x9 </dev/null" played >/dev/null </dev/null
  verdict 'notes off' "$(grep -q '"one"' played || echo yes)" 'a note'
  script -qec "'$program' render bounce.bx -o bar.mp4 $small --frames 1f..600f" bar </dev/null >/dev/null
  is 'render on a terminal' "$?" 0
  verdict 'a progress bar' "$(grep -qE '\] [0-9]+/600' bar && echo yes)" "$(cat bar)"
fi

printf 'create a sphere position=(1 2 3)\nat 1f..25f a.motion T(8 0)\n' >moved.bx
check 'where a motion has put something' 0 'a.world.x  5' eval moved.bx --at 13f a.world.x
check 'where it goes' 0 '' plot moved.bx a.world.x -o moved.svg
has 'a plot of where it goes' "$(cat moved.svg 2>&1)" 'a.world.x'
# ---- the studio, if it is not built, or without a display
is 'a window without a display' "$(env -u DISPLAY -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM "$program" studio 2>&1; echo $?)" \
  "betwixt: error: a window needs a display
  set DISPLAY, or save a picture of the window: --screenshot OUT.png
3"
is 'a studio that is not built' "$(BETWIXT_STUDIO=/none "$program" studio --screenshot x.png 2>&1; echo $?)" \
  "betwixt: error: the studio is missing
  to build it: ./betwixt studio; in an installation it is beside betwixt if it was built with it
3"
"$program" studio --layout heap --screenshot x.png >/dev/null 2>&1
is 'a layout that there is not' $? 2

summary
