#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# The page docs/gallery.md: a picture of each short example, what its first comment says, and the script. And what docs/look.md shows.
#   tools/gallery.sh PROGRAM   makes the page and its pictures
#   tools/gallery.sh --check   says whether the page has the scripts as they are
root=$(cd -P -- "$(dirname -- "$0")/.." && pwd)
films='pendulum-wave 60 bars 80 gears 40 spirograph 200 sine 110 ride 100 swarm 100 letters 60 unfold 55 walk 60 fourier 170 race 170'

page() {
  printf '# Gallery\n\nShort films, each with all of its text. `./test` renders them; `tools/gallery.sh PROGRAM` makes this page.\n'
  set -- $films
  for (( ; $#; )); do
    printf '\n## %s\n\n%s\n\n![%s](pictures/gallery/%s.png)\n\n```\n' "$1" "$(sed -n '/^# /!q; s/^# //p' "$root/examples/$1.bx")" "$1" "$1"
    sed '/^[^#]/,$!d' "$root/examples/$1.bx"
    printf '```\n'
    shift 2
  done
  cat <<'END'

## How long they are

Ten of them, each beside the same film in the idiom of a tool whose gallery shows that kind ([bench/scripts](../bench/scripts)): written for this
table, as compact as that tool's own pages are, and not run. Comments, blank lines and indentation are not counted, nor what it takes
to make a film of a page that moves. Least is gained where the other has a word for the whole (a bar chart, a text that is split),
most where scene, lights and loop are made by hand.

END
  python3 "$root/bench/scripts/lengths.py"
}

case ${1-} in
  --check)
    diff <(page) "$root/docs/gallery.md" >/dev/null || { echo 'docs/gallery.md is not as the examples are: tools/gallery.sh PROGRAM'; exit 1; }
    ;;
  '') sed -n '7,8s/^# *//p' "$0" && exit 2 ;;
  *)
    page >"$root/docs/gallery.md"
    mkdir -p "$root/docs/pictures/gallery"
    set -- "$1" $films
    for (( ; $# > 1; )); do
      "$1" frame "$root/examples/$2.bx" --at "$3f" -o "$root/docs/pictures/gallery/$2.png" --size 480x270 || exit 1
      set -- "$1" "${@:4}"
    done
    # The films of docs/look.md, each below its heading.
    folder=$(mktemp -d) || exit 1
    awk -v folder="$folder" '/^## /{name = tolower($2)} /^```/{inside = !inside; next} inside{print >(folder "/" name ".bx")}' "$root/docs/look.md"
    for film in "$folder"/*.bx; do
      name=${film##*/} name=${name%.bx} how='--size 480x270'
      # Another style has no picture of an earlier program beside it, but one of this; smaller, as grain takes many bytes.
      if [ "$name" = traced ]; then
        how='--size 440x248'
        "$1" frame "$film" --at 1f -o "$root/docs/pictures/look/$name-before.png" $how || exit 1
        how="$how --style traced --samples 256"
      fi
      "$1" frame "$film" --at 1f -o "$root/docs/pictures/look/$name-after.png" $how || exit 1
    done
    rm -r "$folder"
    ;;
esac
