#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests wrong input of every kind. The program must print a clear message, end with the right exit code, and leave no
# incomplete file.
#   bad_input_test.sh PROGRAM
. "$(dirname -- "$0")/support.sh" || exit 3
out=$work.out err=$work.err

# call NAME EXIT-CODE TEXT ARGUMENT…: runs the program. Stderr must contain TEXT, and stdout is empty unless the code is
# 0.
call() {
  local name=$1 code=$2 text=$3 got
  shift 3
  timeout 60 "$program" "$@" >"$out" 2>"$err" </dev/null
  got=$?
  verdict "$name" "$([ $got = "$code" ] && { [ -z "$text" ] || grep -qF -- "$text" "$err"; } && { [ "$code" = 0 ] || [ ! -s "$out" ]; } && echo yes)" \
    "exit code $got (not $code?), said: $(head -c 600 "$err"), answered: $(head -c 300 "$out")"
}
# bad NAME TEXT: checks that every command that reads scripts refuses NAME.bx with a message that contains TEXT.
bad() {
  call "check $1" 1 "$2" check "$1.bx"
  call "eval $1" 1 "$2" eval "$1.bx" --at 1f --json
  call "tidy $1" 1 "$2" tidy "$1.bx"
}
# line TEXT SCRIPT-LINE: checks that a script with that line is refused with a message that contains TEXT.
line() {
  printf 'create ball sphere\ncreate eye camera\n%s\nset ball.radius 2\n' "$2" >line.bx
  call "line '$2'" 1 "$1" check line.bx
  verdict "place of '$2'" "$(grep -qE '^line.bx:3:[0-9]+: error: ' "$err" && grep -q '\^' "$err" && echo yes)" "$(cat "$err")"
}

# Malformed lines of each kind.
line "did you mean 'create'?" 'crate b sphere'
line "did you mean 'sphere'?" 'create b spere'
line "did you mean 'radius'?" 'create b sphere radios=2'
line "did you mean 'ball'?" 'set bal.radius 2'
line "did you mean 'gold'?" 'set ball.color glod'
line "did you mean 'linear'?" 'at 5f ball.radius 2 liner'
line 'already' 'create ball box'
line 'cannot be a name' 'create 1ball box'
line 'a frame number' 'at 5 ball.radius 2'
line 'not a unit of time' 'at 5q ball.radius 2'
line 'is not a number' 'set ball.radius nan'
line 'is not a number' 'set ball.radius inf'
line 'is not a number' 'set ball.radius -inf'
line 'too large for a number' 'set ball.radius 1e400'
line 'too large for a number' 'set ball.radius -1e400'
line '146 years' 'at 1e300s ball.radius 2'
line '146 years' 'at 999999999999f ball.radius 2'
line 'a vector' 'set ball.position 5'
line 'expected a number' 'set ball.radius (1 2 3)'
line 'expected 3 numbers' 'set ball.scale (1 2)'
line 'only 3 numbers' 'set ball.position (1 2 3 4)'
line 'never closed' 'set ball.position (1 2 3'
line 'expected here' 'set ball.radius 1 )'
line 'not closed on the same line' 'at 5f note "open'
line 'never closed by' 'at 5f note """open'
line '3 or 6 digits' 'set ball.color #12345'
line 'an angle needs a unit' 'set eye.fov 50'
line 'f-stop must be at least 0.0001' 'set eye.f-stop 0'
line "'eye' cannot focus on itself" 'set eye.focus eye'
line 'greater than 0 m' 'set eye.focus -3'
line 'write 90deg (360deg is a frame)' 'set eye.shutter 90'
line 'the number of subframes must be' 'subframes 0'
line 'on or off' 'set ball.display maybe'
line 'ends before it begins' 'range 9f 1f'
line 'per second' 'rate 0'
line 'per second' 'rate -24'
line 'per second' 'rate 24/0'
line 'not a camera' 'at 5f look through ball'
line 'itself' 'couple ball to ball'
line 'a twerper is missing' 'twerper ball.radius'
line "there is no file 'none.obj'" 'create m mesh file="none.obj"'
line "there is no file 'none.png'" 'create m sphere texture="none.png"'
line "there is no file 'none.bx'" 'use none.bx'
line 'includes itself' 'use line.bx'
line "outside the script's folder" 'use "/etc/passwd"'
line 'itself' 'hang ball on ball'
line "there is no environment 'spin'" 'halt spin'
line 'unexpected symbol' 'at 5f ball.radius = "t +"'
line 'is a shell command' 'undo'
for b in '\001' '\377' '\303' '\300\257' '\355\240\200'; do
  printf "create ball sphere\nset ball.radius 2 $b\n" >line.bx
  call "byte $b" 1 'line.bx:2:19: error: this is not a text' check line.bx
