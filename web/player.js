// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// <betwixt-player> plays a film from its text, with the interface of <video>. It draws with the engine of engine.js; its
// look, its source and its controls are in the player_*.js. The build puts all together. docs/web.md explains how to use it.
if (globalThis.customElements && !customElements.get("betwixt-player")) {
  const longest_side = 4096;     // of a picture, in pixels
  const timeupdate_every = 250;  // ms, as videos do
  const tries_again = 1000;      // ms, after drawing failed
  const flags = ["autoplay", "loop", "controls", "muted", "stepped"];
  let upgrading = false;         // while elements that the page already has are defined
  const wants_calm = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

  const look = player_look();

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
    #size_rule = "";
    #film = null;         // the film that is shown
    #engine = null;
    #source = null;       // a FilmSource
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
    #poster_waits = true; // the poster is shown until the film plays or seeks
    #stage_size = [0, 0]; // in pixels of the page
    #drawn = {};
    #trouble = "";        // the error of the last draw
    #retry = 0;
    #controls;            // a PlayerControls

    constructor() {
      super();
      this.#root = this.attachShadow({ mode: "open", delegatesFocus: true });
      this.#root.append(player_insides());
      this.#root.adoptedStyleSheets = [look, this.#size];
      const part = (name) => this.#root.querySelector(name);
      this.#parts = {
        stage: part(".stage"), canvas: part("canvas"), poster: part("img"), wait: part(".wait"),
        controls: part(".controls"), play: part("[data-do=toggle]"), time: part("input"), clock: part(".clock"),
        speed: part("select"), full: part("[data-do=fullscreen]"), banner: part(".banner"), message: part(".message"),
      };
      this.#controls = new PlayerControls(this, this.#parts, {
        time: () => this.#time, moving: () => this.#moving(), stuck: () => this.#stuck(),
        frames_at: (time) => this.#frames_at(time), hold: () => this.#hold(),
      });
    }

    connectedCallback() {
      // Properties that were set before the element was defined hide the accessors, so set them again.
      for (const name of ["files", "script", "currentTime", "playbackRate", "src", ...flags])
        if (Object.hasOwn(this, name)) {
          const value = this[name];
          delete this[name];
          this[name] = value;
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
        this.#controls.stop();
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
        this.#poster_waits = false;
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
      this.#poster_waits = true;
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
        const source = await FilmSource.find(this, this.#given_text, this.#given_files, signal);
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
        const film = await source.open(this.#engine, signal);
        if (signal.aborted) film.dispose();
        else this.#use_film(film);
      } catch (error) {
        if (!signal.aborted) this.#fail(4, message_of(error));
      } finally {
        if (this.#loading === loading) this.#loading = null;
      }
    }

    // Opens a new text: at once, unless files must be fetched first.
    #open_again() {
      let film;
      try {
        film = this.#source.open_now(this.#engine);
      } catch (error) {
        this.#fail(3, message_of(error));
        return;
      }
      if (!this.#source.missing(film).length) {
        this.#use_film(film);
        return;
      }
      film.dispose();
      const loading = (this.#loading = new AbortController());
      this.#source.open(this.#engine, loading.signal)
        .then((film) => (loading.signal.aborted ? film.dispose() : this.#use_film(film)))
        .catch((error) => loading.signal.aborted || this.#fail(3, message_of(error)))
        .finally(() => this.#loading === loading && (this.#loading = null));
    }

    #use_film(film) {
      this.#network = 1;
      this.#diagnostics = film.diagnostics;
      this.#text_wrong = !film.ok;
      this.#message = film.message + this.#source.failed_files(film);
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
        this.#fire_notes(before, now);
      } else if (this.loop) {
        this.#set_clock(now - Math.floor(now / end) * end);
        for (const name of ["seeking", "timeupdate", "seeked"]) this.#fire(name);
      } else {
        this.#set_clock(now < 0 ? 0 : end);
        this.#fire_notes(before, this.#time);
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

    #fire_notes(before, now) {
      for (const note of this.#film.notes ?? []) {
        const at = note.seconds - this.#film.start;
        if (before < now ? at > before && at <= now : at < before && at >= now)
          this.#fire("note", { text: note.text, time: at });
      }
    }

    #seek(time) {
      this.#set_clock(clamp(time, 0, this.duration));
      this.#poster_waits = false;
      if (!this.#seeking) {
        this.#seeking = true;
        this.#fire("seeking");
      }
      if (!this.#visible || document.hidden) setTimeout(() => this.#end_seek());
      this.#update();
    }
    #end_seek() {
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
      this.#end_seek();
      this.#controls.show_time();
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
        this.#report_code_errors(film);
        if (!this.#trouble) return;
        this.#trouble = "";
        this.#show();
      } catch (error) {
        this.#cannot_draw(error);
      }
    }

    // Reports errors of the author's code, which appear only when frames are made.
    #report_code_errors(film) {
      if (this.#text_wrong) return;  // already reported; the film shown is the last good one
      const found = film.problems();
      if (found.length + film.diagnostics.length === this.#diagnostics.length) return;
      this.#diagnostics = [...film.diagnostics, ...found];
      this.#fire("diagnostics", { diagnostics: this.#diagnostics });
      this.#show();
    }

    // Tries again later: a graphics context can be lost when a machine sleeps or is overloaded.
    #cannot_draw(error) {
      const words = message_of(error);
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
      if (this.#size_rule !== rule) this.#size.replaceSync((this.#size_rule = rule));
    }
    #show_poster() { this.#parts.poster.hidden = !(this.#poster_waits && this.poster && !this.#error); }

    #show() {
      const { message, banner, wait, stage, canvas, full } = this.#parts;
      const text = this.#error ? this.#error.message : this.#trouble && !this.#drawn.count ? this.#trouble : "";
      const source = this.#source ? this.#source.name : "";
      message.hidden = !text;
      if (text) this.#show_message(text);
      const wrong = this.#diagnostics.find((d) => d.severity === "error");
      banner.hidden = !!text || !wrong || this.hasAttribute("editing");
      if (!banner.hidden) banner.textContent = `line ${wrong.line}: ${wrong.text}`;
      wait.hidden = !(this.#network === 2 && !this.#film) || !!text;
      const words = this.alt || first_comment(this.script) || (source && `the film ${source}`) || "a film";
      stage.setAttribute("aria-label", this.getAttribute("aria-label") || `Film: ${source || words}`);
      canvas.setAttribute("aria-label", words);
      full.hidden = !document.fullscreenEnabled;
      this.#controls.show();
    }

    #show_message(text) {
      const { message } = this.#parts;
      const broken = this.#error && this.#error.code === 3;
      message.replaceChildren();
      const head = document.createElement("strong"), words = document.createElement("pre");
      head.textContent = broken ? "This film has errors" : "This film cannot be shown";
      words.textContent = text.trim();
      message.append(head, words);
      if (broken) return;
      const again = document.createElement("button");
      again.type = "button";
      again.textContent = "Try again";
      again.addEventListener("click", () => this.load());
      message.append(again);
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
