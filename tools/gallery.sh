#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Makes docs/gallery.md (each short example with its first comment, a picture and its script) and pictures of
# docs/look.md.
#   tools/gallery.sh PROGRAM   makes the page and its pictures
#   tools/gallery.sh --check   fails if the page differs from the examples
root=$(cd -P -- "$(dirname -- "$0")/.." && pwd)
films='pendulum-wave 60 bars 80 gears 40 spirograph 200 sine 110 ride 100 swarm 100 letters 60 completing-the-square 130 unfold 55 walk 60 fourier 170 race 170
derivative-limit 150 riemann-sums 120 linear-map 145 eigenvectors 200 fourier-series 121 taylor-polynomials 265 phase-portrait 289
pendulum-phase 200 unit-circle 150 complex-map 120 pythagoras 56 inequalities 217 bayes-areas 241 table-to-chart 103 bubble-sort 23
binary-search 100 refactoring 120 dijkstra 265 neural-network 112 gradient-descent 70'
# Pictures of README.md and of other pages.
pictures='solar 70 menagerie 100 title 80 grab 40 four-balls 66 clockwork 60 nail 60 potter 100 funnel 80 lighthouse 60 figure 40'

page() {
  printf '# Gallery\n\nShort films, each with its whole script. `./test` renders them, and `tools/gallery.sh PROGRAM` makes this page.\nThe films from [derivative-limit](#derivative-limit) on are for lessons.\n'
  set -- $films
  for (( ; $#; )); do
    printf '\n## %s\n\n%s\n\n![%s](pictures/gallery/%s.png)\n\n<!-- live: new -->\n```\n' "$1" "$(sed -n '/^# /!q; s/^# //p' "$root/examples/$1.bx")" "$1" "$1"
    sed '/^[^#]/,$!d' "$root/examples/$1.bx"
    printf '```\n'
    shift 2
  done
  cat <<'END'

## How long they are

This table compares ten of these films with the same film in another tool ([bench/scripts](../bench/scripts)). For each film we chose
a tool whose own gallery has a film of that kind. We wrote these scripts for the table, as compact as that tool's own examples, and did
not run them. The counts leave out comments, blank lines, indentation, and the code that turns a moving page into a film.

The difference is smallest where the other tool has one command for the whole task, such as a bar chart or a split text. It is largest
where you build scene, lights and loop by hand there.

END
  python3 "$root/bench/scripts/lengths.py"
  cat <<'END'

The twenty films for lessons have counterparts in Manim, which we have not run either ([bench/teaching](../bench/teaching/README.md)).
These are the numbers of characters:

END
  python3 "$root/bench/teaching/count.py"
}

# Two suns, whose lights have this `shadow`.
shadows() {
  cat <<END
ground #d4d0c8
create ball sphere radius=0.8 position=(-1.6 0.8 0.2) color=tomato material=satin
create box1 box size=(1.1 1.1 1.1) position=(0.3 0.55 0.6) rotation=(0 30deg 0) color=steelblue material=satin
create cone1 cone radius=0.5 height=1.7 position=(1.8 0.85 0) color=seagreen material=satin
create sun1 light shines=sun position=(-4 6 5) shadow=$1
create sun2 light shines=sun position=(6 5 3) intensity=0.5 color=#ffe0b0 shadow=$1
create eye  camera position=(0 2.6 7) look-at=(0 0.5 0) lens=38mm
END
}

# The animation at the top of README.md: two seconds of six films.
reel() {
  local films='still-life 20 sunset 20 letters 20 chart-race 150 marbles 60 solar 60' n=0 inputs=()
  set -- "$1" "$2" $films
  for (( ; $# > 2; ++n )); do
    "$1" render "$root/examples/$3.bx" --frames "$4f..$(($4 + 47))f" --size 1280x720 --quality 95 -o "$2/$n.mp4" || return 1
    inputs+=(-i "$2/$n.mp4")
    set -- "$1" "$2" "${@:5}"
  done
  ffmpeg -v error -y "${inputs[@]}" -filter_complex "concat=n=$n,fps=12" -c:v libwebp_anim -q:v 60 -compression_level 6 -loop 0 \
    "$root/docs/pictures/reel.webp"
}

case ${1-} in
  --check)
    diff <(page) "$root/docs/gallery.md" >/dev/null || { echo 'docs/gallery.md differs from the examples: call tools/gallery.sh PROGRAM'; exit 1; }
    ;;
  '') sed -n '6,7s/^# *//p' "$0" && exit 2 ;;
  *)
    page >"$root/docs/gallery.md"
    mkdir -p "$root/docs/pictures/gallery"
    set -- "$1" $films
    for (( ; $# > 1; )); do
      "$1" frame "$root/examples/$2.bx" --at "$3f" -o "$root/docs/pictures/gallery/$2.png" --size 1280x720 || exit 1
      set -- "$1" "${@:4}"
    done
    "$1" frame "$root/examples/materials.bx" --at 48f -o "$root/docs/pictures/look/materials.png" --size 1280x720 --samples 16 || exit 1
    "$1" frame "$root/examples/sunset.bx" --at 70f -o "$root/docs/pictures/look/sunset.png" --size 1280x720 || exit 1
    "$1" frame "$root/examples/still-life.bx" --at 90f -o "$root/docs/pictures/look/still-life.png" --size 1280x720 --samples 16 || exit 1
    set -- "$1" $pictures
    for (( ; $# > 1; )); do
      "$1" frame "$root/examples/$2.bx" --at "$3f" -o "$root/docs/pictures/$2.png" --size 1280x720 --samples 16 || exit 1
      set -- "$1" "${@:4}"
    done
    folder=$(mktemp -d) || exit 1
    for at in 20 44; do "$1" frame "$root/examples/blur.bx" --at "${at}f" -o "$folder/$at.png" --size 960x540 || exit 1; done
    ffmpeg -v error -y -i "$folder/20.png" -i "$folder/44.png" -filter_complex hstack "$root/docs/pictures/blur.png" || exit 1
    for kind in auto soft; do
      shadows "$kind" >"$folder/$kind.film.bx"
      "$1" frame "$folder/$kind.film.bx" -o "$folder/$kind.png" --size 960x540 --samples 16 || exit 1
    done
    ffmpeg -v error -y -i "$folder/auto.png" -i "$folder/soft.png" -filter_complex hstack "$root/docs/pictures/shadows.png" || exit 1
    reel "$1" "$folder" || exit 1
    rm -f "$folder"/*
    # The films of docs/look.md. Each film has the name of the heading above it.
    awk -v folder="$folder" '/^###? /{name = tolower($2)} /^```/{inside = !inside; next} inside{print >(folder "/" name ".bx")}' "$root/docs/look.md"
    for film in "$folder"/*.bx; do
      name=${film##*/} name=${name%.bx} how='--size 1280x720'
      # Only the style `traced` gets its picture "before" here too.
      if [ "$name" = traced ]; then
        "$1" frame "$film" --at 1f -o "$root/docs/pictures/look/$name-before.png" $how || exit 1
        how="$how --style traced --samples 64"
      fi
      "$1" frame "$film" --at 1f -o "$root/docs/pictures/look/$name-after.png" $how || exit 1
    done
    rm -r "$folder"
    ;;
esac