done

# All errors in one run, in the order of the file.
printf 'create b spere\n\nset c.radius 1\nball.position\n  1f (0 0 0)\n  2f junk\nrate fast\n' >all.bx
bad all 'all.bx:1:10: error: '
is 'all errors are said' "$(grep -c ': error: ' "$err")" 4
timeout 60 "$program" check all.bx 2>&1 >/dev/null | grep -q '^4 errors' && verdict 'errors are counted' yes '' || verdict 'errors are counted' no "$(tail -1 "$err")"

# Meshes that cannot be read.
printf 'not a mesh at all\001\002' >broken.obj
printf 'glTF\002\000\000\000' >broken.glb
printf 'ply\nformat ascii 1.0\nelement vertex 4000000000\n' >broken.ply
: >empty.obj
for m in broken.obj broken.glb broken.ply empty.obj none.stl .; do
  printf 'create m mesh file="%s"\n' "$m" >mesh.bx
  call "mesh $m" 1 'mesh.bx:1:20: error: ' check mesh.bx
  call "eval with mesh $m" 1 'mesh.bx:1:20: error: ' eval mesh.bx --at 1f --json
done
# A mesh that crashes the process that reads it is an ordinary error.
{ printf '; FBX 7.4.0 project file\n' && printf 'A: {%.0s' {1..50000}; } >deep.fbx
printf 'create m mesh file="deep.fbx"\n' >deep.bx
call 'a mesh that is too deep' 1 'deep.fbx is damaged: the program that reads it crashed' check deep.bx

# Files that are no scripts are not quoted in messages.
printf 'password = hunter2\n' >secret
printf 'use secret\n' >uses.bx
call 'use of something else' 1 "'secret' is not a script: its line 1 is not a command" check uses.bx
verdict 'without its words' "$(grep -q hunter "$err" || echo yes)" "$(cat "$err")"
mkfifo pipe
printf 'use pipe\n' >uses.bx
call 'use of a pipe' 1 "'pipe' is not a regular file" check uses.bx

# Absurd sizes.
printf 'rate 24\n' >huge.bx && truncate -s 3G huge.bx
SECONDS=0
bad huge 'too large for a script: 3.2 GB'
verdict '3 GB are refused soon' "$([ $SECONDS -lt 20 ] && echo yes)" "$SECONDS s"
python3 -c 'print("set ball.position " + "(" * 100000 + ")" * 100000)' >deep.bx 2>/dev/null ||
  { printf 'set ball.position '; head -c 100000 /dev/zero | tr '\0' '('; head -c 100000 /dev/zero | tr '\0' ')'; } >deep.bx
bad deep 'deep.bx:1:5: error: there is no object'
{ printf 'create p polygon points='; head -c 100000 /dev/zero | tr '\0' '('; } >deep2.bx
bad deep2 'deep2.bx:1:'
yes 'what is this ((( """ {' | head -n 100000 >garbage.bx
SECONDS=0
bad garbage 'more than 1000 errors'
verdict '100,000 lines of garbage end soon' "$([ $SECONDS -lt 60 ] && echo yes)" "$SECONDS s"
head -c 20000000 /dev/zero | tr '\0' 'a' >long.bx
bad long 'there is no command'
verdict 'a message stays short' "$([ "$(wc -c <"$err")" -lt 2000 ] && echo yes)" "$(wc -c <"$err") bytes"

# Files that are no scripts.
head -c 65536 /dev/urandom >binary.bx
bad binary 'this is not a text'
cp "$program" program.bx
bad program 'this is not a text'
mkdir folder.bx
bad folder 'is a folder, not a script'
bad missing "there is no file 'missing.bx'"
printf 'rate 24\n' >secret.bx && chmod 000 secret.bx
if ! cat secret.bx >/dev/null 2>&1; then
  bad secret 'cannot be read'
elif command -v setpriv >/dev/null && cp "$program" prog 2>/dev/null && chmod 755 . prog; then
  # root can read every file, so run this as the user nobody
  setpriv --reuid 65534 --regid 65534 --clear-groups ./prog check secret.bx >"$out" 2>"$err" </dev/null
  is 'an unreadable file' "$?" 1
  verdict 'an unreadable file, in words' "$(grep -q 'cannot be read: Permission denied' "$err" && echo yes)" "$(cat "$err")"
fi
chmod 644 secret.bx

