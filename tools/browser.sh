#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Compares the program's CSS transforms with a real browser. Chromium shows 300 random pairs of lists at seven times
# each, and the tests of the algebra compare the matrices. ./test needs no browser: it compares with recorded answers.
#   tools/browser.sh [--record] [TESTS]
# --record writes one frame of each pair to tests/algebra/css_chromium.txt, which ./test uses. The default of TESTS is
# build/release/bin/test_algebra.
root=$(cd -P -- "$(dirname -- "$0")/.." && pwd)
die() { printf 'browser.sh: %s\n' "$*" >&2; exit 3; }

record=
[ "${1-}" != --record ] || { record=yes && shift; }
tests=${1:-$root/build/release/bin/test_algebra}
[ -x "$tests" ] || die "$tests is missing: ./test builds it"
for browser in ${BROWSER-} chromium chromium-browser google-chrome ''; do
  ! command -v "$browser" >/dev/null || break
done
[ -n "$browser" ] || die "no browser was found: apt-get install chromium, or set BROWSER=PROGRAM"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
version=$("$browser" --version 2>/dev/null | grep -oE '^[A-Za-z ]+ [0-9.]+')
# Chromium needs --no-sandbox when root starts it. The page is our own, so that is safe.
timeout 120 "$browser" --headless=new --no-sandbox --disable-gpu --user-data-dir="$work/profile" --dump-dom \
  "file://$root/tools/browser.html" 2>"$work/log" >"$work/page"
{
  echo "# $version"
  sed -n '/^<pre id="answers">/,/^# the end/p' "$work/page" | sed 's/^<pre id="answers">//; /^# the end/,$d'
} >"$work/answers"
grep -q '^# the end' "$work/page" && [ "$(wc -l <"$work/answers")" -gt 1000 ] || {
  tail -n 5 "$work/log" >&2
  die "the browser wrote no answers"
}
echo "$version"
BETWIXT_CSS_ANSWERS=$work/answers "$tests" --gtest_filter='CssInChromium.*' >"$work/result" 2>&1
status=$?
grep -vE '^\[|^Note|^Running|^$' "$work/result"
[ "$status" = 0 ] || { echo "they differ" && exit 1; }
[ -z "$record" ] ||
  # One of the seven times of each pair, but neither the first nor the last.
  awk '/^#/ || (row++ % 7) == int((row - 1) / 7) % 5 + 1' "$work/answers" >"$root/tests/algebra/css_chromium.txt"
