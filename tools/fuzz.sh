#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# fuzz.sh SECONDS [JOBS]: looks for texts that crash the language. What is found lies in build/fuzz/found; what was learnt
# is kept in build/fuzz/corpus, so that the next run goes on from there.
root=$(cd -P -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
. "$root/tools/setup.sh"
seconds=${1:-60} jobs=${2:-1}
need "$root/tools/packages.txt" "$root/tools/run-packages.txt" "$root/tools/test-packages.txt"
build fuzz fuzz_language

folder=$root/build/fuzz
mkdir -p "$folder/corpus" "$folder/found" "$folder/seeds"
# Seeds: the examples, and every script that the tests hold.
find "$root/examples" "$root/tests" -name '*.bx' -size -32k -exec cp -f {} "$folder/seeds/" \;
cd "$folder" || die "there is no $folder"
several=()
[ "$jobs" = 1 ] || several=(-fork="$jobs")
LSAN_OPTIONS=suppressions=$root/tests/leaks.txt:print_suppressions=0 \
  "$folder/bin/fuzz_language" corpus seeds -dict="$root/tests/fuzz/language.dict" -artifact_prefix=found/ \
    -max_total_time="$seconds" -max_len=8192 -timeout=20 -rss_limit_mb=3000 "${several[@]}" >fuzz.log 2>&1
status=$?
runs=$(grep -aoE '^#[0-9]+' fuzz.log | tail -n 1 | tr -d '#')
if [ "$status" = 0 ]; then
  echo "${runs:-0} texts in $seconds s without a crash"
else
  grep -aE 'ERROR|SUMMARY|does not hold|runtime error|#[0-9]+ .*betwixt' fuzz.log | head -n 20
  echo "a failure after ${runs:-0} texts: the text is in $folder/found, what was said in $folder/fuzz.log"
fi
exit "$status"
