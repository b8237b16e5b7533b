// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures of motions, in the plane and in space. A matrix is twelve numbers: its upper three rows, row by row. A place
// is three numbers. Factors and paths have their own colours.
const byId = (id) => document.getElementById(id);
const svgSpace = byId("play").querySelector("svg").namespaceURI;

// Sets text only as text, never as markup.
const put = (parent, name, attributes = {}, text) => {
  const space = parent.namespaceURI === svgSpace || name === "svg" ? svgSpace : parent.namespaceURI;
  const element = parent.appendChild(document.createElementNS(space, name));
  for (const key in attributes)
    if (key === "style") element.style.cssText = attributes[key];  // as an attribute it would be against the page's policy
    else element.setAttribute(key, attributes[key]);
  if (text !== undefined) element.textContent = text;
  return element;
};
const factorColour = (i) => `var(--f${i % 4})`;
const pathColour = (i) => `var(--p${i % 3})`;

const number = (x, digits = 4) => {
  if (x === null || !Number.isFinite(x)) return "∞";
  const short = +x.toPrecision(digits);
  return (Math.abs(short) >= 1e6 || (short !== 0 && Math.abs(short) < 1e-4) ? short.toExponential() : String(short))
    .replace(/-/g, "−")
    .replace("e+", "e");
};

// ---- Vectors

const plus = (a, b, k = 1) => [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]];
const crossed = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const lengthOf = (v) => Math.hypot(...v);
const direction = (v) => v.map((x) => x / (lengthOf(v) || 1));
const moved = (m, [x, y, z]) => [0, 4, 8].map((r) => m[r] * x + m[r + 1] * y + m[r + 2] * z + m[r + 3]);
// Returns the directions of the angles 0 and a quarter turn about an axis.
const around = (axis) => {
  const first = direction(crossed(Math.abs(axis[1]) < 0.9 ? [0, 1, 0] : [0, 0, -1], axis));
  return [first, crossed(axis, first)];
};

// ---- The figure: a letter F, in space as thick as its lines

const letter = [[0, 0], [.3, 0], [.3, .6], [.8, .6], [.8, .9], [.3, .9], [.3, 1.2], [1, 1.2], [1, 1.5], [0, 1.5]];
const figureOf = (unit, flat) => {
  const side = (z) => letter.map(([x, y]) => [x * unit, y * unit, z * unit]);
  if (flat) return {outline: side(0), faces: [side(0)], tip: side(0)[8], foot: side(0)[0]};
  const front = side(.15), back = side(-.15), n = letter.length;
  const walls = letter.map((_, i) => [front[(i + 1) % n], front[i], back[i], back[(i + 1) % n]]);
  return {outline: front, faces: [front, back.slice().reverse(), ...walls], tip: front[8], foot: front[0]};
};

// ---- Windows

// Returns the view directions: turned about y by yaw, then tilted by pitch. In the plane both are 0.
const lookFrom = ({yaw, pitch}) => {
  const cy = Math.cos(yaw), sy = Math.sin(yaw), cp = Math.cos(pitch), sp = Math.sin(pitch);
  return {right: [cy, 0, sy], up: [sy * sp, cp, -cy * sp], near: [-sy * cp, sp, cy * cp]};
};
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

// Returns round numbers that divide low to high into a few parts.
const ticks = (low, high, most) => {
  const least = (high - low) / most, power = 10 ** Math.floor(Math.log10(least));
  const step = power * ([1, 2, 5].find((s) => s * power >= least * (1 - 1e-9)) || 10);
  const all = [];
  for (let k = Math.ceil(low / step); k * step <= high; ++k) all.push(k * step);
  return all;
};

// Returns the middle and the extent of places. In space the extent is that of a ball around them, so that the picture
// keeps its size while it turns.
const frameAround = (places, unit, flat) => {
  const low = [0, 1, 2].map((c) => places.reduce((x, p) => Math.min(x, p[c]), Infinity));
  const high = [0, 1, 2].map((c) => places.reduce((x, p) => Math.max(x, p[c]), -Infinity));
  const middle = plus(low, high).map((x) => x / 2), size = plus(high, low, -1);
  const round = Math.max(...places.map((p) => lengthOf(plus(p, middle, -1)))) * 2;
  const air = 0.16 * Math.max(...size, unit);
  return {middle, wide: (flat ? size[0] : round) + air, high: (flat ? size[1] : round * 0.86) + air};
};

