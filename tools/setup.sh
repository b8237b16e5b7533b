# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Functions that ./betwixt and ./test share: they install missing packages, configure and build. Set `root` to the
# project's folder and source this file. The functions print on stderr. After a failure they exit with code 3.

with=()  # extra options for cmake
say() { printf 'betwixt: %s\n' "$*" >&2; }
die() { say "$*"; exit 3; }

# need FILE…: installs the missing packages of these lists.
need() {
  local missing
  if ! command -v dpkg-query apt-get >/dev/null; then
    say "this is not Debian: packages are not checked (tools/*packages.txt lists what is needed)"
    return
  fi
  missing=$(comm -23 <(sed 's/#.*//; s/ .*//; /^$/d' "$@" | sort -u) \
    <(dpkg-query -W -f='${db:Status-Status} ${Package}\n' | sed -n 's/^installed //p' | sort -u))
  [ -z "$missing" ] || install_packages $missing
}

# need_meanwhile FILE…: the same in the background if no password is needed. need_done waits for it.
need_meanwhile() {
  meanwhile=
  if [ "$(id -u)" = 0 ] || sudo -n true 2>/dev/null; then
    need "$@" &
    meanwhile=$!
  else
    need "$@"
  fi
}

need_done() { [ -z "$meanwhile" ] || wait "$meanwhile" || exit 3; }

install_packages() {
  local admin=() log
  if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null ||
      die "Debian packages are missing, and there is neither root nor sudo to install them. As root: apt-get install $*"
    admin=(sudo)
  fi
  say "installing Debian packages${admin:+ with sudo} (what each is for: tools/*packages.txt):"
  say "  $*"
  log=$(mktemp)
  local get=("${admin[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=300)
  compgen -G '/var/lib/apt/lists/*_Packages*' >/dev/null || "${get[@]}" update >"$log" 2>&1 || true
  if ! "${get[@]}" install -y --no-install-recommends "$@" >"$log" 2>&1; then
    # If the package lists are old, they name files that the server no longer has: update them and try again.
    { "${get[@]}" update && "${get[@]}" install -y --no-install-recommends "$@"; } >"$log" 2>&1 || {
      tail -n 20 "$log" >&2
      rm -f "$log"
      die "the packages could not be installed"
    }
  fi
  rm -f "$log"
}

# build PRESET TARGET…: configures build/PRESET if needed and builds the targets. Only one build of a preset runs at a
# time.
build() {
  mkdir -p "$root/build" || die "cannot write in $root"
  (
    flock -n 9 || { say "waiting for another build to end" && flock 9; }
    configure "$1" && make_targets "$@"
  ) 9>"$root/build/$1.lock" || exit 3
}

# with_parts PRESET PART…: adds parts (studio, python, tests) to a preset. Later builds keep them.
with_parts() {
  local cache=$root/build/$1/CMakeCache.txt part
  for part in "${@:2}"; do
    with+=("-DBETWIXT_${part^^}=ON")
    grep -qx "BETWIXT_${part^^}:BOOL=ON" "$cache" 2>/dev/null || rm -f "$root/build/$1/build.ninja"
  done
  mkdir -p "$root/build" || die "cannot write in $root"
  (
    flock 9 && configure "$1"
  ) 9>"$root/build/$1.lock" || exit 3
}

# build_player: builds build/web/betwixt-player.js, the player for web pages.
build_player() {
  mkdir -p "$root/build" || die "cannot write in $root"
  (
    flock -n 9 || { say "waiting for another build to end" && flock 9; }
    say "building the player for web pages (some minutes when it is the first time)"
    "$root/tools/web.sh" 2>&1 | tee "$root/build/web.log" | sparse web
    [ "${PIPESTATUS[0]}" = 0 ] || {
      grep -iE 'error|undefined|cannot' "$root/build/web.log" | tail -n 20 >&2
      die "the player could not be built: build/web.log has the whole output"
    }
  ) 9>"$root/build/web.lock" || exit 3
}

configure() {
  local cache=$root/build/$1/CMakeCache.txt log=$root/build/$1.log options=()
  if [ -f "$cache" ] && [ "$cache" -nt "$root/CMakePresets.json" ] &&
    grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then
    [ ! -f "$root/build/$1/build.ninja" ] || return 0
  else
    # A checkout that was moved needs `--fresh`, which deletes all compiled files. A new part alone does not need it.
    [ ! -f "$cache" ] || options+=(--fresh)
    # clang compiles in two thirds of the time of g++. Both compilers work.
    ! command -v clang++-19 >/dev/null || options+=(-DCMAKE_CXX_COMPILER=clang++-19)
  fi
  # Parts that were added earlier stay.
  local part
  for part in STUDIO PYTHON TESTS; do
    ! grep -qx "BETWIXT_$part:BOOL=ON" "$cache" 2>/dev/null || with+=("-DBETWIXT_$part=ON")
  done
  ! command -v ccache >/dev/null || options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  (cd "$root" && cmake --preset "$1" "${options[@]}" "${with[@]}") >"$log" 2>&1 || {
    grep -v '^-- ' "$log" | tail -n 30 >&2
    die "the build could not be configured (the whole output: build/$1.log)"
  }
}

make_targets() {
  local preset=$1 log=$root/build/$1.log
  shift
  if [ -t 2 ]; then
    NINJA_STATUS='[%f/%t, %es] ' ninja -C "$root/build/$preset" "$@" >&2 || die "the build failed"
  else
    NINJA_STATUS='[%f/%t] ' ninja -C "$root/build/$preset" "$@" 2>&1 | tee "$log" | sparse "$preset"
    [ "${PIPESTATUS[0]}" = 0 ] || {
      tail -n 40 "$log" >&2
      die "the build failed (the whole output: build/$preset.log)"
    }
  fi
}

# ccache caches files with precompiled headers only if it ignores these differences.
export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS-pch_defines,time_macros,include_file_mtime,include_file_ctime}

# sparse NAME: reads the output of ninja and prints one line for every tenth of the work.
sparse() {
  awk -v what="$1" -F '[][/]' '/^\[[0-9]+\/[0-9]+\]/ && $3 > 3 && int(10 * $2 / $3) > tenth {
    tenth = int(10 * $2 / $3)
    printf "betwixt: building (%s) %d of %d\n", what, $2, $3
    fflush()
  }' >&2
}
