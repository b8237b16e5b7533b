#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# examples.sh PROGRAM: renders every example in a small size. Each film must have as many frames as its range. Then
# checks some values of some examples.
# shows: G3 G5 G12 G21 G54 G55 G56 G58 G82 G83 G96 G97 G105
# shows: G4 G52 G63
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
program=$1 folder=$(mktemp -d) passed=0 failed=0
trap 'rm -rf "$folder"' EXIT
. "$root/tests/timed.sh"
for script in "$root"/examples/*.bx; do
  name=$(basename "$script" .bx) film=$folder/$name.mp4
  # The number of frames comes from `range 1f 72f`. Without a range, the last event is the last frame.
  expected=$(sed -nE 's/^range +([0-9]+)f +([0-9]+)f.*/\2-\1+1/p' "$script" | tail -n 1)
  # range 1f voice.end+12f ends half a second behind the sound.
  grep -q '^range .*voice.end+12f' "$script" &&
    expected=$(ffprobe -v error -show_entries format=duration -of csv=p=0 "${script%.bx}.wav" | awk '{ print int(24 * ($1 + 0.5)) + 1 }')
  [ -n "$expected" ] || expected=$(grep -oE '[0-9]+f\b' "$script" | sed 's/f//' | sort -n | tail -n 1)
  if ! "$program" render "$script" -o "$film" --size 160x90 >"$folder/said" 2>&1; then
    said=$(tail -n 5 "$folder/said")
  else
    said=$(ffprobe -v error -select_streams v -count_frames -show_entries stream=nb_read_frames,width,height -of csv=p=0 "$film")
    [ "$said" != "160,90,$((${expected:-0}))" ] || said=
  fi
  timed "$name"
  if [ -z "$said" ]; then
    passed=$((passed + 1))
  else
    printf 'FAILED %s: expected 160,90,%s (width, height, frames)\n%s\n' "$name" "$((${expected:-0}))" "$said"
    failed=$((failed + 1))
  fi
done