const windowOn = (parent, seen, look, label, wide, shapes, flat) => {
  const shape = Math.min(shapes[1], Math.max(shapes[0], seen.high / seen.wide));
  const high = Math.round(wide * shape), scale = Math.min(wide / seen.wide, high / seen.high);
  const eye = lookFrom(look), mx = dot(seen.middle, eye.right), my = dot(seen.middle, eye.up);
  const on = (p) => [wide / 2 + (dot(p, eye.right) - mx) * scale, high / 2 - (dot(p, eye.up) - my) * scale];
  const path = (ps, closed) =>
    ps.length ? "M" + ps.map((p) => on(p).map((v) => v.toFixed(1)).join(" ")).join("L") + (closed ? "Z" : "") : "";
  const svg = put(
    parent, "svg",
    {class: flat ? "picture" : "picture space", viewBox: `0 0 ${wide} ${high}`, role: "img", "aria-label": label});
  const w = {svg, on, path, eye, scale, wide, high};
  (flat ? paper : floor)(w, seen);
  return w;
};

// Draws squared paper under the plane.
const paper = ({svg, on, scale, wide, high}, {middle}) => {
  const grid = put(svg, "g", {"stroke-width": 1, fill: "none", "aria-hidden": true});
  const marks = put(svg, "g", {"aria-hidden": true});
  const x0 = middle[0] - wide / 2 / scale, y0 = middle[1] - high / 2 / scale;
  const line = (at) => Math.abs(at) < 1e-9 * wide / scale ? "var(--rule)" : "var(--grid)";
  for (const x of ticks(x0, x0 + wide / scale, 8)) {
    const at = on([x, 0, 0])[0];
    put(grid, "path", {d: `M${at} 0V${high}`, stroke: line(x)});
    if (at > 26 && at < wide - 26) put(marks, "text", {x: at, y: high - 6, "text-anchor": "middle"}, number(x));
  }
  for (const y of ticks(y0, y0 + high / scale, Math.max(2, Math.round(8 * high / wide)))) {
    const at = on([0, y, 0])[1];
    put(grid, "path", {d: `M0 ${at}H${wide}`, stroke: line(y)});
    if (at > 14 && at < high - 22) put(marks, "text", {x: 6, y: at + 4}, number(y));
  }
};
// Draws a squared floor, y = 0, under space, and the three axes.
const floor = ({svg, on, path}, {middle, wide}) => {
  const g = put(svg, "g", {"stroke-width": 1, fill: "none", "aria-hidden": true});
  const r = wide / 2, lines = ticks(-r, r, 8), step = lines[1] - lines[0];
  const round = (x) => Math.round(x / step) * step;
  const cx = round(middle[0]), cz = round(middle[2]), reach = lines.at(-1);
  for (const x of lines) {
    put(g, "path", {d: path([[cx + x, 0, cz - reach], [cx + x, 0, cz + reach]]), stroke: "var(--grid)"});
    put(g, "path", {d: path([[cx - reach, 0, cz + x], [cx + reach, 0, cz + x]]), stroke: "var(--grid)"});
  }
  [[1, 0, 0], [0, 1, 0], [0, 0, 1]].forEach((axis, i) => {
    const end = axis.map((x) => x * reach);
    put(g, "path", {d: path([[0, 0, 0], end]), stroke: "var(--rule)", "stroke-width": 2});
    const [x, y] = on(end);
    put(g, "text", {x: x + 4, y: y - 4}, "xyz"[i] + " " + number(reach));
  });
};

// ---- The figure and its motion

const stand = (element, [x, y]) => element.setAttribute("transform", `translate(${x.toFixed(2)} ${y.toFixed(2)})`);
const cross = (parent, stroke) => put(
  parent, "path",
  {class: "factor", d: "M-7 0H7M0 -7V7", stroke, "stroke-width": 2, fill: "none", "stroke-linecap": "round"});

