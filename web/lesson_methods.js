// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares the methods: their cost, their drift, and other paths to the same end.
// ---- Methods

const means = {
  matrix: "The points at rest, times the matrix of the step. Its numbers continue from step to step.",
  geometric: "Points are pushed, grown and sheared where they are.",
  "geometric, linear law": "The same for scalings by the linear law, for which the source counts it.",
  differences: "One constant matrix, times the points of the step before.",
  best: "The cheapest exact way that the string compiler finds."
};
const showMethods = () => {
  const answer = algebra.methods(shownText, state.steps, measured());
  byId("methods-none").hidden = !answer.error;
  byId("methods-all").hidden = Boolean(answer.error);
  lesson.ways = [];
  if (answer.error) {
    byId("methods-none").textContent =
      `Not here: ${answer.error.message}, and ${answer.error.hint}. A(t) is worked out anew for every moment.`;
    return;
  }
  lesson.ways = answer.ways;
  byId("steps").value = state.steps;
  byId("compiled").textContent = answer.compiled.replace(/-/g, "−");
  byId("ways-caption").textContent =
    `Counted for this string and ${state.steps} steps; the best way is sought for ${answer.countedFor} points.`;
  const list = byId("ways");
  list.textContent = "";
  for (const w of answer.ways) showMethod(list, w);
  showBars(answer);
  showMethodPictures(answer.ways);
};
const showMethod = (list, w) => {
  const row = put(list, "tr", w.name === "best" ? {class: "best"} : {});
  put(put(row, "th", {scope: "row"}, w.name), "small", {}, means[w.name]);
  const cell = (label, text, note) => {
    const td = put(row, "td", {class: "number", "data-label": label}, text);
    if (note) put(td, "small", {}, note);
  };
  const printed = (part) => {
    if (!w.printed) return cell("The source:", "–");
    const after = part === "before" && w.printed.after !== "0" ? `and ${w.printed.after} after the last step` : "";
    cell("The source:", w.printed[part], after);
  };
  if (w.refused) {
    const why = put(row, "td", {class: "refused", colspan: w.printed ? 1 : 5}, `Refuses: ${w.refused}.`);
    if (w.hint) put(why, "small", {}, w.hint.replace(/`([^`]*)`/g, "“$1”"));
    if (!w.printed) return;
    printed("step");
    cell("Before:", "–");
    printed("before");
    cell("Farthest:", "–");
    return;
  }
  cell("Per step:", w.step, `each point: ${w.does}`);
  printed("step");
  cell("Before:", w.before, w.functions ? `and ${counted(w.functions, "sine or the like", "sines and the like")}` : "");
  printed("before");
  const exact = w.gap <= 1e-7 * lesson.unit;
  cell(
    "Farthest:", exact ? tiny(w.gap) : number(w.gap, 3),
    exact ? "of rounding alone" : `at t = ${number(w.at, 3)}${w.linear ? ", from the motion by the linear law" : ""}`);
};
const showBars = ({ways, countedFor}) => {
  const able = ways.filter((w) => !w.refused), bars = byId("bars");
  const most =
    Math.max(1, ...ways.flatMap((w) => [w.operations || 0, w.printed && !w.refused ? w.printed.operations : 0]));
  bars.textContent = "";
  put(bars, "p", {class: "label"}, `Operations per step for ${countedFor} points. Dashed: as the source prints.`);
  for (const w of able) {
    const row = put(bars, "div", w.name === "best" ? {class: "best"} : {});
    put(row, "span", {}, w.name);
    const both = put(row, "i");
    const bar = (n, name) => {
      const b = put(both, "b", {class: name});
      put(b, "span", {style: `width: ${(100 * n / most).toFixed(2)}%`});
      put(b, "em", {}, grouped(n));
    };
    bar(w.operations, "ours");
    if (w.printed) bar(w.printed.operations, "printed");
  }
};
// Shows where each method puts the marked corner, step by step, on the path of the motion.
const showMethodPictures = (ways) => {
  const box = byId("ways-pictures"), tip = wholeFigure().followed[0], most = 240;
  box.textContent = "";
  updates.methods = [];
  for (const w of ways) {
    const figure = put(box, "figure");
    const caption = put(put(figure, "figcaption"), "b", {}, w.name).parentNode;
    if (w.refused) {
      caption.append(": refuses.");
      continue;
    }
    const motion = motionOf(lesson.factors, w.linear), path = motion.line.map((m) => moved(m, tip));
    const steps = w.frames.slice(0, most + 1).map((m) => moved(m, tip)),
          seen = frameAround([...path, ...steps], lesson.unit, true);
    const {svg, on, path: drawn} =
      windowOn(figure, seen, look(), `The marked corner, step by step, by the method ${w.name}`, 300, [0.5, 0.9], true);
    put(
      svg, "path",
      {class: "path", d: drawn(path), fill: "none", stroke: pathColour(0), "stroke-width": 3, "stroke-opacity": 0.6});
    for (const p of steps)
      stand(put(svg, "circle", {class: "path", r: steps.length > 100 ? 2 : 3, fill: pathColour(1)}), on(p));
    const mark = put(svg, "circle", {r: 6, fill: "none", stroke: "var(--ink)", "stroke-width": 2});
    const update = (t) => stand(mark, on(steps[Math.min(steps.length - 1, Math.round(t * (w.frames.length - 1)))]));
    update(state.t);
    updates.methods.push(update);
    caption.append(
      `: ${w.step}; ${w.gap <= 1e-7 * lesson.unit ? "on the path" : `up to ${number(w.gap, 3)} beside it`}`);
    figure.append(caption);
  }
};
byId("steps").addEventListener("change", () => {
  const n = Math.round(+byId("steps").value);
  if (n >= 1 && n <= 2000) state.steps = n;
  noteAddress();
  showMethods();
});

// ---- Drift

const methodLine = (name) => ["var(--p0)", "var(--p1)", "var(--p2)", "var(--ink)"][
  ["matrix", "geometric", "differences", "best"].indexOf(name.split(",")[0])];
const methodWidth = (name) => [4.5, 3.4, 2.4, 1.6][
  ["matrix", "geometric", "differences", "best"].indexOf(name.split(",")[0])];  // each is visible where lines meet
const showDrift = (drifting, marks, steps) => {
  const all =
    drifting.flatMap((w) => ["f32", "f64"].flatMap((k) => [...w[k].alone, ...w[k].renewed])).filter((d) => d > 0);
  const even = (p) => 2 * Math.floor(p / 2);
  const low = Math.max(-24, Math.min(-16, even(Math.log10(Math.min(1, ...all)))));
  const high = Math.min(12, Math.max(0, even(Math.log10(Math.max(1, ...all))) + 2));
  byId("drifts").textContent = "";
  byId("losses").textContent = "";
  if (all.length)
    for (const kind of ["f32", "f64"]) driftPicture(kind, drifting, marks, steps, low, high);
  byId("drift-none").hidden = all.length > 0;
  byId("drift-table").hidden = drifting.length === 0;
  const lost = drifting.some((w) => !(w.f32.alone.at(-1) <= 100 * w.f32.renewed.at(-1)));
  byId("drift-why").hidden = !(lost && turnsOf(lesson.factors) > 0);
  for (const w of drifting) {
    const row = put(byId("losses"), "tr", w.name === "best" ? {class: "best"} : {});
    put(row, "th", {scope: "row"}, w.name);
    for (const kind of ["f32", "f64"])
      for (const how of ["alone", "renewed"])
        put(
          row, "td", {class: "number", "data-label": `${kind}, ${how === "alone" ? "left alone" : how}:`},
          tiny(w[kind][how].at(-1)));
  }
};
const driftPicture = (kind, drifting, marks, steps, low, high) => {
  const box = put(byId("drifts"), "figure"), wide = 460, tall = 300, left = 52, right = 16, top = 16, below = 34;
  const svg = put(box, "svg", {
    class: "picture",
    viewBox: `0 0 ${wide} ${tall}`,
    role: "img",
    "aria-label":
      `Largest distance so far in ${kind} against steps, both by powers of ten; the numbers are in the table below`
  });
  const x = (step) => left + Math.log10(step) / Math.log10(steps) * (wide - left - right);
  const y = (d) => tall - below -
    (Math.log10(Math.min(Math.max(d, 10 ** low), 10 ** high)) - low) / (high - low) * (tall - top - below);
  for (let p = low; p <= high; p += 2) {
    put(svg, "path", {d: `M${left} ${y(10 ** p)}H${wide - right}`, stroke: "var(--grid)"});
    put(
      svg, "text", {x: left - 8, y: y(10 ** p) + 4, "text-anchor": "end"}, p === 0 ? "1" : `1e${p}`.replace("-", "−"));
  }
  for (let s = 1; s <= steps; s *= 10)
    put(
      svg, "text",
      {x: x(s),
       y: tall - 12,
       "text-anchor": s === 1 ? "start" :
         s === steps          ? "end" :
                                "middle"},
      s === 1     ? "1 step" :
        s >= 1000 ? `${s / 1000}k` :
                    s);
  for (const w of drifting)
    for (const how of ["renewed", "alone"])
      put(svg, "path", {
        fill: "none",
        stroke: methodLine(w.name),
        "stroke-width": methodWidth(w.name),
        "stroke-linejoin": "round",
        "stroke-dasharray": how === "alone" ? "none" : "3 4",
        d: "M" +
          w[kind][how].map((d, i) => `${x(marks[i]).toFixed(1)} ${y(d === null ? 10 ** high : d).toFixed(1)}`).join("L")
      });
  const caption = put(box, "figcaption", {}, `${kind}. `);
  for (const w of drifting) {
    put(caption, "span", {class: "key", style: `border-color: ${methodLine(w.name)}`});
    caption.append(w.name + " ");
  }
};
// Measures a hundred thousand steps, eight times, in pieces, so that the page stays responsive.
const measureDrift = (of) => {
  const able = (lesson.ways || []).filter((w) => !w.refused),
        pieces = able.flatMap((w) => ["f32", "f64"].map((kind) => ({w, kind})));
  const points = measured();
  let marks = [], steps = 0;
  byId("drift").classList.add("stale");
  byId("drift-wait").textContent = pieces.length ? "Measuring…" : "";
  const next = () => {
    if (of !== lesson) return;
    const piece = pieces.shift();
    if (!piece) {
      byId("drift").classList.remove("stale");
      byId("drift-wait").textContent =
        lesson.planar ? "" : "The methods are for the plane: there is nothing to measure in space.";
      const drifting = able.filter((w) => w.f32.alone.length > 0);
      showDrift(drifting, marks, steps);
      byId("drift-none").hidden ||= !lesson.planar;
      document.documentElement.dataset.measured = shownText;
      return;
    }
    const answer = algebra.drift(shownText, piece.w.method, piece.w.linear, piece.kind === "f32", points);
    piece.w[piece.kind] = answer;
    marks = answer.marks, steps = answer.steps;
    setTimeout(next);
  };
  next();
};

// ---- Other ways to the same end

const between = (frames) => (t) => {
  const at = t * (frames.length - 1), k = Math.min(frames.length - 2, Math.floor(at)), part = at - k;
  return frames[k].map((x, i) => x + part * (frames[k + 1][i] - x));
};
const showWays = () => {
  const all = algebra.ways(shownText, measured()), paths = all.filter((p) => p.kind !== "no root");
  byId("paths-none").hidden = all.length > 0;
  byId("paths-lead").hidden = paths.length === 0;
  byId("no-root").hidden = paths.length === all.length;
  byId("paths").textContent = "";
  const dense = isDense(lesson.factors);
  for (const p of paths) {
    const box = put(byId("paths"), "div", {class: "way"}), figure = put(box, "figure"), words = put(box, "div");
    words.append(byId(`path-${p.kind}`).content.cloneNode(true));
    const drawn = !dense || p.kind === "root";
    const other = p.kind === "law" ? {at: matrixOf(lesson.factors, true), line: motionOf(lesson.factors, true).line} :
                                     {at: between(p.frames), line: p.frames};
    if (drawn)
      picture(
        figure, lesson.factors, words.querySelector("h3").textContent,
        {linear: p.linear, other, options: {wide: 560, shapes: lesson.planar ? [0.5, 0.9] : [0.7, 0.7]}});
    if (dense)
      put(
        figure, "figcaption", {},
        drawn ? denseNote(lesson.factors) : "These are too many turns for this way to be drawn.");
    const most = `The largest distance: ${number(p.gap, 3)}, at t = ${number(p.at, 3)}.`;
    put(words, "p", {class: "small"}, `${most} The letter is ${number(1.5 * lesson.unit)} high.`);
  }
};

// Updates everything below the picture a moment later, because the reader looks at the picture during a drag.
let later = 0, measuring = 0;
const showLater = () => {
  clearTimeout(later);
  clearTimeout(measuring);
  later = setTimeout(() => {
    updates.rest = [];
    showCards();
    showMethods();
    showWays();
    document.documentElement.dataset.shown = shownText;
  }, 150);
  const of = lesson;
  measuring = setTimeout(() => measureDrift(of), 900);
};
