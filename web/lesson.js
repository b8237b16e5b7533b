// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The lesson: a string that is edited as text, as a row of factors or by what is dragged in the picture, and all that
// follows from it. What is worked out of a motion comes from the engine (algebra.js); here it is shown.
const given = JSON.parse(byId("lesson").textContent);
const state = { text: given.text, points: given.points, steps: given.steps, t: 0, yaw: -0.5, pitch: 0.35 };
let algebra = null;
let shownText = "";  // the last string that was one
let lesson = null;   // what there is to know of it
let before = [];     // strings, to undo
const updates = { stage: [], rest: [], methods: [] };  // what is drawn anew when t changes

// ---- Words

const place = (p) => `(${(p[2] ? p : p.slice(0, 2)).map((x) => number(x)).join(", ")})`;
// As many digits at any time, so that they do not jump about; small figures have small numbers.
const fixed = (x, unit = lesson.unit) => {
  if (Math.abs(x) < 1e-7 * Math.min(1, unit)) x = 0;
  if (Math.abs(x) >= 1e7 || (unit < 0.01 && x !== 0 && Math.abs(x) < 0.01)) return number(x, 5);
  return x.toFixed(Math.abs(x) >= 1000 ? 1 : Math.abs(x) >= 100 ? 3 : 5).replace("-", "−");
};
// An error of floating point, as one says it.
const tiny = (x) => {
  if (x === null) return "lost";
  if (x === 0) return "none";
  return x >= 0.01 ? number(x, 2) : x.toExponential(1).replace("-", "−");
};
const grouped = (n) => n.toLocaleString("en").replace(/,/g, "\u202f");
const counted = (n, one, many) => `${n} ${n === 1 ? one : many}`;

const wayInWords = ([x, y, z]) => {
  const parts = [];
  if (x) parts.push(`${number(Math.abs(x))} to the ${x > 0 ? "right" : "left"}`);
  if (y) parts.push(`${number(Math.abs(y))} ${y > 0 ? "up" : "down"}`);
  if (z) parts.push(`${number(Math.abs(z))} to the ${z > 0 ? "front" : "back"}`);
  return parts.join(" and ");
};
const turnInWords = (turns) => {
  const size = Math.abs(turns), whole = Math.abs(size - Math.round(size)) < 1e-9;
  if (size === 0.5) return "half a turn";
  if (size === 0.25) return "a quarter of a turn";
  if (whole && size > 0.5) return Math.round(size) === 1 ? "one whole turn" : `${number(size, 12)} whole turns`;
  return size < 1 ? `by ${number(360 * size)}°` : `${number(size, 8)} turns`;
};
const growthInWords = (g) => {
  const plain = { "-1": "its own mirror image", "0": "zero", "0.5": "half as large", "2": "twice as large" };
  const size = Math.abs(g), digits = Math.abs(size - 1) < 1e-3 ? 17 : 4;  // or nearly 1 would be 1
  return plain[g] || `${g < 0 ? "mirrored and " : ""}${number(size, digits)} times as large`;
};
const scalingInWords = (f) => {
  const [x, y, z] = f.by, sizes = lesson.planar ? [x, y] : f.by;
  if (sizes.every((g) => g === 1)) return "Leaves every size as it is.";
  const names = ["width", "height", "depth"];
  let what = "Makes the " + sizes.map((g, i) => g === 1 ? "" : `${names[i]} ${growthInWords(g)}`).filter(Boolean).join(" and the ");
  if (x === y && (lesson.planar || y === z)) what = x === 0 ? "Shrinks everything to one point" : `Makes everything ${growthInWords(x)}`;
  const does = sizes.every((g) => g >= 1) ? "grows" : sizes.every((g) => g >= 0 && g <= 1) ? "shrinks" : "changes";
  return `${what}. The centre ${place(f.centre)} stays. The size ${does} by the same `
    + (f.linear ? "amount in every step (the linear law)." : "factor in every step (the exponential law).");
};
const described = (f) => {
  if (f.kind === "T") return f.by.some(Boolean) ? `Moves everything ${wayInWords(f.by)}.` : "Moves nothing.";
  if (f.kind === "S") return scalingInWords(f);
  if (f.turns === 0) return "Turns nothing.";
  const upright = f.axis[0] === 0 && f.axis[1] === 0, forward = upright ? f.turns * f.axis[2] : f.turns;
  const seen = upright ? "" : `, seen from where the axis ${place(f.axis)} points to`;
  return `Turns everything ${turnInWords(f.turns)} about ${place(f.centre)}, ${forward > 0 ? "counterclockwise" : "clockwise"}${seen}.`;
};
// What of a factor is done: its numbers as the engine gives them.
const partly = (f, part) => {
  const at = f.centre && f.centre.some(Boolean) ? ` @ ${(f.centre[2] ? f.centre : f.centre.slice(0, 2)).map((x) => number(x)).join(" ")}` : "";
  const numbers = (lesson.planar ? part.slice(0, 2) : part).map((x) => number(x)).join(" ");
  return f.kind === "T" ? `T(${numbers})` : f.kind === "R" ? `R(${number(part[0])}°${at})` : `S(${numbers}${at})`;
};

// ---- Asking the engine

const kept = new Map();  // frames of some factors, as long as the string is the same
const keptNow = { t: -1, of: new Map() };  // and at one moment, which many pictures ask for
const framesOf = (texts, from, to, count, linear = false) => {
  const text = texts.join(" "), key = [text, from, to, count, linear].join();
  if (count === 0) return [momentOf(text, from, linear)];
  if (!kept.has(key)) kept.set(key, algebra.frames(text, from, to, count, linear));
  return kept.get(key);
};
const momentOf = (text, t, linear) => {
  const key = linear + text;
  if (t !== keptNow.t) keptNow.of.clear(), keptNow.t = t;
  if (!keptNow.of.has(key)) keptNow.of.set(key, algebra.frames(text, t, t, 0, linear)[0]);
  return keptNow.of.get(key);
};
const textsOf = (factors) => factors.map((f) => f.text);
const matrixOf = (factors, linear) => {
  const texts = textsOf(factors);
  return (t) => framesOf(texts, t, t, 0, linear)[0];
};

