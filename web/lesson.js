// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The lesson: everything on the page follows from the string of motions. Its factors one at a time, its time, and the
// engine that computes it.
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
