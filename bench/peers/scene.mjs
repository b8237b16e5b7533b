// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The numbers of bench/scenes.h, and what the peers in JavaScript have in common.

export function hash(n) {
  n ^= n >>> 16, n = Math.imul(n, 0x7feb352d);
  n ^= n >>> 15, n = Math.imul(n, 0x846ca68b);
  return (n ^ (n >>> 16)) >>> 0;
}

export const keys = 60, functions = 3;
const any = (object, f, key, which) => hash(((object * functions + f) * keys + key) * 4 + which);

export function frameOf(shared, object, f, key) {
  const even = 1 + 10 * key;
  return shared || key === 0 || key === keys - 1 ? even : even + (any(object, f, key, 3) % 80) / 10 - 4;
}

// Rotations in degrees.
export function valueOf(object, f, key) {
  const number = (which, below) => any(object, f, key, which) % below;
  if (f === 1) return [number(0, 360), number(1, 360), number(2, 360)];
  return [number(0, 900) / 100, number(1, 900) / 100, 1 + number(2, 900) / 100];
}

export const seconds = frame => (frame - 1) / 60;

export function framesOf(row) {
  const out = [];
  for (let k = 0; k < 500; ++k) out.push(row === 'random' ? 1 + (hash(1000000 + k) % 5990) / 10 : 2 + k);
  return out;
}

// What a frame takes, in units of so many nanoseconds; a line a round, as bench/timing.h reports.
export function measure(name, rounds, frames, unit, go) {
  for (const frame of frames) go(frame); // makes ready what is made at first use
  for (let round = 0; round < rounds; ++round) {
    go(frames[0]);
    const begun = process.hrtime.bigint();
    for (let k = 1; k < frames.length; ++k) go(frames[k]);
    console.log(name, Number(process.hrtime.bigint() - begun) / (frames.length - 1) / unit);
  }
}

// Compares with lines of `bench_checks keys` on standard input: what is at an object and frame, as numbers by position,
// angles (degrees) and scale, and where given its matrix. `null`: not compared there. Says the largest difference.
export async function compare(name, at) {
  let text = '', worst = 0, compared = 0;
  for await (const chunk of process.stdin) text += chunk;
  for (const line of text.trim().split('\n')) {
    const [object, frame, ...wanted] = line.split(' ').map(Number);
    for (let i = 3; i < 6; ++i) wanted[i] *= 180 / Math.PI;
    at(object, frame).forEach((is, i) => {
      if (is === null) return;
      ++compared;
      const by = Math.abs(is - wanted[i]) / (1 + Math.abs(wanted[i]));
      worst = by <= worst ? worst : by;
    });
  }
  console.log('compared', compared);
  console.log('differs', worst);
}
