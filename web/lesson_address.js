// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The address of the page, which has the string, the moment and the other settings, and the figures to go to.
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
  const said = new Map(location.hash.slice(1).split("&").map(
    (part) => [part.slice(0, part.indexOf("=")), part.slice(part.indexOf("=") + 1)]));
  const numberOf = (name, low, high) => {
    const x = Number(said.get(name) || NaN);
    return x >= low && x <= high ? x : null;
  };
  clearTimeout(noting);
  state.t = numberOf("t", 0, 1) ?? (said.has("m") ? 0.4 : state.t);
  state.steps = Math.round(numberOf("n", 1, 2000) ?? state.steps);
  const view = (said.get("v") || "").split(",").map(Number);
  if (view.length === 2 && view.every(Number.isFinite))
    [state.yaw, state.pitch] = [view[0], Math.max(-1.5, Math.min(1.5, view[1]))];
  // A string in the address has its own points.
  const points = said.has("m") ? readPoints(said.get("p") || "") : state.points;
  const other = pointsText(points) !== pointsText(state.points);
  state.points = points;
  let text = state.text;
  try {
    text = said.has("m") ? decodeURIComponent(said.get("m")) : text;
  } catch { /* no text of an address: the string stays */
  }
  stop();
  if (!lesson) change(given.text, "address");  // a valid string is needed, even if the address has none
  if (other || text !== shownText)
    change(text, "address");
  else
    drawStage();
  show(state.t);
};
