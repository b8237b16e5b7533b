// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The string that the reader edits: its text, its errors, and the row of its factors.
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
