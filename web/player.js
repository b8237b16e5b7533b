// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// <betwixt-player> plays a film from its text, with the interface of <video>. It draws with the engine of engine.js; the
// build puts both together. docs/web.md explains how to use it.
if (globalThis.customElements && !customElements.get("betwixt-player")) {
  const longest_side = 4096;     // of a picture, in pixels
  const timeupdate_every = 250;  // ms, as videos do
  const tries_again = 1000;      // ms, after drawing failed
  const flags = ["autoplay", "loop", "controls", "muted", "stepped"];
  const speeds = [-2, -1, -0.5, 0.25, 0.5, 1, 1.5, 2, 4];
  let upgrading = false;         // while elements that the page already has are defined
  const script_query = 'script[type="text/betwixt"]';
  const files_query = 'script[type="application/json"][data-betwixt-files]';

  const text_of = (script) =>
    script.textContent.replace(/^\r?\n/, "").replace(/<\\(\\*(?:\/script|script|!--))/gi, "<$1");
  const bytes_of = (base64) => {
    const held = atob(base64), bytes = new Uint8Array(held.length);  // a loop: Uint8Array.from takes ten times as long
    for (let i = 0; i < held.length; ++i) bytes[i] = held.charCodeAt(i);
    return bytes;
  };
  const as_bytes = (held) =>
    typeof held === "string" ? new TextEncoder().encode(held)
    : ArrayBuffer.isView(held) ? new Uint8Array(held.buffer, held.byteOffset, held.byteLength)
    : new Uint8Array(held);
  const clamp = (x, low, high) => Math.min(Math.max(x, low), high);
  const has_words = (error) => (error && error.message) || String(error);
  const wants_calm = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

  // Returns the first comment of a script, without the file name in front.
  const first_comment = (script) => {
    const said = [];
    for (const line of script.split("\n")) {
      const words = line.match(/^\s*#\s?(.*)$/);
      if (!words) break;
      said.push(words[1].trim());
    }
    return said.join(" ").replace(/^[\w.-]+\.bx\s*[—:-]+\s*/, "").trim();
  };

  // Returns the URL of a file, or null if it is not in the script's folder or below it.
  const below = (base, path) => {
    const url = new URL(path.split("/").map(encodeURIComponent).join("/"), base);
    return url.href.startsWith(base.href) ? url : null;
  };
  const folder_of = (url) => {
    const folder = new URL(".", url);
    folder.search = folder.hash = "";
    return folder;
  };

  async function fetched(url, signal) {
    if (url.protocol === "file:")
      throw new Error(
        `A page that was opened from a disk may not read ${url.pathname.split("/").pop()}.\n` +
          "betwixt web FILE -o page.html makes a page that holds its film and plays anywhere; " +
          "or serve this folder: python3 -m http.server");
    let answer;
    try {
      answer = await fetch(url, { signal });
    } catch (error) {
      if (signal.aborted) throw error;
      throw new Error(`${url} cannot be fetched: ${has_words(error)}`);
    }
    if (!answer.ok) throw new Error(`${url} cannot be fetched: the server answered ${answer.status}`);
    return new Uint8Array(await answer.arrayBuffer());
  }

  const icons = {
    play: "M6 4l14 8-14 8z",
    pause: "M6 4h4v16H6zM14 4h4v16h-4z",
    again: "M12 5a7 7 0 1 1-6.7 5l2.9.9A4 4 0 1 0 12 8v4L6 6.5 12 1z",
    full: "M4 4h7v2H6v5H4zM13 18h5v-5h2v7h-7z",
    small: "M9 4h2v7H4V9h5zM13 13h7v2h-5v5h-2z",
  };

  const look = sheet(`
:host { display: block; position: relative; aspect-ratio: 16 / 9; max-width: 100%;
  min-height: 2rem; overflow: hidden; background: var(--betwixt-letterbox, #000); color: #fff;
  font: var(--betwixt-font, 14px/1.4 system-ui, sans-serif); }
:host([hidden]) { display: none; }
:host(:fullscreen) { max-width: none; aspect-ratio: auto !important; }
.stage { position: absolute; inset: 0; display: grid; place-items: center; outline: none; }
.stage > canvas, .stage > img { grid-area: 1 / 1; max-width: 100%; max-height: 100%; }
.stage > img { width: 100%; height: 100%; object-fit: contain; z-index: 1; }
[hidden] { display: none !important; }
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
  const insides = () => element("div", { class: "stage", part: "stage", tabindex: "-1", role: "group" },
    element("canvas", { part: "picture", role: "img", width: 1, height: 1 }),
    element("img", { part: "poster", alt: "", hidden: "" }),
    element("span", { class: "wait", part: "wait", hidden: "" }, "loading …"),
    element("div", { class: "controls", part: "controls", hidden: "" },
      element("button", { part: "button play", type: "button", "data-do": "toggle" }),
      element("input", { part: "time", type: "range", min: 0, max: 1, step: "any", value: 0, "aria-label": "Time" }),
      element("span", { class: "clock", part: "clock", "aria-hidden": "true" }),
      element("select", { part: "speed", "aria-label": "Speed" }),
      element("button", { part: "button fullscreen", type: "button", "data-do": "fullscreen" })),
    element("div", { class: "banner", part: "banner", role: "status", hidden: "" }),
    element("div", { class: "message", part: "message", role: "alert", hidden: "" }));

  class BetwixtPlayer extends HTMLElement {
    static observedAttributes = ["src", "controls", "poster", "autoplay", "playbackrate", "alt", "width", "height",
                                 "editing", "stepped"];

    static NETWORK_EMPTY = 0;
    static NETWORK_IDLE = 1;
    static NETWORK_LOADING = 2;
    static NETWORK_NO_SOURCE = 3;
    static HAVE_NOTHING = 0;
    static HAVE_METADATA = 1;
    static HAVE_CURRENT_DATA = 2;
    static HAVE_FUTURE_DATA = 3;
    static HAVE_ENOUGH_DATA = 4;

    // ---- Shared by all players of a page

    // One loop for all players. It runs while a visible picture may change.
    static #awake = new Set();
    static #due = 0;
    static #wake(player) {
      this.#awake.add(player);
      this.#due ||= requestAnimationFrame(() => this.#beat());
    }
    static #beat() {
      this.#due = 0;
      const now = [...this.#awake];
      this.#awake.clear();
      for (const player of now)
        if (player.isConnected && player.#step()) this.#wake(player);
    }

    static #seen = new IntersectionObserver((all) => {
      for (const one of all) one.target.#see(one.isIntersecting);
    });
    static #near = new IntersectionObserver((all) => {
      for (const one of all)
        if (one.isIntersecting) one.target.#comes_near();
    }, { rootMargin: "100% 25%" });
    static #sizes = new ResizeObserver((all) => {
      for (const one of all) one.target.getRootNode().host.#measure(one.contentRect);
    });
    // Redraws on another screen or another zoom: the size on the page stays, but the number of screen pixels changes.
    static #all = new Set();
    static #watch_pixels() {
      matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener("change", () => {
        for (const player of this.#all) this.#wake(player);
        this.#watch_pixels();
      }, { once: true });
    }
    static { this.#watch_pixels(); }

    // ---- State

    #root;
    #parts;
    #size = sheet();      // its size and its background
    #said_size = "";
    #film = null;         // the film that is shown
    #engine = null;
    #source = null;       // {text, name, base, files, failed}
    #given_text = null;   // set by `script`; overrides the page's text
    #given_files = {};    // set by `files`
    #text_wrong = false;
    #diagnostics = [];
    #message = "";
    #error = null;
    #loading = null;      // an AbortController
    #network = 0;
    #ready = 0;
    #paused = true;
    #may_autoplay = true;
    #time = 0;            // seconds since the film's beginning, when the clock was last set
    #wall = 0;            // the real time of that
    #begin = 0;           // start time that was set before there was a film
    #rate = 1;
    #seeking = false;
    #held = null;         // an AbortController: the slider is dragged, and the clock waits
    #visible = false;
    #pulse = 0;
    #updated = 0;
    #promises = [];
    #posing = true;       // the poster is shown until the film plays or seeks
    #stage_size = [0, 0]; // in pixels of the page
    #drawn = {};
    #trouble = "";        // the error of the last draw
    #retry = 0;
    #quiet_timer = 0;
    #spoken = 0;

    constructor() {
      super();
      this.#root = this.attachShadow({ mode: "open", delegatesFocus: true });
      this.#root.append(insides());
      this.#root.adoptedStyleSheets = [look, this.#size];
      const part = (name) => this.#root.querySelector(name);
      this.#parts = {
        stage: part(".stage"), canvas: part("canvas"), poster: part("img"), wait: part(".wait"),
        controls: part(".controls"), play: part("[data-do=toggle]"), time: part("input"), clock: part(".clock"),
        speed: part("select"), full: part("[data-do=fullscreen]"), banner: part(".banner"), message: part(".message"),
      };
      this.#listen();
    }

    connectedCallback() {
      // Properties that were set before the element was defined hide the accessors, so set them again.
      for (const name of ["files", "script", "currentTime", "playbackRate", "src", ...flags])
        if (Object.hasOwn(this, name)) {
          const said = this[name];
          delete this[name];
          this[name] = said;
        }
      BetwixtPlayer.#seen.observe(this);
      BetwixtPlayer.#near.observe(this);
      BetwixtPlayer.#sizes.observe(this.#parts.stage);
      BetwixtPlayer.#all.add(this);
      this.#show_attributes();
      // The place of an existing element is known at once, without waiting for an observer.
      const { top, bottom } = upgrading || document.readyState !== "loading" ? this.getBoundingClientRect() : { top: Infinity };
      this.#visible = top < innerHeight && bottom > 0;
      if (this.loading === "eager" || (top < 2 * innerHeight && bottom > -innerHeight)) this.#comes_near();
    }

    // A player that is only moved in the page is connected again before the microtask.
    disconnectedCallback() {
      queueMicrotask(() => {
        if (this.isConnected) return;
        BetwixtPlayer.#seen.unobserve(this);
        BetwixtPlayer.#near.unobserve(this);
        BetwixtPlayer.#sizes.unobserve(this.#parts.stage);
        BetwixtPlayer.#all.delete(this);
        BetwixtPlayer.#awake.delete(this);
        this.#visible = false;
        this.#let_go();
        this.pause();
        clearTimeout(this.#retry);
        clearTimeout(this.#quiet_timer);
        this.#begin = this.currentTime;
        this.#forget();
      });
    }

    attributeChangedCallback(name, before, now) {
      if (before === now) return;
      if (name === "src") {
        if (this.#network !== 0) this.load();
        else if (this.isConnected) BetwixtPlayer.#near.unobserve(this), BetwixtPlayer.#near.observe(this);
      } else if (name === "playbackrate") {
        if (now !== null && Number.isFinite(Number(now))) this.playbackRate = Number(now);
      } else if (name === "autoplay") {
        this.#autoplay();
      } else {
        this.#show_attributes();
      }
    }

    // ---- As a video

    get src() { return this.hasAttribute("src") ? new URL(this.getAttribute("src"), document.baseURI).href : ""; }
    set src(url) { this.setAttribute("src", url); }
    get currentSrc() { return (this.#source && this.#source.url) || ""; }
    get poster() { return this.hasAttribute("poster") ? new URL(this.getAttribute("poster"), document.baseURI).href : ""; }
    set poster(url) { this.setAttribute("poster", url); }
    get alt() { return this.getAttribute("alt") ?? ""; }
    set alt(text) { this.setAttribute("alt", text); }
    get preload() { return this.getAttribute("preload") ?? "auto"; }
    set preload(word) { this.setAttribute("preload", word); }
    get loading() { return this.getAttribute("loading") === "eager" ? "eager" : "lazy"; }
    set loading(word) { this.setAttribute("loading", word); }
    get width() { return Number.parseInt(this.getAttribute("width"), 10) || 0; }
    set width(pixels) { this.setAttribute("width", pixels); }
    get height() { return Number.parseInt(this.getAttribute("height"), 10) || 0; }
    set height(pixels) { this.setAttribute("height", pixels); }

    get error() { return this.#error; }
    get networkState() { return this.#network; }
    get readyState() { return this.#ready; }
    get paused() { return this.#paused; }
    get seeking() { return this.#seeking; }
    get ended() { return this.#ready > 0 && this.#rate >= 0 && !this.loop && this.#time >= this.duration; }
    get duration() { return this.#film ? this.#frames / this.#film.fps : NaN; }
    get videoWidth() { return this.#film ? this.#film.width : 0; }
    get videoHeight() { return this.#film ? this.#film.height : 0; }

    get currentTime() { return this.#ready > 0 ? clamp(this.#now(), 0, this.duration) : this.#begin; }
    set currentTime(seconds) {
      seconds = Number(seconds);
      if (!Number.isFinite(seconds)) throw new TypeError("currentTime is a number of seconds");
      if (this.#ready > 0) this.#seek(seconds);
      else this.#begin = seconds;
    }

    get playbackRate() { return this.#rate; }
    set playbackRate(rate) {
      rate = Number(rate);
      if (!Number.isFinite(rate)) throw new TypeError("playbackRate is a number");
      if (rate === this.#rate) return;
      this.#set_clock(this.currentTime);
      this.#rate = rate;
      this.#fire("ratechange");
      this.#update();
    }

    play() {
      if (this.#error) return Promise.reject(new DOMException(this.#error.message, "NotSupportedError"));
      this.#may_autoplay = false;
      if (this.ended) this.#seek(0);
      const promise = new Promise((resolve, reject) => this.#promises.push({ resolve, reject }));
      promise.catch(() => {});  // callers may ignore the promise
      if (this.#paused) {
        this.#set_clock(this.#time);
        this.#paused = false;
        this.#posing = false;
        this.#fire("play");
        this.#fire(this.#ready > 2 ? "playing" : "waiting");
      }
      if (this.#ready > 2) this.#settle();
      else if (this.#network === 0) this.#load_source();
      this.#update();
      return promise;
    }

    pause() {
      this.#may_autoplay = false;
      if (this.#paused) return;
      if (this.#ready > 0) this.#set_clock(this.currentTime);
      this.#paused = true;
      this.#fire("timeupdate");
      this.#fire("pause");
      this.#settle(new DOMException("play() was interrupted by pause()", "AbortError"));
      this.#update();
    }

    // Starts again with the page's own source.
    load() {
      this.#settle(new DOMException("play() was interrupted by load()", "AbortError"));
      const was_there = this.#network !== 0;
      this.#forget();
      this.#given_text = null;
      this.#source = null;
      this.#error = null;
      this.#begin = 0;
      this.#posing = true;
      this.#may_autoplay = true;
      if (was_there) this.#fire("emptied");
      if (!this.#paused) this.#paused = true;
      this.#load_source();
    }

    getVideoPlaybackQuality() {
      return { creationTime: performance.now(), totalVideoFrames: this.#drawn.count ?? 0, droppedVideoFrames: 0 };
    }

    // ---- Of films

    get film() { return this.#film; }
    get diagnostics() { return this.#diagnostics; }
    get message() { return this.#message; }

    // Returns a value at a time since the film's beginning, as `betwixt eval --json` gives it.
    eval(target, time = this.currentTime) {
      if (!this.#film) throw new Error("there is no film yet: wait for loadedmetadata");
      return this.#film.eval(target, typeof time === "number" ? this.#film.start + time : time);
    }

    // The film's text. Setting it shows the new film at the same time; if it has errors, the last good film stays.
    get script() {
      if (this.#given_text !== null) return this.#given_text;
      const inline = this.#source || this.hasAttribute("src") ? null : this.querySelector(script_query);
      return this.#source ? this.#source.text : inline ? text_of(inline) : "";
    }
    set script(text) {
      if (this.#given_text === String(text)) return;
      this.#given_text = String(text);
      if (!this.#engine || !this.#source || this.#loading) {
        this.#load_source();
        return;
      }
      this.#source.text = this.#given_text;
      this.#open_again();
    }

    // The film's files by their names in the script: texts, Uint8Arrays or ArrayBuffers.
    get files() { return { ...(this.#source ? Object.fromEntries(this.#source.files) : this.#given_files) }; }
    set files(all) {
      this.#given_files = {};
      for (const [name, held] of Object.entries(all ?? {})) this.#given_files[name] = as_bytes(held);
      if (this.#source && this.#engine && !this.#loading) {
        this.#source.files = new Map(Object.entries(this.#given_files));
        this.#open_again();
      }
    }

    // ---- The source

    #comes_near() {
      BetwixtPlayer.#near.unobserve(this);
      if (this.#network === 0 && this.preload !== "none") this.#load_source();
    }

    #inline_files() {
      const found = {};
      const all = [...document.querySelectorAll(files_query)].filter(
        (script) => this.contains(script) || !script.closest("betwixt-player"));
      for (const script of all)
        for (const [name, held] of Object.entries(JSON.parse(script.textContent))) found[name] = bytes_of(held);
      return found;
    }

    async #find_source(signal) {
      // The children exist once the page has been parsed.
      if (!this.hasAttribute("src") && this.#given_text === null && document.readyState === "loading")
        await new Promise((done) => document.addEventListener("DOMContentLoaded", done, { once: true, signal }));
      const inline = this.querySelector(script_query);
      const src = this.getAttribute("src");
      const here = { failed: [], base: folder_of(document.baseURI), name: "film.bx", url: "" };
      const held = { ...(src === null ? this.#inline_files() : {}), ...this.#given_files };
      here.files = new Map(Object.entries(held));
      if (inline && inline.dataset.name) here.name = inline.dataset.name;
      if (src !== null) {
        const url = new URL(src, document.baseURI);
        here.url = url.href;
        here.name = decodeURIComponent(url.pathname.split("/").pop()) || here.name;
        here.base = folder_of(url);
        here.text = this.#given_text ?? new TextDecoder().decode(await fetched(url, signal));
      } else if (this.#given_text !== null || inline) {
        here.text = this.#given_text ?? text_of(inline);
      } else {
        return null;
      }
      return here;
    }

    // Opens the film and fetches the files that it lacks, until no missing file can be fetched.
    async #open(signal) {
      const source = this.#source;
      for (const tried = new Set(); ;) {
        await this.#engine.prepare(Object.fromEntries(source.files));
        const film = this.#open_now();
        const missing = this.#missing(film).filter((path) => !tried.has(path));
        if (!missing.length) return film;
        film.dispose();
        await Promise.all(missing.map(async (path) => {
          tried.add(path);
          const url = below(source.base, path);
          if (!url) return;
          try {
            source.files.set(path, await fetched(url, signal));
          } catch (error) {
            if (signal.aborted) throw error;
            source.failed.push({ path, words: has_words(error) });
          }
        }));
      }
    }
    #open_now() {
      const { text, name, files } = this.#source;
      return this.#engine.open(text, { name, files: Object.fromEntries(files) });
    }
    #missing(film) {
      const { files, failed } = this.#source;
      return film.wants.filter((path) => !files.has(path) && !failed.some((f) => f.path === path));
    }

    async #load_source() {
      if (this.#loading) this.#loading.abort();
      const loading = (this.#loading = new AbortController());
      const { signal } = loading;
      this.#network = 2;
      this.#error = null;
      this.#fire("loadstart");
      this.#show();
      try {
        const engine = Betwixt.engine();  // loads in parallel with the source
        engine.catch(() => {});
        const source = await this.#find_source(signal);
        if (signal.aborted) return;
        if (!source) {
          this.#loading = null;
          this.#network = 0;
          this.#show();
          return;
        }
        this.#source = source;
        this.#engine = await engine;
        if (signal.aborted) return;
        const film = await this.#open(signal);
        if (signal.aborted) film.dispose();
        else this.#take(film);
      } catch (error) {
        if (!signal.aborted) this.#fail(4, has_words(error));
      } finally {
        if (this.#loading === loading) this.#loading = null;
      }
    }

    // Opens a new text: at once, unless files must be fetched first.
    #open_again() {
      let film;
      try {
        film = this.#open_now();
      } catch (error) {
        this.#fail(3, has_words(error));
        return;
      }
      if (!this.#missing(film).length) {
        this.#take(film);
        return;
      }
      film.dispose();
      const loading = (this.#loading = new AbortController());
      this.#open(loading.signal)
        .then((film) => (loading.signal.aborted ? film.dispose() : this.#take(film)))
        .catch((error) => loading.signal.aborted || this.#fail(3, has_words(error)))
        .finally(() => this.#loading === loading && (this.#loading = null));
    }

    #take(film) {
      this.#network = 1;
      this.#diagnostics = film.diagnostics;
      this.#text_wrong = !film.ok;
      this.#message = film.message + this.#failed_files(film);
      if (!film.ok) {
        film.dispose();
        if (this.#film) this.#show();
        else this.#fail(3, this.#message);
        this.#fire("diagnostics", { diagnostics: this.#diagnostics });
        return;
      }
      const before = this.#film, time = this.currentTime;
      const [width, height, duration] = [this.videoWidth, this.videoHeight, this.duration];
      this.#film = film;
      if (before) before.dispose();
      this.#error = null;
      this.#drawn.film = null;
      this.#show_size();
      this.#ready = 4;
      this.#set_clock(clamp(time, 0, this.duration));
      if (this.duration !== duration) this.#fire("durationchange");
      if (before && (this.videoWidth !== width || this.videoHeight !== height)) this.#fire("resize");
      if (!before) this.#first_film();
      this.#fire("diagnostics", { diagnostics: this.#diagnostics });
      this.#show();
      this.#update();
    }

    #first_film() {
      this.#begin = 0;
      this.#fire("resize");
      for (const name of ["loadedmetadata", "loadeddata", "canplay", "canplaythrough"]) this.#fire(name);
      if (!this.#paused) {
        this.#fire("playing");
        this.#settle();
      }
      this.#autoplay();
    }

    #failed_files(film) {
      const bad = this.#source.failed.filter((f) => film.wants.includes(f.path));
      return bad.length ? "\n" + bad.map((f) => f.words).join("\n") : "";
    }

    #autoplay() {
      if (!this.autoplay || !this.#may_autoplay || !this.#visible || this.#ready < 3 || wants_calm()) return;
      this.play();
    }

    #fail(code, message) {
      this.#error = { code, message };
      this.#network = code === 4 ? 3 : 1;
      this.#settle(new DOMException(message, "NotSupportedError"));
      if (!this.#paused) this.#paused = true;
      this.#fire("error");
      this.#show();
      this.#update();
    }

    // Releases the film, and keeps its source.
    #forget() {
      if (this.#loading) this.#loading.abort();
      this.#loading = null;
      if (this.#film) this.#film.dispose();
      this.#film = null;
      this.#drawn = {};
      this.#ready = 0;
      this.#network = 0;
      this.#seeking = false;
      this.#trouble = "";
      this.#time = 0;
      this.#update();
    }

    // ---- Time

    get #frames() { return Math.max(1, Math.floor(this.#film.lastFrame - this.#film.firstFrame + 1 + 1e-6)); }
    get #last() { return (this.#frames - 1) / this.#film.fps; }
    // Returns the number of whole frames before a time.
    #frames_at(time) { return clamp(Math.floor(time * this.#film.fps + 1e-6), 0, this.#frames - 1); }

    #moving() {
      return !this.#paused && !this.#held && this.#ready > 2 && this.#rate !== 0 && !this.#stuck();
    }
    // Whether the film is at the end of its direction, where a video stops, paused or not.
    #stuck() {
      return !this.loop && (this.#rate > 0 ? this.#time >= this.duration : this.#rate < 0 && this.#time <= 0);
    }
    #now() {
      if (!this.#moving() || this.#seeking) return this.#time;
      return this.#time + ((performance.now() - this.#wall) / 1000) * this.#rate;
    }
    #set_clock(time) {
      this.#time = time;
      this.#wall = performance.now();
    }

    #tick() {
      if (!this.#moving() || this.#seeking) return;
      const before = this.#time, now = this.#now(), end = this.duration;
      if (now >= 0 && now < end) {
        this.#set_clock(now);
        this.#say_notes(before, now);
      } else if (this.loop) {
        this.#set_clock(now - Math.floor(now / end) * end);
        for (const name of ["seeking", "timeupdate", "seeked"]) this.#fire(name);
      } else {
        this.#set_clock(now < 0 ? 0 : end);
        this.#say_notes(before, this.#time);
        this.#fire("timeupdate");
        this.#end();
        this.#update();
      }
    }
    // Stops the film at its end.
    #end() {
      if (this.#paused || this.#held || !this.ended || this.#rate <= 0) return;
      this.#paused = true;
      this.#fire("pause");
      this.#fire("ended");
    }

    #say_notes(before, now) {
      for (const note of this.#film.notes ?? []) {
        const at = note.seconds - this.#film.start;
        if (before < now ? at > before && at <= now : at < before && at >= now)
          this.#fire("note", { text: note.text, time: at });
      }
    }

    #seek(time) {
      this.#set_clock(clamp(time, 0, this.duration));
      this.#posing = false;
      if (!this.#seeking) {
        this.#seeking = true;
        this.#fire("seeking");
      }
      if (!this.#visible || document.hidden) setTimeout(() => this.#sought());
      this.#update();
    }
    #sought() {
      if (!this.#seeking) return;
      this.#seeking = false;
      this.#set_clock(this.#time);
      this.#fire("timeupdate");
      this.#fire("seeked");
      this.#end();
      this.#update();
    }

    // Makes the film wait while the slider is dragged.
    #hold() {
      if (this.#held) return;
      this.#set_clock(this.currentTime);
      this.#held = new AbortController();
      for (const name of ["pointerup", "pointercancel", "blur"])
        addEventListener(name, () => this.#let_go(), { capture: true, signal: this.#held.signal });
      this.#update();
    }
    #let_go() {
      if (!this.#held) return;
      this.#held.abort();
      this.#held = null;
      this.#set_clock(this.#time);
      if (!this.#seeking) this.#end();
      this.#update();
    }

    // Starts or stops the timer, and redraws, after any change of state.
    #update() {
      const moving = this.#moving();
      if (moving && !this.#pulse)
        this.#pulse = setInterval(() => {
          this.#tick();
          if (this.#moving()) this.#fire("timeupdate");
        }, timeupdate_every);
      if (!moving && this.#pulse) {
        clearInterval(this.#pulse);
        this.#pulse = 0;
      }
      this.#show_poster();
      BetwixtPlayer.#wake(this);
    }

    // Fires an event after the caller has finished, so that events keep their order.
    #fire(name, detail) {
      queueMicrotask(() => this.dispatchEvent(detail ? new CustomEvent(name, { detail }) : new Event(name)));
    }
    #settle(error) {
      const all = this.#promises.splice(0);
      queueMicrotask(() => all.forEach((p) => (error ? p.reject(error) : p.resolve())));
    }

    // ---- Pictures

    #see(visible) {
      this.#visible = visible;
      if (!visible) return;
      this.#autoplay();
      BetwixtPlayer.#wake(this);
    }

    #measure({ width, height }) {
      this.#stage_size = [width, height];
      this.#parts.stage.classList.toggle("narrow", width < 360);
      BetwixtPlayer.#wake(this);
    }

    // One step of the loop. Returns whether the player needs another.
    #step() {
      this.#tick();
      if (this.#film && this.#visible) this.#draw();
      this.#sought();
      this.#show_time();
      return this.#moving() && this.#visible;
    }

    // Draws as large as fits, in whole pixels of the screen.
    #draw() {
      const { canvas } = this.#parts, film = this.#film, drawn = this.#drawn, ratio = devicePixelRatio || 1;
      const [w, h] = this.#stage_size.map((side) => Math.round(side * ratio));
      if (w < 1 || h < 1) return;
      const scale = Math.min(w / film.width, h / film.height);
      const [wide, high] = [Math.round(film.width * scale), Math.round(film.height * scale)];
      const fills = w - wide <= 1 && h - high <= 1;
      const down = Math.min(1, longest_side / Math.max(w, h));
      const width = Math.max(1, Math.floor((fills ? w : wide) * down));
      const height = Math.max(1, Math.floor((fills ? h : high) * down));
      const time = Math.min(this.#time, this.#last);
      const seconds = film.start + (this.stepped ? this.#frames_at(time) / film.fps : time);
      if (drawn.film === film && drawn.seconds === seconds && drawn.width === width && drawn.height === height) return;
      try {
        if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
        canvas.style.width = fills ? "100%" : `${wide / ratio}px`;
        canvas.style.height = fills ? "100%" : `${high / ratio}px`;
        film.draw(canvas, seconds);
        this.#drawn = { film, seconds, width, height, count: (drawn.count ?? 0) + 1 };
        this.#hear_code(film);
        if (!this.#trouble) return;
        this.#trouble = "";
        this.#show();
      } catch (error) {
        this.#cannot_draw(error);
      }
    }

    // Reports errors of the author's code, which appear only when frames are made.
    #hear_code(film) {
      if (this.#text_wrong) return;  // already reported; the film shown is the last good one
      const found = film.problems();
      if (found.length + film.diagnostics.length === this.#diagnostics.length) return;
      this.#diagnostics = [...film.diagnostics, ...found];
      this.#fire("diagnostics", { diagnostics: this.#diagnostics });
      this.#show();
    }

    // Tries again later: a graphics context can be lost when a machine sleeps or is overloaded.
    #cannot_draw(error) {
      const words = has_words(error);
      if (this.#trouble !== words) {
        this.#trouble = words;
        this.#fire("error");
        this.#show();
      }
      clearTimeout(this.#retry);
      this.#retry = setTimeout(() => this.isConnected && BetwixtPlayer.#wake(this), tries_again);
    }

    // ---- Size, messages and controls

    #show_attributes() {
      const { controls, poster } = this.#parts;
      controls.hidden = !this.controls;
      this.#show_size();
      if (this.poster) poster.src = this.poster;
      this.#drawn.film = null;
      this.#show_poster();
      this.#show();
      BetwixtPlayer.#wake(this);
    }
    // Sets the size from the attributes until there is a film. A style of the page overrides it.
    #show_size() {
      const { width, height } = this.#film ?? this;
      const aspect = width && height ? `aspect-ratio: ${width} / ${height};` : "";
      const side = this.width ? `width: ${this.width}px;` : this.height ? `width: auto; height: ${this.height}px;` : "";
      // The page shows through a transparent film.
      const behind = this.#film?.clear ? "background: var(--betwixt-letterbox, transparent);" : "";
      const rule = `:host { ${aspect} ${side} ${behind} }`;
      if (this.#said_size !== rule) this.#size.replaceSync((this.#said_size = rule));
    }
    #show_poster() { this.#parts.poster.hidden = !(this.#posing && this.poster && !this.#error); }

    #show() {
      const { message, banner, wait, stage, canvas, full } = this.#parts;
      const said = this.#error ? this.#error.message : this.#trouble && !this.#drawn.count ? this.#trouble : "";
      const source = this.#source ? this.#source.name : "";
      message.hidden = !said;
      if (said) this.#show_message(said);
      const wrong = this.#diagnostics.find((d) => d.severity === "error");
      banner.hidden = !!said || !wrong || this.hasAttribute("editing");
      if (!banner.hidden) banner.textContent = `line ${wrong.line}: ${wrong.text}`;
      wait.hidden = !(this.#network === 2 && !this.#film) || !!said;
      const words = this.alt || first_comment(this.script) || (source && `the film ${source}`) || "a film";
      stage.setAttribute("aria-label", this.getAttribute("aria-label") || `Film: ${source || words}`);
      canvas.setAttribute("aria-label", words);
      full.hidden = !document.fullscreenEnabled;
      this.#show_controls();
    }

    #show_message(said) {
      const { message } = this.#parts;
      const broken = this.#error && this.#error.code === 3;
      message.replaceChildren();
      const head = document.createElement("strong"), words = document.createElement("pre");
      head.textContent = broken ? "This film has errors" : "This film cannot be shown";
      words.textContent = said.trim();
      message.append(head, words);
      if (broken) return;
      const again = document.createElement("button");
      again.type = "button";
      again.textContent = "Try again";
      again.addEventListener("click", () => this.load());
      message.append(again);
    }

    #show_controls() {
      if (!this.controls) return;
      const { controls, play, full, speed } = this.#parts;
      controls.hidden = !!this.#error;
      const at_rest = this.#paused || this.#stuck();
      const name = !at_rest ? "pause" : this.ended ? "again" : "play";
      this.#set_button(play, name, { play: "Play", pause: "Pause", again: "Play again" }[name]);
      const large = document.fullscreenElement === this;
      this.#set_button(full, large ? "small" : "full", large ? "Leave full screen" : "Full screen");
      const rates = [...new Set([...speeds, this.#rate])].sort((a, b) => a - b);
      if (speed.options.length !== rates.length)
        speed.replaceChildren(...rates.map((r) => new Option(`${r}×`.replace("-", "−"), r)));
      speed.value = String(this.#rate);
    }
    #set_button(button, name, words) {
      if (button.dataset.icon === name) return;
      button.dataset.icon = name;
      button.replaceChildren(drawing(icons[name]));
      button.setAttribute("aria-label", words);
      button.title = words;
    }

    #show_time() {
      if (!this.#film || !this.controls) return;
      const { time, clock } = this.#parts, now = this.#time, end = this.duration;
      const frame = this.#frames_at(now) + this.#film.firstFrame;
      time.max = end;
      time.value = now;
      time.style.setProperty("--at", `${(100 * now) / end}%`);
      clock.textContent = `${now.toFixed(1)} / ${end.toFixed(1)}`;
      clock.title = `frame ${frame} of ${this.#film.lastFrame}`;
      // A screen reader should not read every frame of a playing film.
      if (this.#moving() && performance.now() - this.#spoken < 1000) return;
      this.#spoken = performance.now();
      time.setAttribute("aria-valuetext", `frame ${frame} of ${this.#film.lastFrame}, ${now.toFixed(1)} seconds`);
    }

    // ---- Input

    #listen() {
      const { stage, time, speed, canvas, poster } = this.#parts;
      const shown = () => this.#show_controls();
      for (const name of ["play", "pause", "ended", "ratechange", "seeked", "timeupdate"])
        this.addEventListener(name, shown);
      this.addEventListener("fullscreenchange", shown);
      this.addEventListener("keydown", (event) => this.controls && this.#key(event));
      stage.addEventListener("click", (event) => {
        const button = event.target.closest("[data-do]");
        if (button && button.dataset.do === "toggle") this.#toggle();
        if (button && button.dataset.do === "fullscreen") this.#fullscreen();
      });
      for (const picture of [canvas, poster])
        picture.addEventListener("click", () => this.controls && this.#toggle());
      time.addEventListener("pointerdown", (event) => event.button === 0 && this.#hold());
      time.addEventListener("input", () => (this.currentTime = Number(time.value)));
      speed.addEventListener("change", () => (this.playbackRate = Number(speed.value)));
      for (const name of ["pointermove", "pointerdown", "focusin", "play", "pause"])
        this.addEventListener(name, () => this.#stir());
      stage.addEventListener("pointerleave", () => this.#rest());
    }

    // Hides the controls if the film plays and the pointer rests.
    #stir() {
      this.#parts.stage.classList.remove("idle");
      clearTimeout(this.#quiet_timer);
      this.#quiet_timer = setTimeout(() => this.#rest(), 2000);
    }
    #rest() { this.#parts.stage.classList.toggle("idle", this.#moving()); }

    #toggle() {
      if (this.#paused) {
        this.play();
      } else if (this.#stuck()) {
        this.playbackRate = -this.#rate;  // at an end, the only way is back
      } else {
        this.pause();
      }
    }
    #fullscreen() {
      if (document.fullscreenElement === this) document.exitFullscreen();
      else this.requestFullscreen?.().catch(() => {});
    }
    #by_frames(count) {
      if (!this.#film) return;
      this.pause();
      this.currentTime = (this.#frames_at(this.currentTime) + count) / this.#film.fps;
    }
    // As on an editing table: j runs backwards, l forwards, and again doubles the speed.
    #shuttle(way) {
      const faster = !this.#paused && Math.sign(this.#rate) === way;
      this.playbackRate = faster ? clamp(2 * this.#rate, -8, 8) : way;
      if (this.#paused && way < 0 && this.#time <= 0) this.currentTime = this.duration;
      this.play();
    }
    #speed(way) {
      const next = way > 0 ? speeds.find((s) => s > this.#rate) : speeds.findLast((s) => s < this.#rate);
      if (next !== undefined) this.playbackRate = next;
    }

    #key(event) {
      if (event.ctrlKey || event.altKey || event.metaKey || event.defaultPrevented) return;
      const at = event.composedPath()[0], key = event.key;
      const on_button = at.localName === "button", on_speed = at.localName === "select";
      if (on_button && (key === " " || key === "Enter")) return;
      if (on_speed && key !== "f") return;
      if (!this.#parts.stage.contains(at) && at !== this) return;  // an element that the page put inside
      const second = this.#film ? Math.round(this.#film.fps) : 1, by = event.shiftKey ? second : 1;
      const keys = {
        " ": () => this.#toggle(), k: () => this.#toggle(),
        ArrowRight: () => this.#by_frames(by), ArrowLeft: () => this.#by_frames(-by),
        ArrowUp: () => this.#by_frames(second), ArrowDown: () => this.#by_frames(-second),
        ".": () => this.#by_frames(1), ",": () => this.#by_frames(-1),
        Home: () => (this.currentTime = 0), End: () => (this.currentTime = this.duration || 0),
        j: () => this.#shuttle(-1), l: () => this.#shuttle(1),
        f: () => this.#fullscreen(), "+": () => this.#speed(1), "-": () => this.#speed(-1),
      };
      const act = keys[key.length === 1 ? key.toLowerCase() : key];
      if (!act) return;
      event.preventDefault();
      act();
    }
  }

  // Boolean attributes as properties.
  for (const name of flags)
    Object.defineProperty(BetwixtPlayer.prototype, name, {
      configurable: true,
      enumerable: true,
      get() { return this.hasAttribute(name); },
      set(on) { this.toggleAttribute(name, Boolean(on)); },
    });
  for (const name of ["HAVE_NOTHING", "HAVE_METADATA", "HAVE_CURRENT_DATA", "HAVE_FUTURE_DATA", "HAVE_ENOUGH_DATA",
                      "NETWORK_EMPTY", "NETWORK_IDLE", "NETWORK_LOADING", "NETWORK_NO_SOURCE"])
    Object.defineProperty(BetwixtPlayer.prototype, name, { value: BetwixtPlayer[name] });

  globalThis.Betwixt = globalThis.Betwixt ?? {};
  Betwixt.Player = BetwixtPlayer;
  upgrading = true;
  customElements.define("betwixt-player", BetwixtPlayer);
  upgrading = false;
}
