#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests transparency and linear light in every kind of file, as other programs read it: ffprobe, ffmpeg and alpha.py.
#   alpha_test.sh PROGRAM
tests=$(realpath -- "$(dirname -- "$0")")
. "$tests/support.sh" || exit 3
export LC_ALL=C.UTF-8

reads() { is "$1" "$(python3 "$tests/alpha.py" "${@:2}" 2>&1 | tail -1)" well; } # NAME COMMAND FILE…
probe() { ffprobe -v error -select_streams v:0 -show_entries "stream=$2" -of default=nw=1:nk=1 "$1" | xargs; }
same_pictures() { # NAME A B: to the bit, as they are decoded
  local by=
  [[ $2 == *.webm ]] && by='-c:v libvpx-vp9'
  is "$1" "$(ffmpeg -v error $by -i "$2" -f md5 -)" "$(ffmpeg -v error $by -i "$3" -f md5 -)"
}

# Glowing objects with exact colours, their borders, and glass over the background and over another object.
cat >clear.bx <<'BX'
rate 24
range 1f 4f
size 96x64
background transparent
create card rectangle size=(3 2) color=white material=glow
create ball sphere radius=1.2 color=#ff8000 material=glow
create glass sphere radius=1 color=#3080ff transparency=0.6 material=glow
create pane rectangle size=(2 2) color=#20c040 transparency=0.3 material=glow
create eye camera position=(0 0 14) look-at=(0 0 0)
set card.position (-2.5 1 0)
set glass.position (1.7 -0.5 2)
set pane.position (4 1 0)
ball.position
  1f (-1 -1 1)
  4f (0 -1 1)
BX
sed 's/background transparent/background #204060/' clear.bx >opaque.bx
for o in c-%d.png c-%d.exr c.webm c.mov c.gif c.apng; do check "render $o" 0 '4 frames' render clear.bx -o $o; done
check 'render 16 bits' 0 '4 frames' render clear.bx -o d-%d.png --bits 16
is 'pictures' "$(ls c-*.png c-*.exr d-*.png | xargs)" 'c-1.exr c-1.png c-2.exr c-2.png c-3.exr c-3.png c-4.exr c-4.png d-1.png d-2.png d-3.png d-4.png'

# Compares as other programs read the files. The limits: the average over black and white, the largest difference of
# opacity, and that of the colour of half transparent pixels.
has 'PNG: nothing, all and between' "$(python3 "$tests/alpha.py" clear c-1.png)" ''
is 'PNG: something between' "$(($(python3 "$tests/alpha.py" clear c-1.png) > 4))" 1
reads 'PNG of 16 bits' sixteen c-1.png d-1.png
reads 'OpenEXR' light d-1.png c-1.exr
reads 'APNG' compare c-1.png c.apng 0 0 0
reads 'ProRes' compare c-1.png c.mov 0.6 2 3
reads 'WebM' compare c-1.png c.webm 1.5 12 6
reads 'GIF: clear or not' on-or-off c-1.png c.gif
tags=codec_name,profile,pix_fmt,width,height,color_range,color_space,color_transfer,color_primaries,r_frame_rate
is 'tags of ProRes' "$(probe c.mov $tags)" 'prores 4444 96 64 yuva444p12le tv bt709 bt709 bt709 24/1'
is 'tags of WebM' "$(probe c.webm $tags)" 'vp9 Profile 0 96 64 yuv420p tv bt709 bt709 bt709 24/1'
is 'WebM says that it has an opacity' "$(ffprobe -v error -show_entries stream_tags=alpha_mode -of csv=p=0 c.webm)" 1
is 'tags of PNG' "$(probe d-1.png codec_name,pix_fmt,color_range)" 'png rgba64be pc'
is 'PNG says that it is sRGB' "$(grep -c sRGB d-1.png)" 1
is 'tags of OpenEXR' "$(probe c-1.exr codec_name,pix_fmt,width,height)" 'exr 96 64 gbrapf32le'

