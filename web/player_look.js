// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a <betwixt-player> looks like: its icons, its style sheet and its parts.
const player_icons = {
  play: "M6 4l14 8-14 8z",
  pause: "M6 4h4v16H6zM14 4h4v16h-4z",
  again: "M12 5a7 7 0 1 1-6.7 5l2.9.9A4 4 0 1 0 12 8v4L6 6.5 12 1z",
  loud: "M3 9v6h4l5 5V4L7 9zM15 8.2v7.6a4.2 4.2 0 0 0 0-7.6zM15 4v2.1a6.2 6.2 0 0 1 0 11.8V20a8.2 8.2 0 0 0 0-16z",
  silent: "M3 9v6h4l5 5V4L7 9zM21.5 9.9l-1.4-1.4-2.1 2.1-2.1-2.1-1.4 1.4 2.1 2.1-2.1 2.1 1.4 1.4 2.1-2.1 2.1 2.1 1.4-1.4-2.1-2.1z",
  full: "M4 4h7v2H6v5H4zM13 18h5v-5h2v7h-7z",
  small: "M9 4h2v7H4V9h5zM13 13h7v2h-5v5h-2z",
};

const player_look = () => sheet(`
:host { display: block; position: relative; aspect-ratio: 16 / 9; max-width: 100%;
  min-height: 2rem; overflow: hidden; background: var(--betwixt-letterbox, #000); color: #fff;
  font: var(--betwixt-font, 14px/1.4 system-ui, sans-serif); }
:host([hidden]) { display: none; }
:host(:fullscreen) { max-width: none; aspect-ratio: auto !important; }
.stage { position: absolute; inset: 0; display: grid; place-items: center; outline: none; }
.stage > canvas, .stage > img { grid-area: 1 / 1; max-width: 100%; max-height: 100%; }
.stage > img { width: 100%; height: 100%; object-fit: contain; z-index: 1; }
[hidden] { display: none !important; }
.said { position: absolute; width: 1px; height: 1px; margin: -1px; overflow: hidden; clip-path: inset(50%); }
.wait { grid-area: 1 / 1; z-index: 2; color: #bbb; opacity: 0; animation: appear 0.3s 0.6s forwards; }
@keyframes appear { to { opacity: 1; } }
.message { position: absolute; inset: 0; z-index: 3; overflow: auto; padding: 1rem 1.25rem; box-sizing: border-box;
  background: Canvas; color: CanvasText; border: 1px solid color-mix(in srgb, CanvasText 20%, Canvas); }
.message strong { display: block; margin-bottom: 0.5em; }
.message pre { margin: 0 0 1em; white-space: pre-wrap; overflow-wrap: anywhere;
  font: 13px/1.45 ui-monospace, monospace; }
.message button { font: inherit; padding: 0.25em 0.9em; }
.banner { position: absolute; inset: auto 0 0; z-index: 3; padding: 0.4em 0.8em; background: #7a1d14; color: #fff;
  white-space: nowrap; overflow: hidden; text-overflow: ellipsis; }
.controls { position: absolute; inset: auto 0 0; z-index: 2; display: flex; align-items: center; gap: 0.5em;
  padding: 1.6em 0.6em 0.35em; background: linear-gradient(transparent, #000a); transition: opacity 0.25s;
  user-select: none; -webkit-user-select: none; }
.idle .controls:not(:focus-within) { opacity: 0; }
.idle:not(:focus-within) { cursor: none; }
.controls button, .controls select { font: inherit; color: inherit; background: none; border: 0; border-radius: 4px;
  height: 2.2em; cursor: pointer; }
.controls button { width: 2.2em; flex: none; padding: 0.3em; }
.controls select { appearance: none; text-align: center; padding: 0 0.3em; min-width: 3em; }
.controls option { color: #000; background: #fff; }
.controls :is(button, select):hover { background: #fff3; }
.controls :focus-visible { outline: 2px solid #fff; outline-offset: 1px; }
.controls svg { width: 100%; height: 100%; fill: currentColor; display: block; }
.clock { flex: none; font-variant-numeric: tabular-nums; white-space: nowrap; }
input[type="range"] { flex: 1; min-width: 3em; height: 1.6em; margin: 0; appearance: none; background: none;
  cursor: pointer; --track: linear-gradient(to right, var(--betwixt-accent, #ffb000) var(--at, 0%), #fff5 0); }
input::-webkit-slider-runnable-track { height: 4px; border-radius: 2px; background: var(--track); }
input::-moz-range-track { height: 4px; border-radius: 2px; background: var(--track); }
input::-webkit-slider-thumb { appearance: none; width: 14px; height: 14px; margin-top: -5px; border: 0;
  border-radius: 50%; background: var(--betwixt-accent, #ffb000); }
input::-moz-range-thumb { width: 14px; height: 14px; border: 0; border-radius: 50%;
  background: var(--betwixt-accent, #ffb000); }
.narrow .clock, .narrow select { display: none; }
@media (pointer: coarse) {
  .controls button, .controls select, .message button { min-width: 44px; min-height: 44px; }
  .controls button { padding: 11px; }
  input[type="range"] { min-width: 44px; height: 44px; touch-action: pan-y; }
  input::-webkit-slider-thumb { width: 24px; height: 24px; margin-top: -10px; }
  input::-moz-range-thumb { width: 24px; height: 24px; }
}
@media (prefers-reduced-motion: reduce) { .controls { transition: none; } .wait { animation-duration: 1ms; } }
@media (forced-colors: active) { .controls { background: Canvas; color: CanvasText; } }
`);
const player_insides = () => element("div", { class: "stage", part: "stage", tabindex: "-1", role: "group" },
  element("canvas", { part: "picture", role: "img", width: 1, height: 1 }),
  element("img", { part: "poster", alt: "", hidden: "" }),
  element("span", { class: "wait", part: "wait", hidden: "" }, "loading …"),
  element("div", { class: "controls", part: "controls", hidden: "" },
    element("button", { part: "button play", type: "button", "data-do": "toggle" }),
    element("input", { part: "time", type: "range", min: 0, max: 1, step: "any", value: 0, "aria-label": "Time" }),
    element("span", { class: "clock", part: "clock", "aria-hidden": "true" }),
    element("select", { part: "speed", "aria-label": "Speed" }),
    element("button", { part: "button mute", type: "button", "data-do": "mute", hidden: "" }),
    element("button", { part: "button fullscreen", type: "button", "data-do": "fullscreen" })),
  element("div", { class: "banner", part: "banner", role: "status", hidden: "" }),
  element("div", { class: "message", part: "message", role: "alert", hidden: "" }));
