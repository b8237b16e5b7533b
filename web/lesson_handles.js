// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The whole motion in a picture, and the handles in it.
// ---- The whole motion and its handles

const lead = (factors) => {
  const count = factors.length;
  if (count === 0) return "A motion of no factors. Nothing moves. Every method agrees.";
  if (count === 1) return "A motion of one factor. T moves, R turns, S scales.";
  return `A motion of ${count} factors. Read it from the right: ${factors[count - 1].text} comes first, ` +
    `${factors[0].text} last. Each factor also moves the centres of those on its right.`;
};
let stage = null;    // the picture
let holding = null;  // the window's frame while a handle is dragged; it stays unchanged

const drawStage = () => {
  const {figure, followed} = wholeFigure(), grips = gripsOf(lesson.factors);
  const box = byId("stage"), focused = document.activeElement?.dataset?.grip;
  box.textContent = "";
  stage = drawMotion(box, motionOf(lesson.factors), {
    figure,
    followed,
    look: look(),
    label: "The figure at rest, on its way and at the end; the paths of its points; what can be dragged",
    wide: 760,
    shapes: lesson.planar ? [0.45, 0.85] : [0.72, 0.72],
    unit: lesson.unit,
    flat: lesson.planar,
    crosses: crossesOf(lesson.factors, 0),
    also: grips.flatMap((g) => [g.at, ...(g.guide || [])]),
    seen: holding
  });
  const svg = stage.w.svg;
  svg.setAttribute("role", "group");
  grips.forEach((grip, k) => showGrip(svg, grip, k));
  if (focused) svg.querySelector(`[data-grip="${focused}"]`)?.focus({preventScroll: true});
  if (!lesson.planar) orbit(svg);
  updates.stage = [stage.update, showNumbers];
  updates.stage.forEach((update) => update(state.t));
};
const look = () => lesson.planar ? {yaw: 0, pitch: 0} : state;

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
    const {yaw, pitch} = state;
    follow(
      down, (e) => turn(yaw - (e.clientX - down.clientX) * 0.01, pitch + (e.clientY - down.clientY) * 0.01), showLater);
  });
  svg.addEventListener("keydown", (e) => {
    const by = {ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1]}[e.key];
    if (!by || e.target !== svg) return;
    e.preventDefault();
    turn(state.yaw + by[0], state.pitch + by[1]);
    stage.w.svg.focus({preventScroll: true});
    showLater();
  });
};
// Follows a pressed pointer. The box captures it, because the elements in the box are drawn anew during the drag.
const follow = (down, moves, ends) => {
  down.preventDefault();
  byId("stage").setPointerCapture(down.pointerId);
  const move = (e) => {
    if (e.pointerId === down.pointerId) moves(e);
  };
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

// Returns the handles (grips) of all factors: the place of each, and the change that a new place makes.
const gripsOf = (factors) => factors.flatMap((f, i) => {
  const u = lesson.unit,
        grip = (what, name, at, to, more = {}) => ({i, what, name: `${name} of ${f.text}`, at, to, ...more});
  if (f.kind === "T")
    return [grip("by", "The way", f.by, (p) => ["by", round(p)], {guide: [[0, 0, 0], f.by], shape: "tip"})];
  const centre = grip("centre", "The centre", f.centre, (p) => ["centre", round(p)], {shape: "ring"});
  if (f.kind === "R") {
    const [e1, e2] = around(f.axis), r = 1.25 * u, angle = 2 * Math.PI * f.turns;
    const on = (a) => plus(plus(f.centre, e1, r * Math.cos(a)), e2, r * Math.sin(a));
    const least = angle - Math.sign(angle) * Math.min(Math.abs(angle), 2 * Math.PI);
    const arc = Array.from({length: 65}, (_, k) => on(least + (angle - least) * k / 64));
    const turned = (p, fine) => {
      const d = plus(p, f.centre, -1), now = Math.atan2(dot(d, e2), dot(d, e1)) / (2 * Math.PI);
      const turns = f.turns + (now - f.turns) - Math.round(now - f.turns), step = fine ? 1 : 5;
      return ["angle", [Math.round(turns * 360 / step) * step, 0, 0]];
    };
    const all = [
      centre,
      grip("angle", "The angle", on(angle), turned, {guide: arc, spoke: [f.centre, on(0)], shape: "dot", by: 5 / 360})
    ];
    if (!lesson.planar)
      all.push(grip(
        "axis", "The axis", plus(f.centre, f.axis, 2 * u),
        (p) => ["axis", direction(plus(p, f.centre, -1)).map((x) => +x.toFixed(2))],
        {guide: [plus(f.centre, f.axis, -2 * u), plus(f.centre, f.axis, 2 * u)], shape: "tip"}));
    return all;
  }
  const sized = (change) => (p, fine) => {
    const g = plus(p, f.centre, -1).map((x) => x / u), step = fine ? 0.01 : 0.1;
    const rounded = (x) => {
      const by = +(Math.round(x / step) * step).toFixed(2);
      return f.linear ? by : Math.max(step, by);
    };
    return ["by", change(f.by.slice(), g, rounded)];
  };
  const axes = (lesson.planar ? [0, 1] : [0, 1, 2]).map((c) => {
    const at = f.centre.slice();
    at[c] += f.by[c] * u;
    return grip(
      "xyz"[c], `The growth along ${"xyz"[c]}`, at, sized((by, g, rounded) => {
        by[c] = rounded(g[c]);
        return lesson.planar ? [by[0], by[1], 1] : by;
      }),
      {guide: [f.centre, at], shape: "box"});
  });
  const corner = plus(f.centre, lesson.planar ? [f.by[0], f.by[1], 0] : f.by, u);
  const alike = sized((_, g, rounded) => {
    const all = rounded((g[0] + g[1] + (lesson.planar ? 0 : g[2])) / (lesson.planar ? 2 : 3));
    return [all, all, all];
  });
  return [centre, ...axes, grip("all", "The growth", corner, alike, {shape: "box"})];
});
const round = (p) => {
  const step = lesson.unit / (dragFine ? 100 : 10);
  return p.map((x) => +(Math.round(x / step) * step).toPrecision(12));
};
let dragFine = false;

const shapes = {
  ring: "M-6 0a6 6 0 1 0 12 0a6 6 0 1 0-12 0",
  dot: "M-4.5 0a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0-9 0",
  box: "M-5-5h10v10h-10z",
  tip: "M0-6.5L6.5 0 0 6.5-6.5 0z"
};
const showGrip = (svg, grip, k) => {
  const stroke = factorColour(grip.i), {w} = stage;
  for (const line of [grip.guide, grip.spoke])
    if (line)
      put(svg, "path", {
        class: "factor",
        d: w.path(line),
        stroke,
        fill: "none",
        "stroke-width": 1.3,
        "stroke-opacity": 0.75,
        "pointer-events": "none"
      });
  const g = put(svg, "g", {
    class: "handle",
    tabindex: 0,
    role: "button",
    "data-grip": `${grip.i}-${grip.what}`,
    "aria-label": `${grip.name}: drag it, or move it by the arrow keys`
  });
  put(g, "title", {}, grip.name);
  put(g, "circle", {class: "reach", r: 15});
  put(g, "path", {class: "grip factor", d: shapes[grip.shape], stroke});
  stand(g, w.on(grip.at));
  g.addEventListener("pointerdown", (down) => {
    if (down.button === 0) dragGrip(down, grip);
  });
  g.addEventListener("touchstart", (e) => e.preventDefault(), {passive: false});  // otherwise the page would scroll
  g.addEventListener("keydown", (e) => moveGrip(e, grip));
};
// Moves a place in the plane of the picture by pixels.
const dragged = (from, dx, dy) =>
  plus(plus(from, stage.w.eye.right, dx / stage.w.scale), stage.w.eye.up, -dy / stage.w.scale);
const changeBy = (grip, at, fine) => {
  dragFine = fine;
  const [what, to] = grip.to(at, fine);
  const answer = algebra.changed(shownText, grip.i, what, to);
  if (answer.error)
    complain(shownText, answer.error);
  else if (answer.text !== shownText)
    change(answer.text, "drag");
};
const dragGrip = (down, grip) => {
  down.stopPropagation();
  const perPixel = 1 / stage.w.svg.getScreenCTM().a, {what, i} = grip, first = shownText;
  holding = stage.seen;
  let wanted = null, scheduled = 0;
  const go = () => {
    scheduled = 0;
    const now = gripsOf(lesson.factors).find((g) => g.i === i && g.what === what);
    changeBy(
      now, dragged(grip.at, (wanted.clientX - down.clientX) * perPixel, (wanted.clientY - down.clientY) * perPixel),
      wanted.shiftKey);
  };
  stage.w.svg.querySelector(`[data-grip="${i}-${what}"]`)?.focus({preventScroll: true});
  follow(
    down,
    (e) => {
      wanted = e;
      scheduled ||= requestAnimationFrame(go);
    },
    () => {
      if (scheduled) cancelAnimationFrame(scheduled), go();
      holding = null;
      dragFine = false;
      if (shownText === first) return;
      remember(first);
      change(shownText, "address");
    });
};
const moveGrip = (e, grip) => {
  const way = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[e.key];
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
