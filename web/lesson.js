// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The lesson: a string of motions, which the reader edits as text, as a row of factors, or by dragging in the picture.
// Everything else on the page follows from the string.
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
  box.textContent = (error.column > 0 ? `${line}\n${" ".repeat(error.column - 1)}${caret}\n` : "") +
    `Error: ${error.message}` + (error.hint ? `\n${error.hint}` : "");
};

// Sets the string. `from`: "typing" keeps the text box unchanged, "drag" the window.
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
  lesson = {...answer, unit: from === "drag" && lesson ? lesson.unit : answer.unit};
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
// Switches a scaling between equal factors in equal times and equal amounts.
const changeLaw = (i) => {
  const answer = algebra.changed(shownText, i, "linear", [+!lesson.factors[i].linear]);
  if (answer.error)
    complain(shownText, answer.error);
  else
    change(answer.text);
  byId("chips").querySelector(`[data-factor="${i}"] .law`)?.focus();
};
const showChips = () => {
  const list = byId("chips");
  list.textContent = "";
  lesson.factors.forEach((f, i) => {
    const item = put(list, "li");
    const chip = put(item, "div", {class: "chip factor", "data-factor": i, style: `border-color: ${factorColour(i)}`});
    put(chip, "span", {style: `color: ${factorColour(i)}`}, f.text);
    if (f.kind === "S")
      put(
        chip, "button", {
          type: "button",
          class: "law",
          "aria-pressed": f.linear,
          title: "by equal amounts, as in CSS, and not by equal factors"
        },
        "linear")
        .addEventListener("click", () => changeLaw(i));
    put(chip, "button", {type: "button", class: "out", "aria-label": `Take ${f.text} out`}, "×")
      .addEventListener("click", () => takeOut(i));
    chip.addEventListener("pointerdown", (e) => dragChip(e, chip, i));
    if (i + 1 === lesson.factors.length) return;
    const name = `Swap ${f.text} and ${lesson.factors[i + 1].text}`;
    put(item, "button", {type: "button", class: "swap", "aria-label": name, title: name}, "⇄")
      .addEventListener("click", () => swap(i, i + 1));
  });
};
// Drags a factor. Released over another one, the two swap places.
const dragChip = (down, chip, i) => {
  if (down.button !== 0 || down.target.closest("button")) return;
  down.preventDefault();
  chip.setPointerCapture(down.pointerId);
  chip.classList.add("held");
  const chips = [...byId("chips").querySelectorAll(".chip")];
  const under = (e) => chips.findIndex((c) => {
    const box = c.getBoundingClientRect();
    return c !== chip && e.clientX >= box.left && e.clientX <= box.right && e.clientY >= box.top &&
      e.clientY <= box.bottom;
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

const beginning = {
  T: (u) => `T(${2 * u} 0${lesson.planar ? "" : " 0"})`,
  R: (u) => `R(90deg @ ${u} 0)`,
  S: (u) => `S(1.5 @ ${u} 0)`
};
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

// ---- Numbers beside the picture

const bracketed = (parent, kind = "") => {
  const size = lesson.planar ? 3 : 4;
  const body = parent.tagName === "TBODY" ? parent : put(put(parent, "table", {class: `matrix ${kind}`}), "tbody");
  body.textContent = "";
  body.parentNode.classList.toggle("of-space", !lesson.planar);
  return Array.from({length: size}, () => put(body, "tr"))
    .map((row) => Array.from({length: size}, () => put(row, "td")));
};
// Returns which of the twelve numbers a plane or space shows, by rows.
const across = () => lesson.planar ? [[0, 1, 3], [4, 5, 7]] : [[0, 1, 2, 3], [4, 5, 6, 7], [8, 9, 10, 11]];
const fill = (cells, write) => {
  const rows = across();
  rows.forEach((row, r) => row.forEach((at, c) => write(cells[r][c], at)));
  cells.at(-1).forEach((cell, c) => {
    cell.textContent = c === cells.length - 1 ? "1" : "0";
  });
};
const spans = (parent, all) => {
  parent.textContent = "";
  return all.map((text, i) => put(parent, "span", {class: "factor", style: `color: ${factorColour(i)}`}, text));
};

let numbers = null;
const prepareNumbers = () => {
  const {followed} = wholeFigure();
  numbers = {now: spans(byId("now"), texts()), cells: bracketed(byId("matrix")), tip: followed[0]};
  if (!lesson.factors.length) byId("now").textContent = "empty: the identity";
  const legend = byId("legend");
  legend.textContent = "";
  followed.forEach((p, i) => {
    const name = [`the top of the figure, ${place(p)} at rest`, `its foot, ${place(p)}`][i] || place(p);
    put(legend, "span", {class: "key path", style: `border-color: ${pathColour(i)}`});
    legend.append(name + (i + 1 < followed.length ? "; " : ". "));
  });
  if (lesson.factors.some((f) => f.kind !== "T"))
    legend.append("Crosses are centres, in the colours of their factors; dots show how they are carried. ");
  legend.append("Thin letters: every eighth part of the motion. ");
  if (isDense(lesson.factors)) legend.append(denseNote(lesson.factors));
  byId("hint").textContent = lesson.factors.length === 0 ?
    "" :
    "Rings, squares and tips can be dragged, or moved by the arrow keys: centres, angles, growths, ways" +
      (lesson.planar ? "" : ", axes") + ", as they are at rest. With Shift they go by finer steps." +
      (lesson.planar ? "" : " Drag beside them to turn the view.");
};
const showNumbers = (t) => {
  const moment = algebra.moment(shownText, t);
  fill(numbers.cells, (cell, at) => {
    cell.textContent = fixed(moment.matrix[at]);
  });
  numbers.now.forEach((s, i) => {
    s.textContent = partly(lesson.factors[i], moment.parts[i]);
  });
  const at = moved(moment.matrix, numbers.tip), shown = lesson.planar ? at.slice(0, 2) : at;
  byId("corner").textContent = `${place(numbers.tip)} → (${shown.map((x) => fixed(x)).join(", ")})`;
  (written || []).forEach((update) => update(moment));
};

// ---- Matrices in letters

let written = null;
// Writes a sum such as "(1 - c2) x2^2", each letter in the colour of its factor.
const writeSum = (cell, sum, symbols) => {
  cell.textContent = "";
  for (const part of sum.split(/([a-z]\d*(?:\^\d+)?)/)) {
    const [, name, index, power] = /^([a-z])(\d*)(?:\^(\d+))?$/.exec(part) || [];
    if (!name) {
      cell.append(part.replace(/-/g, "−"));
      continue;
    }
    const letter = symbols.letters.find((l) => l.name === name + index);
    const box = put(cell, "i", {class: "factor", style: `color: ${factorColour(letter.factor)}`}, name);
    if (index) put(box, "sub", {}, index);
    if (power) put(box, "sup", {}, power);
  }
};
const showMatrices = () => {
  const box = byId("written");
  box.textContent = "";
  written = [];
  const line = (name, colour, symbols, numbersOf) => {
    const row = put(box, "div", {class: "written"});
    put(row, "h3", colour ? {class: "factor", style: `color: ${colour}`} : {}, name);
    const left = put(row, "div", {class: "scroll", tabindex: 0, role: "group", "aria-label": `${name} in letters`});
    if (symbols.why)
      put(
        left, "p", {class: "small"},
        `${symbols.why[0].toUpperCase()}${symbols.why.slice(1)}: it stands as the product of those above.`);
    else
      fill(bracketed(left, "symbols"), (cell, at) => writeSum(cell, symbols.sums[at], symbols));
    put(row, "span", {class: "equals"}, "=");
    const cells =
      bracketed(put(row, "div", {class: "scroll", tabindex: 0, role: "group", "aria-label": `${name} in numbers`}));
    written.push((moment) => fill(cells, (cell, at) => {
                   cell.textContent = fixed(numbersOf(moment)[at]);
                 }));
  };
  lesson.factors.forEach((f, i) => line(f.text, factorColour(i), lesson.alone[i], (m) => m.alone[i]));
  if (lesson.factors.length !== 1) line("A(t), the product of all", null, lesson.symbols, (m) => m.matrix);
  const list = byId("letters"), letters = lesson.symbols.letters || [];
  list.textContent = "";
  const rows = letters.map((l) => {
    const row = put(list, "tr");
    writeSum(put(row, "th", {scope: "row"}), l.name, lesson.symbols);
    put(row, "td", {}, l.means.replace(/-/g, "−"));
    return put(row, "td");
  });
  written.push((moment) => rows.forEach((cell, k) => {
    cell.textContent = fixed(moment.letters[k]);
  }));
  list.closest("table").hidden = letters.length === 0;
};

const showString = () => {
  showChips();
  byId("lead").textContent = lead(lesson.factors);
  document.title = `${shownText || "no factors"} – a lesson in motion`;
  byId("command").textContent =
    `betwixt algebra --lesson lesson.html "${shownText}"\n\nball.motion\n  1f..48f ${shownText}`;
  prepareNumbers();
  showMatrices();
  drawStage();
};

// ---- One factor at a time

const picture = (parent, factors, label, more = {}) => {
  const {figure, followed} = wholeFigure();
  const drawn = drawMotion(parent, {...motionOf(factors, more.linear), other: more.other}, {
    figure,
    followed,
    look: look(),
    label,
    wide: 460,
    shapes: lesson.planar ? [0.5, 0.75] : [0.7, 0.7],
    unit: lesson.unit,
    flat: lesson.planar,
    crosses: more.other ? [] : crossesOf(factors, more.first || 0),
    ...more.options
  });
  drawn.update(state.t);
  updates.rest.push(drawn.update);
};
const showCards = () => {
  const {factors} = lesson, count = factors.length;
  const order = "In the order in which they act on the figure, from the right of the string to its left. " +
    "Each is shown alone first, and then after all those before it.";
  byId("factors-lead").textContent =
    ["There are none. An empty string is the identity at every t.", "There is only one here."][count] || order;
  byId("cards").textContent = "";
  const most = 12;  // more pictures would repeat
  for (let i = count - 1; i >= Math.max(0, count - most); --i) {
    const card = put(byId("cards"), "li");
    put(card, "h3", {class: "factor", style: `color: ${factorColour(i)}`}, factors[i].text);
    put(card, "p", {}, described(factors[i]));
    const pair = put(card, "div", {class: "pair"});
    const one = (some, first, caption) => {
      const box = put(pair, "figure");
      picture(box, some, `${caption}: ${textsOf(some).join(" ")}`, {first});
      put(box, "figcaption", {}, isDense(some) ? `${caption}. ${denseNote(some)}` : caption);
    };
    one([factors[i]], i, "Alone");
    if (i < count - 1)
      one(
        factors.slice(i), i,
        i === 0 ? "After all the others: the whole motion" : `After ${counted(count - 1 - i, "factor", "factors")}`);
  }
  if (count > most) put(byId("cards"), "li", {}, `And ${count - most} more, which act after these.`);
};

// ---- The figures

const figures = {
  plane: [
    ["T: a way", "T(5 3)"], ["S: a growth", "S(2 3 @ -1 1)"], ["R: a turn", "R(-270deg @ 2 1)"],
    ["TS: a growth, carried on", "T(4 0) S(0.4 2.2 @ 1 0)"], ["ST: a way that grows", "S(2 2.5 @ -1 0) T(3 1)"],
    ["TR: a nail in a rolling tyre", "T(12.566 0) R(-2turn @ 0 1)"],
    ["RT: a way that turns, a spiral", "R(2turn) T(6 0)"],
    ["RS: a growth that turns", "R(1turn @ 1 0) S(2.5 0.5 @ 0 1)"],
    ["SR: a turn that is stretched", "S(2.2 0.6 @ -1 1) R(1.5turn @ 2 0)"],
    ["TRS: all three", "T(8 2) R(-1turn @ 1 1) S(0.5 @ 0 0)"],
    ["RR: a moon about a planet", "R(1turn) R(6turn @ 4 0)", [[4, 0, 0]]],
    ["RRR: arms on arms", "R(1turn) R(-3turn @ 3 0) R(9turn @ 4 0)"],
    ["SRT: a chain of motions", "S(1.3 @ -40 -20) R(35deg) T(100 0)"],
    ["TTRR: two ways, two turns", "T(6 0) T(0 2) R(1turn @ 1 1) R(-1turn @ 2 1)"]
  ],
  space: [
    ["The potter’s wheel", "R(10turn @ 0 0 0 axis y) S(0.62 1.9 0.62)"],
    ["A ball in a funnel", "T(0 -3 0) R(6turn @ 0 0 0 axis y) S(0.1 1 0.1)", [[3, 0, 0]]],
    ["A screw", "T(0 4 0) R(3turn @ -2 0 0 axis y)"],
    ["A moon about an earth about a sun", "R(1turn axis y) R(11turn @ 7 0 0 axis y)", [[8.5, 0, 0]]],
    [
      "The earth that does not lean over",
      "R(1turn axis y) R(-1turn @ 7 0 0 axis y) R(6turn @ 7 0 0 axis -0.397 0.918 0)"
    ],
    ["A coin that tumbles", "T(5 0 -3) R(2turn @ 0.5 0.75 0 axis 1 1 0) R(3turn @ 0.5 0.75 0 axis y)"]
  ]
};
const addressOf = (text, points) =>
  `#m=${encodeURIComponent(text)}` + (points.length ? `&p=${pointsText(points)}` : "");
const pointsText = (points) => points.map((p) => (p[2] ? p : p.slice(0, 2)).join(",")).join(";");
const showGallery = () => {
  for (const kind of ["plane", "space"])
    for (const [name, text, points = []] of figures[kind]) {
      const link = put(put(byId(`${kind}-figures`), "li"), "a", {href: addressOf(text, points)});
      link.addEventListener("click", () => {
        scrollTo({top: 0, behavior: "instant"});
        byId("motion-title").focus({preventScroll: true});
      });
      const {factors, planar, unit} = algebra.string(text, points), figure = figureOf(unit, planar);
      const drawn = drawMotion(link, motionOf(factors), {
        figure,
        followed: [figure.tip, figure.foot, ...points],
        look: planar ? {yaw: 0, pitch: 0} : {yaw: -0.5, pitch: 0.35},
        label: "",
        wide: 240,
        shapes: [0.72, 0.72],
        unit,
        flat: planar,
        crosses: crossesOf(factors, 0),
        plain: true
      });
      drawn.update(0.5);
      drawn.w.svg.querySelectorAll("text").forEach((mark) => mark.remove());
      drawn.w.svg.setAttribute("aria-hidden", true);
      put(link, "b", {}, name);
      put(link, "code", {}, text);
    }
};

// ---- The address: the string, the moment, and the other settings

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
const readPoints = (text) => text.split(";")
                               .map((p) => p.split(",").map(Number))
                               .filter((p) => (p.length === 2 || p.length === 3) && p.every((x) => Math.abs(x) <= 1e9))
                               .map((p) => [...p, 0].slice(0, 3))
                               .slice(0, 50);
const fromAddress = () => {
  const settings = new Map(location.hash.slice(1).split("&").map(
    (part) => [part.slice(0, part.indexOf("=")), part.slice(part.indexOf("=") + 1)]));
  const numberOf = (name, low, high) => {
    const x = Number(settings.get(name) || NaN);
    return x >= low && x <= high ? x : null;
  };
  clearTimeout(noting);
  state.t = numberOf("t", 0, 1) ?? (settings.has("m") ? 0.4 : state.t);
  state.steps = Math.round(numberOf("n", 1, 2000) ?? state.steps);
  const view = (settings.get("v") || "").split(",").map(Number);
  if (view.length === 2 && view.every(Number.isFinite))
    [state.yaw, state.pitch] = [view[0], Math.max(-1.5, Math.min(1.5, view[1]))];
  // A string in the address has its own points.
  const points = settings.has("m") ? readPoints(settings.get("p") || "") : state.points;
  const other = pointsText(points) !== pointsText(state.points);
  state.points = points;
  let text = state.text;
  try {
    text = settings.has("m") ? decodeURIComponent(settings.get("m")) : text;
  } catch { /* the address has no valid text, so the string stays */
  }
  stop();
  if (!lesson) change(given.text, "address");  // a valid string is needed, even if the address has none
  if (other || text !== shownText)
    change(text, "address");
  else
    drawStage();
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
    if (state.t < 1)
      requestAnimationFrame(tick);
    else
      stop();
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
  if (e.key !== " " || e.ctrlKey || e.metaKey || e.altKey || e.target.closest("button, textarea, input, .handle, a"))
    return;
  e.preventDefault();
  toggle();
});
addEventListener("hashchange", fromAddress);

// ---- The engine

const silent = (why) => {
  byId("silent").hidden = false;
  byId("silent").textContent = `This lesson lives by Betwixt’s engine, and that is not running here: ` +
    `${why}. The string is ${given.text || "empty"}; betwixt algebra "${given.text}" shows its frames.`;
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
})()
  .catch((error) => silent(error.message));
