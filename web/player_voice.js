// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a <betwixt-player> says of its film to people who cannot see it: the film's descriptions, for screen readers.
class PlayerVoice {
  #words = element("p", { class: "said", part: "description", id: "said", "aria-live": "polite" });
  #said = "";

  constructor(parts) {
    parts.stage.append(this.#words);
    parts.canvas.setAttribute("aria-describedby", "said");
  }
  // `time` counts as the film's times do.
  say(film, time) {
    const all = film?.descriptions ?? [];
    let now = "";
    for (const one of all) if (one.seconds <= time + 1e-6) now = one.text;
    if (now !== this.#said) this.#words.textContent = this.#said = now;
  }
}