# Unusual, but valid.
: >empty.bx
printf '\n\n   \n# nothing' >blank.bx
printf '\357\273\277create ball sphere\r\nball.radius\r\n  1f 1\r\n  9f 2' >dos.bx
printf '#!/usr/bin/env betwixt\ncreate ball sphere' >bang.bx
for f in empty blank dos bang; do
  call "check $f" 0 '' check $f.bx
  is "check $f says so" "$(cut -d, -f1 "$out")" "$f.bx: no errors"
  call "tidy $f" 0 '' tidy $f.bx
  call "eval $f" 0 '' eval $f.bx --at 1f --json
done
is 'eval of nothing' "$("$program" eval empty.bx --at 1f --json)" '{"times":[{"at":"1f","seconds":0,"values":{}}]}'
is 'eval of dos' "$("$program" eval dos.bx --at 9f ball.radius --json)" \
  '{"times":[{"at":"9f","seconds":0.3333333333333333,"values":{"ball.radius":2}}]}'
is 'a pipe is a file too' "$(printf 'create b sphere\n' | "$program" eval /dev/stdin --at 1f b.radius --json)" \
  '{"times":[{"at":"1f","seconds":0,"values":{"b.radius":1}}]}'

# `use` of the script itself, in a circle, of a file outside the folder, through a link.
mkdir -p film/parts
printf 'use main.bx\n' >film/main.bx
call 'use of itself' 1 "film/main.bx:1:5: error: 'main.bx' includes itself" check film/main.bx
printf 'use parts/a.bx\n' >film/main.bx
printf '# circle\nuse "../main.bx"\n' >film/parts/a.bx
call 'use in a circle' 1 "film/parts/a.bx:2:5: error: '../main.bx' includes itself" check film/main.bx
printf 'create out sphere\n' >outside.bx
ln -s ../outside.bx film/link.bx
for u in ../outside.bx link.bx "$work/outside.bx"; do
  printf 'use "%s"\n' "$u" >film/main.bx
  call "use of $u" 1 "is outside the script's folder" check film/main.bx
  call "use of $u with leave" 0 '' check film/main.bx --read-anywhere
done
printf 'create m mesh file="../broken.obj"\n' >film/main.bx
call 'a mesh outside' 1 "is outside the script's folder" check film/main.bx

# Stdout has only the answer of eval.
cat >bounce.bx <<'BX'
rate 24
range 1f 72f
create ball sphere radius=1 color=gold
BX
cat >>bounce.bx <<'BX'
create t text text="say \"hi\"\n\ttab é"
create eye camera look-at=ball
ball.position
  1f  (0 10 0)
  12f (4 1 0) linear
  24f (8 10 0) ease-in=4f
set nobody*.color red
t.rotation
  1f euler(0 0 0)
  9f axis(z 90deg)
BX
"$program" eval bounce.bx --at 24f,12f,-1s,0.1s ball.position ball.world ball.position.y 't.*' eye.look-at 'nobody*.color' --json >"$out" 2>"$err"
is 'eval' "$?" 0
has 'warnings go to stderr' "$(cat "$err")" warning
if command -v python3 >/dev/null; then
  verdict 'eval answers in JSON' "$(python3 -m json.tool "$out" >/dev/null 2>"$err" && echo yes)" "$(cat "$err" "$out")"
fi
is 'one line' "$(wc -l <"$out")" 1
verdict 'times in the order asked' "$(grep -qE '^\{"times":\[\{"at":"24f","seconds":0\.9583333333333334,"values":\{"ball\.position":\[8,10,0\],"ball\.world":\[1,0,0,8,0,1,0,10,0,0,1,0,0,0,0,1\],"ball\.position\.y":10,.*\{"at":"12f","seconds":0\.4583333333333333,.*\{"at":"-1s","seconds":-1,.*\{"at":"0\.1s","seconds":0\.1,' "$out" && echo yes)" "$(cat "$out")"
verdict 'texts, names and booleans' "$(grep -qF '"t.text":"say \"hi\"\n\u0009tab é"' "$out" && grep -qF '"eye.look-at":"ball"' "$out" && grep -qF '"t.display":true' "$out" && echo yes)" "$(cat "$out")"
printf 'create b sphere scale=(1e300 1 1)\ncreate b/c sphere scale=(1e300 1 1) position=(1e300 1e300 0)\n' >vast.bx
"$program" eval vast.bx --at 1f --json >"$out" 2>"$err"
verdict 'no inf or nan in JSON' "$(! grep -qiE 'inf|nan' "$out" && echo yes)" "$(cat "$out")"
call 'eval of nobody' 1 "there is no object 'bal'" eval bounce.bx --at 1f bal.position --json
call 'eval of no function' 1 "did you mean 'position'?" eval bounce.bx --at 1f ball.postion
call 'eval of a velocity that is not' 1 'has no velocity' eval bounce.bx --at 1f ball.display.velocity --json
call 'eval without a time: the first frame' 0 '' eval bounce.bx ball.position
call 'eval at a word' 2 "'soon' is not a time" eval bounce.bx --at soon ball.position
call 'eval at a bare number: a frame' 0 '' eval bounce.bx --at 24 ball.position
call 'eval without a file' 2 'FILE' eval --at 1f
call 'check without a file' 2 'FILE' check
call 'tidy with one word more' 2 "'more'" tidy bounce.bx more
is 'a pattern that names nothing is a notice' "$("$program" eval bounce.bx --at 1f 'zz*.color' --json 2>/dev/null)" \
  '{"times":[{"at":"1f","seconds":0,"values":{}}]}'