# A single picture equals that picture of a film.
check 'frame 8' 0 '' frame clear.bx --at 2f -o f.png
check 'frame 16' 0 '' frame clear.bx --at 2f -o f16.png --bits 16
check 'frame exr' 0 '' frame clear.bx --at 2f -o f.EXR
verdict 'frames are those of films' "$(cmp f.png c-2.png && cmp f16.png d-2.png && cmp f.EXR c-2.exr && echo yes)" 'they differ'

# Blurred edges fade to transparent, not to black.
sed -n '/^rate/,/^background/p' clear.bx >blurred.bx
printf 'create ball sphere color=#ff8000 material=glow\ncreate eye camera position=(0 0 14) shutter=180deg\nball.position\n  1f (-3 0 0)\n  4f (3 0 0) linear\n' >>blurred.bx
check 'blurred' 0 '' frame blurred.bx --at 2f -o blurred.png
reads 'blurred' one-colour blurred.png 255 128 0

# Light above white is kept in the file, and is shown as white.
printf 'range 1f 1f\nsize 64x48\ncreate w rectangle size=(9 9) color=white material=matte\ncreate l light position=(0 0 4) range=8 intensity=5\ncreate e camera position=(0 0 9) height=6\nambient off\n' >bright.bx
check 'bright' 0 '' frame bright.bx --at 1f -o bright.exr
is 'light of a lamp at half its range' "$(python3 "$tests/alpha.py" bright bright.exr)" 2.2 # 0.8 * 5 * (1 - 1/4)²

# In formats without transparency the background is black, with a warning. Opaque films are opaque in every format.
check 'mp4' 0 'notice: c.mp4 has no transparency, so transparent parts are black; .webm, .mov and pictures have it' render clear.bx -o c.mp4
is 'mp4 is black' "$(ffmpeg -v error -i c.mp4 -frames:v 1 -vf crop=4:2:0:0 -f rawvideo -pix_fmt gray - | od -An -tu1 | xargs)" '0 0 0 0 0 0 0 0'
for o in o.mov o.webm o.mp4 o-%d.png; do
  check "opaque $o" 0 '' render opaque.bx -o $o
  is "opaque $o: nothing is said" "$(grep -c notice <<<"$said")" 0
done
is 'opaque ProRes' "$(probe o.mov pix_fmt)" yuv444p12le
is 'opaque WebM' "$(ffprobe -v error -show_entries stream_tags=alpha_mode -of csv=p=0 o.webm)" ''

# Joined pictures give the same film as `render`.
check 'join png' 0 '' join o-%d.png -o oj.mp4
verdict 'of PNG: the very bytes' "$(cmp oj.mp4 o.mp4 && echo yes)" 'they differ'
check 'join 16 bits' 0 '' join d-%d.png -o dj.mov
verdict 'of 16 bits: the very bytes' "$(cmp dj.mov c.mov && echo yes)" 'they differ'
check 'join to webm' 0 '' join c-%d.png -o cj.webm
same_pictures 'of PNG: the very pictures' cj.webm c.webm
check 'join exr to mov' 0 '' join c-%d.exr -o ej.mov
reads 'OpenEXR to ProRes' compare c-1.png ej.mov 0.6 2 3
check 'join exr to png' 0 '' join c-%d.exr -o ep-%d.png
reads 'OpenEXR to PNG' compare c-1.png ep-1.png 0.1 1 1
check 'join to mp4' 0 'notice: ej.mp4 has no transparency' join c-%d.exr -o ej.mp4
check 'join png to mp4' 0 'notice: cj.mp4 has no transparency' join c-%d.png -o cj.mp4
for f in ej cj; do
  psnr=$(ffmpeg -i $f.mp4 -i c.mp4 -lavfi psnr -f null - 2>&1 | grep -o 'average:[0-9.inf]*' | cut -d: -f2)
  is "$f.mp4 over black is what is rendered" "$(awk -v x="$psnr" 'BEGIN {print (x == "inf" || x > 44)}')" 1
