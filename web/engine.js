// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The engine for pages: Betwixt.engine() returns the page's engine, engine.open(text) a film. It calls the functions of
// engine.cpp. The build wraps all parts of the player in one function. There `makeBetwixt` is Emscripten's, `wasmBytes(name)`
// returns a program, and `algebraOf` is in algebra.js.

const Betwixt = (globalThis.Betwixt ??= {});

// The fonts that only some films need, and the words in their scripts (web/put_together.py, src/app/web_page.cpp).
const some_fonts = { "betwixt-formulas": /\btex\b/, "betwixt-code": /\bcode\b/ };

// The parts of a path below the film's folder.
const parts_of = (path) => path.split("/").filter((p) => p && p !== "." && p !== "..");

class Film {
  changed = null;  // a function, called after each edit; its argument: whether the duration is another one
  #engine;
  #handle;
  #source;         // its name and its files, for the first edit
  #edited = false;
  #contexts = new WeakMap();

  constructor(engine, handle, source) {
    this.#engine = engine;
    this.#handle = handle;
    this.#source = source;
    this.#describe();
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
  // Replaces all events of a track. `times` are seconds, in order. `values` has a number for each, or two or three, row
  // after row: metres, radians, or sRGB from 0 to 1. `twerper` is the interpolation, such as "linear".
  setTrack(target, times, values, { twerper = "", ...others } = {}) {
    for (const name in others) throw new Error(`setTrack has no option '${name}'; it has 'twerper'`);
    const columns = [times, values].map((column) => Array.isArray(column) ? column.flat() : column ?? []);
    if (columns.some((column) => Array.prototype.some.call(column, (value) => typeof value !== "number")))
      throw new Error("setTrack needs lists of numbers: seconds, and values; a colour is three numbers from 0 to 1");
    const numbers = columns.map((column) => Float64Array.from(column));
    this.#edit(() => this.#engine.with_numbers(numbers, (...places) =>
      this.#engine.call("betwixt_set_track", this.#handle, target, twerper, ...places)));
  }
  // Returns the events of a track as setTrack takes them: { times, values, width }, `width` numbers for each time.
  trackNumbers(target) {
    this.#alive();
    const { at, count, width } = this.#answer(this.#engine.call("betwixt_track_numbers", this.#handle, target));
    const all = this.#engine.take_numbers(at, count * (1 + width));
    return { times: all.slice(0, count), values: all.slice(count), width };
  }
  // Takes back the last edit, or repeats the one that was taken back. Returns a line that names it.
  undo() { return this.#edit(() => this.#engine.call("betwixt_step", this.#handle, "undo")); }
  redo() { return this.#edit(() => this.#engine.call("betwixt_step", this.#handle, "redo")); }
  // The script, with all edits.
  get text() {
    this.#alive();
    return this.#engine.call("betwixt_text", this.#handle);
  }
  // Returns `count` samples of the film's sound from sample `first` of the film on, 48,000 a second: those of the sound
  // track that `betwixt render` writes, { left, right }.
  sound(first, count) {
    this.#alive();
    return this.#engine.mixed(this.#handle, first, count);
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

  #describe() {
    Object.assign(this, JSON.parse(this.#engine.call("betwixt_about", this.#handle)));
    this.duration = this.end - this.start;
  }
  #answer(words) {
    const result = JSON.parse(words);
    if (result.error) throw new Error(result.error);
    return result;
  }
  #edit(run) {
    this.#alive();
    const { name, files } = this.#source;
    if (!this.#edited) this.#engine.with_files(files, () => this.#engine.call("betwixt_begin_edits", this.#handle, name));
    this.#edited = true;
    const { said } = this.#answer(run()), { duration } = this;
    this.#describe();
    this.changed?.(this.duration !== duration);
    return said;
  }
  #alive() {
    if (!this.#handle) throw new Error("this film has been disposed of");
  }
  #eval(targets, times, one, text = false) {
    this.#alive();
    const when = times.map((t) => (typeof t === "number" ? `${t}s` : String(t)));
    const words = this.#engine.call("betwixt_eval", this.#handle, targets.join("\n"), when.join("\n"), one);
    const result = this.#answer(words);
    return text ? words : result;
  }
}

class Engine {
  #module;
  #canvas = null;
  #lost = false;
  #reader = null;
  #loading_reader = null;
  #fonts = {};  // those of some_fonts that are loaded, or loading
  #files = {};  // of the film that is opening
  #sounds = new DecodedSounds(this);

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

  // Loads what only some films need: the reader of meshes, scenes, drawings and pictures, and the fonts of formulas and
  // of code. Decodes sounds.
  async prepare(files, text = "") {
    await Promise.all([this.#needs_reader(files) && this.#load_reader(), this.#sounds.decode(files),
                       ...this.#needed_fonts(files, text).map((name) => (this.#fonts[name] ??= this.#load_font(name)))]);
  }
  // Returns whether a film can be opened without loading anything.
  is_prepared(files, text) {
    return !this.#needs_reader(files) && !this.#sounds.lacks(files) && !this.#needed_fonts(files, text).length;
  }

  #needs_reader(files) {
    const plain = /\.(bx|ttf|otf|ttc|po|csv|tsv|txt|words|vtt|srt)$/i;
    return !this.#reader && Object.keys(files).some((path) => !plain.test(path) && !is_sound(path));
  }
  // The word may stand in a comment; then the font is loaded for nothing.
  #needed_fonts(files, text) {
    const scripts = [text, ...Object.entries(files).filter(([path]) => /\.bx$/i.test(path)).map(([, held]) =>
      typeof held === "string" ? held : new TextDecoder().decode(held))];
    return Object.keys(some_fonts).filter((name) =>
      this.#fonts[name] !== true && scripts.some((script) => some_fonts[name].test(script)));
  }
  async #load_reader() {
    this.#loading_reader ??= reader().finally(() => (this.#loading_reader = null));
    this.#reader = await this.#loading_reader;
  }
  async #load_font(name) {
    try {
      this.#add_font(`${name}.otf`, new Uint8Array(await wasmBytes(name)));
      this.#fonts[name] = true;
    } catch (error) {
      delete this.#fonts[name];
      throw error;
    }
  }

  // Opens the film of a script. `files` has the bytes of its files by path, and fonts (.ttf, .otf) by any path. `lets`
  // has other values for its lets, `language` the path of a catalogue of its texts ("": as they are written).
  open(text, { name: given = "film.bx", files = {}, lets = {}, language = null } = {}) {
    const name = parts_of(given).join("/");  // absolute paths of Node too
    for (const [path, bytes] of Object.entries(files)) if (/\.(ttf|otf|ttc)$/i.test(path)) this.#add_font(path, bytes);
    for (const [of, value] of Object.entries(lets)) this.call("betwixt_let", of, String(value));
    if (language !== null) this.call("betwixt_language", language);
    return this.with_files({ ...files, [name]: text },
                           () => new Film(this, this.call("betwixt_open", name, false), { name, files }));
  }

  // ---- Used by Film

  // Calls a function while these files are in the film's folder.
  with_files(files, run) {
    const { FS } = this.#module;
    const written = [];
    const put = (path, content) => {
      const parts = parts_of(path);
      for (let i = 1; i < parts.length; ++i) {
        const folder = "/film/" + parts.slice(0, i).join("/");
        if (!FS.analyzePath(folder).exists) FS.mkdir(folder);
      }
      FS.writeFile("/film/" + parts.join("/"), content);
      written.push("/film/" + parts.join("/"));
    };
    for (const [path, content] of Object.entries(files)) put(path, content);
    this.#files = files;
    this.#sounds.give(files);
    try {
      return run();
    } finally {
      for (const path of written) FS.unlink(path);
      this.#files = {};
      this.#sounds.give_none();
    }
  }
  add_sound(number, trouble, stereo) {
    const m = this.#module, at = m._malloc(stereo.byteLength + 8);
    if (!at) throw new Error("there is no memory left");
    m.HEAPF32.set(stereo, at / 4);
    this.call("betwixt_add_sound", number, trouble, at, stereo.length / 2);
    m._free(at);
  }
  mixed(film, first, count) {
    const at = this.call("betwixt_mix", film, first, count, false) / 4, { HEAPF32 } = this.#module;
    const left = new Float32Array(count), right = new Float32Array(count);
    for (let i = 0; i < count; ++i) left[i] = HEAPF32[at + 2 * i], right[i] = HEAPF32[at + 2 * i + 1];
    return { left, right };
  }
  // Calls a function with the address and the length of each of these columns in the engine's memory.
  with_numbers(columns, run) {
    const m = this.#module, places = [];
    try {
      for (const column of columns) {
        const at = m._malloc(column.byteLength + 8);
        if (!at) throw new Error("there is no memory left");
        places.push(at, column.length);
        m.HEAPF64.set(column, at / 8);
      }
      return run(...places);
    } finally {
      for (let i = 0; i < places.length; i += 2) m._free(places[i]);
    }
  }
  // Returns numbers from the engine's memory, and frees them there.
  take_numbers(at, count) {
    const taken = this.#module.HEAPF64.slice(at / 8, at / 8 + count);
    this.#module._free(at);
    return taken;
  }
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
      if (path.startsWith("/tmp/")) FS.writeFile(path, this.#module.FS.readFile(path)), written.push(path);  // videos.cpp
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
    const lost = waiting_canvas?.getContext("webgl2")?.isContextLost();
    const canvas = lost || !waiting_canvas ? new_canvas() : waiting_canvas;
    waiting_canvas = null;
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

// Makes a hidden canvas with its context. graphics.cpp asks for the same attributes, and so gets this context.
const new_canvas = () => {
  const canvas = globalThis.OffscreenCanvas ? new OffscreenCanvas(16, 16) : document.createElement("canvas");
  const context = canvas.getContext("webgl2", { alpha: true, depth: false, stencil: false, antialias: false,
                                                premultipliedAlpha: true, preserveDrawingBuffer: false });
  if (context) trust_shaders(context);
  return canvas;
};
// Does not wait for the answer whether a shader could be compiled: if not, its program cannot be linked, and that is asked.
const trust_shaders = (context) => {
  const { getShaderParameter, getProgramInfoLog } = context;
  context.getShaderParameter = (shader, what) =>
    what === context.COMPILE_STATUS || getShaderParameter.call(context, shader, what);
  context.getProgramInfoLog = (program) =>
    [getProgramInfoLog.call(context, program),
     ...(context.getAttachedShaders(program) ?? []).map((shader) => context.getShaderInfoLog(shader))].join(" ").trim();
};
let waiting_canvas = null;  // made before the engine

const reader = async () => {
  if (typeof makeReader === "undefined")
    throw new Error("this page reads no meshes, scenes, drawings and pictures, because its films had none when it was made");
  const module = await makeReader({ wasmBinary: await wasmBytes("betwixt-reader"), print() {}, printErr() {} });
  module.FS.mkdir("/film");
  module.FS.chdir("/film");
  return module;
};

let only = null;
// Returns the engine of this page; the first call makes it. Rejects with a readable message if that fails. `draws`: begins
// the graphics at once, before the browser is busy with the page's first picture of itself.
Betwixt.engine = ({ draws = false } = {}) =>
  (only ??= (async () => {
    if (typeof WebAssembly !== "object") throw new Error("this browser cannot run the engine: it has no WebAssembly");
    if (draws) waiting_canvas ??= new_canvas();
    const module = await makeBetwixt({ wasmBinary: await wasmBytes("betwixt"), print() {}, printErr() {} });
    return new Engine(module);
  })().catch((e) => {
    only = null;
    throw e;
  }));
