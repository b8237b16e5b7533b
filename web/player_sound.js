// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The sound of a <betwixt-player>. The engine mixes it, a second ahead, for the browser's audio clock. The picture
// follows that clock. Browsers play sound only after the reader has clicked or typed in the page.
const sound_chunk = 12000;      // samples: a quarter of a second
const sound_ahead = 1.25;       // seconds; more than the time between two pulses of the player's clock
const sound_lead = 0.03;        // seconds before the first sample
const sound_fade = 0.005;       // seconds; a jump within a sound is no click
const sound_patience = 300;     // ms that the picture waits for the audio clock to start
const sound_stalled = 700;      // ms after which a clock counts as broken

// The audio clock of the page, made when the reader has touched the page and a film has sound.
const page_audio = (() => {
  let context = null, wanted = false, touched = false;
  const start = () => {
    try {
      context ??= new AudioContext({ sampleRate: sound_rate, latencyHint: "balanced" });
      if (context.state !== "running") context.resume().catch(() => {});
    } catch {
      wanted = false;  // no sound here; films play on
    }
  };
  const touch = () => {
    touched = true;
    if (wanted) start();  // Safari starts it only here
  };
  for (const name of ["pointerup", "keydown", "touchend"])
    globalThis.addEventListener?.(name, touch, { capture: true, passive: true });
  const may_start = () => touched || (navigator.userActivation?.hasBeenActive ?? false);
  return {
    may_start,
    // Returns the AudioContext if it runs.
    running() {
      wanted = true;
      if (context?.state !== "running" && may_start()) start();
      return context?.state === "running" ? context : null;
    },
  };
})();

// Returns the context's time at the loudspeaker.
const audible_time = (context) => {
  const { contextTime = 0, performanceTime = 0 } = context.getOutputTimestamp?.() ?? {}, now = context.currentTime;
  const heard = performanceTime > 0 ? contextTime + (performance.now() - performanceTime) / 1000
                                    : now - (context.outputLatency || 0);
  return clamp(heard, now - 1, now);
};

class FilmSound {
  #player;
  #inside;          // functions of the player that pages do not have: now
  #run = null;      // the sound from one jump to the next
  #fresh = true;    // after a jump: the picture waits for its sound
  #waits_since = 0;
  #broken = false;  // the clock does not move
  #volume = null;   // a GainNode

  constructor(player, inside) {
    this.#player = player;
    this.#inside = inside;
  }

