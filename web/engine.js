// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The engine for pages: Betwixt.engine() returns the page's engine, engine.open(text) a film. It calls the functions of
// engine.cpp. The build wraps all parts of the player in one function. There `makeBetwixt` is Emscripten's, `wasmBytes(name)`
// returns a program, and `algebraOf` is in algebra.js.

const Betwixt = (globalThis.Betwixt ??= {});

class Film {
  #engine;
  #handle;
  #contexts = new WeakMap();

  constructor(engine, handle) {
    this.#engine = engine;
    this.#handle = handle;
    Object.assign(this, JSON.parse(engine.call("betwixt_about", handle)));
    this.duration = this.end - this.start;
  }

  // Draws the film at `seconds` in the size of the canvas. Throws without WebGL 2, or if drawing fails.
  draw(canvas, seconds) {
    this.#alive();
    const { width, height } = canvas;
    if (!width || !height) return;
    this.#engine.picture(width, height, () => this.#engine.call("betwixt_draw", this.#handle, seconds, width, height));
    const context = this.#contexts.get(canvas) ?? (canvas.getContext("bitmaprenderer") || canvas.getContext("2d"));
    this.#contexts.set(canvas, context);
    this.#engine.copy_to(context, width, height);
  }
  // Returns the value of a target at a time (seconds, or a text such as "24f") as `betwixt eval --json` gives it; with
  // `text`, as `betwixt eval` prints it.
  eval(target, time, { text = false } = {}) {
    return this.#eval([target], [time], 1)[text ? "text" : "value"];
  }
  // Returns the values of all targets at all times: the object that `betwixt eval --json` prints, or its text.
  evalAll(targets, times, { text = false } = {}) {
    return this.#eval(targets, times, 0, text);
  }
  // Returns the errors of procedures while pictures were drawn, in the form of `diagnostics`.
  problems() {
    this.#alive();
    return JSON.parse(this.#engine.call("betwixt_problems", this.#handle));
  }
  // Releases the graphics resources until the next draw.
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
    const result = JSON.parse(words);
    if (result.error) throw new Error(result.error);
    return text ? words : result;
  }
}

class Engine {
  #module;
  #canvas = null;
  #lost = false;
  #reader = null;
  #loading_reader = null;
  #files = {};  // of the film that is opening

  constructor(module) {
    this.#module = module;
    module.makeCanvas = () => this.#make_canvas();
    module.readInReader = (task, path) => this.#read_in_reader(task, path);
    module.FS.mkdir("/film");
    module.FS.mkdir("/fonts");
    module.FS.chdir("/film");
    this.version = this.call("betwixt_version");
    this.algebra = algebraOf((...all) => this.call(...all));
  }

  // Loads the reader of meshes, scenes, drawings and pictures if one of the files needs it.
  async prepare(files) {
    if (this.#reader || Object.keys(files).every((path) => /\.(bx|ttf|otf|ttc)$/i.test(path))) return;
    this.#loading_reader ??= reader().finally(() => (this.#loading_reader = null));
    this.#reader = await this.#loading_reader;
  }

  // Opens the film of a script. `files` has the bytes of its files by path, and fonts (.ttf, .otf) by any path.
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
      put(path, bytes);  // a script can name a font's file, too
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

  // ---- Used by Film

  // Calls a function of the engine, and converts texts. Returns a text, or with a last argument `false` a handle.
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
      const returned = m["_" + name](...given);
      return number ? returned : returned ? m.UTF8ToString(returned) : "";
    } catch (e) {
      throw e instanceof WebAssembly.RuntimeError || e?.name === "ExitStatus"
        ? new Error("the film took more than this page has: " + e.message, { cause: e })
        : e;
    } finally {
      for (const at of texts) m._free(at);
    }
  }
  // Resizes the hidden canvas and draws. Throws if drawing fails.
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
  // Copies the hidden canvas to the canvas of a context.
  copy_to(context, width, height) {
    if (context.transferFromImageBitmap) return context.transferFromImageBitmap(this.#canvas.transferToImageBitmap());
    context.clearRect(0, 0, width, height);
    context.drawImage(this.#canvas, 0, 0);
  }

  // Reads a file in the reader's module, and puts the result where apart.cpp finds it. Returns the paths of the files that
  // the reader asked for, a line each, or null without a reader.
  #read_in_reader(task, path) {
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
      const needed = UTF8ToString(this.#reader._betwixt_parse(task, at));
      _free(at);
      this.#module.FS.writeFile("/result", FS.readFile("/result"));
      for (const file of written) FS.unlink(file);
      return needed;
    } catch {
      this.#reader = null;  // a reader that failed is in an unknown state
      this.#module.FS.writeFile("/result", "");
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
  if (typeof makeReader === "undefined")
    throw new Error("this page reads no meshes, scenes, drawings and pictures, because its films had none when it was made");
  const module = await makeReader({ wasmBinary: await wasmBytes("betwixt-reader"), print() {}, printErr() {} });
  module.FS.mkdir("/film");
  module.FS.chdir("/film");
  return module;
};

let only = null;
// Returns the engine of this page; the first call makes it. Rejects with a readable message if that fails.
Betwixt.engine = () =>
  (only ??= (async () => {
    if (typeof WebAssembly !== "object") throw new Error("this browser cannot run the engine: it has no WebAssembly");
    const module = await makeBetwixt({ wasmBinary: await wasmBytes("betwixt"), print() {}, printErr() {} });
    return new Engine(module);
  })().catch((e) => {
    only = null;
    throw e;
  }));
