// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The attributes of a <betwixt-player> as properties, and the constants of <video>.
const player_flags = ["autoplay", "loop", "controls", "stepped"];

const player_attributes = () => {
  class Attributes extends HTMLElement {
    static NETWORK_EMPTY = 0;
    static NETWORK_IDLE = 1;
    static NETWORK_LOADING = 2;
    static NETWORK_NO_SOURCE = 3;
    static HAVE_NOTHING = 0;
    static HAVE_METADATA = 1;
    static HAVE_CURRENT_DATA = 2;
    static HAVE_FUTURE_DATA = 3;
    static HAVE_ENOUGH_DATA = 4;

    get src() { return this.hasAttribute("src") ? new URL(this.getAttribute("src"), document.baseURI).href : ""; }
    set src(url) { this.setAttribute("src", url); }
    get poster() { return this.hasAttribute("poster") ? new URL(this.getAttribute("poster"), document.baseURI).href : ""; }
    set poster(url) { this.setAttribute("poster", url); }
    get alt() { return this.getAttribute("alt") ?? ""; }
    set alt(text) { this.setAttribute("alt", text); }
    get preload() { return this.getAttribute("preload") ?? "auto"; }
    set preload(word) { this.setAttribute("preload", word); }
    get loading() { return this.getAttribute("loading") === "eager" ? "eager" : "lazy"; }
    set loading(word) { this.setAttribute("loading", word); }
    get defaultMuted() { return this.hasAttribute("muted"); }
    set defaultMuted(on) { this.toggleAttribute("muted", Boolean(on)); }
    get width() { return Number.parseInt(this.getAttribute("width"), 10) || 0; }
    set width(pixels) { this.setAttribute("width", pixels); }
    get height() { return Number.parseInt(this.getAttribute("height"), 10) || 0; }
    set height(pixels) { this.setAttribute("height", pixels); }
  }

  for (const name of player_flags)
    Object.defineProperty(Attributes.prototype, name, {
      configurable: true,
      enumerable: true,
      get() { return this.hasAttribute(name); },
      set(on) { this.toggleAttribute(name, Boolean(on)); },
    });
  for (const [name, value] of Object.entries(Attributes)) Object.defineProperty(Attributes.prototype, name, { value });
  return Attributes;
};
