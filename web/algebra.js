// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The algebra of motions for pages: returns the answers of algebra.cpp as values. `call` is Engine.call of engine.js.
const algebraOf = (call) => {
  const ask = (name, ...given) => JSON.parse(call(name, ...given));
  const places = (points) => points.flat().join(' ');
  return {
    string: (text, points = []) => ask('betwixt_string', text, places(points)),
    frames: (text, from, to, count, linear = false) => ask('betwixt_frames', text, from, to, count, +linear).frames,
    moment: (text, t) => ask('betwixt_moment', text, t),
    methods: (text, steps, points) => ask('betwixt_methods', text, steps, places(points)),
    drift: (text, method, linear, single, points) => ask(
      'betwixt_drift', text, ['matrix', 'geometric', 'differences', 'best'].indexOf(method), +linear, +single,
      places(points)),
    ways: (text, points) => ask('betwixt_ways', text, places(points)).ways,
    changed: (text, factor, what, to) =>
      ask('betwixt_changed', text, factor, what, ...to, ...[0, 0, 0].slice(to.length))
  };
};