# holds WHAT CONDITION SCRIPT TIMES TARGETS…: checks a condition of awk about v[1], v[2] …, the numbers that eval
# prints, in the order of times and targets.
holds() {
  local what=$1 condition=$2 script=$3 times=$4 values
  shift 4
  [[ $script == /* ]] || script=$root/examples/$script.bx
  values=$("$program" eval "$script" --at "$times" "$@" | sed -E '/^[0-9.]+f \(/d; s/^ *[^ ]+ +//; s/[a-z]{2,}//g' | tr -c '0-9.e-' ' ')
  timed "$what"
  if [ -n "$values" ] && awk -v all="$values" "function same(a, b) { return a - b < 1e-4 && b - a < 1e-4 }
      BEGIN { split(all, v); exit !($condition) }"; then
    passed=$((passed + 1))
  else
    printf 'FAILED %s: %s\n' "$what" "$values"
    failed=$((failed + 1))
  fi
}
holds 'the twin mirrors the ball' 'same(v[1], v[4]) && same(v[2], -v[5]) && same(v[7], v[10]) && same(v[8], -v[11])' \
  mirror 10f,100f ball.position twin.position
holds 'the third bounce is the second, seven metres on' 'same(v[1] + 7, v[4]) && same(v[2], v[5])' \
  mirror 63f,111f ball.position
holds 'four balls, a quarter turn between them' \
  'same(v[4], v[3]) && same(v[5], v[2]) && same(v[7], -v[1]) && same(v[9], -v[3]) && same(v[10], -v[3])' \
  four-balls 70f ball1.position ball2.position ball3.position ball4.position
holds 'nothing jumps when the hand opens' 'same(v[4], v[20]) && same(v[8], v[24]) && same(v[12], v[28]) && same(v[1], v[17])' \
  grab 59.99999f,60f ball.world
holds 'the kid goes along' 'same(v[4], v[20]) && same(v[8], v[24]) && same(v[12], v[28] + 0.6)' grab 70f ball/kid.world ball.world
# The hand's chord into frame 60 is (2.5 -1.2) in 20 frames.
holds 'the ball flies on with the speed of the hand' 'same(v[1], -3 + 1.5) && same(v[2], 4 - 0.72 - 9.81 / 2 / 4)' grab 72f ball.position
holds 'what the wheel in the ring draws closes' 'same(v[4], v[20]) && same(v[8], v[24])' spirograph 1f,241f arm/wheel/pen.world
holds 'the dot is as high as the hand' 'v[4] == 240 && same(v[2], -sqrt(3))' sine 49f dot.position hand.rotation.z
holds 'five circles draw the sum of five sines' 'same(v[2], 1.9 * (1 - 1 / 3 + 1 / 5 - 1 / 7 + 1 / 9))' fourier 21f dot.position
holds 'the bars are as wide as cities are large' 'same(v[1], 23.3 / 4) && same(v[3], 3.5 / 4)' race 81f bar2.size bar5.size
holds 'one eigenvector becomes three times as long, the other stays' 'same(v[1], 4.5 / sqrt(2)) && same(v[2], v[1]) && same(v[4], -1.5 / sqrt(2))' \
  eigenvectors 145f v2.to v6.to
holds 'bubble sort puts the bars in order' 'v[1] < v[2] && v[2] < v[3] && v[3] < v[4] && v[4] < v[5] && v[5] < v[6] && v[6] < v[7]' \
  bubble-sort 289f b{1..7}.position.x
holds 'the areas of clouds stay the same' 'same(v[1] * v[2], v[5] * v[6]) && same(v[3] * v[4], v[7] * v[8]) && same(v[5], v[7])' \
  bayes-areas 85f,133f days/clouds1.size days/clouds2.size
holds 'a damped pendulum loses energy' 'v[2] ^ 2 / 2 - 6 * cos(v[1]) < -6 * cos(2.9) - 1' pendulum-phase 289f dot.position
holds 'the search ends at 53' 'v[1] == v[2] && same(v[1], 3)' binary-search 217f look.position.x b11.position.x
# Each distance is that of the neighbour before it on the shortest way, and the weight of the edge between them.
holds 'Dijkstra finds the shortest ways' 'v[1] == 0 && v[3] == v[1] + 2 && v[2] == v[3] + 1 && v[4] == v[2] + 5 && v[5] == v[4] + 2 && v[6] == v[4] + 6' \
  dijkstra 289f g/{A,B,C,D,E,F}/far.text
holds 'the network tells a cat from a bird' 'v[1] > v[2] + 0.4 && v[1] > v[3] + 0.4 && v[6] > v[4] + 0.4 && v[6] > v[5] + 0.4' \
  neural-network 140f,280f n4-{1,2,3}.level
# In a valley the slope is 0: cos(2x) cos(1.5y) + 0.16x = 0 and -0.75 sin(2x) sin(1.5y) + 0.16y = 0.
holds 'a ball rolls into a valley' 'same(cos(2 * v[1]) * cos(1.5 * v[2]) + 0.16 * v[1], 0) && same(0.75 * sin(2 * v[1]) * sin(1.5 * v[2]), 0.16 * v[2])' \
  gradient-descent 193f ball20.position
holds 'a name and a number of the table arrive where the chart has them' 'same(v[1], v[3]) && same(v[2], v[4]) && same(v[5], v[7]) && same(v[6], v[8])' \
  table-to-chart 115f t/4-1.world.x t/4-1.world.y c/Oslo/label.world.x c/Oslo/label.world.y t/4-2.world.x t/4-2.world.y c/Oslo/number.world.x c/Oslo/number.world.y
holds 'the ride ends where it began' 'same(v[1], v[4]) && same(v[2], v[5]) && same(v[3], v[6])' ride 1f,193f eye.position
holds 'the fifth fish is where the leader was 15.36 frames before' 'same(v[1], v[10]) && same(v[2], v[11])' \
  swarm 84.64f,100f fish0.position fish5.position
holds 'a foot stays where it is while it carries' \
  'same(v[4], 0.45) && same(v[8], 0.05) && same(v[20], 0.45) && same(v[24], 0.05) && same(v[6], 1) && same(v[22], 1)' \
  walk 3f,13f man/left/knee/foot.world
holds 'letters come one after another' 'same(v[2], 0) && v[5] < -1 && same(v[11], 0)' \
  letters 30f,54f title/1.position title/7.position
holds 'what was a lid on top lies in the plane at last' 'same(v[8], 2.03) && same(v[12], 0) && same(v[24], 0.03) && same(v[28], -4)' \
  unfold 5f,100f side2/wall/lid.world
holds 'a stiff knee' 'same(v[1], 1.85) && v[2] < -50 && same(v[3], 1.69) && same(v[4], -12)' \
  limp 31f,55f man.position.y man/right/knee.rotation.z
holds 'the small gear turns twice as fast the other way' 'same(v[1], 60) && same(v[4], -120) && v[5] == 2' \
  clockwork 49f big.rotation.z small.rotation count.text
# shows: C10 C132 C140
holds 'after half of the time every other pendulum is on the other side' 'same(v[1], -30) && same(v[2], 30) && same(v[3], -30) && same(v[4], 30)' \
  pendulum-wave 241f p1.rotation.z p2.rotation.z p15.rotation.z p14.rotation.z
holds 'gears turn by the ratio of their teeth' 'same(v[1], -180) && same(v[2], 202.5)' gears 49f small.rotation.z large.rotation.z
holds 'the flower rolls on by as much as it turns' 'same(v[4], -9 + 150 * 0.1222) && same(v[8], 1.75) && same(v[1], cos(600 * 3.14159265 / 180))' \
  flower 150f flower.world
# Intervals of 1 to 5 ticks: 30, 15, 10, 8 and 6 updates, then the object rests.
holds 'the ball rolls slower until it lies' 'same(v[4], -6 + 70 * 0.17453) && same(v[20], v[4]) && same(v[1], cos(700 * 3.14159265 / 180))' \
  roll 155f,165f ball.world
# shows: C63 C131
# Values of a stack of matrices after 31 and 61 updates, computed by hand.
holds 'two stars turn in opposite directions while the scene drifts' \
  'same(v[4], 0.93) && same(v[17], -0.760406) && same(v[21], -0.649448) && same(v[33], -0.052336) && same(v[37], 0.99863)' \
  two-stars 25f sky/drift-1.world sky/drift-1/right-1.world sky/drift-1/left-1.world
holds 'a spinning frisbee follows its trajectory' \
  'same(v[4], -2.916396) && same(v[8], 1.724549) && same(v[12], 1.10578) && same(v[1], 0.038124) && same(v[5], -0.230091)' \
  frisbee 25f flight/roll-1/travel-1/rise-1/sink-1/spin-1/frisbee-1.world
# Half a second without support, then g/2 t^2. A fall writes events, which can be moved.
cat >"$folder/air.bx" <<'END'
create late sphere position=(0 20 0)
at 1f fall late delay=0.5s
create moved like late
move moved.position.y 1f..300f by 24f
END
holds 'the law begins late' 'same(v[1], 20) && same(v[2], 20 - 9.81 / 2 / 4)' "$folder/air.bx" 10f,25f late.position.y
holds 'a fall is plain events' 'same(v[1], v[4]) && same(v[2], 20)' \
  "$folder/air.bx" 25f,49f late.position.y moved.position.y
# Only the geometry is switched.
cat >"$folder/switch.bx" <<'END'
create form7 box
create thing sphere position=(1 2 3) color=red
at 1f thing.geometry none
at 12f thing.geometry shape(form7)
END
holds 'only the geometry is switched' 'v[1] == v[4] && v[2] == v[5] && v[3] == v[6] && v[1] == 1 && v[7] == 7' \
  "$folder/switch.bx" 6f,13f thing.position thing.geometry
# A parcel that is carried does not jump when it is taken or put down, and arrives where the command says. A foot that
# stands does not slide.
holds 'a parcel is taken and put down without a jump' \
  'same(v[1], v[4]) && same(v[2], v[5]) && same(v[3], v[6]) && same(v[7], 3.68) && same(v[8], 1.31) && same(v[9], -0.82) && same(v[10], v[7])' \
  errand 120.999f,121.001f,315.999f,316.001f parcel.world.x parcel.world.y parcel.world.z
holds 'a foot stands where it stands' 'same(v[1], v[3]) && same(v[2], v[4])' errand 60f,66f anna/hips/right/knee/foot.world.x anna/hips/right/knee/foot.world.z
# The tour of the studio: checked, but not rendered, because it takes two minutes.
if "$program" check "$root/docs/tour/tour.bx" >/dev/null; then
  passed=$((passed + 1))
else
  failed=$((failed + 1)) && echo 'docs/tour/tour.bx has mistakes'
fi
if "$root/tools/gallery.sh" --check; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
printf '%d passed, %d failed\n' "$passed" "$failed"
[ "$failed" = 0 ]
