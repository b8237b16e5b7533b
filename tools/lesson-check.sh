#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# lesson-check.sh PROGRAM [FOLDER]: opens lessons in a real browser, wide and narrow, and sees that they say no error,
# load nothing, fit the window, obey the slider, the keys, the button and the address, and compute what the program
# computes. With FOLDER, pictures of them go there. It needs Chromium, and exits 3 where there is none.
here=$(dirname -- "$(realpath -- "${BASH_SOURCE[0]}")")
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome) ||
  { echo "lesson-check.sh: there is no Chromium here: apt-get install chromium" >&2; exit 3; }
pictures=${2:+$(mkdir -p -- "$2" && realpath -- "$2")}
# shellcheck source=tests/app/support.sh
. "$here/../tests/app/support.sh"
browse() { # SIZE ARGUMENT…
  local size=$1
  shift
  timeout 120 "$browser" --headless=new --no-sandbox --disable-gpu --hide-scrollbars --user-data-dir="$work/profile" \
    --enable-logging=stderr --virtual-time-budget=15000 --window-size="$size" "$@"
}

# What is appended to a copy of the page: a reader who uses it, and notes what is wrong.
cat >"$work/reader.html" <<'HTML'
<script>
'use strict';
(async () => {
  const wrong = [], root = document.documentElement, slider = document.getElementById('time');
  const lesson = JSON.parse(document.getElementById('lesson').textContent);
  const want = (what, is) => { if (!is) wrong.push(what); };
  const later = (ms) => new Promise((done) => setTimeout(done, ms));
  const at = () => +root.dataset.t;
  const shown = () => [...document.querySelectorAll('#matrix td')].map((c) => +c.textContent.replace('−', '-'));
  const drag = (t) => { slider.value = t; slider.dispatchEvent(new Event('input')); slider.dispatchEvent(new Event('change')); };

  want('the address sets t', at() === 0.25);
  want('computes what the program computes: ' + root.dataset.apart, +root.dataset.apart <= 1e-9);
  for (const k of [0, 30, 60, 120]) {
    drag(k / 120);
    const [a, b, c, d, e, f] = lesson.frames[k], m = shown();
    want('the matrix at ' + k, [a, c, e, b, d, f, 0, 0, 1].every((x, i) => Math.abs(m[i] - x) <= 1e-3 * Math.max(1, Math.abs(x))));
  }
  drag(0.5);
  want('the slider sets t', at() === 0.5);
  want('the slider says what it is', slider.getAttribute('aria-label') && slider.getAttribute('aria-valuetext') === 't = 0.500');
  want('the slider is noted in the address', location.hash === '#t=0.500');
  const button = document.getElementById('play');
  // A browser without a screen draws when it likes: the clock of this page takes its place.
  window.requestAnimationFrame = (draw) => setTimeout(() => draw(performance.now()), 16);
  drag(0);
  button.click();
  want('the button says Pause', button.getAttribute('aria-label') === 'Pause');
  for (let i = 0; i < 100 && at() === 0; ++i) await later(20);
  want('play goes on', at() > 0 && at() < 1);
  document.body.dispatchEvent(new KeyboardEvent('keydown', {key: ' ', bubbles: true, cancelable: true}));
  const halted = at();
  await later(200);
  want('the space bar halts', at() === halted && button.getAttribute('aria-label') === 'Play');
  location.hash = '#t=0.75';
  await later(50);
  want('a new address moves it', at() === 0.75);
  want('numbers are numbers', ![...document.querySelectorAll('svg *')].some((e) =>
    [...e.attributes].some((a) => /NaN|Infinity|undefined/.test(a.value))));
  want('words are words', !/NaN|undefined|Infinity|\[object/.test(document.querySelector('main').innerText));
  want('pictures are named', [...document.querySelectorAll('svg.picture')].every((s) => s.getAttribute('aria-label')));
  const turns = lesson.factors.reduce((n, f) => n + Math.abs(f.turns || 0), 0), many = 'Too many turns to be drawn one by one';
  const corners = (e) => e.getAttribute('d').split('L').length;
  const lines = [...document.querySelectorAll('#stage path')].filter((e) => e.getAttribute('stroke-width') === '2' && corners(e) > 1);
  const shades = [...document.querySelectorAll('#stage path[stroke-opacity="0.22"]')];
  want('many turns are said', document.getElementById('legend').innerText.includes(many) === turns > 24);
  want('and shaded', (shades.length > 0) === turns > 24 && shades.every((e) => corners(e) >= 64 * Math.min(turns, 40)));
  want('turns are round', lines.every((e) => corners(e) >= 64 * Math.min(turns, 3)) && (turns > 24 || lines.every((e) => corners(e) >= 64 * turns)));
  const words = {
    'S(1)': 'Leaves every size as it is.',
    'S(1.0000001)': 'Makes everything 1.0000001 times as large. The centre (0, 0) stays. The size grows by the same factor in every step (the exponential law).',
    'S(0 linear)': 'Shrinks everything to one point. The centre (0, 0) stays. The size shrinks by the same amount in every step (the linear law).',
    'S(2 0.5 @ 1 1)': 'Makes the width twice as large and the height half as large. The centre (1, 1) stays. The size changes by the same factor in every step (the exponential law).'
  };
  for (const card of document.querySelectorAll('#cards > li')) {
    const text = words[card.querySelector('h3').innerText];
    if (text) want('the words of ' + text, card.querySelector('p').innerText === text);
  }
  want('nothing is loaded', performance.getEntriesByType('resource').length === 0);
  want('it fits: ' + root.scrollWidth + ' of ' + innerWidth, root.scrollWidth <= innerWidth);
  const cells = document.querySelector('#ways').innerText;
  for (const w of lesson.ways)
    for (const text of w.refused ? [w.refused] : [w.step, w.before]) want('shows ' + text, cells.includes(text));
  want('a picture for each factor', document.querySelectorAll('#cards > li').length === lesson.factors.length);
  root.dataset.wrong = wrong.length ? wrong.join('; ') : 'nothing';
})();
</script>
HTML

number=0
while IFS= read -r motion; do
  number=$((number + 1))
  page=$work/lesson-$number.html
  "$program" algebra --lesson "$page" "$motion" || { verdict "\"$motion\"" no "no lesson"; continue; }
  { cat "$page" "$work/reader.html"; } >"$work/read.html"
  for size in 1200,1000 400,800; do
    dom=$(browse $size --dump-dom "file://$work/read.html#t=0.25" 2>"$work/said")
    wrong=$(sed -nE '1,/<head/s/.*data-wrong="([^"]*)".*/\1/p' <<<"$dom")
    verdict "\"$motion\" at $size" "$([ "$wrong" = nothing ] && echo yes)" "${wrong:-the reader did not come to an end}"
    verdict "\"$motion\" at $size, console" "$(grep -q CONSOLE "$work/said" || echo yes)" "$(grep -m 3 CONSOLE "$work/said")"
  done
  [ -n "$pictures" ] || continue
  browse 1200,4600 --screenshot="$pictures/lesson-$number.png" "file://$page#t=0.4" 2>/dev/null
  browse 400,9000 --screenshot="$pictures/lesson-$number-narrow.png" "file://$page#t=0.4" 2>/dev/null
done <<'MOTIONS'
T(6.28 0) R(-1turn @ 0 1)
R(1turn) T(3 0)
S(2 0.5 @ 1 1) R(180deg)
S(3 0.5 @ 1 2 linear) T(6 1)
R(1turn) R(12turn @ 3 0) R(-2turn @ 4 1)
T(100 0) R(35deg @ 3 1) S(2 2 @ 0 0)

T(1 0) R(90deg @ 1 0) S(1.5 @ 0 1) T(0 2) R(-1turn @ 2 2) S(0.5 1 @ 1 1) R(45deg) T(-1 -1) S(2 1 linear) R(0.5turn @ 3 0) T(2 0) R(-30deg @ 1 1)
S(-1 0 @ 1 1 linear)
R(1000.25turn @ 1e-3 0)
R(24turn) T(3 0)
R(500turn) T(3 0)
R(10000turn) S(20) R(99turn @ 3 0)
S(0 linear) S(1.0000001) S(1 1)
T(1e-9 0) S(1e3)
T(9e8 -9e8)
MOTIONS
summary
