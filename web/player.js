// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// <betwixt-player> plays a film from its text, with the interface of <video>. It draws with the engine of engine.js; its
// look, its source and its controls are in the player_*.js. The build puts all together. docs/web.md explains how to use it.
if (globalThis.customElements && !customElements.get("betwixt-player")) {
  let upgrading = false;  // while elements that the page already has are defined
  const wants_calm = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

  const look = player_look(), page = player_loop();

  class BetwixtPlayer extends player_attributes() {
    static observedAttributes = ["src", "controls", "poster", "autoplay", "playbackrate", "alt", "width", "height",
                                 "editing", "stepped", "muted", "volume"];

    // ---- State

    #face;                // a PlayerFace
    #parts;
    #film = null;         // the film that is shown
    #loader;              // a FilmLoader
    #text_wrong = false;
    #diagnostics = [];
    #message = "";
    #error = null;
    #network = 0;
    #ready = 0;
    #may_autoplay = true;
    #clock;               // a FilmClock
    #begin = 0;           // start time that was set before there was a film
    #visible = false;
    #promises = [];
    #poster_waits = true;       // the poster is shown until the film plays or seeks
    #picture;             // a FilmPicture
    #controls;            // a PlayerControls
    #sound;               // a FilmSound
    #muted = false;
    #volume = 1;
    #voice;               // a PlayerVoice

    constructor() {
      super();
      this.#face = new PlayerFace(this, look, {
        source_name: () => this.#loader.source?.name ?? "",
        text_until_edits: () => this.#loader.text_until_edits,
        trouble: () => (this.#picture.count ? "" : this.#picture.trouble),
      });
      this.#parts = this.#face.parts;
      this.#loader = new FilmLoader(this, {
        begin: () => this.#begin_loading(), stay_empty: () => this.#stay_empty(),
        take: (film) => this.#use_film(film), fail: (code, words) => this.#fail(code, words),
      });
      this.#sound = new FilmSound(this, { now: () => this.#clock.now() });
      this.#clock = new FilmClock(this, {
        fire: (name, detail) => this.#fire(name, detail), update: () => this.#update(), in_sight: () => this.#visible,
        sound: () => this.#sound,
      });
      this.#picture = new FilmPicture(this.#parts.canvas, {
        drawn: (film) => this.#report_code_errors(film), recovered: () => this.#show(),
        failed: () => (this.#fire("error"), this.#show()), again: () => this.isConnected && page.wake(this),
      });
      this.#controls = new PlayerControls(this, this.#parts, {
        time: () => this.#clock.time, moving: () => this.#clock.moving(), stuck: () => this.#clock.stuck(),
        frames_at: (time) => this.#frames_at(time), hold: () => this.#clock.hold(),
        silent: () => this.#muted || this.#volume === 0 || this.#sound.blocked, loud: () => this.#make_loud(),
      });
      this.#voice = new PlayerVoice(this.#parts);
      page.add(this, {
        step: () => this.#step(), see: (visible) => this.#see(visible), comes_near: () => this.#comes_near(),
        measure: (size) => this.#measure(size),
      });
    }

    connectedCallback() {
      // Properties that were set before the element was defined hide the accessors, so set them again.
      for (const name of ["files", "lets", "script", "currentTime", "playbackRate", "muted", "volume", "src",
                          ...player_flags])
        if (Object.hasOwn(this, name)) {
          const value = this[name];
          delete this[name];
          this[name] = value;
        }
      page.watch(this, this.#parts.stage);
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
        page.leave(this, this.#parts.stage);
        this.#visible = false;
        this.#clock.let_go();
        this.pause();
        this.#picture.stop();
        this.#controls.stop();
        this.#begin = this.currentTime;
        this.#forget();
      });
    }

    attributeChangedCallback(name, before, now) {
      if (before === now) return;
      if (name === "src") {
        if (this.#network !== 0) this.load();
        else if (this.isConnected) page.ask(this);
      } else if (name === "playbackrate") {
        if (now !== null && Number.isFinite(Number(now))) this.playbackRate = Number(now);
      } else if (name === "volume") {
        if (now !== null && Number(now) >= 0 && Number(now) <= 1) this.volume = Number(now);
      } else if (name === "muted") {
        if (this.isConnected) this.muted = now !== null;
        else this.#muted = now !== null;  // the tag's own: no event
      } else if (name === "autoplay") {
        this.#autoplay();
      } else {
        this.#show_attributes();
      }
    }

    // ---- As a video

    get currentSrc() { return this.#loader.source?.url || ""; }
    get error() { return this.#error; }
    get networkState() { return this.#network; }
    get readyState() { return this.#ready; }
    get paused() { return this.#clock.paused; }
    get seeking() { return this.#clock.seeking; }
    get ended() {
      return this.#ready > 0 && this.#clock.rate >= 0 && !this.loop && this.#clock.time >= this.duration;
    }
    get duration() { return this.#film ? this.#frames / this.#film.fps : NaN; }
    get videoWidth() { return this.#film ? this.#film.width : 0; }
    get videoHeight() { return this.#film ? this.#film.height : 0; }

    get currentTime() { return this.#ready > 0 ? clamp(this.#clock.now(), 0, this.duration) : this.#begin; }
    set currentTime(seconds) {
      seconds = Number(seconds);
      if (!Number.isFinite(seconds)) throw new TypeError("currentTime is a number of seconds");
      if (this.#ready > 0) this.#seek(seconds);
      else this.#begin = seconds;
    }

    get playbackRate() { return this.#clock.rate; }
    set playbackRate(rate) {
      rate = Number(rate);
      if (!Number.isFinite(rate)) throw new TypeError("playbackRate is a number");
      if (rate === this.#clock.rate) return;
      this.#clock.set(this.currentTime);
      this.#clock.rate = rate;
      this.#fire("ratechange");
      this.#update();
    }

    get muted() { return this.#muted; }
    set muted(on) {
      if (this.#muted === Boolean(on)) return;
      this.#muted = Boolean(on);
      this.#fire("volumechange");
      this.#update();
    }
    get volume() { return this.#volume; }
    set volume(share) {
      share = Number(share);
      if (!Number.isFinite(share)) throw new TypeError("volume is a number");
      if (share < 0 || share > 1) throw new DOMException(`volume is between 0 and 1, not ${share}`, "IndexSizeError");
      if (share === this.#volume) return;
      this.#volume = share;
      this.#sound.set_volume(share);
      this.#fire("volumechange");
    }
    // Turns the sound on for the button.
    #make_loud() {
      this.muted = false;
      if (this.#volume === 0) this.volume = 1;
      this.#show();
    }

    play() {
      if (this.#error) return Promise.reject(new DOMException(this.#error.message, "NotSupportedError"));
      this.#may_autoplay = false;
      if (this.ended) this.#seek(0);
      const promise = new Promise((resolve, reject) => this.#promises.push({ resolve, reject }));
      promise.catch(() => {});  // callers may ignore the promise
      if (this.paused) {
        this.#clock.set(this.#clock.time);
        this.#clock.paused = false;
        this.#poster_waits = false;
        this.#fire("play");
        this.#fire(this.#ready > 2 ? "playing" : "waiting");
      }
      if (this.#ready > 2) this.#settle();
      else if (this.#network === 0) this.#loader.load();
      this.#update();
      return promise;
    }

    pause() {
      this.#may_autoplay = false;
      if (this.paused) return;
      if (this.#ready > 0) this.#clock.set(this.currentTime);
      this.#clock.paused = true;
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
      this.#loader.forget();
      this.#error = null;
      this.#begin = 0;
      this.#poster_waits = true;
      this.#may_autoplay = true;
      if (was_there) this.#fire("emptied");
      this.#clock.paused = true;
      this.#loader.load();
    }

    getVideoPlaybackQuality() {
      return { creationTime: performance.now(), totalVideoFrames: this.#picture.count, droppedVideoFrames: 0 };
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
    get script() { return this.#loader.text; }
    set script(text) { text == null ? this.load() : (this.#loader.text = text); }

    // The film's files by their names in the script: texts, Uint8Arrays or ArrayBuffers.
    get files() { return this.#loader.files; }
    set files(all) { this.#loader.files = all; }

    // Other values for the script's lets, by their names.
    get lets() { return this.#loader.lets; }
    set lets(all) { this.#loader.lets = all; }

    // ---- The source

    #comes_near() {
      page.is_near(this);
      if (this.#network === 0 && this.preload !== "none") this.#loader.load();
    }

    #begin_loading() {
      this.#network = 2;
      this.#error = null;
      this.#fire("loadstart");
      this.#show();
    }
    #stay_empty() {
      this.#network = 0;
      this.#show();
    }

    #use_film(film) {
      this.#network = 1;
      this.#diagnostics = film.diagnostics;
      this.#text_wrong = !film.ok;
      this.#message = film.message + this.#loader.source.failed_files(film);
      if (!film.ok) {
        film.dispose();
        if (this.#film) this.#show();
        else this.#fail(3, this.#message);
        this.#fire("diagnostics", { diagnostics: this.#diagnostics });
        return;
      }
      const before = this.#film, time = this.currentTime;
      const [width, height, duration] = [this.videoWidth, this.videoHeight, this.duration];
      this.#film = Object.assign(film, { changed: (longer) => this.#film_changed(longer) });
      if (before) before.dispose();
      this.#error = null;
      this.#picture.outdate();
      this.#face.show_size();
      this.#ready = 4;
      this.#clock.set(clamp(time, 0, this.duration));
      if (this.duration !== duration) this.#fire("durationchange");
      if (before && (this.videoWidth !== width || this.videoHeight !== height)) this.#fire("resize");
      if (!before) this.#first_film();
      this.#fire("diagnostics", { diagnostics: this.#diagnostics });
      this.#show();
      this.#update();
    }

    // Shows the film after film.setTrack(), undo or redo.
    #film_changed(longer) {
      this.#loader.text_changed(() => this.#film.text);
      this.#diagnostics = this.#film.diagnostics;
      this.#picture.outdate();
      this.#sound.change();
      if (longer) this.#fire("durationchange");
      this.#fire("diagnostics", { diagnostics: this.#diagnostics });
      this.#update();
    }

    #first_film() {
      this.#begin = 0;
      this.#fire("resize");
      for (const name of ["loadedmetadata", "loadeddata", "canplay", "canplaythrough"]) this.#fire(name);
      if (!this.paused) {
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
      this.#clock.paused = true;
      this.#fire("error");
      this.#show();
      this.#update();
    }

    // Releases the film, and keeps its source.
    #forget() {
      this.#loader.stop();
      if (this.#film) this.#film.dispose();
      this.#film = null;
      this.#picture.forget();
      this.#ready = 0;
      this.#network = 0;
      this.#clock.seeking = false;
      this.#clock.time = 0;
      this.#update();
    }

    // ---- Time

    get #frames() { return Math.max(1, Math.floor(this.#film.lastFrame - this.#film.firstFrame + 1 + 1e-6)); }
    get #last() { return (this.#frames - 1) / this.#film.fps; }
    // Returns the number of whole frames before a time.
    #frames_at(time) { return clamp(Math.floor(time * this.#film.fps + 1e-6), 0, this.#frames - 1); }

    #seek(time) {
      this.#poster_waits = false;
      this.#clock.seek(time);
    }

    // Redraws, after any change of state.
    #update() {
      this.#clock.update();
      this.#show_poster();
      page.wake(this);
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
      page.wake(this);
    }

    #measure({ width, height }) {
      this.#picture.measure(width, height);
      this.#parts.stage.classList.toggle("narrow", width < 360);
      page.wake(this);
    }

    // One step of the loop. Returns whether the player needs another.
    #step() {
      this.#clock.tick();
      if (this.#film && this.#visible) this.#draw();
      this.#clock.end_seek();
      this.#controls.show_time();
      if (this.#film) this.#voice.say(this.#film, this.#film.start + this.#clock.time);
      return this.#clock.moving() && this.#visible;
    }

    #draw() {
      const film = this.#film, time = Math.min(this.#clock.time, this.#last);
      this.#picture.draw(film, film.start + (this.stepped ? this.#frames_at(time) / film.fps : time));
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

    // ---- Size, messages and controls

    #show_attributes() {
      const { controls, poster } = this.#parts;
      controls.hidden = !this.controls;
      this.#face.show_size();
      if (this.poster) poster.src = this.poster;
      this.#picture.outdate();
      this.#show_poster();
      this.#show();
      page.wake(this);
    }
    #show_poster() { this.#face.show_poster(this.#poster_waits); }
    #show() {
      this.#face.show();
      this.#controls.show();
    }
  }

  globalThis.Betwixt = globalThis.Betwixt ?? {};
  Betwixt.Player = BetwixtPlayer;
  upgrading = true;
  customElements.define("betwixt-player", BetwixtPlayer);
  upgrading = false;
}