# tidy writes in place, keeps permissions and links, and does not change scripts with errors.
printf 'rate   25\ncreate  b sphere  # gold\n' >loose.bx && chmod 640 loose.bx && ln -s loose.bx alias.bx
call 'tidy prints' 0 '' tidy loose.bx
is 'tidy' "$(cat "$out")" $'rate 25\ncreate b sphere  # gold'
is 'tidy only prints' "$(head -1 loose.bx)" 'rate   25'
call 'tidy writes' 0 '' tidy alias.bx --write
is 'tidy says nothing then' "$(cat "$out" "$err")" ''
is 'tidy wrote' "$(cat loose.bx)" $'rate 25\ncreate b sphere  # gold'
is 'rights stay' "$(stat -c %a loose.bx)" 640
verdict 'a link stays' "$([ -L alias.bx ] && echo yes)" "$(ls -l alias.bx)"
cp all.bx before.bx
call 'tidy leaves errors alone' 1 'error' tidy all.bx --write
verdict 'nothing is changed' "$(cmp -s all.bx before.bx && echo yes)" 'all.bx has changed'
call 'tidy of a pipe' 2 'only a file' tidy /dev/stdin --write

# Output that cannot be written, a full disk, a missing program: no incomplete file is left.
small='--size 64x48 --samples 1'
printf 'create ball sphere\nrange 1f 4f\nat 1f ball.radius 1\n' >film.bx
call 'render into no folder' 2 'there is no folder' render film.bx -o nowhere/a.mp4 $small
call 'frame into no folder' 2 'there is no folder' frame film.bx --at 1f -o nowhere/a.png $small
call 'plot into no folder' 2 'nowhere' plot film.bx ball.radius -o nowhere/a.svg
for o in a.mp4 a.gif a.webm a.apng; do
  PATH=$work/none "$program" render film.bx -o $o $small >"$out" 2>"$err" </dev/null
  is "no ffmpeg: $o" "$?" 3
  verdict "no ffmpeg in words: $o" "$(grep -q ffmpeg "$err" && [ ! -s "$out" ] && echo yes)" "$(cat "$err")"
done
PATH=$work/none "$program" frame film.bx --at 1f -o alone.png $small 2>"$err"
is 'one picture needs no ffmpeg' "$?" 0
mkdir -p disk
if mount -t tmpfs -o size=4k tmpfs disk 2>/dev/null; then
  head -c 4096 /dev/zero >disk/filler 2>/dev/null
  for o in a.mp4 a.gif p%d.png; do call "disk full: $o" 3 '' render film.bx -o "disk/$o" --size 640x480; done
  call 'disk full: frame' 3 '' frame film.bx --at 1f -o disk/a.png $small
  call 'disk full: plot' 3 '' plot film.bx ball.radius -o disk/a.svg
  is 'disk full: nothing stays' "$(ls -A disk)" filler
  rm disk/filler
  { printf 'create  ball sphere\n'; head -c 3900 /dev/zero | tr '\0' '\n'; printf '#  x\n'; } >disk/t.bx
  before=$(md5sum <disk/t.bx)
  call 'disk full: tidy' 3 'cannot be written' tidy disk/t.bx --write
  is 'disk full: the script is as it was' "$(md5sum <disk/t.bx)" "$before"
  is 'disk full: nothing stays beside it' "$(ls -A disk)" t.bx
  umount disk
fi
"$program" eval film.bx --at 1f --json >/dev/full 2>"$err"
is 'an answer that cannot be written' "$?" 3
"$program" tidy film.bx >/dev/full 2>"$err"
is 'a tidy script that cannot be written' "$?" 3
verdict 'nothing half-written' "$(! find . -name '*partial*' -o -name 'a.[mgws]*' | grep -q . && echo yes)" "$(find . -name '*partial*' -o -name 'a.[mgws]*')"

summary
