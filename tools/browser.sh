#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Lists of CSS transforms beside a real browser, frame by frame: Chromium shows 300 random pairs of lists at seven times
# each, and the tests of the algebra compare. The tests alone, without a browser, take what one has answered before.
#   tools/browser.sh [--record] [TESTS]
# --record: one frame of each pair becomes tests/algebra/css_chromium.txt. TESTS: build/release/bin/test_algebra
root=$(cd -P -- "$(dirname -- "$0")/.." && pwd)
die() { printf 'browser.sh: %s\n' "$*" >&2; exit 3; }

record=
[ "${1-}" != --record ] || { record=yes && shift; }
tests=${1:-$root/build/release/bin/test_algebra}
[ -x "$tests" ] || die "$tests is missing: ./test builds it"
for browser in ${BROWSER-} chromium chromium-browser google-chrome ''; do
  ! command -v "$browser" >/dev/null || break
done
[ -n "$browser" ] || die "this compares with a real browser, and there is none: apt-get install chromium, or BROWSER=PROGRAM"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
version=$("$browser" --version 2>/dev/null | grep -oE '^[A-Za-z ]+ [0-9.]+')
# As root a browser has no sandbox of its own; the page is ours.
timeout 120 "$browser" --headless=new --no-sandbox --disable-gpu --user-data-dir="$work/profile" --dump-dom \
  "file://$root/tools/browser.html" 2>"$work/log" >"$work/page"
{
  echo "# $version"
  sed -n '/^<pre id="answers">/,/^# the end/p' "$work/page" | sed 's/^<pre id="answers">//; /^# the end/,$d'
} >"$work/answers"
grep -q '^# the end' "$work/page" && [ "$(wc -l <"$work/answers")" -gt 1000 ] || {
  tail -n 5 "$work/log" >&2
  die "the browser gave no answers"
}
echo "$version"
BETWIXT_CSS_ANSWERS=$work/answers "$tests" --gtest_filter='CssInChromium.*' >"$work/result" 2>&1
status=$?
grep -vE '^\[|^Note|^Running|^$' "$work/result"
[ "$status" = 0 ] || { echo "they differ" && exit 1; }
[ -z "$record" ] ||
  # Neither the first nor the last of the seven.
  awk '/^#/ || (row++ % 7) == int((row - 1) / 7) % 5 + 1' "$work/answers" >"$root/tests/algebra/css_chromium.txt"