const turnsOf = (factors) => factors.reduce((n, f) => n + (f.kind === "R" ? Math.abs(f.turns) : 0), 0);
const exponentsOf = (factors) => factors.reduce(
  (n, f) => n + (f.kind === "S" && !f.linear ? Math.max(...f.by.map((g) => Math.abs(Math.log(g)))) : 0), 0);

// The moments that a path is drawn through are so many that a quick turn looks round. More turns than can be told apart
// are not drawn one by one: `line` is the first of them then, and `shade` shows where they run. It has all, or so many
// as can be drawn, in no rhythm that another turn could share.
const mostTurns = 24, firstTurns = 3, perTurn = 64, mostShaded = 300;
const isDense = (factors) => turnsOf(factors) > mostTurns;
const denseNote = (factors) => {
  const where = turnsOf(factors) > mostShaded ? `where ${mostShaded} of them run` : "where they run";
  return `Too many turns to be drawn one by one: the lines are the first ${firstTurns}, the shade is ${where}.`;
};
const motionOf = (factors, linear = false) => {
  const texts = textsOf(factors), turns = turnsOf(factors), at = matrixOf(factors, linear);
  const frames = (from, to, count) => framesOf(texts, from, to, count, linear);
  if (!isDense(factors)) return { at, line: frames(0, 1, Math.ceil(120 + perTurn * turns + 16 * exponentsOf(factors))), shade: [] };
  const line = frames(0, firstTurns / turns, perTurn * firstTurns);
  if (turns <= mostShaded) return { at, line, shade: [frames(0, 1, Math.ceil(perTurn * turns))] };
  const golden = (Math.sqrt(5) - 1) / 2;
  const begin = (k) => (k + golden * k % 1) / mostShaded * (1 - 1 / turns);
  return { at, line, shade: Array.from({ length: mostShaded }, (_, k) => frames(begin(k), begin(k) + 1 / turns, perTurn)) };
};
// A centre is carried by the factors on its left.
const crossesOf = (factors, first) => factors.flatMap((f, i) => {
  if (f.kind === "T") return [];
  const over = factors.slice(0, i), at = matrixOf(over);
  const line = i > 0 ? motionOf(over).line.map((m) => moved(m, f.centre)) : [];
  return [{ colour: factorColour(first + i), line, at: i > 0 ? (t) => moved(at(t), f.centre) : () => f.centre }];
});
const wholeFigure = () => {
  const figure = figureOf(lesson.unit, lesson.planar);
  return { figure, followed: [figure.tip, figure.foot, ...state.points] };
};
const measured = () => wholeFigure().figure.outline.concat(state.points);

// ---- The string: text, errors, the row of factors

const field = byId("string");
const sameHeight = () => {
  field.style.height = "0";
  field.style.height = `${field.scrollHeight + 2}px`;
};
const complain = (text, error) => {
  const box = byId("wrong");
  box.hidden = !error;
  field.setAttribute("aria-invalid", Boolean(error));
  document.documentElement.classList.toggle("wrong", Boolean(error));
  byId("lesson-main").classList.toggle("stale", Boolean(error));
  if (!error) return;
  const line = text.replace(/\s/g, " "), caret = "^".repeat(Math.max(1, Math.min(error.length, 40)));
  box.textContent = (error.column > 0 ? `${line}\n${" ".repeat(error.column - 1)}${caret}\n` : "")
    + `Error: ${error.message}` + (error.hint ? `\n${error.hint}` : "");
};

// The string is now this one. `from`: "typing" leaves the text as it stands, "drag" the window.
const change = (text, from = "") => {
  const answer = algebra.string(text, state.points);
  if (from !== "typing") field.value = answer.error ? text : answer.text;
  sameHeight();
  complain(text, answer.error);
  state.text = text;
  if (answer.error) return false;
  if (from !== "drag" && from !== "address" && lesson && shownText !== answer.text) remember(shownText);
  shownText = answer.text;
  delete document.documentElement.dataset.shown;
  delete document.documentElement.dataset.measured;
  kept.clear();
  lesson = { ...answer, unit: from === "drag" && lesson ? lesson.unit : answer.unit };
  showString();
  if (from !== "drag") showLater();
  noteAddress();
  return true;
};
const remember = (text) => {
  before.push(text);
  before = before.slice(-100);
  byId("undo").disabled = false;
};
const join = (texts) => change(texts.join(" "));
const texts = () => textsOf(lesson.factors);

const swapped = (i, j) => {
  const all = texts();
  [all[i], all[j]] = [all[j], all[i]];
  return all;
};
const swap = (i, j) => {
  join(swapped(i, j));
  const again = byId("chips").querySelectorAll(".swap")[Math.min(i, j)];
  if (again && Math.abs(i - j) === 1) again.focus();
};
const takeOut = (i) => {
  join(texts().filter((_, k) => k !== i));
  const left = byId("chips").querySelectorAll(".out");
  (left[Math.min(i, left.length - 1)] || byId("add-T")).focus();
};
// Equal factors in equal times, or equal amounts.
const changeLaw = (i) => {
  const answer = algebra.changed(shownText, i, "linear", [+!lesson.factors[i].linear]);
  if (answer.error) complain(shownText, answer.error);
  else change(answer.text);
  byId("chips").querySelector(`[data-factor="${i}"] .law`)?.focus();
};
const showChips = () => {
  const list = byId("chips");
  list.textContent = "";
  lesson.factors.forEach((f, i) => {
    const item = put(list, "li");
    const chip = put(item, "div", { class: "chip factor", "data-factor": i, style: `border-color: ${factorColour(i)}` });
    put(chip, "span", { style: `color: ${factorColour(i)}` }, f.text);
    if (f.kind === "S")
      put(chip, "button", { type: "button", class: "law", "aria-pressed": f.linear, title: "by equal amounts, as in CSS, and not by equal factors" }, "linear")
        .addEventListener("click", () => changeLaw(i));
    put(chip, "button", { type: "button", class: "out", "aria-label": `Take ${f.text} out` }, "×")
      .addEventListener("click", () => takeOut(i));
    chip.addEventListener("pointerdown", (e) => dragChip(e, chip, i));
    if (i + 1 === lesson.factors.length) return;
    const name = `Swap ${f.text} and ${lesson.factors[i + 1].text}`;
    put(item, "button", { type: "button", class: "swap", "aria-label": name, title: name }, "⇄")
      .addEventListener("click", () => swap(i, i + 1));
  });
};
// Let go over another factor, it changes places with that.
const dragChip = (down, chip, i) => {
  if (down.button !== 0 || down.target.closest("button")) return;
  down.preventDefault();
  chip.setPointerCapture(down.pointerId);
  chip.classList.add("held");
  const chips = [...byId("chips").querySelectorAll(".chip")];
  const under = (e) => chips.findIndex((c) => {
    const box = c.getBoundingClientRect();
    return c !== chip && e.clientX >= box.left && e.clientX <= box.right && e.clientY >= box.top && e.clientY <= box.bottom;
  });
  const move = (e) => {
    chip.style.transform = `translate(${e.clientX - down.clientX}px, ${e.clientY - down.clientY}px)`;
    chips.forEach((c, k) => c.classList.toggle("over", k === under(e)));
  };
  const end = (e) => {
    chip.removeEventListener("pointermove", move);
    chip.removeEventListener("pointerup", end);
    chip.removeEventListener("pointercancel", end);
    const to = e.type === "pointerup" ? under(e) : -1;
    if (to >= 0) return swap(i, to);
    chip.classList.remove("held");
    chip.style.transform = "";
    chips.forEach((c) => c.classList.remove("over"));
  };
  chip.addEventListener("pointermove", move);
  chip.addEventListener("pointerup", end);
  chip.addEventListener("pointercancel", end);
};

