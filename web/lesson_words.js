// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Describes motions in words, and asks the engine (algebra.js), which computes everything that the lesson shows.
const given = JSON.parse(byId("lesson").textContent);
const state = {
  text: given.text,
  points: given.points,
  steps: given.steps,
  t: 0,
  yaw: -0.5,
  pitch: 0.35
};
let algebra = null;
let shownText = "";  // the last valid string
let lesson = null;   // the engine's answer for it
let before = [];     // earlier strings, for undo
const updates = {
  stage: [],
  rest: [],
  methods: []
};  // functions to call when t changes

// ---- Words

const place = (p) => `(${(p[2] ? p : p.slice(0, 2)).map((x) => number(x)).join(", ")})`;
// Writes a number with a fixed number of digits, so that it does not jump about; small figures get more digits.
const fixed = (x, unit = lesson.unit) => {
  if (Math.abs(x) < 1e-7 * Math.min(1, unit)) x = 0;
  if (Math.abs(x) >= 1e7 || (unit < 0.01 && x !== 0 && Math.abs(x) < 0.01)) return number(x, 5);
  return x.toFixed(Math.abs(x) >= 1000 ? 1 : Math.abs(x) >= 100 ? 3 : 5).replace("-", "−");
};
// Writes a floating-point error in words or short digits.
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
  const plain = {"-1": "its own mirror image", "0": "zero", "0.5": "half as large", "2": "twice as large"};
  const size = Math.abs(g), digits = Math.abs(size - 1) < 1e-3 ? 17 : 4;  // otherwise a number near 1 would read as 1
  return plain[g] || `${g < 0 ? "mirrored and " : ""}${number(size, digits)} times as large`;
};
const scalingInWords = (f) => {
  const [x, y, z] = f.by, sizes = lesson.planar ? [x, y] : f.by;
  if (sizes.every((g) => g === 1)) return "Leaves every size as it is.";
  const names = ["width", "height", "depth"];
  let what = "Makes the " +
    sizes.map((g, i) => g === 1 ? "" : `${names[i]} ${growthInWords(g)}`).filter(Boolean).join(" and the ");
  if (x === y && (lesson.planar || y === z))
    what = x === 0 ? "Shrinks everything to one point" : `Makes everything ${growthInWords(x)}`;
  const does = sizes.every((g) => g >= 1) ? "grows" : sizes.every((g) => g >= 0 && g <= 1) ? "shrinks" : "changes";
  return `${what}. The centre ${place(f.centre)} stays. The size ${does} by the same ` +
    (f.linear ? "amount in every step (the linear law)." : "factor in every step (the exponential law).");
};
const described = (f) => {
  if (f.kind === "T") return f.by.some(Boolean) ? `Moves everything ${wayInWords(f.by)}.` : "Moves nothing.";
  if (f.kind === "S") return scalingInWords(f);
  if (f.turns === 0) return "Turns nothing.";
  const upright = f.axis[0] === 0 && f.axis[1] === 0, forward = upright ? f.turns * f.axis[2] : f.turns;
  const seen = upright ? "" : `, seen from where the axis ${place(f.axis)} points to`;
  const round = forward > 0 ? "counterclockwise" : "clockwise";
  return `Turns everything ${turnInWords(f.turns)} about ${place(f.centre)}, ${round}${seen}.`;
};
// Writes the part of a factor that is done, from the engine's numbers.
const partly = (f, part) => {
  const at = f.centre && f.centre.some(Boolean) ?
    ` @ ${(f.centre[2] ? f.centre : f.centre.slice(0, 2)).map((x) => number(x)).join(" ")}` :
    "";
  const numbers = (lesson.planar ? part.slice(0, 2) : part).map((x) => number(x)).join(" ");
  return f.kind === "T" ? `T(${numbers})` : f.kind === "R" ? `R(${number(part[0])}°${at})` : `S(${numbers}${at})`;
};

// ---- Asking the engine

const kept = new Map();  // frames of factors, for the current string
const keptNow = {
  t: -1,
  of: new Map()
};  // matrices at one moment, which many pictures share
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

// Samples a path densely enough that a quick turn looks round. If there are too many turns to tell apart, `line` is only
// the first of them, and `shade` shows where they run: all of them, or as many as can be drawn, spaced irregularly so
// that they do not line up with another turn.
const mostTurns = 24, firstTurns = 3, perTurn = 64, mostShaded = 300;
const isDense = (factors) => turnsOf(factors) > mostTurns;
const denseNote = (factors) => {
  const where = turnsOf(factors) > mostShaded ? `where ${mostShaded} of them run` : "where they run";
  return `Too many turns to be drawn one by one: the lines are the first ${firstTurns}, the shade is ${where}.`;
};
const motionOf = (factors, linear = false) => {
  const texts = textsOf(factors), turns = turnsOf(factors), at = matrixOf(factors, linear);
  const frames = (from, to, count) => framesOf(texts, from, to, count, linear);
  if (!isDense(factors))
    return {at, line: frames(0, 1, Math.ceil(120 + perTurn * turns + 16 * exponentsOf(factors))), shade: []};
  const line = frames(0, firstTurns / turns, perTurn * firstTurns);
  if (turns <= mostShaded) return {at, line, shade: [frames(0, 1, Math.ceil(perTurn * turns))]};
  const golden = (Math.sqrt(5) - 1) / 2;
  const begin = (k) => (k + golden * k % 1) / mostShaded * (1 - 1 / turns);
  return {at, line, shade: Array.from({length: mostShaded}, (_, k) => frames(begin(k), begin(k) + 1 / turns, perTurn))};
};
// Returns the paths of the centres. The factors on the left of a centre move it.
const crossesOf = (factors, first) => factors.flatMap((f, i) => {
  if (f.kind === "T") return [];
  const over = factors.slice(0, i), at = matrixOf(over);
  const line = i > 0 ? motionOf(over).line.map((m) => moved(m, f.centre)) : [];
  return [{colour: factorColour(first + i), line, at: i > 0 ? (t) => moved(at(t), f.centre) : () => f.centre}];
});
const wholeFigure = () => {
  const figure = figureOf(lesson.unit, lesson.planar);
  return {figure, followed: [figure.tip, figure.foot, ...state.points]};
};
const measured = () => wholeFigure().figure.outline.concat(state.points);