done
# The first picture decides whether the joined film is transparent, unless --alpha is given.
mkdir later && cp o-1.png later/f-1.png && cp c-2.png later/f-2.png
check 'join, later clear' 0 '' join later/f-%d.png -o later.mov
is 'the first picture says whether there is an opacity' "$(probe later.mov pix_fmt)" yuv444p12le
check 'join --alpha' 0 '' join later/f-%d.png --alpha -o later2.mov
is 'or --alpha' "$(probe later2.mov pix_fmt)" yuva444p12le

# --missing makes only pictures that are missing, cut off or of another kind.
cp c-3.exr before.exr
rm c-2.exr && truncate -s -1 c-3.exr && cp d-1.png c-4.exr
check 'render --missing' 0 '3 frames' render clear.bx -o c-%d.exr --missing
verdict 'it is as it was' "$(cmp c-3.exr before.exr && [ "$(head -c 4 c-4.exr | od -An -tx1 | xargs)" = '76 2f 31 01' ] && echo yes)" 'it differs'
truncate -s -1 c-3.exr
check 'join, one cut' 1 'c-%d.exr' join c-%d.exr -o broken.mov
verdict 'nothing is made then' "$([ ! -e broken.mov ] && echo yes)" "$(ls)"

# Flat films need no graphics interface; others say that there is none.
printf 'film flat\ncreate c circle\n' >flat.bx
printf 'create s sphere\n' >solid.bx
export __EGL_VENDOR_LIBRARY_FILENAMES=/dev/null
check 'a flat picture without graphics' 0 '' frame flat.bx -o flat.png
check 'a solid picture without graphics' 3 'graphics are not available' frame solid.bx -o solid.png
is 'nothing was made' "$(ls | grep -c '^solid.png')" 0
unset __EGL_VENDOR_LIBRARY_FILENAMES

# Wrong options.
printf 'background transparant\n' >wrong.bx
check 'transparant' 1 "did you mean 'transparent'?" check wrong.bx
printf 'background transparent to red\n' >wrong.bx
check 'transparent to' 1 "'to' is not expected here" check wrong.bx
check 'bits 12' 2 "--bits" render clear.bx -o x-%d.png --bits 12
for o in x.mp4 x.mov x-%d.exr; do check "16 bits of $o" 2 '--bits 16 is only for numbered PNG' render clear.bx -o $o --bits 16; done
check '16 bits of one exr' 2 '--bits is for PNG' frame clear.bx --at 1f -o x.exr --bits 16
check 'frame gif' 2 'one picture must be a .png, .jpg or .exr, not "x.gif"' frame clear.bx --at 1f -o x.gif
check 'a JPEG is not clear' 0 'x.jpg has no transparency, so transparent parts are black' frame clear.bx --at 1f -o x.jpg
rm -f x.jpg
check 'an unknown ending' 2 '.mp4 .webm .mov .gif .apng' render clear.bx -o x.avi
check 'one exr for a film' 2 'needs one number, unlike "x.exr"' render clear.bx -o x.exr
check 'no folder' 2 'there is no folder' render clear.bx -o no/x-%d.exr
check 'no folder: frame' 2 'there is no folder' frame clear.bx --at 1f -o no/x.exr
check 'no-overwrite' 2 'already exists' frame clear.bx --at 1f -o f.EXR --no-overwrite
is 'nothing was made' "$(ls | grep -c '^x')" 0
mkdir disk
if mount -t tmpfs -o size=4k tmpfs disk 2>/dev/null; then
  for o in 'x-%d.exr' x.mov x.webm; do
    check "disk full: $o" 3 'o space left' render clear.bx -o "disk/$o" --size 640x480
    is "disk full: $o leaves nothing" "$(ls -A disk)" ''
  done
  check 'disk full: a picture' 3 'no space left' frame clear.bx --at 1f -o disk/a.exr --size 640x480
  check 'disk full: 16 bits' 3 'no space left' frame clear.bx --at 1f -o disk/a.png --bits 16 --size 640x480
  is 'disk full: no picture' "$(ls -A disk)" ''
  umount disk
fi

summary