const beginning = { T: (u) => `T(${2 * u} 0${lesson.planar ? "" : " 0"})`, R: (u) => `R(90deg @ ${u} 0)`, S: (u) => `S(1.5 @ ${u} 0)` };
for (const kind of ["T", "R", "S"])
  byId(`add-${kind}`).addEventListener("click", () => join([beginning[kind](lesson.unit), ...texts()]));
const undo = () => {
  const last = before.pop();
  byId("undo").disabled = before.length === 0;
  if (last !== undefined) change(last, "address");
};
byId("undo").addEventListener("click", undo);
field.addEventListener("input", () => change(field.value, "typing"));
field.addEventListener("keydown", (e) => {
  if (e.key === "Enter") e.preventDefault();  // a string is one line
});

// ---- The whole motion, and what can be dragged in it

const lead = (factors) => {
  const count = factors.length;
  if (count === 0) return "A motion of no factors. Nothing moves. Every method agrees.";
  if (count === 1) return "A motion of one factor. T moves, R turns, S scales.";
  return `A motion of ${count} factors. Read it from the right: ${factors[count - 1].text} comes first, ${factors[0].text} last. `
    + "Each factor also moves the centres of those on its right.";
};
let stage = null;   // the picture
let holding = null;  // the window stays as it is while something is dragged

const drawStage = () => {
  const { figure, followed } = wholeFigure(), grips = gripsOf(lesson.factors);
  const box = byId("stage"), focused = document.activeElement?.dataset?.grip;
  box.textContent = "";
  stage = drawMotion(box, motionOf(lesson.factors), {
    figure, followed, look: look(), label: "The figure at rest, on its way and at the end; the paths of its points; what can be dragged",
    wide: 760, shapes: lesson.planar ? [0.45, 0.85] : [0.72, 0.72], unit: lesson.unit, flat: lesson.planar,
    crosses: crossesOf(lesson.factors, 0), also: grips.flatMap((g) => [g.at, ...(g.guide || [])]), seen: holding
  });
  const svg = stage.w.svg;
  svg.setAttribute("role", "group");
  grips.forEach((grip, k) => showGrip(svg, grip, k));
  if (focused) svg.querySelector(`[data-grip="${focused}"]`)?.focus({ preventScroll: true });
  if (!lesson.planar) orbit(svg);
  updates.stage = [stage.update, showNumbers];
  updates.stage.forEach((update) => update(state.t));
};
const look = () => lesson.planar ? { yaw: 0, pitch: 0 } : state;

const orbit = (svg) => {
  svg.setAttribute("tabindex", 0);
  const turn = (yaw, pitch) => {
    state.yaw = (yaw + 3 * Math.PI) % (2 * Math.PI) - Math.PI, state.pitch = Math.max(-1.5, Math.min(1.5, pitch));
    holding = stage.seen;
    drawStage();
    holding = null;
    noteAddress();
  };
  svg.addEventListener("pointerdown", (down) => {
    if (down.button !== 0 || down.target.closest(".handle")) return;
    const { yaw, pitch } = state;
    follow(down, (e) => turn(yaw - (e.clientX - down.clientX) * 0.01, pitch + (e.clientY - down.clientY) * 0.01), showLater);
  });
  svg.addEventListener("keydown", (e) => {
    const by = { ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] }[e.key];
    if (!by || e.target !== svg) return;
    e.preventDefault();
    turn(state.yaw + by[0], state.pitch + by[1]);
    stage.w.svg.focus({ preventScroll: true });
    showLater();
  });
};
// What was pressed is followed wherever it goes. The elements under it are drawn anew meanwhile, so that the box around
// them is what a finger holds.
const follow = (down, moves, ends) => {
  down.preventDefault();
  byId("stage").setPointerCapture(down.pointerId);
  const move = (e) => { if (e.pointerId === down.pointerId) moves(e); };
  const end = (e) => {
    if (e.pointerId !== down.pointerId) return;
    removeEventListener("pointermove", move);
    removeEventListener("pointerup", end);
    removeEventListener("pointercancel", end);
    ends();
  };
  addEventListener("pointermove", move);
  addEventListener("pointerup", end);
  addEventListener("pointercancel", end);
};

