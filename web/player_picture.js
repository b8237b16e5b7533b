// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The picture in a <betwixt-player>: draws the film as large as fits, and tries again later where that fails.
const longest_side = 4096;  // of a picture, in pixels
const tries_again = 1000;   // ms, after drawing failed

class FilmPicture {
  count = 0;     // of drawn pictures
  trouble = "";  // the error of the last draw
  #canvas;
  #inside;        // functions of the player: drawn, recovered, failed, again
  #size = [0, 0]; // in pixels of the page
  #drawn = {};
  #retry = 0;

  constructor(canvas, inside) {
    this.#canvas = canvas;
    this.#inside = inside;
  }
  measure(width, height) { this.#size = [width, height]; }
  // Draws again even if nothing has changed.
  outdate() { this.#drawn = {}; }
  forget() {
    this.#drawn = {};
    this.count = 0;
    this.trouble = "";
  }
  stop() { clearTimeout(this.#retry); }

  // Draws as large as fits, in whole pixels of the screen.
  draw(film, seconds) {
    const canvas = this.#canvas, drawn = this.#drawn, ratio = devicePixelRatio || 1;
    const [w, h] = this.#size.map((side) => Math.round(side * ratio));
    if (w < 1 || h < 1) return;
    const scale = Math.min(w / film.width, h / film.height);
    const [wide, high] = [Math.round(film.width * scale), Math.round(film.height * scale)];
    const fills = w - wide <= 1 && h - high <= 1;
    const down = Math.min(1, longest_side / Math.max(w, h));
    const width = Math.max(1, Math.floor((fills ? w : wide) * down));
    const height = Math.max(1, Math.floor((fills ? h : high) * down));
    if (drawn.film === film && drawn.seconds === seconds && drawn.width === width && drawn.height === height) return;
    try {
      if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
      canvas.style.width = fills ? "100%" : `${wide / ratio}px`;
      canvas.style.height = fills ? "100%" : `${high / ratio}px`;
      film.draw(canvas, seconds);
      this.#drawn = { film, seconds, width, height };
      ++this.count;
      this.#inside.drawn(film);
      if (!this.trouble) return;
      this.trouble = "";
      this.#inside.recovered();
    } catch (error) {
      this.#fail(message_of(error));
    }
  }

  // Tries again later: a graphics context can be lost when a machine sleeps or is overloaded.
  #fail(words) {
    if (this.trouble !== words) {
      this.trouble = words;
      this.#inside.failed();
    }
    clearTimeout(this.#retry);
    this.#retry = setTimeout(() => this.#inside.again(), tries_again);
  }
}
