#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Kills sessions (SIGKILL) at random points. All acknowledged lines must be there after recovery.
#   kill_test.sh PROGRAM [SESSIONS] [SEED]
# A small preloaded library counts the system calls that change files, and kills the process at the chosen call: before
# it, in the middle of it (a write), or after it, before the session can answer. Some sessions are killed from outside
# at any time instead. Sessions that are not killed give the expected result.
# shows: G22
. "$(dirname -- "$0")/support.sh" || exit 3
sessions=${2:-60} seed=${3:-1}
RANDOM=$seed

cat >shim.c <<'C'
#define _GNU_SOURCE
#include <dlfcn.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/types.h>
#include <unistd.h>
static int calls = 0;
static void stop(void) { kill(getpid(), SIGKILL); }
static int chosen(void) { /* the call to be killed at */
  const char* at = getenv("KILL_AT");
  return at && ++calls == atoi(at);
}
static int where(void) { return getenv("KILL_WHERE") ? atoi(getenv("KILL_WHERE")) : 0; } /* 0 before, 1 within, 2 behind */
#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))
#define WATCHED(type, name, parameters, arguments) \
  type name parameters {                           \
    const int here = chosen();                     \
    if (here && where() < 2) stop();               \
    const type r = REAL(name) arguments;           \
    if (here) stop();                              \
    return r;                                      \
  }
WATCHED(int, fdatasync, (int f), (f))
WATCHED(int, fsync, (int f), (f))
WATCHED(int, rename, (const char* a, const char* b), (a, b))
WATCHED(int, unlink, (const char* a), (a))
WATCHED(int, ftruncate, (int f, off_t n), (f, n))
WATCHED(int, ftruncate64, (int f, off64_t n), (f, n))
ssize_t write(int f, const void* bytes, size_t n) {
  const int here = chosen();
  if (here && where() == 0) stop();
  const ssize_t r = REAL(write)(f, bytes, here && where() == 1 ? n / 2 : n);
  if (here) stop();
  return r;
}
C
"${CC:-cc}" -shared -fPIC -O1 -o shim.so shim.c -ldl || exit 3

# script: puts lines for one session into the array `lines`, and whether each will be acknowledged into `answered`.
script() {
  lines=() answered=()
  local n=$((8 + RANDOM % 20)) depth=1 undone=0 i
  say() { lines+=("$1") answered+=("$2"); }
  say 'create ball sphere' 1
  for ((i = 0; i < n; i++)); do
    case $((RANDOM % 12)) in
      0 | 1 | 2) say "set ball.radius $((1 + RANDOM % 99))" 1 && depth=$((depth + 1)) undone=0 ;;
      3 | 4) say "at $((1 + RANDOM % 48))f ball.position ($((RANDOM % 9)) $i 0) linear  # € $i" 1 && depth=$((depth + 1)) undone=0 ;;
      5)
        say 'ball.color' 1 && say "  $((1 + RANDOM % 48))f gold" 1 && say "  $((49 + RANDOM % 48))f red" 1
        depth=$((depth + 3)) undone=0
        ;;
      6) say "create b$i box size=(1
$((1 + RANDOM % 9)) 1)" 1 && depth=$((depth + 1)) undone=0 ;;
      7 | 8) [ $depth -gt 1 ] && say undo 1 && depth=$((depth - 1)) undone=$((undone + 1)) ;;
      9) [ $undone -gt 0 ] && say redo 1 && depth=$((depth + 1)) undone=$((undone - 1)) ;;
      10) say save 1 ;;
      11) say "set ball.raduis $i" 0 ;;
    esac
  done
}

# play FOLDER COUNT: runs a session with the first COUNT lines in a copy of the author's script, without a kill.
play() {
  mkdir -p "$1"
  printf '# by hand\nrate 24\ncreate eye camera\n' >"$1/film.bx"
  { [ "$2" = 0 ] || printf '%s\n' "${lines[@]:0:$2}"; printf 'save\nquit\n'; } | (cd "$1" && "$program" shell film.bx) >/dev/null 2>&1
}

killed=0 acknowledged=0 lost=0 ahead=0
for ((session = 1; session <= sessions; session++)); do
  script
  rm -rf run want next
  mkdir run
  printf '# by hand\nrate 24\ncreate eye camera\n' >run/film.bx
  printf '%s\n' "${lines[@]}" >input
  if ((RANDOM % 6 == 0)); then # from outside
    (cd run && exec "$program" shell film.bx) <input >out 2>err &
    process=$!
    sleep 0.0$((RANDOM % 60 + 10))
    kill -KILL $process 2>/dev/null
    wait $process 2>/dev/null
  else
    export KILL_AT=$((1 + RANDOM % (4 * ${#lines[@]} + 4))) KILL_WHERE=$((RANDOM % 3))
    (cd run && LD_PRELOAD=$work/shim.so exec "$program" shell film.bx) <input >out 2>err
    unset KILL_AT KILL_WHERE
  fi 2>/dev/null
  [ -e run/.film.bx.journal ] && killed=$((killed + 1))
  oks=$(grep -cx ok out)
  # The number of lines that took effect: the acknowledged ones, and perhaps the next one.
  at=0 seen=0
  while [ $seen -lt "$oks" ]; do
    seen=$((seen + answered[at])) at=$((at + 1))
  done
  before=$at # lines that came before the first that has no answer
  while [ $at -lt ${#lines[@]} ] && [ "${answered[at]}" = 0 ]; do at=$((at + 1)); done
  acknowledged=$((acknowledged + oks))
  play want "$before"
  play next $((at + 1))
  printf 'save\nquit\n' | (cd run && "$program" shell film.bx --recover) >recovered 2>&1
  kept=yes
  if ! cmp -s run/film.bx want/film.bx; then
    if cmp -s run/film.bx next/film.bx; then # on the disk, and killed before it could be said
      ahead=$((ahead + 1))
    else
      kept=no lost=$((lost + 1))
    fi
  fi
  verdict "session $session (seed $seed)" $kept \
    "$oks acknowledged; recovery said: $(cat recovered; diff want/film.bx run/film.bx)"
  [ ! -e run/.film.bx.journal ] || verdict "session $session (seed $seed)" no 'the journal is still there'
done
printf '%d sessions, %d left a journal; %d commands acknowledged, %d lost; killed between a write and its answer: %d\n' \
  "$sessions" $killed $acknowledged $lost $ahead
summary
