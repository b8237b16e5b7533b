// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// anime.js and GSAP: a timeline of tweens on plain objects, sought. They make numbers, no matrices; a tenth of the objects,
// as what they cost grows with these.
//   node tweens.mjs anime|gsap ROW ROUNDS      keys, random, shared
//   node tweens.mjs anime|gsap compare <LINES  see scene.mjs
import { compare, frameOf, framesOf, keys, measure, seconds, valueOf } from './scene.mjs';

const [library, row, rounds = '5'] = process.argv.slice(2);
const count = 100, names = ['px', 'py', 'pz', 'rx', 'ry', 'rz', 'sx', 'sy', 'sz'];

function objects() {
  const first = k => [0, 1, 2].flatMap(f => valueOf(k, f, 0));
  return Array.from({ length: count }, (_, k) => Object.fromEntries(first(k).map((v, i) => [names[i], v])));
}
const lengthOf = (shared, k, f, i) => seconds(frameOf(shared, k, f, i)) - seconds(frameOf(shared, k, f, i - 1));

async function anime(all, shared) {
  const { createTimeline } = await import('animejs');
  const film = createTimeline({ autoplay: false, defaults: { ease: 'linear' } });
  all.forEach((o, k) => {
    for (let f = 0; f < 3; ++f) {
      const rows = {};
      for (let c = 0; c < 3; ++c) {
        rows[names[3 * f + c]] = [];
        for (let i = 1; i < keys; ++i) {
          const step = { to: valueOf(k, f, i)[c], duration: 1000 * lengthOf(shared, k, f, i) };
          if (i === 1) step.from = valueOf(k, f, 0)[c];
          rows[names[3 * f + c]].push(step);
        }
      }
      film.add(o, rows, 0);
    }
  });
  return frame => film.seek(1000 * seconds(frame), true);
}

async function gsap(all, shared) {
  const { gsap } = await import('gsap');
  const film = gsap.timeline({ paused: true, defaults: { ease: 'none', lazy: false } });
  all.forEach((o, k) => {
    for (let f = 0; f < 3; ++f) {
      const keyframes = [];
      for (let i = 1; i < keys; ++i) {
        const step = { duration: lengthOf(shared, k, f, i), ease: 'none' };
        valueOf(k, f, i).forEach((v, c) => (step[names[3 * f + c]] = v));
        keyframes.push(step);
      }
      film.to(o, { keyframes, ease: 'none' }, 0);
    }
  });
  return frame => film.time(seconds(frame), true);
}

const all = objects(), make = library === 'gsap' ? gsap : anime;
const name = library === 'gsap' ? 'GSAP' : 'anime.js';
if (row === 'compare') {
  const go = await make(all, false);
  await compare(name, (object, frame) => {
    go(frame);
    return names.map(n => all[object][n]);
  });
} else measure(name, Number(rounds), framesOf(row).slice(0, 100), count, await make(all, row === 'shared'));
process.exit(0);
