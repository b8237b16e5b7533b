// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The algebra of motions for pages: what algebra.cpp answers, as values. `module` is the compiled engine.
const algebraOf = (module) => {
  const ask = (name, ...given) => {
    const texts = [];
    const pass = (value) => {
      if (typeof value !== 'string') return value;
      const size = module.lengthBytesUTF8(value) + 1, at = module._malloc(size);
      module.stringToUTF8(value, at, size);
      texts.push(at);
      return at;
    };
    try {
      return JSON.parse(module.UTF8ToString(module[name](...given.map(pass))));
    } finally {
      texts.forEach(module._free);
    }
  };
  const places = (points) => points.flat().join(' ');
  return {
    string: (text, points = []) => ask('_betwixt_string', text, places(points)),
    frames: (text, from, to, count, linear = false) => ask('_betwixt_frames', text, from, to, count, +linear).frames,
    moment: (text, t) => ask('_betwixt_moment', text, t),
    methods: (text, steps, points) => ask('_betwixt_methods', text, steps, places(points)),
    drift: (text, method, linear, single, points) => ask(
      '_betwixt_drift', text, ['matrix', 'geometric', 'differences', 'best'].indexOf(method), +linear, +single,
      places(points)),
    ways: (text, points) => ask('_betwixt_ways', text, places(points)).ways,
    changed: (text, factor, what, to) =>
      ask('_betwixt_changed', text, factor, what, ...to, ...[0, 0, 0].slice(to.length))
  };
};
