// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The controls of a <betwixt-player>: buttons, the slider, the clock, and keys.
const player_speeds = [-2, -1, -0.5, 0.25, 0.5, 1, 1.5, 2, 4];

class PlayerControls {
  #player;
  #parts;
  #inside;  // functions of the player that pages do not have: time, moving, stuck, frames_at, hold,
            // silent, loud
  #quiet_timer = 0;
  #spoken = 0;

  constructor(player, parts, inside) {
    this.#player = player;
    this.#parts = parts;
    this.#inside = inside;
    this.#listen();
  }
  stop() { clearTimeout(this.#quiet_timer); }

  show() {
    if (!this.#player.controls) return;
    const { controls, play, full, speed, mute } = this.#parts;
    controls.hidden = !!this.#player.error;
    const at_rest = this.#player.paused || this.#inside.stuck();
    const name = !at_rest ? "pause" : this.#player.ended ? "again" : "play";
    this.#set_button(play, name, { play: "Play", pause: "Pause", again: "Play again" }[name]);
    mute.hidden = !this.#player.film?.sounds;
    const silent = this.#inside.silent();
    this.#set_button(mute, silent ? "silent" : "loud", silent ? "Sound on" : "Sound off");
    const large = document.fullscreenElement === this.#player;
    this.#set_button(full, large ? "small" : "full", large ? "Leave full screen" : "Full screen");
    const rates = [...new Set([...player_speeds, this.#player.playbackRate])].sort((a, b) => a - b);
    if (speed.options.length !== rates.length)
      speed.replaceChildren(...rates.map((r) => new Option(`${r}×`.replace("-", "−"), r)));
    speed.value = String(this.#player.playbackRate);
  }
  #set_button(button, name, words) {
    if (button.dataset.icon === name) return;
    button.dataset.icon = name;
    button.replaceChildren(drawing(player_icons[name]));
    button.setAttribute("aria-label", words);
    button.title = words;
  }

  show_time() {
    const film = this.#player.film;
    if (!film || !this.#player.controls) return;
    const { time, clock } = this.#parts, now = this.#inside.time(), end = this.#player.duration;
    const frame = this.#inside.frames_at(now) + film.firstFrame;
    time.max = end;
    time.value = now;
    time.style.setProperty("--at", `${(100 * now) / end}%`);
    clock.textContent = `${now.toFixed(1)} / ${end.toFixed(1)}`;
    clock.title = `frame ${frame} of ${film.lastFrame}`;
    // A screen reader should not read every frame of a playing film.
    if (this.#inside.moving() && performance.now() - this.#spoken < 1000) return;
    this.#spoken = performance.now();
    time.setAttribute("aria-valuetext", `frame ${frame} of ${film.lastFrame}, ${now.toFixed(1)} seconds`);
  }

  #listen() {
    const player = this.#player, { stage, time, speed, canvas, poster } = this.#parts;
    const shown = () => this.show();
    for (const name of ["play", "pause", "ended", "ratechange", "seeked", "timeupdate", "volumechange"])
      player.addEventListener(name, shown);
    player.addEventListener("fullscreenchange", shown);
    player.addEventListener("keydown", (event) => player.controls && this.#key(event));
    stage.addEventListener("click", (event) => {
      const button = event.target.closest("[data-do]");
      if (button && button.dataset.do === "toggle") this.#toggle();
      if (button && button.dataset.do === "mute") this.#mute();
      if (button && button.dataset.do === "fullscreen") this.#fullscreen();
    });
    for (const picture of [canvas, poster])
      picture.addEventListener("click", () => player.controls && this.#toggle());
    time.addEventListener("pointerdown", (event) => event.button === 0 && this.#inside.hold());
    time.addEventListener("input", () => (player.currentTime = Number(time.value)));
    speed.addEventListener("change", () => (player.playbackRate = Number(speed.value)));
    for (const name of ["pointermove", "pointerdown", "focusin", "play", "pause"])
      player.addEventListener(name, () => this.#stir());
    stage.addEventListener("pointerleave", () => this.#rest());
  }

  // Hides the controls if the film plays and the pointer rests.
  #stir() {
    this.#parts.stage.classList.remove("idle");
    clearTimeout(this.#quiet_timer);
    this.#quiet_timer = setTimeout(() => this.#rest(), 2000);
  }
  #rest() { this.#parts.stage.classList.toggle("idle", this.#inside.moving()); }

  #toggle() {
    const player = this.#player;
    if (player.paused) {
      player.play();
    } else if (this.#inside.stuck()) {
      player.playbackRate = -player.playbackRate;  // at an end, the only way is back
    } else {
      player.pause();
    }
  }
  // What the reader sees counts: a click on "Sound on" in a page that was not touched before mutes nothing.
  #mute() {
    if (this.#parts.mute.dataset.icon === "loud") this.#player.muted = true;
    else this.#inside.loud();
  }
  #fullscreen() {
    if (document.fullscreenElement === this.#player) document.exitFullscreen();
    else this.#player.requestFullscreen?.().catch(() => {});
  }
  #by_frames(count) {
    const player = this.#player;
    if (!player.film) return;
    player.pause();
    player.currentTime = (this.#inside.frames_at(player.currentTime) + count) / player.film.fps;
  }
  // As on an editing table: j runs backwards, l forwards, and again doubles the speed.
  #shuttle(way) {
    const player = this.#player, rate = player.playbackRate;
    const faster = !player.paused && Math.sign(rate) === way;
    player.playbackRate = faster ? clamp(2 * rate, -8, 8) : way;
    if (player.paused && way < 0 && this.#inside.time() <= 0) player.currentTime = player.duration;
    player.play();
  }
  #speed(way) {
    const rate = this.#player.playbackRate;
    const next = way > 0 ? player_speeds.find((s) => s > rate) : player_speeds.findLast((s) => s < rate);
    if (next !== undefined) this.#player.playbackRate = next;
  }

  #key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey || event.defaultPrevented) return;
    const player = this.#player, at = event.composedPath()[0], key = event.key;
    const on_button = at.localName === "button", on_speed = at.localName === "select";
    if (on_button && (key === " " || key === "Enter")) return;
    if (on_speed && key !== "f") return;
    if (!this.#parts.stage.contains(at) && at !== player) return;  // an element that the page put inside
    const second = player.film ? Math.round(player.film.fps) : 1, by = event.shiftKey ? second : 1;
    const keys = {
      " ": () => this.#toggle(), k: () => this.#toggle(),
      ArrowRight: () => this.#by_frames(by), ArrowLeft: () => this.#by_frames(-by),
      ArrowUp: () => this.#by_frames(second), ArrowDown: () => this.#by_frames(-second),
      ".": () => this.#by_frames(1), ",": () => this.#by_frames(-1),
      Home: () => (player.currentTime = 0), End: () => (player.currentTime = player.duration || 0),
      j: () => this.#shuttle(-1), l: () => this.#shuttle(1),
      f: () => this.#fullscreen(), m: () => this.#mute(), "+": () => this.#speed(1), "-": () => this.#speed(-1),
    };
    const act = keys[key.length === 1 ? key.toLowerCase() : key];
    if (!act) return;
    event.preventDefault();
    act();
  }
}