// Whatever of a factor can be dragged: where its grip stands, at rest, and what comes of another place for it.
const gripsOf = (factors) => factors.flatMap((f, i) => {
  const u = lesson.unit, grip = (what, name, at, to, more = {}) => ({ i, what, name: `${name} of ${f.text}`, at, to, ...more });
  if (f.kind === "T") return [grip("by", "The way", f.by, (p) => ["by", round(p)], { guide: [[0, 0, 0], f.by], shape: "tip" })];
  const centre = grip("centre", "The centre", f.centre, (p) => ["centre", round(p)], { shape: "ring" });
  if (f.kind === "R") {
    const [e1, e2] = around(f.axis), r = 1.25 * u, angle = 2 * Math.PI * f.turns;
    const on = (a) => plus(plus(f.centre, e1, r * Math.cos(a)), e2, r * Math.sin(a));
    const least = angle - Math.sign(angle) * Math.min(Math.abs(angle), 2 * Math.PI);
    const arc = Array.from({ length: 65 }, (_, k) => on(least + (angle - least) * k / 64));
    const turned = (p, fine) => {
      const d = plus(p, f.centre, -1), now = Math.atan2(dot(d, e2), dot(d, e1)) / (2 * Math.PI);
      const turns = f.turns + (now - f.turns) - Math.round(now - f.turns), step = fine ? 1 : 5;
      return ["angle", [Math.round(turns * 360 / step) * step, 0, 0]];
    };
    const all = [centre, grip("angle", "The angle", on(angle), turned, { guide: arc, spoke: [f.centre, on(0)], shape: "dot", by: 5 / 360 })];
    if (!lesson.planar)
      all.push(grip("axis", "The axis", plus(f.centre, f.axis, 2 * u), (p) => ["axis", direction(plus(p, f.centre, -1)).map((x) => +x.toFixed(2))],
        { guide: [plus(f.centre, f.axis, -2 * u), plus(f.centre, f.axis, 2 * u)], shape: "tip" }));
    return all;
  }
  const sized = (change) => (p, fine) => {
    const g = plus(p, f.centre, -1).map((x) => x / u), step = fine ? 0.01 : 0.1;
    const rounded = (x) => { const by = +(Math.round(x / step) * step).toFixed(2); return f.linear ? by : Math.max(step, by); };
    return ["by", change(f.by.slice(), g, rounded)];
  };
  const axes = (lesson.planar ? [0, 1] : [0, 1, 2]).map((c) => {
    const at = f.centre.slice();
    at[c] += f.by[c] * u;
    return grip("xyz"[c], `The growth along ${"xyz"[c]}`, at, sized((by, g, rounded) => { by[c] = rounded(g[c]); return lesson.planar ? [by[0], by[1], 1] : by; }),
      { guide: [f.centre, at], shape: "box" });
  });
  const corner = plus(f.centre, lesson.planar ? [f.by[0], f.by[1], 0] : f.by, u);
  const alike = sized((_, g, rounded) => {
    const all = rounded((g[0] + g[1] + (lesson.planar ? 0 : g[2])) / (lesson.planar ? 2 : 3));
    return [all, all, all];
  });
  return [centre, ...axes, grip("all", "The growth", corner, alike, { shape: "box" })];
});
const round = (p) => {
  const step = lesson.unit / (dragFine ? 100 : 10);
  return p.map((x) => +(Math.round(x / step) * step).toPrecision(12));
};
let dragFine = false;

const shapes = { ring: "M-6 0a6 6 0 1 0 12 0a6 6 0 1 0-12 0", dot: "M-4.5 0a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0-9 0", box: "M-5-5h10v10h-10z", tip: "M0-6.5L6.5 0 0 6.5-6.5 0z" };
const showGrip = (svg, grip, k) => {
  const stroke = factorColour(grip.i), { w } = stage;
  for (const line of [grip.guide, grip.spoke])
    if (line) put(svg, "path", { class: "factor", d: w.path(line), stroke, fill: "none", "stroke-width": 1.3, "stroke-opacity": 0.75, "pointer-events": "none" });
  const g = put(svg, "g", {
    class: "handle", tabindex: 0, role: "button", "data-grip": `${grip.i}-${grip.what}`, "aria-label": `${grip.name}: drag it, or move it by the arrow keys`
  });
  put(g, "title", {}, grip.name);
  put(g, "circle", { class: "reach", r: 15 });
  put(g, "path", { class: "grip factor", d: shapes[grip.shape], stroke });
  stand(g, w.on(grip.at));
  g.addEventListener("pointerdown", (down) => { if (down.button === 0) dragGrip(down, grip); });
  g.addEventListener("touchstart", (e) => e.preventDefault(), { passive: false });  // or the page would be scrolled
  g.addEventListener("keydown", (e) => moveGrip(e, grip));
};
// In the plane of the paper, through where the grip stood.
const dragged = (from, dx, dy) => plus(plus(from, stage.w.eye.right, dx / stage.w.scale), stage.w.eye.up, -dy / stage.w.scale);
const changeBy = (grip, at, fine) => {
  dragFine = fine;
  const [what, to] = grip.to(at, fine);
  const answer = algebra.changed(shownText, grip.i, what, to);
  if (answer.error) complain(shownText, answer.error);
  else if (answer.text !== shownText) change(answer.text, "drag");
};
const dragGrip = (down, grip) => {
  down.stopPropagation();
  const perPixel = 1 / stage.w.svg.getScreenCTM().a, { what, i } = grip, first = shownText;
  holding = stage.seen;
  let wanted = null, asked = 0;
  const go = () => {
    asked = 0;
    const now = gripsOf(lesson.factors).find((g) => g.i === i && g.what === what);
    changeBy(now, dragged(grip.at, (wanted.clientX - down.clientX) * perPixel, (wanted.clientY - down.clientY) * perPixel), wanted.shiftKey);
  };
  stage.w.svg.querySelector(`[data-grip="${i}-${what}"]`)?.focus({ preventScroll: true });
  follow(down, (e) => { wanted = e; asked ||= requestAnimationFrame(go); }, () => {
    if (asked) cancelAnimationFrame(asked), go();
    holding = null;
    dragFine = false;
    if (shownText === first) return;
    remember(first);
    change(shownText, "address");
  });
};
const moveGrip = (e, grip) => {
  const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[e.key];
  if (!way || e.ctrlKey || e.metaKey || e.altKey) return;
  e.preventDefault();
  e.stopPropagation();
  const first = shownText, [dx, dy] = way, step = (e.shiftKey ? 0.01 : 0.1) * lesson.unit * stage.w.scale;
  if (grip.what === "angle") {
    const degrees = Math.round(lesson.factors[grip.i].turns * 360 * 1e9) / 1e9 + (dx || -dy) * (e.shiftKey ? 1 : 5);
    const answer = algebra.changed(shownText, grip.i, "angle", [degrees]);
    if (!answer.error) change(answer.text, "address");
  } else {
    changeBy(grip, dragged(grip.at, dx * step, dy * step), e.shiftKey);
    change(shownText, "address");
  }
  if (shownText !== first) remember(first);
};

