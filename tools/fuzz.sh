#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Fuzzing: gives random input to the readers of the program, and looks for input that makes them fail.
#   tools/fuzz.sh [SECONDS [JOBS [TARGET…]]]  SECONDS is the time of all targets together
#   tools/fuzz.sh build                       only builds the targets
#   tools/fuzz.sh keep [TARGET…]              stores the corpora of earlier runs, made small, in tests/fuzz/corpus
# The targets are motion, drawing, language, protocol, scene, lsp, words and tables; the default is all of them. A run begins with the
# corpora of tests/fuzz/corpus and build/fuzz/corpus, the examples and the scripts of the tests. It writes failing input
# to build/fuzz/found, its log to build/fuzz/TARGET.log, and new input to build/fuzz/corpus.
root=$(cd -P -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
. "$root/tools/setup.sh"
keep=
build_only=
if [ "${1-}" = keep ]; then keep=1 && set -- 1 1 "${@:2}"; fi
if [ "${1-}" = build ]; then build_only=1 && set --; fi
seconds=${1:-60} jobs=${2:-1}
targets=("${@:3}")
[ ${#targets[@]} != 0 ] || targets=(motion drawing language protocol scene lsp words tables)
need "$root/tools/packages.txt" "$root/tools/run-packages.txt" "$root/tools/fuzz-packages.txt"
[[ ${seconds} =~ ^[1-9][0-9]*$ ]] || die "usage: tools/fuzz.sh [SECONDS [JOBS [TARGET…]]], build, or keep [TARGET…]"
build fuzz "${targets[@]/#/fuzz_}"
[ -z "$build_only" ] || exit 0

folder=$root/build/fuzz
cd "$folder" || die "there is no $folder"
mkdir -p found
# Leaks are checked once at the end: a check after each execution would take longer than everything else. The inputs are
# short, because a few lines are enough to show most mistakes.
declare -A longest=([motion]=400 [drawing]=2048 [language]=2048 [protocol]=1024 [scene]=8192 [lsp]=1024
  [words]=2048 [tables]=2048)
options=(-artifact_prefix=found/ -detect_leaks=0 -entropic=0 -timeout=120 -rss_limit_mb=3000)
export LSAN_OPTIONS=suppressions=$root/tests/leaks.txt:print_suppressions=0

# dictionary TARGET: prints the path of its dictionary.
dictionary() {
  local own=$root/tests/fuzz/$1.dict
  [ -e "$own" ] || own=$root/tests/fuzz/language.dict
  echo "$own"
}

# seeds TARGET: copies the input with which its run begins to seeds/TARGET.
seeds() {
  rm -rf "seeds/$1"
  mkdir -p "seeds/$1" "corpus/$1"
  tar -xzf "$root/tests/fuzz/corpus/$1.tar.gz" -C "seeds/$1" || die "the corpus cannot be read"
  local ending=bx
  [ "$1" != drawing ] || ending=svg
  [ "$1" != scene ] || ending=glb
  [[ $1 =~ ^(motion|words|tables)$ ]] || find "$root/examples" "$root/tests" -name "*.$ending" -size -32k -exec cp -f {} "seeds/$1/" \;
}

# fuzz TARGET SECONDS: runs a target and prints its result. Fails if it found a failure.
fuzz() {
  local several=() status runs
  [ "$jobs" = 1 ] || several=(-fork="$jobs")
  seeds "$1"
  bin/fuzz_"$1" "corpus/$1" "seeds/$1" "${options[@]}" -dict="$(dictionary "$1")" -max_len="${longest[$1]}" \
    -max_total_time="$2" "${several[@]}" >"$1.log" 2>&1
  status=$?
  runs=$(grep -aoE '^#[0-9]+' "$1.log" | tail -n 1 | tr -d '#')
  if [ "$status" = 0 ]; then
    echo "$1: ${runs:-0} texts without a failure"
  else
    grep -aE 'ERROR|SUMMARY|does not hold|runtime error|#[0-9]+ .*betwixt' "$1.log" | head -n 20
    echo "$1: a failure after ${runs:-0} texts: the text is in $folder/found, the log is $folder/$1.log"
    # Where only this output is kept, the text must be in it.
    local text
    text=$(sed -n 's/.*Test unit written to //p' "$1.log" | tail -n 1)
    [ ! -s "$text" ] || echo "$1: the text in base64: $(head -c 6000 "$text" | base64 -w 0)"
  fi
  return "$status"
}

# merge TARGET: stores a corpus of the same coverage with fewer texts in tests/fuzz/corpus.
merge() {
  seeds "$1"
  rm -rf "kept/$1"
  mkdir -p "kept/$1"
  bin/fuzz_"$1" -merge=1 "${options[@]}" -max_len="${longest[$1]}" "kept/$1" "seeds/$1" "corpus/$1" >"$1.log" 2>&1 ||
    die "the corpus cannot be merged (build/fuzz/$1.log)"
  # The shortest texts, up to 300 kB. The same texts give the same archive.
  (cd "kept/$1" && find . -type f -printf '%s %P\n' | LC_ALL=C sort -k1n -k2 |
    awk '(sum += $1) < 300000 { print $2 }' |
    tar --mtime=@0 --owner=0 --group=0 --numeric-owner -cf - -T -) | gzip -n9 >"$root/tests/fuzz/corpus/$1.tar.gz"
}

failed=0
for target in "${targets[@]}"; do
  if [ -n "$keep" ]; then
    merge "$target"
  else
    fuzz "$target" $(((seconds + ${#targets[@]} - 1) / ${#targets[@]})) || failed=1
  fi
done
exit "$failed"
