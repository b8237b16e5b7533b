// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Player and editor make their insides by these. So a page may forbid markup from text, styles in the page, and scripts
// that it does not name (docs/web.md#which-policy-it-needs).

// An element, its attributes, and what is in it: elements and texts.
const element = (name, attributes = {}, ...inside) => {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...inside);
  return made;
};
const drawing = (path) => {
  const made = (name, attributes) => {
    const one = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) one.setAttribute(key, value);
    return one;
  };
  const svg = made("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" });
  svg.append(made("path", { d: path }));
  return svg;
};
// Rules that several roots may have.
const sheet = (rules = "") => {
  const made = new CSSStyleSheet();
  made.replaceSync(rules);
  return made;
};