const bracketed = (parent, kind = "") => {
  const size = lesson.planar ? 3 : 4;
  const body = parent.tagName === "TBODY" ? parent : put(put(parent, "table", { class: `matrix ${kind}` }), "tbody");
  body.textContent = "";
  body.parentNode.classList.toggle("of-space", !lesson.planar);
  return Array.from({ length: size }, () => put(body, "tr")).map((row) => Array.from({ length: size }, () => put(row, "td")));
};
// Of twelve, those that the plane has.
const across = () => lesson.planar ? [[0, 1, 3], [4, 5, 7]] : [[0, 1, 2, 3], [4, 5, 6, 7], [8, 9, 10, 11]];
const fill = (cells, write) => {
  const rows = across();
  rows.forEach((row, r) => row.forEach((at, c) => write(cells[r][c], at)));
  cells.at(-1).forEach((cell, c) => { cell.textContent = c === cells.length - 1 ? "1" : "0"; });
};
const spans = (parent, all) => {
  parent.textContent = "";
  return all.map((text, i) => put(parent, "span", { class: "factor", style: `color: ${factorColour(i)}` }, text));
};

let numbers = null;
const prepareNumbers = () => {
  const { followed } = wholeFigure();
  numbers = { now: spans(byId("now"), texts()), cells: bracketed(byId("matrix")), tip: followed[0] };
  if (!lesson.factors.length) byId("now").textContent = "empty: the identity";
  const legend = byId("legend");
  legend.textContent = "";
  followed.forEach((p, i) => {
    const name = [`the top of the figure, ${place(p)} at rest`, `its foot, ${place(p)}`][i] || place(p);
    put(legend, "span", { class: "key path", style: `border-color: ${pathColour(i)}` });
    legend.append(name + (i + 1 < followed.length ? "; " : ". "));
  });
  if (lesson.factors.some((f) => f.kind !== "T"))
    legend.append("Crosses are centres, in the colours of their factors; dots show how they are carried. ");
  legend.append("Thin letters: every eighth part of the motion. ");
  if (isDense(lesson.factors)) legend.append(denseNote(lesson.factors));
  byId("hint").textContent = lesson.factors.length === 0 ? ""
    : "Rings, squares and tips can be dragged, or moved by the arrow keys: centres, angles, growths, ways"
      + (lesson.planar ? "" : ", axes") + ", as they are at rest. With Shift they go by finer steps."
      + (lesson.planar ? "" : " Drag beside them to turn the view.");
};
const showNumbers = (t) => {
  const moment = algebra.moment(shownText, t);
  fill(numbers.cells, (cell, at) => { cell.textContent = fixed(moment.matrix[at]); });
  numbers.now.forEach((s, i) => { s.textContent = partly(lesson.factors[i], moment.parts[i]); });
  const at = moved(moment.matrix, numbers.tip), shown = lesson.planar ? at.slice(0, 2) : at;
  byId("corner").textContent = `${place(numbers.tip)} → (${shown.map((x) => fixed(x)).join(", ")})`;
  (written || []).forEach((update) => update(moment));
};

// ---- Matrices in letters

let written = null;
// "(1 - c2) x2^2", its letters in their factors' colours.
const writeSum = (cell, sum, symbols) => {
  cell.textContent = "";
  for (const part of sum.split(/([a-z]\d*(?:\^\d+)?)/)) {
    const [, name, index, power] = /^([a-z])(\d*)(?:\^(\d+))?$/.exec(part) || [];
    if (!name) {
      cell.append(part.replace(/-/g, "−"));
      continue;
    }
    const letter = symbols.letters.find((l) => l.name === name + index);
    const box = put(cell, "i", { class: "factor", style: `color: ${factorColour(letter.factor)}` }, name);
    if (index) put(box, "sub", {}, index);
    if (power) put(box, "sup", {}, power);
  }
};
const showMatrices = () => {
  const box = byId("written");
  box.textContent = "";
  written = [];
  const line = (name, colour, symbols, numbersOf) => {
    const row = put(box, "div", { class: "written" });
    put(row, "h3", colour ? { class: "factor", style: `color: ${colour}` } : {}, name);
    const left = put(row, "div", { class: "scroll", tabindex: 0, role: "group", "aria-label": `${name} in letters` });
    if (symbols.why) put(left, "p", { class: "small" }, `${symbols.why[0].toUpperCase()}${symbols.why.slice(1)}: it stands as the product of those above.`);
    else fill(bracketed(left, "symbols"), (cell, at) => writeSum(cell, symbols.sums[at], symbols));
    put(row, "span", { class: "equals" }, "=");
    const cells = bracketed(put(row, "div", { class: "scroll", tabindex: 0, role: "group", "aria-label": `${name} in numbers` }));
    written.push((moment) => fill(cells, (cell, at) => { cell.textContent = fixed(numbersOf(moment)[at]); }));
  };
  lesson.factors.forEach((f, i) => line(f.text, factorColour(i), lesson.alone[i], (m) => m.alone[i]));
  if (lesson.factors.length !== 1) line("A(t), the product of all", null, lesson.symbols, (m) => m.matrix);
  const list = byId("letters"), letters = lesson.symbols.letters || [];
  list.textContent = "";
  const rows = letters.map((l) => {
    const row = put(list, "tr");
    writeSum(put(row, "th", { scope: "row" }), l.name, lesson.symbols);
    put(row, "td", {}, l.means.replace(/-/g, "−"));
    return put(row, "td");
  });
  written.push((moment) => rows.forEach((cell, k) => { cell.textContent = fixed(moment.letters[k]); }));
  list.closest("table").hidden = letters.length === 0;
};

const showString = () => {
  showChips();
  byId("lead").textContent = lead(lesson.factors);
  document.title = `${shownText || "no factors"} – a lesson in motion`;
  byId("command").textContent = `betwixt algebra --lesson lesson.html "${shownText}"\n\nball.motion\n  1f..48f ${shownText}`;
  prepareNumbers();
  showMatrices();
  drawStage();
};

// ---- One factor at a time

