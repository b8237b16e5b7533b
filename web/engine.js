// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The engine as a page sees it: Betwixt.engine() gives the one of this page, engine.open(text) a film. engine.cpp is the
// other half. Stands inside a function that the build puts around all parts of the player; `makeBetwixt` is
// Emscripten's, `wasmBytes(name)` gives a program, `algebraOf` is in algebra.js.

const Betwixt = (globalThis.Betwixt ??= {});

class Film {
  #engine;
  #handle;
  #bitmaps = new WeakMap();

  constructor(engine, handle) {
    this.#engine = engine;
    this.#handle = handle;
    Object.assign(this, JSON.parse(engine.call("betwixt_about", handle)));
    this.duration = this.end - this.start;
  }

  // Draws the film at `seconds` as large as the canvas is. Errors: no WebGL 2, what the graphics refuse.
  draw(canvas, seconds) {
    this.#alive();
    const { width, height } = canvas;
    if (!width || !height) return;
    this.#engine.picture(width, height, () => this.#engine.call("betwixt_draw", this.#handle, seconds, width, height));
    const kind = this.#bitmaps.get(canvas) ?? (canvas.getContext("bitmaprenderer") || canvas.getContext("2d"));
    this.#bitmaps.set(canvas, kind);
    this.#engine.hand_over(kind, width, height);
  }
  // What a target is at a time (seconds, or a text such as "24f"): numbers, as `betwixt eval --json` has them; `text`: as
  // `betwixt eval` prints it.
  eval(target, time, { text = false } = {}) {
    return this.#eval([target], [time], 1)[text ? "text" : "value"];
  }
  // What all of them are at all times: the object that `betwixt eval --json` prints; `text`: as it prints it.
  evalAll(targets, times, { text = false } = {}) {
    return this.#eval(targets, times, 0, text);
  }
  // What procedures did wrong while pictures were drawn, as `diagnostics`.
  problems() {
    this.#alive();
    return JSON.parse(this.#engine.call("betwixt_problems", this.#handle));
  }
  // Gives up what is kept to draw with, until it is drawn again.
  rest() {
    if (this.#handle) this.#engine.call("betwixt_rest", this.#handle);
  }
  dispose() {
    if (this.#handle) this.#engine.call("betwixt_close", this.#handle);
    this.#handle = 0;
  }

  #alive() {
    if (!this.#handle) throw new Error("this film has been disposed of");
  }
  #eval(targets, times, one, text = false) {
    this.#alive();
    const when = times.map((t) => (typeof t === "number" ? `${t}s` : String(t)));
    const words = this.#engine.call("betwixt_eval", this.#handle, targets.join("\n"), when.join("\n"), one);
    const said = JSON.parse(words);
    if (said.error) throw new Error(said.error);
    return text ? words : said;
  }
}

class Engine {
  #module;
  #canvas = null;
  #lost = false;
  #reader = null;
  #coming = null;
  #files = {};  // of the film that is being opened

  constructor(module) {
    this.#module = module;
    module.makeCanvas = () => this.#make_canvas();
    module.readApart = (task, path) => this.#read_apart(task, path);
    module.FS.mkdir("/film");
    module.FS.mkdir("/fonts");
    module.FS.chdir("/film");
    this.version = this.call("betwixt_version");
    this.algebra = algebraOf((...all) => this.call(...all));
  }

  // Brings what reads such files where it is not there yet: meshes, scenes, drawings, pictures.
  async prepare(files) {
    if (this.#reader || Object.keys(files).every((path) => /\.(bx|ttf|otf|ttc)$/i.test(path))) return;
    this.#coming ??= reader().finally(() => (this.#coming = null));
    this.#reader = await this.#coming;
  }

  // A film of a script. `files`: what lies beside it, bytes by path; fonts (.ttf, .otf) wherever they lie.
  open(text, { name = "film.bx", files = {} } = {}) {
    const { FS } = this.#module;
    const written = [];
    const put = (path, content) => {
      const parts = path.split("/").filter((p) => p && p !== "." && p !== "..");
      for (let i = 1; i < parts.length; ++i) {
        const folder = "/film/" + parts.slice(0, i).join("/");
        if (!FS.analyzePath(folder).exists) FS.mkdir(folder);
      }
      FS.writeFile("/film/" + parts.join("/"), content);
      written.push("/film/" + parts.join("/"));
    };
    for (const [path, bytes] of Object.entries(files)) {
      if (/\.(ttf|otf|ttc)$/i.test(path)) this.#add_font(path, bytes);
      else put(path, bytes);
    }
    put(name, text);
    this.#files = files;
    try {
      return new Film(this, this.call("betwixt_open", name, false));
    } finally {
      for (const path of written) FS.unlink(path);
      this.#files = {};
    }
  }

  // ---- for films

  // Calls a function of the engine; texts become texts. What it gives is a text, or with `false` at the end a handle.
  call(name, ...values) {
    const m = this.#module;
    const number = values.at(-1) === false && (values.pop(), true);
    const texts = [];
    const given = values.map((v) => {
      if (typeof v !== "string") return v;
      const size = m.lengthBytesUTF8(v) + 1, at = m._malloc(size);
      m.stringToUTF8(v, at, size);
      texts.push(at);
      return at;
    });
    try {
      const got = m["_" + name](...given);
      return number ? got : got ? m.UTF8ToString(got) : "";
    } catch (e) {
      throw e instanceof WebAssembly.RuntimeError || e?.name === "ExitStatus"
        ? new Error("the film took more than this page has: " + e.message, { cause: e })
        : e;
    } finally {
      for (const at of texts) m._free(at);
    }
  }
  // Makes the hidden canvas as large and draws; what stands against it becomes an Error.
  picture(width, height, draw) {
    if (this.#lost) {
      this.#lost = false;
      this.#canvas = null;
      this.call("betwixt_forget_graphics");
    }
    const canvas = this.#canvas ?? this.#make_canvas();
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    const why = draw();
    if (why) throw new Error(why);
  }
  hand_over(kind, width, height) {
    if (kind.transferFromImageBitmap) return kind.transferFromImageBitmap(this.#canvas.transferToImageBitmap());
    kind.clearRect(0, 0, width, height);
    kind.drawImage(this.#canvas, 0, 0);
  }

  // The files that were asked for on the way, a line each; what was read is put where apart.cpp finds it.
  #read_apart(task, path) {
    if (!this.#reader) return null;
    const { FS, UTF8ToString, stringToUTF8, lengthBytesUTF8, _malloc, _free } = this.#reader;
    const written = [];
    try {
      for (const [file, bytes] of Object.entries(this.#files)) {
        const at = "/film/" + file;
        FS.mkdirTree(at.slice(0, at.lastIndexOf("/")));
        FS.writeFile(at, bytes);
        written.push(at);
      }
      const size = lengthBytesUTF8(path) + 1, at = _malloc(size);
      stringToUTF8(path, at, size);
      const asked = UTF8ToString(this.#reader._betwixt_parse(task, at));
      _free(at);
      this.#module.FS.writeFile("/handed", FS.readFile("/handed"));
      for (const file of written) FS.unlink(file);
      return asked;
    } catch {
      this.#reader = null;  // what it was at is broken, and so is it
      this.#module.FS.writeFile("/handed", "");
      return "";
    }
  }
  #make_canvas() {
    if (this.#canvas) return this.#canvas;
    const canvas = globalThis.OffscreenCanvas ? new OffscreenCanvas(16, 16) : document.createElement("canvas");
    canvas.addEventListener("webglcontextlost", () => (this.#lost = true));
    return (this.#canvas = canvas);
  }
  #add_font(path, bytes) {
    const at = "/fonts/" + path.replace(/[^\w.-]/g, "_");
    if (this.#module.FS.analyzePath(at).exists) return;
    this.#module.FS.writeFile(at, bytes);
    this.call("betwixt_add_font", at, false);
  }
}

const reader = async () => {
  const module = await makeReader({ wasmBinary: await wasmBytes("betwixt-reader"), print() {}, printErr() {} });
  module.FS.mkdir("/film");
  module.FS.chdir("/film");
  return module;
};

let only = null;
// The engine of this page, made when it is first asked for. Errors: in plain words, where it cannot be had.
Betwixt.engine = () =>
  (only ??= (async () => {
    if (typeof WebAssembly !== "object") throw new Error("this browser cannot run the engine: it has no WebAssembly");
    const module = await makeBetwixt({ wasmBinary: await wasmBytes("betwixt"), print() {}, printErr() {} });
    return new Engine(module);
  })().catch((e) => {
    only = null;
    throw e;
  }));
