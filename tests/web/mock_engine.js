// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A mock of the engine: it has the interface of docs/web.md, but makes no films. Tests check the player alone with it,
// and count its calls.
//   It understands rate 24, range 1f 72f, size 640x360 and note "…". "broken" is an error; "use NAME" needs a file.
globalThis.Betwixt = {
  counts: { opened: 0, disposed: 0, drawn: 0, engines: 0 },
  drawing_fails: "",
  async engine() {
    if (Betwixt.engine_fails) throw new Error(Betwixt.engine_fails);
    return (Betwixt.one ??= (Betwixt.counts.engines++, { version: "mock", prepare: async () => {}, is_prepared: () => true, open: (text, how) => new Betwixt.Film(text, how) }));
  },
  Film: class {
    constructor(text, { name, files = {} }) {
      ++Betwixt.counts.opened;
      const number = (pattern, otherwise) => Number((text.match(pattern) ?? [0, otherwise])[1]);
      this.fps = number(/^rate (\d+)/m, 24);
      this.firstFrame = number(/^range (\d+)f/m, 1);
      this.lastFrame = number(/^range \d+f (\d+)f/m, 72);
      this.width = number(/^size (\d+)x/m, 1280), this.height = number(/^size \d+x(\d+)/m, 720);
      this.start = (this.firstFrame - 1) / this.fps, this.end = (this.lastFrame - 1) / this.fps;
      this.duration = this.end - this.start;
      this.color = (text.match(/color=(\w+)/) ?? [0, "gold"])[1];
      this.wants = [...text.matchAll(/^use (\S+)/gm)].map((m) => m[1]).filter((path) => !(path in files));
      this.used = files;
      this.notes = [...text.matchAll(/^at (\d+)f note "(.*)"/gm)].map((m) => ({ seconds: (m[1] - 1) / this.fps, text: m[2] }));
      this.diagnostics = [];
      const lines = text.split("\n");
      const error = (line, column, words, hint = "") =>
        this.diagnostics.push({ severity: "error", text: words, hint, file: name, line, column, source: lines[line - 1] });
      lines.forEach((line, i) => {
        if (line.includes("broken")) error(i + 1, [...line.slice(0, line.indexOf("broken"))].length + 1, "this is broken", "mend it");
      });
      for (const path of this.wants) error(lines.findIndex((l) => l.includes(path)) + 1, 5, `there is no file '${path}'`);
      this.ok = !this.diagnostics.length;
      this.message = this.diagnostics
        .map((d) => `${name}:${d.line}:${d.column}: error: ${d.text}\n  ${d.source}\n  ${" ".repeat(d.column - 1)}^\n`).join("");
    }
    draw(canvas, seconds) {
      if (this.gone) throw new Error("it is disposed");
      if (Betwixt.drawing_fails) throw new Error(Betwixt.drawing_fails);
      ++Betwixt.counts.drawn;
      Betwixt.last_drawn = seconds;
      const pen = canvas.getContext("2d"), at = (seconds - this.start) / (this.end - this.start || 1);
      pen.fillStyle = "#cdd6de", pen.fillRect(0, 0, canvas.width, canvas.height);
      pen.fillStyle = this.color, pen.beginPath();
      pen.arc(canvas.width * (0.1 + 0.8 * at), canvas.height / 2, canvas.height / 8, 0, 7), pen.fill();
    }
    eval(target, seconds) {
      if (target !== "ball.position") throw new Error(`there is no object '${target}'`);
      return [seconds, 0, 0];
    }
    problems() { return []; }
    dispose() { this.gone || ++Betwixt.counts.disposed, (this.gone = true); }
  },
};
