#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# cycles.sh FILM.bx -o OUT [--samples N] [--size WxH] [--frames A..B]: renders a film with Blender's Cycles. OUT is a
# movie of a type that betwixt join writes (.mp4, .webm, …), or numbered pictures (frame-%04d.png). Installs Blender if
# it is missing, and builds the Python module first.
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
. "$root/tools/setup.sh"
usage() {
  sed -n '5,7s/^# //p' "$0"
  exit "$1"
}
film='' out='' how=()
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help) usage 0 ;;
    -o | --samples | --size | --frames)
      [ $# -gt 1 ] || usage 2 >&2
      if [ "$1" = -o ]; then out=$2; else how+=("$1" "$2"); fi
      shift ;;
    -*) usage 2 >&2 ;;
    *) [ -z "$film" ] || usage 2 >&2; film=$1 ;;
  esac
  shift
done
[ -n "$film" ] && [ -n "$out" ] || usage 2 >&2
[ -f "$film" ] || die "there is no script $film"
if [ -z "${BETWIXT_PYTHON-}" ]; then
  need "$root/tools/packages.txt" "$root"/tools/{run,python,blender}-packages.txt
  with_parts release python
  build release betwixt_command betwixt_python
  export BETWIXT_PYTHON=$root/build/release/python
fi
program=${BETWIXT_PROGRAM:-$root/build/release/bin/betwixt}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$root/tools/blender.sh" -b --factory-startup --python-exit-code 3 --python "$root/clients/blender/render_with_cycles.py" -- \
  "$film" "$folder" "${how[@]}" >"$folder/log" 2>&1 || {
  status=$?
  grep -vE '^(Blender|Fra:|Saved:| Time:|Read|$)' "$folder/log" >&2
  exit $status
}
compgen -G "$folder/frame-*.png" >/dev/null || { tail -n 20 "$folder/log" >&2; die "Blender rendered nothing"; }
case $out in
  *%*.png)
    for picture in "$folder"/frame-*.png; do
      number=${picture##*/frame-} number=$((10#${number%.png}))
      # shellcheck disable=SC2059
      mv -- "$picture" "$(printf "$out" $number)" || exit 3
    done ;;
  *)
    rate=$("$program" render "$film" -o "$out" --plan | sed -n 's/.*"rate":"\([^"]*\)".*/\1/p')
    "$program" join "$folder/frame-%04d.png" -o "$out" --rate "${rate:-24}" ;;
esac