const picture = (parent, factors, label, more = {}) => {
  const { figure, followed } = wholeFigure();
  const drawn = drawMotion(parent, { ...motionOf(factors, more.linear), other: more.other }, {
    figure, followed, look: look(), label, wide: 460, shapes: lesson.planar ? [0.5, 0.75] : [0.7, 0.7], unit: lesson.unit,
    flat: lesson.planar, crosses: more.other ? [] : crossesOf(factors, more.first || 0), ...more.options
  });
  drawn.update(state.t);
  updates.rest.push(drawn.update);
};
const showCards = () => {
  const { factors } = lesson, count = factors.length;
  const order = "In the order in which they act on the figure, from the right of the string to its left. "
    + "Each is shown alone first, and then after all those before it.";
  byId("factors-lead").textContent =
    ["There are none. An empty string is the identity at every t.", "There is only one here."][count] || order;
  byId("cards").textContent = "";
  const most = 12;  // more would be as many pictures twice
  for (let i = count - 1; i >= Math.max(0, count - most); --i) {
    const card = put(byId("cards"), "li");
    put(card, "h3", { class: "factor", style: `color: ${factorColour(i)}` }, factors[i].text);
    put(card, "p", {}, described(factors[i]));
    const pair = put(card, "div", { class: "pair" });
    const one = (some, first, caption) => {
      const box = put(pair, "figure");
      picture(box, some, `${caption}: ${textsOf(some).join(" ")}`, { first });
      put(box, "figcaption", {}, isDense(some) ? `${caption}. ${denseNote(some)}` : caption);
    };
    one([factors[i]], i, "Alone");
    if (i < count - 1)
      one(factors.slice(i), i, i === 0 ? "After all the others: the whole motion" : `After ${counted(count - 1 - i, "factor", "factors")}`);
  }
  if (count > most) put(byId("cards"), "li", {}, `And ${count - most} more, which act after these.`);
};

// ---- Methods

