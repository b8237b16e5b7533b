// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Helpers with which player and editor build their contents. They need no markup from text and no inline styles or
// scripts, so a page may forbid those (docs/web.md#which-policy-it-needs).

// Makes an element with attributes and children (elements and texts).
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
// Makes a style sheet that several shadow roots can share.
const sheet = (rules = "") => {
  const made = new CSSStyleSheet();
  made.replaceSync(rules);
  return made;
};
