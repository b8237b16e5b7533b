// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The clock of a <betwixt-player>, as that of a video: it plays, seeks, waits while the slider is dragged, and ends.
const timeupdate_every = 250;  // ms, as videos do

class FilmClock {
  time = 0;  // seconds since the film's beginning, when the clock was last set
  paused = true;
  rate = 1;
  seeking = false;
  #player;
  #inside;       // functions of the player that pages do not have: fire, update, in_sight, sound
  #wall = 0;     // the real time when the clock was last set
  #held = null;  // an AbortController: the slider is dragged, and the clock waits
  #pulse = 0;

  constructor(player, inside) {
    this.#player = player;
    this.#inside = inside;
  }

  moving() {
    return !this.paused && !this.#held && this.#player.readyState > 2 && this.rate !== 0 && !this.stuck();
  }
  // Whether the film is at the end of its direction, where a video stops, paused or not.
  stuck() {
    return !this.#player.loop && (this.rate > 0 ? this.time >= this.#player.duration : this.rate < 0 && this.time <= 0);
  }
  now() {
    if (!this.#plays_now()) return this.time;
    return this.#inside.sound().heard(this.time) ?? this.time + ((performance.now() - this.#wall) / 1000) * this.rate;
  }
  // Jumps to a time.
  set(time) {
    this.#inside.sound().jump();
    this.#go_on(time);
  }
  #go_on(time) {
    this.time = time;
    this.#wall = performance.now();
  }
  #plays_now() { return this.moving() && !this.seeking; }

  tick() {
    if (!this.#plays_now()) return;
    this.#inside.sound().follow(true);
    const before = this.time, now = this.now(), end = this.#player.duration;
    if (now >= 0 && now < end) {
      this.#go_on(now);
      this.#fire_notes(before, now);
    } else if (this.#player.loop) {
      const laps = Math.floor(now / end) * end;
      this.#inside.sound().lap(laps);
      this.#go_on(now - laps);
      for (const name of ["seeking", "timeupdate", "seeked"]) this.#inside.fire(name);
    } else {
      this.set(now < 0 ? 0 : end);
      this.#fire_notes(before, this.time);
      this.#inside.fire("timeupdate");
      this.#end();
      this.#inside.update();
    }
  }
  // Stops the film at its end.
  #end() {
    if (this.paused || this.#held || !this.#player.ended || this.rate <= 0) return;
    this.paused = true;
    this.#inside.fire("pause");
    this.#inside.fire("ended");
  }
  #fire_notes(before, now) {
    const { film } = this.#player;
    for (const note of film.notes ?? []) {
      const at = note.seconds - film.start;
      if (before < now ? at > before && at <= now : at < before && at >= now)
        this.#inside.fire("note", { text: note.text, time: at });
    }
  }

  seek(time) {
    this.set(clamp(time, 0, this.#player.duration));
    if (!this.seeking) {
      this.seeking = true;
      this.#inside.fire("seeking");
    }
    if (!this.#inside.in_sight() || document.hidden) setTimeout(() => this.end_seek());
    this.#inside.update();
  }
  end_seek() {
    if (!this.seeking) return;
    this.seeking = false;
    this.set(this.time);
    this.#inside.fire("timeupdate");
    this.#inside.fire("seeked");
    this.#end();
    this.#inside.update();
  }

  // Makes the film wait while the slider is dragged.
  hold() {
    if (this.#held) return;
    this.set(this.#player.currentTime);
    this.#held = new AbortController();
    for (const name of ["pointerup", "pointercancel", "blur"])
      addEventListener(name, () => this.let_go(), { capture: true, signal: this.#held.signal });
    this.#inside.update();
  }
  let_go() {
    if (!this.#held) return;
    this.#held.abort();
    this.#held = null;
    this.set(this.time);
    if (!this.seeking) this.#end();
    this.#inside.update();
  }

  // Starts or stops the timer and the sound, after any change of state.
  update() {
    const moving = this.moving();
    this.#inside.sound().follow(this.#plays_now());
    if (moving && !this.#pulse)
      this.#pulse = setInterval(() => {
        this.tick();
        if (this.moving()) this.#inside.fire("timeupdate");
      }, timeupdate_every);
    if (!moving && this.#pulse) {
      clearInterval(this.#pulse);
      this.#pulse = 0;
    }
  }
}