  // Whether the film would be heard if the reader had touched the page.
  get blocked() { return this.#may_sound() && !page_audio.may_start(); }

  set_volume(volume) {
    if (this.#volume) this.#volume.gain.value = volume;
  }

  // Starts, feeds or ends the sound. `moving`: the film plays at this moment.
  follow(moving) {
    if (!moving || !this.#may_sound() || this.#broken) {
      this.#end();
      if (moving) this.#fresh = false;  // it plays silently
      this.#waits_since = 0;
      return;
    }
    this.#waits_since ||= performance.now();
    const context = page_audio.running(), run = this.#run;
    const late = run && run.at + run.done / sound_rate < context?.currentTime;
    if (!context || late || run?.loop !== this.#player.loop) this.#end();
    if (!context) return;
    if (!this.#run) this.#begin(context);
    while (this.#run.at + this.#run.done / sound_rate < context.currentTime + sound_ahead) this.#feed();
  }
  // Stops the sound, because the film's time has been set.
  jump() {
    this.#end();
    this.#fresh = true;
    this.#waits_since = 0;
    this.#broken = false;
  }
  // The film has changed, and plays on.
  change() { this.#end(); }
  // The film has begun again.
  lap(seconds) {
    if (this.#run) this.#run.laps += seconds, this.#run.heard -= seconds;
  }

  // Returns the film's time at the loudspeaker, or null if there is no sound.
  heard(time) {
    const run = this.#run;
    if (!run) {
      const waits = this.#fresh && this.#waits_since && page_audio.may_start() &&
        performance.now() - this.#waits_since < sound_patience;
      if (this.#waits_since && !waits) this.#fresh = false;
      return waits ? time : null;
    }
    const heard = run.from / sound_rate + Math.max(audible_time(run.context) - run.at, run.earliest) * run.rate - run.laps;
    if (heard > run.heard || heard < run.heard - 1) run.heard = heard, run.moved = performance.now();
    if (performance.now() - run.moved < sound_stalled) return run.heard;
    this.#broken = true;
    this.#end();
    return null;
  }

  #may_sound() {
    const { film, muted, playbackRate } = this.#player;
    return !!film?.sounds && !muted && playbackRate > 0;
  }

  #begin(context) {
    const rate = this.#player.playbackRate, at = Math.ceil((context.currentTime + sound_lead) * sound_rate) / sound_rate;
    const now = this.#inside.now(), before = at - audible_time(context);
    // After a jump the picture waits for its first sample. Otherwise the sound joins the picture.
    const from = Math.round((this.#fresh ? now : now + before * rate) * sound_rate);
    const fade = context.createGain();
    if (from > 0) {
      fade.gain.setValueAtTime(0, at);
      fade.gain.linearRampToValueAtTime(1, at + sound_fade);
    }
    if (!this.#volume) {
      this.#volume = context.createGain();
      this.#volume.gain.value = this.#player.volume;
      this.#volume.connect(context.destination);
    }
    fade.connect(this.#volume);
    this.#run = { context, rate, at, from, fade, film: this.#player.film, loop: this.#player.loop, done: 0, laps: 0,
                  heard: now, earliest: this.#fresh ? 0 : -before, moved: performance.now(), sources: new Set() };
    this.#fresh = false;
  }
  #feed() {
    const run = this.#run, { context, sources } = run;
    const [left, right] = this.#at_rate(run.from + run.done * run.rate, run.rate);
    const buffer = context.createBuffer(2, sound_chunk, sound_rate), source = context.createBufferSource();
    buffer.copyToChannel(left, 0);
    buffer.copyToChannel(right, 1);
    source.buffer = buffer;
    source.connect(run.fade);
    source.start(run.at + run.done / sound_rate);
    source.onended = () => sources.delete(source);
    sources.add(source);
    run.done += sound_chunk;
  }
  #end() {
    const run = this.#run;
    if (!run) return;
    this.#run = null;
    const { fade, context, sources } = run, now = context.currentTime;
    fade.gain.cancelScheduledValues(now);
    fade.gain.setValueAtTime(fade.gain.value, now);
    fade.gain.linearRampToValueAtTime(0, now + sound_fade);
    for (const source of sources) source.stop(now + sound_fade);
    setTimeout(() => fade.disconnect(), 1000);
  }

  // Returns a chunk of the film's samples from a place on, at a speed. Between two samples it takes the straight line.
  #at_rate(from, rate) {
    if (rate === 1) return this.#samples(Math.round(from), sound_chunk);
    const first = Math.floor(from), read = this.#samples(first, Math.ceil(rate * sound_chunk) + 2);
    return read.map((side) => Float32Array.from({ length: sound_chunk }, (_, i) => {
      const at = from - first + i * rate, before = Math.floor(at);
      return side[before] + (at - before) * (side[before + 1] - side[before]);
    }));
  }
  // Returns samples across the end of the film, where it begins again or is silent.
  #samples(from, count) {
    const { film, loop } = this.#run, length = this.#player.duration * sound_rate, begin = (lap) => Math.round(lap * length);
    const left = new Float32Array(count), right = new Float32Array(count);
    for (let done = 0, part; done < count; done += part) {
      const at = from + done;
      let lap = loop ? Math.floor(at / length) : 0;
      lap += loop && at >= begin(lap + 1) ? 1 : at < begin(lap) ? -1 : 0;
      part = Math.min(count - done, begin(lap + 1) - at);
      if (part <= 0) break;
      const mixed = film.sound(at - begin(lap), part);
      left.set(mixed.left, done), right.set(mixed.right, done);
    }
    return [left, right];
  }
}