// Returns a function that draws the figure at a matrix: flat, or its faces from the farthest to the nearest.
const solid = (w, figure, flat) => {
  const g = put(w.svg, "g", {stroke: "var(--ink)", "stroke-width": 1.4, "stroke-linejoin": "round"});
  const faces = figure.faces.map(() => put(g, "path", flat ? {fill: "var(--ink)", "fill-opacity": 0.14} : {}));
  return (m) => {
    const all = figure.faces.map((face, i) => ({i, at: face.map((p) => moved(m, p))}));
    if (!flat) all.sort((a, b) => depth(w, a.at) - depth(w, b.at));
    all.forEach(({i, at}, k) => {
      faces[k].setAttribute("d", w.path(at, true));
      if (!flat) faces[k].style.fill = `color-mix(in srgb, var(--ink) ${i < 2 ? 12 : 28}%, var(--panel))`;
    });
  };
};
const depth = (w, places) => places.reduce((sum, p) => sum + dot(p, w.eye.near), 0) / places.length;

const ghosts = [1, 2, 3, 4, 5, 6, 7, 8].map((k) => k / 8);

// Draws a motion. `motion`: {at(t), line: frames, shade: [frames], other: {line, at}}; `crosses`: {colour, at, line};
// `followed`: places. Returns {w, update(t), seen}.
const drawMotion = (parent, motion, options) => {
  const {figure, followed, look, label, wide, shapes, unit, flat, crosses = [], plain = false} = options;
  const poses = ghosts.map(motion.at), corners = figure.outline.concat(followed);
  const other = motion.other;
  const lines = [motion.line, ...(motion.shade || [])].flat();
  const places = corners.concat(
    lines.flatMap((m) => followed.map((p) => moved(m, p))), poses.flatMap((m) => corners.map((p) => moved(m, p))),
    other ? other.line.concat(ghosts.map(other.at)).flatMap((m) => corners.map((p) => moved(m, p))) : [],
    crosses.flatMap((c) => c.line.length ? c.line : [c.at(0)]), options.also || []);
  const seen = options.seen || frameAround(places, unit, flat);
  const w = windowOn(parent, seen, look, label, wide, shapes, flat);
  const ink = (attributes) => put(w.svg, "path", {fill: "none", "stroke-linejoin": "round", ...attributes});
  if (motion.shade && motion.shade.length)
    followed.forEach((p, i) => ink({
                       class: "path shade",
                       d: motion.shade.map((turn) => w.path(turn.map((m) => moved(m, p)))).join(""),
                       stroke: pathColour(i),
                       "stroke-width": 6,
                       "stroke-opacity": 0.22
                     }));
  for (const m of poses)
    ink({d: w.path(figure.outline.map((p) => moved(m, p)), true), stroke: "var(--soft)", "stroke-opacity": 0.35});
  ink({d: w.path(figure.outline, true), stroke: "var(--soft)", "stroke-dasharray": "4 3", "stroke-width": 1.2});
  for (const c of crosses)
    if (c.line.length)
      ink({
        class: "factor",
        d: w.path(c.line),
        stroke: c.colour,
        "stroke-dasharray": "1 4",
        "stroke-linecap": "round",
        "stroke-width": 1.6
      });
  followed.forEach((p, i) => {
    ink({class: "path", d: w.path(motion.line.map((m) => moved(m, p))), stroke: pathColour(i), "stroke-width": 2.2});
    if (other)
      ink({
        class: "path other",
        d: w.path(other.line.map((m) => moved(m, p))),
        stroke: pathColour(i),
        "stroke-width": 2,
        "stroke-dasharray": "7 5"
      });
  });
  const second = other && ink({stroke: "var(--ink)", "stroke-dasharray": "5 3", "stroke-width": 1.4});
  const body = solid(w, figure, flat);
  const dots = plain ?
    [] :
    followed.map(
      (_, i) => put(
        w.svg, "circle", {class: "path", r: 4.5, fill: pathColour(i), stroke: "var(--panel)", "stroke-width": 1.5}));
  const marks = crosses.map((c) => cross(w.svg, c.colour));
  const update = (t) => {
    const m = motion.at(t);
    body(m);
    if (other) second.setAttribute("d", w.path(figure.outline.map((p) => moved(other.at(t), p)), true));
    dots.forEach((d, i) => stand(d, w.on(moved(m, followed[i]))));
    marks.forEach((c, i) => stand(c, w.on(crosses[i].at(t))));
  };
  return {w, seen, update};
};
