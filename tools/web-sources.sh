#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# web-sources.sh FOLDER: downloads the sources of the libraries that the engine for web pages needs. They come as Debian
# source packages from the servers that this machine uses. The package lists of the machine are not changed.
set -e
folder=$(mkdir -p -- "$1" && cd -- "$1" && pwd)
wanted='lua5.4 freetype harfbuzz libglu bullet pugixml meshoptimizer tinyobjloader libspng zlib'
[ ! -e "$folder/all" ] || [ "$(cat "$folder/all")" != "$wanted" ] || exit 0
lists=$(mktemp -d)
trap 'rm -rf "$lists"' EXIT
mkdir -p "$lists/lists/partial" "$lists/cache/archives/partial" "$lists/parts"
for list in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
  [ ! -e "$list" ] || sed -nE 's/^ *deb /deb-src /p' "$list" >"$lists/parts/$(basename "$list" .list).list"
done
for list in /etc/apt/sources.list.d/*.sources; do
  [ ! -e "$list" ] || sed -E 's/^Types:.*/Types: deb-src/' "$list" >"$lists/parts/$(basename "$list")"
done
get=(apt-get -qq -o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$lists/parts"
  -o Dir::State::Lists="$lists/lists" -o Dir::Cache="$lists/cache" -o APT::Sandbox::User=root)
"${get[@]}" update >&2
cd "$lists"
for package in $wanted; do
  # For some packages the server has only the original archive. It is all that we need, so a failure is no error here.
  "${get[@]}" source --download-only "$package" >"$lists/log" 2>&1 || true
  archive=
  for one in "$lists/${package}"_*.orig.tar.*; do
    case $one in *.asc) ;; *) [ ! -s "$one" ] || archive=$one ;; esac
  done
  [ -n "$archive" ] || { cat "$lists/log" >&2; echo "the source of $package cannot be downloaded" >&2; exit 3; }
  tar -x -f "$archive" -C "$folder"
done
echo "$wanted" >"$folder/all"