const means = {
  matrix: "The points at rest, times the matrix of the step. Its numbers go on from step to step.",
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
    byId("methods-none").textContent = `Not here: ${answer.error.message}, and ${answer.error.hint}. A(t) is worked out anew for every moment.`;
    return;
  }
  lesson.ways = answer.ways;
  byId("steps").value = state.steps;
  byId("compiled").textContent = answer.compiled.replace(/-/g, "−");
  byId("ways-caption").textContent = `Counted for this string and ${state.steps} steps; the best way is sought for ${answer.countedFor} points.`;
  const list = byId("ways");
  list.textContent = "";
  for (const w of answer.ways) showMethod(list, w);
  showBars(answer);
  showMethodPictures(answer.ways);
};
const showMethod = (list, w) => {
  const row = put(list, "tr", w.name === "best" ? { class: "best" } : {});
  put(put(row, "th", { scope: "row" }, w.name), "small", {}, means[w.name]);
  const cell = (label, text, note) => {
    const td = put(row, "td", { class: "number", "data-label": label }, text);
    if (note) put(td, "small", {}, note);
  };
  const printed = (part) => {
    if (!w.printed) return cell("The source:", "–");
    const after = part === "before" && w.printed.after !== "0" ? `and ${w.printed.after} after the last step` : "";
    cell("The source:", w.printed[part], after);
  };
  if (w.refused) {
    const why = put(row, "td", { class: "refused", colspan: w.printed ? 1 : 5 }, `Refuses: ${w.refused}.`);
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
  cell("Farthest:", exact ? tiny(w.gap) : number(w.gap, 3), exact ? "of rounding alone" : `at t = ${number(w.at, 3)}${w.linear ? ", from the motion by the linear law" : ""}`);
};
const showBars = ({ ways, countedFor }) => {
  const able = ways.filter((w) => !w.refused), bars = byId("bars");
  const most = Math.max(1, ...ways.flatMap((w) => [w.operations || 0, w.printed && !w.refused ? w.printed.operations : 0]));
  bars.textContent = "";
  put(bars, "p", { class: "label" }, `Operations per step for ${countedFor} points. Dashed: as the source prints.`);
  for (const w of able) {
    const row = put(bars, "div", w.name === "best" ? { class: "best" } : {});
    put(row, "span", {}, w.name);
    const both = put(row, "i");
    const bar = (n, name) => {
      const b = put(both, "b", { class: name });
      put(b, "span", { style: `width: ${(100 * n / most).toFixed(2)}%` });
      put(b, "em", {}, grouped(n));
    };
    bar(w.operations, "ours");
    if (w.printed) bar(w.printed.operations, "printed");
  }
};
// Where each method has the marked corner, step by step, on the path that the motion takes.
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
    const steps = w.frames.slice(0, most + 1).map((m) => moved(m, tip)), seen = frameAround([...path, ...steps], lesson.unit, true);
    const { svg, on, path: drawn } = windowOn(figure, seen, look(), `The marked corner, step by step, by the method ${w.name}`, 300, [0.5, 0.9], true);
    put(svg, "path", { class: "path", d: drawn(path), fill: "none", stroke: pathColour(0), "stroke-width": 3, "stroke-opacity": 0.6 });
    for (const p of steps) stand(put(svg, "circle", { class: "path", r: steps.length > 100 ? 2 : 3, fill: pathColour(1) }), on(p));
    const mark = put(svg, "circle", { r: 6, fill: "none", stroke: "var(--ink)", "stroke-width": 2 });
    const update = (t) => stand(mark, on(steps[Math.min(steps.length - 1, Math.round(t * (w.frames.length - 1)))]));
    update(state.t);
    updates.methods.push(update);
    caption.append(`: ${w.step}; ${w.gap <= 1e-7 * lesson.unit ? "on the path" : `up to ${number(w.gap, 3)} beside it`}`);
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

const methodLine = (name) => ["var(--p0)", "var(--p1)", "var(--p2)", "var(--ink)"][["matrix", "geometric", "differences", "best"].indexOf(name.split(",")[0])];
const methodWidth = (name) => [4.5, 3.4, 2.4, 1.6][["matrix", "geometric", "differences", "best"].indexOf(name.split(",")[0])];  // where lines meet, each is seen
const showDrift = (drifting, marks, steps) => {
  const all = drifting.flatMap((w) => ["f32", "f64"].flatMap((k) => [...w[k].alone, ...w[k].renewed])).filter((d) => d > 0);
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
    const row = put(byId("losses"), "tr", w.name === "best" ? { class: "best" } : {});
    put(row, "th", { scope: "row" }, w.name);
    for (const kind of ["f32", "f64"])
      for (const how of ["alone", "renewed"])
        put(row, "td", { class: "number", "data-label": `${kind}, ${how === "alone" ? "left alone" : how}:` }, tiny(w[kind][how].at(-1)));
  }
};
const driftPicture = (kind, drifting, marks, steps, low, high) => {
  const box = put(byId("drifts"), "figure"), wide = 460, tall = 300, left = 52, right = 16, top = 16, below = 34;
  const svg = put(box, "svg", {
    class: "picture", viewBox: `0 0 ${wide} ${tall}`, role: "img",
    "aria-label": `Largest distance so far in ${kind} against steps, both by powers of ten; the numbers are in the table below`
  });
  const x = (step) => left + Math.log10(step) / Math.log10(steps) * (wide - left - right);
  const y = (d) => tall - below
    - (Math.log10(Math.min(Math.max(d, 10 ** low), 10 ** high)) - low) / (high - low) * (tall - top - below);
  for (let p = low; p <= high; p += 2) {
    put(svg, "path", { d: `M${left} ${y(10 ** p)}H${wide - right}`, stroke: "var(--grid)" });
    put(svg, "text", { x: left - 8, y: y(10 ** p) + 4, "text-anchor": "end" }, p === 0 ? "1" : `1e${p}`.replace("-", "−"));
  }
  for (let s = 1; s <= steps; s *= 10)
    put(svg, "text", { x: x(s), y: tall - 12, "text-anchor": s === 1 ? "start" : s === steps ? "end" : "middle" },
      s === 1 ? "1 step" : s >= 1000 ? `${s / 1000}k` : s);
  for (const w of drifting)
    for (const how of ["renewed", "alone"])
      put(svg, "path", {
        fill: "none", stroke: methodLine(w.name), "stroke-width": methodWidth(w.name), "stroke-linejoin": "round",
        "stroke-dasharray": how === "alone" ? "none" : "3 4",
        d: "M" + w[kind][how].map((d, i) => `${x(marks[i]).toFixed(1)} ${y(d === null ? 10 ** high : d).toFixed(1)}`).join("L")
      });
  const caption = put(box, "figcaption", {}, `${kind}. `);
  for (const w of drifting) {
    put(caption, "span", { class: "key", style: `border-color: ${methodLine(w.name)}` });
    caption.append(w.name + " ");
  }
};
// A hundred thousand steps, eight times: in pieces, while nothing else is wanted.
const measureDrift = (of) => {
  const able = (lesson.ways || []).filter((w) => !w.refused), pieces = able.flatMap((w) => ["f32", "f64"].map((kind) => ({ w, kind })));
  const points = measured();
  let marks = [], steps = 0;
  byId("drift").classList.add("stale");
  byId("drift-wait").textContent = pieces.length ? "Measuring…" : "";
  const next = () => {
    if (of !== lesson) return;
    const piece = pieces.shift();
    if (!piece) {
      byId("drift").classList.remove("stale");
      byId("drift-wait").textContent = lesson.planar ? "" : "The methods are for the plane: there is nothing to measure in space.";
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
    const box = put(byId("paths"), "div", { class: "way" }), figure = put(box, "figure"), words = put(box, "div");
    words.append(byId(`path-${p.kind}`).content.cloneNode(true));
    const drawn = !dense || p.kind === "root";
    const other = p.kind === "law" ? { at: matrixOf(lesson.factors, true), line: motionOf(lesson.factors, true).line }
      : { at: between(p.frames), line: p.frames };
    if (drawn)
      picture(figure, lesson.factors, words.querySelector("h3").textContent,
        { linear: p.linear, other, options: { wide: 560, shapes: lesson.planar ? [0.5, 0.9] : [0.7, 0.7] } });
    if (dense) put(figure, "figcaption", {}, drawn ? denseNote(lesson.factors) : "These are too many turns for this way to be drawn.");
    const most = `The largest distance: ${number(p.gap, 3)}, at t = ${number(p.at, 3)}.`;
    put(words, "p", { class: "small" }, `${most} The letter is ${number(1.5 * lesson.unit)} high.`);
  }
};

// What is below the picture follows a moment later: nobody looks at it while something is dragged.
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

// ---- The figures

const figures = {
  plane: [
    ["T: a way", "T(5 3)"], ["S: a growth", "S(2 3 @ -1 1)"], ["R: a turn", "R(-270deg @ 2 1)"],
    ["TS: a growth, carried on", "T(4 0) S(0.4 2.2 @ 1 0)"], ["ST: a way that grows", "S(2 2.5 @ -1 0) T(3 1)"],
    ["TR: a nail in a rolling tyre", "T(12.566 0) R(-2turn @ 0 1)"], ["RT: a way that turns, a spiral", "R(2turn) T(6 0)"],
    ["RS: a growth that turns", "R(1turn @ 1 0) S(2.5 0.5 @ 0 1)"], ["SR: a turn that is stretched", "S(2.2 0.6 @ -1 1) R(1.5turn @ 2 0)"],
    ["TRS: all three", "T(8 2) R(-1turn @ 1 1) S(0.5 @ 0 0)"], ["RR: a moon about a planet", "R(1turn) R(6turn @ 4 0)", [[4, 0, 0]]],
    ["RRR: arms on arms", "R(1turn) R(-3turn @ 3 0) R(9turn @ 4 0)"],
    ["SRT: a chain of motions", "S(1.3 @ -40 -20) R(35deg) T(100 0)"], ["TTRR: two ways, two turns", "T(6 0) T(0 2) R(1turn @ 1 1) R(-1turn @ 2 1)"]
  ],
  space: [
    ["The potter’s wheel", "R(10turn @ 0 0 0 axis y) S(0.62 1.9 0.62)"], ["A ball in a funnel", "T(0 -3 0) R(6turn @ 0 0 0 axis y) S(0.1 1 0.1)", [[3, 0, 0]]],
    ["A screw", "T(0 4 0) R(3turn @ -2 0 0 axis y)"], ["A moon about an earth about a sun", "R(1turn axis y) R(11turn @ 7 0 0 axis y)", [[8.5, 0, 0]]],
    ["The earth that does not lean over", "R(1turn axis y) R(-1turn @ 7 0 0 axis y) R(6turn @ 7 0 0 axis -0.397 0.918 0)"],
    ["A coin that tumbles", "T(5 0 -3) R(2turn @ 0.5 0.75 0 axis 1 1 0) R(3turn @ 0.5 0.75 0 axis y)"]
  ]
};
const addressOf = (text, points) => `#m=${encodeURIComponent(text)}` + (points.length ? `&p=${pointsText(points)}` : "");
const pointsText = (points) => points.map((p) => (p[2] ? p : p.slice(0, 2)).join(",")).join(";");
const showGallery = () => {
  for (const kind of ["plane", "space"])
    for (const [name, text, points = []] of figures[kind]) {
      const link = put(put(byId(`${kind}-figures`), "li"), "a", { href: addressOf(text, points) });
      link.addEventListener("click", () => {
        scrollTo({ top: 0, behavior: "instant" });
        byId("motion-title").focus({ preventScroll: true });
      });
      const { factors, planar, unit } = algebra.string(text, points), figure = figureOf(unit, planar);
      const drawn = drawMotion(link, motionOf(factors), {
        figure, followed: [figure.tip, figure.foot, ...points], look: planar ? { yaw: 0, pitch: 0 } : { yaw: -0.5, pitch: 0.35 }, label: "", wide: 240,
        shapes: [0.72, 0.72], unit, flat: planar, crosses: crossesOf(factors, 0), plain: true
      });
      drawn.update(0.5);
      drawn.w.svg.querySelectorAll("text").forEach((mark) => mark.remove());
      drawn.w.svg.setAttribute("aria-hidden", true);
      put(link, "b", {}, name);
      put(link, "code", {}, text);
    }
};

// ---- The address: the string, the moment, and what else was chosen

let noting = 0;
const noteAddress = () => {
  clearTimeout(noting);
  noting = setTimeout(() => {
    const parts = [`m=${encodeURIComponent(shownText)}`, `t=${state.t.toFixed(3)}`];
    if (state.points.length) parts.push(`p=${pointsText(state.points)}`);
    if (state.steps !== given.steps) parts.push(`n=${state.steps}`);
    if (lesson && !lesson.planar) parts.push(`v=${state.yaw.toFixed(2)},${state.pitch.toFixed(2)}`);
    history.replaceState(null, "", "#" + parts.join("&"));
  }, 100);
};
const readPoints = (text) => text.split(";").map((p) => p.split(",").map(Number))
  .filter((p) => (p.length === 2 || p.length === 3) && p.every((x) => Math.abs(x) <= 1e9)).map((p) => [...p, 0].slice(0, 3)).slice(0, 50);
const fromAddress = () => {
  const said = new Map(location.hash.slice(1).split("&").map((part) => [part.slice(0, part.indexOf("=")), part.slice(part.indexOf("=") + 1)]));
  const numberOf = (name, low, high) => {
    const x = Number(said.get(name) || NaN);
    return x >= low && x <= high ? x : null;
  };
  clearTimeout(noting);
  state.t = numberOf("t", 0, 1) ?? (said.has("m") ? 0.4 : state.t);
  state.steps = Math.round(numberOf("n", 1, 2000) ?? state.steps);
  const view = (said.get("v") || "").split(",").map(Number);
  if (view.length === 2 && view.every(Number.isFinite)) [state.yaw, state.pitch] = [view[0], Math.max(-1.5, Math.min(1.5, view[1]))];
  // A string of an address comes with its own points.
  const points = said.has("m") ? readPoints(said.get("p") || "") : state.points;
  const other = pointsText(points) !== pointsText(state.points);
  state.points = points;
  let text = state.text;
  try {
    text = said.has("m") ? decodeURIComponent(said.get("m")) : text;
  } catch { /* no text of an address: the string stays */ }
  stop();
  if (!lesson) change(given.text, "address");  // whatever the address says, there is a string
  if (other || text !== shownText) change(text, "address");
  else drawStage();
  show(state.t);
};

// ---- Time

const slider = byId("time"), shown = byId("shown"), play = byId("play"), icon = byId("play-icon");
let playing = null;
const show = (to) => {
  state.t = Math.min(1, Math.max(0, to));
  slider.value = state.t;
  shown.textContent = `t = ${state.t.toFixed(3)}`;
  slider.setAttribute("aria-valuetext", `t = ${state.t.toFixed(3)}`);
  for (const update of Object.values(updates).flat()) update(state.t);
  document.documentElement.dataset.t = state.t;
};
const stop = () => {
  playing = null;
  play.setAttribute("aria-label", "Play");
  icon.setAttribute("d", "M7 4l13 8-13 8z");
};
const start = () => {
  if (state.t >= 1) show(0);
  const from = {}, seconds = Math.min(20, 5 + turnsOf(lesson.factors));
  playing = from;
  play.setAttribute("aria-label", "Pause");
  icon.setAttribute("d", "M6 4h4v16H6zM14 4h4v16h-4z");
  let last = null;
  const tick = (time) => {
    if (playing !== from) return;
    if (last !== null) show(state.t + (time - last) / 1000 / seconds);
    last = time;
    if (state.t < 1) requestAnimationFrame(tick);
    else stop();
  };
  requestAnimationFrame(tick);
};
const toggle = () => playing ? stop() : start();
play.addEventListener("click", toggle);
slider.addEventListener("input", () => {
  stop();
  show(+slider.value);
});
slider.addEventListener("change", noteAddress);
document.addEventListener("keydown", (e) => {
  if (e.key !== " " || e.ctrlKey || e.metaKey || e.altKey || e.target.closest("button, textarea, input, .handle, a")) return;
  e.preventDefault();
  toggle();
});
addEventListener("hashchange", fromAddress);

// ---- The engine

const silent = (why) => {
  byId("silent").hidden = false;
  byId("silent").textContent = `This lesson lives by Betwixt’s engine, and that is not running here: ${why}. The string is ${given.text || "empty"}; `
    + `betwixt algebra "${given.text}" shows its frames.`;
  field.readOnly = true;
};
(async () => {
  if (!globalThis.Betwixt) throw new Error("there is none in this page");
  const engine = await Betwixt.engine();
  if (!engine.algebra) throw new Error("the one in this page is older and knows no lessons");
  algebra = engine.algebra;
  byId("version").textContent = engine.version;
  byId("lesson-main").hidden = byId("bar").hidden = false;
  fromAddress();
  setTimeout(showGallery);
  document.documentElement.dataset.ready = "yes";
})().catch((error) => silent(error.message));
