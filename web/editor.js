// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// <betwixt-editor> wraps a <betwixt-player> and shows the film's text beside its picture. The film follows the typing.
// Errors appear below with a caret, and the last good film keeps playing. docs/web.md explains how to use it.
if (globalThis.customElements && !customElements.get("betwixt-editor")) {
  const longest_coloured = 200_000;  // characters; longer texts are not coloured, because colours would lag

  // The tokens of a line: texts, comments, colours, numbers with units, keys, names.
  const pieces =
    /("(?:[^"\\]|\\.)*"?)|(#(?=\s|$).*)|(#(?:[0-9a-f]{6}|[0-9a-f]{3})\b)|((?<![\w.])[+-]?(?:\d+x\d+|(?:\d+\.?\d*|\.\d+)(?:[a-z°%]+)?))|([A-Za-z][\w-]*)(?==)|([A-Za-z_][\w/*{}.-]*)/gi;
  // Returns a line as texts and coloured elements.
  const coloured_line = (line, bad) => {
    const all = [];
    let at = 0;
    for (const piece of line.matchAll(pieces)) {
      const [word, text, comment, colour, number, key, name] = piece;
      const opens = name && piece.index === 0;
      const kind = text ? "t" : comment ? "c" : colour || number ? "n" : key ? "k" : opens ? (name.includes(".") ? "s" : "v") : "";
      all.push(line.slice(at, piece.index));
      all.push(kind ? element("i", { class: kind + (colour ? " h" : "") }, word) : word);
      if (colour) all.at(-1).style.textDecorationColor = colour;
      at = piece.index + word.length;
    }
    all.push(line.slice(at));
    if (!bad) return all;
    // Leading blanks are not underlined; in a line of blanks one blank is.
    const blanks = line.match(/^\s*/)[0].length;
    let left = blanks;
    const within = all.map((one) => {
      if (typeof one !== "string" || !left) return one;
      const cut = Math.min(left, one.length);
      left -= cut;
      return one.slice(cut);
    });
    const wrong = element("i", { class: "bad" });
    for (const one of blanks < line.length ? within : [" "]) wrong.append(one);
    return [line.slice(0, blanks), wrong];
  };

  // Converts a column, which counts characters, to UTF-16 units, which JavaScript counts.
  const utf16_column = (line, column) => [...line].slice(0, column - 1).join("").length;

  const look = sheet(`
:host { display: block; container-type: inline-size; color: CanvasText;
  font: var(--betwixt-font, 14px/1.5 system-ui, sans-serif);
  --edge: color-mix(in srgb, CanvasText 16%, Canvas); --quiet: color-mix(in srgb, CanvasText 62%, Canvas);
  --paper: color-mix(in srgb, CanvasText 3%, Canvas); --wrong: color-mix(in srgb, #d9261c 78%, CanvasText); }
:host([hidden]) { display: none; }
.both { display: grid; gap: 1rem; align-items: start; }
@container (min-width: 46rem) { .both { grid-template-columns: minmax(0, 1.25fr) minmax(0, 1fr); }
  .picture { position: sticky; top: 1rem; } }
.side { min-width: 0; border: 1px solid var(--edge); border-radius: 8px; background: var(--paper); overflow: hidden; }
.side:has(textarea:focus-visible) { border-color: color-mix(in srgb, Highlight 70%, CanvasText); }
.bar { display: flex; align-items: center; gap: 0.25rem; padding: 0.3rem 0.4rem 0.3rem 0.9rem;
  border-bottom: 1px solid var(--edge); }
.name { flex: 1; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; color: var(--quiet); }
.bar button { font: inherit; color: inherit; background: none; border: 1px solid transparent; border-radius: 5px;
  padding: 0.1rem 0.55rem; cursor: pointer; }
.bar button:hover:enabled { background: color-mix(in srgb, CanvasText 9%, Canvas); }
.bar button:disabled { color: var(--quiet); opacity: 0.5; cursor: default; }
button:focus-visible { outline: 2px solid Highlight; outline-offset: -1px; }
.text, .said, .said code { scrollbar-width: thin; scrollbar-color: var(--edge) transparent; }
.text { display: grid; grid-template-columns: auto 1fr; overflow: auto; min-height: 6rem;
  max-height: var(--betwixt-text-height, 70vh); font: 13px/1.55 ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace;
  tab-size: 4; }
.lines { position: sticky; left: 0; z-index: 1; padding: 0.6rem 0.6rem 0.6rem 0.9rem; text-align: right; white-space: pre;
  color: var(--quiet); background: var(--paper); user-select: none; -webkit-user-select: none; }
.area { display: grid; min-width: 0; }
.area > * { grid-area: 1 / 1; font: inherit; margin: 0; padding: 0.6rem 1rem 0.6rem 0.3rem; white-space: pre; border: 0;
  letter-spacing: inherit; tab-size: inherit; }
.colours { pointer-events: none; min-width: max-content; }
textarea { resize: none; overflow: hidden; background: none; color: transparent; caret-color: CanvasText; outline: none;
  width: 100%; box-sizing: border-box; }
.plain textarea { color: inherit; }
.plain .colours { visibility: hidden; }
textarea::selection { background: color-mix(in srgb, Highlight 45%, transparent); }
i { font-style: normal; }
.c { color: var(--quiet); font-style: italic; }
.t { color: light-dark(#1d6b39, #93d8a5); }
.n { color: light-dark(#94480a, #f0b673); }
.h { text-decoration: underline 3px; text-underline-offset: 2px; }
.k { color: light-dark(#5d4a9c, #c1b2f2); }
.v { color: light-dark(#0b5394, #8fc3f5); font-weight: 600; }
.s { color: light-dark(#0b5394, #8fc3f5); }
.bad { text-decoration: underline wavy 1px var(--wrong); text-underline-offset: 3px; }
.said { border-top: 1px solid var(--edge); max-height: 16rem; overflow: auto; }
.said:empty { display: none; }
.said button { display: block; width: 100%; box-sizing: border-box; text-align: left; font: inherit; color: inherit;
  background: none; border: 0; border-bottom: 1px solid var(--edge); padding: 0.5rem 0.9rem; cursor: pointer; }
.said button:last-child { border-bottom: 0; }
.said button:hover { background: color-mix(in srgb, CanvasText 6%, Canvas); }
.said b { color: var(--wrong); font-weight: 600; }
.said .warning b, .said .notice b { color: light-dark(#8a5a00, #e8b04b); }
.said code { display: block; white-space: pre; overflow: auto; margin: 0.25rem 0; font: 12.5px/1.4 ui-monospace, monospace; }
.said code i { color: var(--wrong); font-weight: 700; }
.said small { display: block; font-size: inherit; color: var(--quiet); }
.how { padding: 0.25rem 0.9rem; margin: 0; color: var(--quiet); font-size: 12px; border-top: 1px solid var(--edge);
  display: none; }
.side:has(textarea:focus) .how { display: block; }
.spoken { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
@media (pointer: coarse) {
  .bar button, .said button { min-width: 44px; min-height: 44px; }
}
`);
  const button = (what, words, title) => element("button", { type: "button", "data-do": what, title }, words);
  const insides = () => element("div", { class: "both", part: "both" },
    element("div", { class: "picture", part: "picture" }, element("slot")),
    element("div", { class: "side", part: "text" },
      element("div", { class: "bar" }, element("span", { class: "name" }),
        button("revert", "As it was", "The text as it was at first; undo brings yours back"),
        button("copy", "Copy", "The text to the clipboard"),
        button("save", "Save", "The text as a file (Ctrl-S)")),
      element("div", { class: "text" }, element("div", { class: "lines", "aria-hidden": "true" }),
        element("div", { class: "area" }, element("pre", { class: "colours", "aria-hidden": "true" }),
          element("textarea", { spellcheck: "false", autocapitalize: "off", autocomplete: "off", autocorrect: "off",
                                wrap: "off", "aria-describedby": "how" }))),
      element("div", { class: "said", part: "said" }),
      element("p", { class: "how", id: "how" }, "Ctrl-Enter plays. Tab indents; Escape, then Tab leaves the text."),
      element("span", { class: "spoken", role: "status" })));

  class BetwixtEditor extends HTMLElement {
    #root;
    #parts;
    #player = null;
    #first = null;      // the original text
    #passed = "";       // the text that the player has from here
    #due = 0;
    #tab_leaves = false; // whether Escape was the last key
    #wrong = new Set(); // lines with errors
    #listening = null;  // an AbortController

    constructor() {
      super();
      this.#root = this.attachShadow({ mode: "open" });
      this.#root.append(insides());
      this.#root.adoptedStyleSheets = [look];
      this.#root.querySelector("[data-do=revert]").disabled = true;
      const part = (name) => this.#root.querySelector(name);
      this.#parts = { name: part(".name"), area: part(".area"), lines: part(".lines"), colours: part(".colours"),
                      text: part("textarea"), said: part(".said"), spoken: part(".spoken"), slot: part("slot") };
      const { text, slot } = this.#parts;
      for (const button of this.#root.querySelectorAll("[data-do]"))
        button.addEventListener("click", () => this.#act(button));
      text.addEventListener("input", () => this.#changed());
      text.addEventListener("keydown", (event) => this.#key(event));
      text.addEventListener("blur", () => (this.#tab_leaves = false));
      slot.addEventListener("slotchange", () => this.#find_player());
    }

    connectedCallback() {
      // The children exist once the page has been parsed.
      if (document.readyState === "loading")
        document.addEventListener("DOMContentLoaded", () => this.#find_player(), { once: true });
      this.#find_player();
    }

    get player() { return this.#player; }
    get text() { return this.#parts.text.value; }
    set text(text) {
      this.#parts.text.value = text;
      this.#changed();
    }

    #find_player() {
      const player = this.querySelector("betwixt-player");
      if (player !== this.#player) {
        this.#listening?.abort();
        this.#listening = new AbortController();
        this.#player = player;
        this.#first = null;
        player?.setAttribute("editing", "");
        player?.addEventListener("diagnostics", (event) => this.#show_diagnostics(event.detail.diagnostics), this.#listening);
        player?.addEventListener("error", () => this.#take_text(), this.#listening);
      }
      this.#take_text();
    }

    // Takes the player's text if the page has changed it, unless the reader edits it.
    #take_text() {
      const { text, name } = this.#parts, script = this.#player?.script ?? "";
      if (!script || script === this.#passed || this.#due) return;
      this.#passed = text.value = script;
      if (this.#first !== null) return this.#show_revert();
      this.#first = script;
      name.textContent = this.#name();
      text.setAttribute("aria-label", `The film's text, ${this.#name()}`);
      this.#colour();
    }
    #name() {
      const inline = this.#player?.querySelector("script[data-name]")?.dataset.name;
      return inline ?? (this.#player?.currentSrc.split("/").pop() || "film.bx");
    }

    // Passes the text on at most once a frame; more often would not be visible.
    #changed() {
      this.#colour();
      this.#show_revert();
      this.#due ||= requestAnimationFrame(() => {
        this.#due = 0;
        this.#passed = this.text;
        if (this.#player) this.#player.script = this.#passed;
      });
    }
    #show_revert() { this.#root.querySelector("[data-do=revert]").disabled = this.text === this.#first; }

    #colour() {
      const { text, area, lines, colours } = this.#parts, all = text.value.split("\n");
      const plain = text.value.length > longest_coloured;
      area.classList.toggle("plain", plain);
      // A last empty line has its height only if something follows it.
      if (plain) colours.textContent = text.value + "\n ";
      else this.#colour_lines(all);
      if (lines.dataset.count !== String(all.length)) {
        lines.dataset.count = all.length;
        lines.textContent = all.map((_, i) => i + 1).join("\n");
      }
    }

    // Appends the pieces one by one, because a text can have more pieces than a call can have arguments.
    #colour_lines(all) {
      const shown = new DocumentFragment();
      all.forEach((line, i) => {
        if (i) shown.append("\n");
        for (const piece of coloured_line(line, this.#wrong.has(i + 1))) shown.append(piece);
      });
      shown.append(" ");
      this.#parts.colours.replaceChildren(shown);
    }

    #show_diagnostics(diagnostics) {
      this.#take_text();
      const { said, spoken } = this.#parts;
      const shown = diagnostics.filter((d) => d.severity !== "notice");
      const wrong = shown.filter((d) => d.severity === "error");
      this.#wrong = new Set(wrong.filter((d) => this.#is_here(d)).map((d) => d.line));
      said.replaceChildren(...shown.slice(0, 50).map((d) => this.#item(d)));
      spoken.textContent = wrong.length ? `Line ${wrong[0].line}: ${wrong[0].text}` : "";
      this.#colour();
    }
    #is_here(d) { return !d.file || d.file.split("/").pop() === this.#name(); }

    #item(d) {
      const item = document.createElement("button");
      item.type = "button";
      item.className = d.severity;
      const add = (tag, text) => {
        const made = element(tag, {}, text);
        item.append(made);
        return made;
      };
      const here = this.#is_here(d);
      if (d.line) add("b", `${here ? "line" : `${d.file},`} ${d.line}: `);
      item.append(d.text);
      if (d.line && d.source) {
        // Tabs before the caret stay tabs, so that the caret is below its place.
        const all = [...d.source], at = d.caret ?? d.column - 1;  // a long line is shown in part
        const before = all.slice(0, at).map((c) => (c === "\t" ? c : " ")).join("");
        const caret = "^".padEnd(Math.min(d.length ?? 1, all.length - at), "~");
        add("code", `${d.source}\n${before}`).append(Object.assign(document.createElement("i"), { textContent: caret }));
      }
      if (d.hint) add("small", d.hint);
      if (here && d.line) item.addEventListener("click", () => this.go(d.line, d.column));
      return item;
    }

    // Puts the cursor at a line and column, both from 1.
    go(line, column = 1) {
      const { text } = this.#parts, all = text.value.split("\n");
      const before = all.slice(0, line - 1).reduce((sum, l) => sum + l.length + 1, 0);
      const at = Math.min(before + utf16_column(all[line - 1] ?? "", column), text.value.length);
      text.focus({ preventScroll: true });
      text.setSelectionRange(at, at);
      const scroller = text.closest(".text"), height = parseFloat(getComputedStyle(text).lineHeight) || 20;
      const top = (line - 1) * height;
      if (top < scroller.scrollTop || top > scroller.scrollTop + scroller.clientHeight - 3 * height)
        scroller.scrollTop = top - scroller.clientHeight / 3;
      scroller.scrollLeft = 0;
      if (scroller.getBoundingClientRect().top < 0) scroller.scrollIntoView({ block: "nearest" });
    }

    // Inserts words as if typed, so that the browser's undo takes them back.
    #type(words) {
      if (!document.execCommand("insertText", false, words)) {
        const { text } = this.#parts;
        text.setRangeText(words, text.selectionStart, text.selectionEnd, "end");
        this.#changed();
      }
    }

    #key(event) {
      const { key } = event, ctrl = event.ctrlKey || event.metaKey;
      if (ctrl && key === "s") {
        event.preventDefault();
        this.#save();
      } else if (ctrl && key === "Enter") {
        event.preventDefault();
        if (this.#player?.paused) this.#player.play().catch(() => {});
        else this.#player?.pause();
      } else if (key === "Tab" && !this.#tab_leaves && !ctrl && !event.altKey && !event.shiftKey) {
        event.preventDefault();
        this.#type("  ");
      } else if (key === "Enter" && !event.isComposing && !event.shiftKey) {
        const { text } = this.#parts, from = text.value.lastIndexOf("\n", text.selectionStart - 1) + 1;
        const indent = text.value.slice(from, text.selectionStart).match(/^[ \t]*/)[0];
        if (indent) {
          event.preventDefault();
          this.#type("\n" + indent);
        }
      }
      this.#tab_leaves = key === "Escape" || (this.#tab_leaves && key === "Shift");
    }

    #act(button) {
      if (button.dataset.do === "save") this.#save();
      if (button.dataset.do === "copy") this.#copy(button);
      if (button.dataset.do === "revert") {
        const { text } = this.#parts;
        text.focus();
        text.select();
        this.#type(this.#first);
      }
    }

    #save() {
      const link = document.createElement("a");
      link.href = URL.createObjectURL(new Blob([this.text], { type: "text/plain;charset=utf-8" }));
      link.download = this.#name();
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
    }

    async #copy(button) {
      try {
        await navigator.clipboard.writeText(this.text);
      } catch {
        this.#parts.text.select();
        document.execCommand("copy");
      }
      button.textContent = "Copied";
      setTimeout(() => (button.textContent = "Copy"), 1500);
    }
  }

  globalThis.Betwixt = globalThis.Betwixt ?? {};
  Betwixt.Editor = BetwixtEditor;
  customElements.define("betwixt-editor", BetwixtEditor);
}
