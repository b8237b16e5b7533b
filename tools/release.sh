#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Makes all that people install, in build/dist (docs/releasing.md).
#   tools/release.sh [PART…]    the parts: deb wheel npm vscode blender archive list sums. Without a part: all.
root=$(cd -P -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
. "$root/tools/setup.sh"
cd "$root" || die "cannot go to $root"
set -e
all=(deb wheel npm vscode blender archive list sums)
for part in "$@"; do
  [[ " ${all[*]} " == *" $part "* ]] || { echo "release.sh: there is no part '$part': ${all[*]}" >&2; exit 2; }
done
[ $# -gt 0 ] || set -- "${all[@]}"
version=$(sed -nE 's/^project\(betwixt VERSION ([0-9.]+).*/\1/p' CMakeLists.txt)
date=$(sed -nE "s/^## $version — ([0-9-]+).*/\1/p" CHANGELOG.md | head -n 1)
[ -n "$date" ] || die "CHANGELOG.md has no section '## $version — YEAR-MONTH-DAY'"
dist=$root/build/dist
mkdir -p "$dist"
# What is made twice from the same sources is the same to the byte.
export SOURCE_DATE_EPOCH
SOURCE_DATE_EPOCH=$(date -u -d "$date" +%s)
made() { say "made build/dist/${1#"$dist/"} ($(du -h "$1" | cut -f1))"; }

deb() {
  need tools/{packages,run-packages,studio-packages,python-packages,release-packages}.txt
  with_parts release studio python
  (build release all)
  local stage=$root/build/deb
  rm -rf --one-file-system "$stage"
  mkdir -p "$stage"
  # dpkg-buildpackage writes beside the folder in which it runs.
  cp -a packaging/debian "$stage/" && cp -a CHANGELOG.md "$stage/"
  cat >"$stage/debian/changelog" <<TEXT
betwixt ($version) bookworm; urgency=medium

  * All changes are in changelog.gz.

 -- The Betwixt authors <maintainers@betwixt.invalid>  $(date -u -R -d "$date")
TEXT
  say "packing the Debian packages"
  (cd "$stage" && BUILD=$root/build/release PATH=/usr/sbin:/usr/bin:/sbin:/bin dpkg-buildpackage -d -b -us -uc) >"$stage.log" 2>&1 ||
    { tail -n 20 "$stage.log" >&2; die "the Debian packages could not be made (build/deb.log)"; }
  local file
  rm -f "$dist"/*.deb
  for file in "$root"/build/*_"$version"_*.deb; do
    mv "$file" "$dist/" && made "$dist/${file##*/}"
  done
  rm -f "$root"/build/betwixt_"$version"_*.{buildinfo,changes}
  desktop-file-validate packaging/desktop/betwixt.desktop
  appstreamcli validate --no-net build/release/packaging/org.betwixt.Studio.metainfo.xml >"$stage.log" 2>&1 || { cat "$stage.log" >&2; die "the metadata for software shops are wrong"; }
  # lintian warns if it runs as root, which is no mistake of the packages.
  lintian --fail-on error,warning --tag-display-limit 0 "$dist"/*_"$version"_*.deb >"$stage.log" 2>&1 ||
    { cat "$stage.log" >&2; die "lintian has found mistakes"; }
}

wheel() {
  need tools/{packages,run-packages,python-packages}.txt
  with_parts release python
  (build release betwixt_python)
  rm -f "$dist"/*.whl
  local name
  name=$(BETWIXT_BUILT_PYTHON=$root/build/release/python/betwixt /usr/bin/python3 python/build_wheel.py "$dist" | tail -n 1)
  made "$dist/$name"
}

npm() {
  build_player
  rm -f "$dist"/betwixt-player-*.tgz
  python3 tools/pack.py npm build/web/package "$dist/betwixt-player-$version.tgz" "$version"
  made "$dist/betwixt-player-$version.tgz"
}

vscode() {
  python3 tools/pack.py vsix clients/vscode "$dist/betwixt-$version.vsix" "$version"
  made "$dist/betwixt-$version.vsix"
}

blender() {
  python3 tools/pack.py blender clients/blender "$dist/betwixt-blender-$version.zip" "$version"
  made "$dist/betwixt-blender-$version.zip"
}

archive() {
  git archive --format=tar --prefix="betwixt-$version/" HEAD | gzip -9n >"$dist/betwixt-$version.tar.gz"
  made "$dist/betwixt-$version.tar.gz"
}

list() {
  python3 tools/parts_list.py "$version" "$date" >"$dist/betwixt-$version.cdx.json"
  made "$dist/betwixt-$version.cdx.json"
}

sums() {
  (cd "$dist" && rm -f SHA256SUMS && sha256sum -- * >SHA256SUMS)
  made "$dist/SHA256SUMS"
}

for part in "$@"; do "$part"; done
