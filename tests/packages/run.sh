#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# run.sh FOLDER: installs the packages of build/dist (tools/release.sh) into a new Debian 12 in FOLDER, uses each, removes
# them, and looks for what they left. Needs root and debootstrap. A FOLDER that holds a Debian is used as it is.
here=$(cd -P -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
dist=$here/../../build/dist
machine=$(realpath -m -- "${1:?usage: run.sh FOLDER}")
# What is mounted in a namespace of its own goes when this ends, whatever ends it.
[ -n "${BETWIXT_APART-}" ] || BETWIXT_APART=1 exec unshare --mount -- "$0" "$machine"
passed=0 failed=0
verdict() { # NAME COMMAND…: passes if the command does
  local name=$1 begun=$EPOCHREALTIME
  shift
  if "$@" >"$machine.log" 2>&1; then
    passed=$((passed + 1)) && printf 'passed %s (%s s)\n' "$name" "$(awk "BEGIN { printf \"%.1f\", $EPOCHREALTIME - $begun }")"
  else
    failed=$((failed + 1)) && printf 'FAILED %s\n' "$name" && tail -n 15 "$machine.log"
  fi
}
inside() { chroot "$machine" /usr/bin/env -i HOME=/home/new LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive \
  bash -c "set -e -o pipefail; cd /home/new; $1"; }
get='apt-get -qq -y --no-install-recommends install'

if [ ! -d "$machine/usr" ]; then
  mirror=$(sed -nE 's/^(URIs: |deb )(\S+).*/\2/p' /etc/apt/sources.list.d/debian.sources /etc/apt/sources.list 2>/dev/null | head -n 1)
  debootstrap --variant=minbase --include=ca-certificates bookworm "$machine" "$mirror" >"$machine.log" 2>&1 ||
    { tail -n 5 "$machine.log"; exit 3; }
  rm -f "$machine/etc/apt/sources.list"
  cp -r /etc/apt/. "$machine/etc/apt/" && cp /etc/resolv.conf "$machine/etc/"
  cp -r /etc/ssl/certs "$machine/etc/ssl/"
fi
for folder in proc sys dev; do mount --rbind "/$folder" "$machine/$folder"; done
mkdir -p "$machine/home/new" && rm -f "$machine"/home/new/*.{deb,whl}
cp "$dist"/*.deb "$dist"/*.whl "$here/../install/CMakeLists.txt" "$here/../install/stranger.cpp" "$machine/home/new/" || exit 3

verdict 'package lists' inside 'apt-get -qq update'
verdict 'betwixt is installed' inside "$get ./betwixt_*.deb"
verdict 'a film, at once' inside 'betwixt render /usr/share/betwixt/examples/bounce.bx -o bounce.mp4 && test -s bounce.mp4'
verdict 'a film of a template' inside 'rm -f film.bx && betwixt new title film.bx && betwixt frame film.bx --at 24f -o film.png'
verdict 'a mesh, which a process of its own reads' inside 'betwixt frame /usr/share/betwixt/examples/menagerie.bx --at 1f -o cow.png'
verdict 'the manual and the completions' inside 'test -s /usr/share/man/man1/betwixt.1.gz && test -s /usr/share/bash-completion/completions/betwixt'
verdict 'the pages lead nowhere that is not there' inside 'cd /usr/share/doc/betwixt && test -s README.md && test -s guide/events.md && test -s pictures/bounce.gif && test -e examples/bounce.bx'
verdict 'a mistake is told with its place' inside 'printf "create ball spere\n" >wrong.bx; ! betwixt check wrong.bx 2>said && grep -q "wrong.bx:1:" said'
verdict 'the studio is installed' inside "$get ./betwixt-studio_*.deb"
verdict 'a picture of the studio' inside 'QT_QPA_PLATFORM=offscreen betwixt studio /usr/share/betwixt/examples/bounce.bx --discard --screenshot studio.png && test -s studio.png'
verdict 'the studio finds the program that makes films' inside 'test -x /usr/libexec/betwixt/../../bin/betwixt'
verdict 'the Python module is installed' inside "$get ./python3-betwixt_*.deb"
verdict 'it gives values' inside 'cd / && /usr/bin/python3 -c "
import betwixt
film = betwixt.load(\"/usr/share/betwixt/examples/bounce.bx\")
assert \"ball\" in film.objects, film.objects
print(film.objects)"'
verdict 'the library is installed' inside "$get ./libbetwixt-dev_*.deb cmake g++ ninja-build pkgconf"
verdict "a stranger's program" inside 'cmake -S . -B build -G Ninja && cmake --build build && test "$(build/stranger | head -c 6)" = "2 4 -1"'
verdict 'the example, without CMake' inside 'g++ /usr/share/doc/libbetwixt-dev/examples/still.cpp -o still $(pkg-config --cflags --libs betwixt) && cp /usr/share/betwixt/examples/bounce.bx . && ./still && test -s still.png'
verdict 'all packages are removed' inside 'apt-get -qq -y purge betwixt betwixt-studio libbetwixt-dev python3-betwixt'
verdict 'nothing is left' inside '! find / -xdev -iname "*betwixt*" -not -path "/home/*" -not -path "/proc/*" -not -path "/sys/*" | grep . && ! dpkg -l | grep betwixt'
verdict 'the wheel is installed in a virtual environment' inside "$get python3-venv && python3 -m venv --system-site-packages env && env/bin/pip install --no-index ./*.whl"
verdict 'the wheel gives values' inside 'printf "create ball sphere\nball.position\n  1f (0 0 0)\n  5f (4 0 0)\n" >film.bx && env/bin/python -c "
import betwixt
film = betwixt.load(\"film.bx\")
assert film.objects == [\"ball\"], film.objects"'
printf '%d passed, %d failed\n' "$passed" "$failed"
[ "$failed" = 0 ]
