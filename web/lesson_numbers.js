// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The numbers beside the picture, and the matrices in letters.
const bracketed = (parent, kind = "") => {
  const size = lesson.planar ? 3 : 4;
  const body = parent.tagName === "TBODY" ? parent : put(put(parent, "table", {class: `matrix ${kind}`}), "tbody");
  body.textContent = "";
  body.parentNode.classList.toggle("of-space", !lesson.planar);
  return Array.from({length: size}, () => put(body, "tr"))
    .map((row) => Array.from({length: size}, () => put(row, "td")));
};
// Of the twelve numbers, those that the plane needs.
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
