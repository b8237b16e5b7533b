// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Loads the film of a <betwixt-player>: finds its source and the engine, and opens it, again when the page changes it.
class FilmLoader {
  source = null;       // a FilmSource
  #player;
  #inside;             // functions of the player that pages do not have: begin, stay_empty, take, fail
  #engine = null;
  #given_text = null;  // set by the page; overrides its own text
  #edited = null;      // returns the text after edits by the page; the text of a million rows is made only when read
  #given_files = {};
  #given_lets = {};
  #loading = null;     // an AbortController

  constructor(player, inside) {
    this.#player = player;
    this.#inside = inside;
  }

  // The film's text. Setting it shows the new film at the same time; if it has errors, the last good film stays.
  get text() {
    this.#write_edits();
    return this.text_until_edits;
  }
  // The text without edits of the film (film.setTrack), which are at its end.
  get text_until_edits() {
    if (this.#given_text !== null) return this.#given_text;
    const inline = this.source || this.#player.hasAttribute("src") ? null : this.#player.querySelector(script_query);
    return this.source ? this.source.text : inline ? text_of(inline) : "";
  }
  set text(text) {
    this.#write_edits();
    if (this.#given_text === String(text)) return;
    this.#given_text = String(text);
    if (!this.#engine || !this.source || this.#loading) {
      this.load();
      return;
    }
    this.source.text = this.#given_text;
    this.#open_again();
  }

  // Takes a function that returns the text of the film that is shown, which the page has edited.
  text_changed(read) { this.#edited = read; }
  #write_edits() {
    if (this.#edited) this.#given_text = this.source.text = this.#edited();
    this.#edited = null;
  }

  get files() { return { ...(this.source ? Object.fromEntries(this.source.files) : this.#given_files) }; }
  set files(all) {
    this.#write_edits();
    this.#given_files = {};
    for (const [name, held] of Object.entries(all ?? {})) this.#given_files[name] = as_bytes(held);
    if (this.source && this.#engine && !this.#loading) {
      this.source.files = new Map(Object.entries(this.#given_files));
      this.#open_again();
    }
  }

  get lets() { return { ...(this.source ? this.source.lets : this.#given_lets) }; }
  set lets(all) {
    this.#write_edits();
    this.#given_lets = { ...all };
    if (this.source && this.#engine && !this.#loading) {
      this.source.lets = this.#given_lets;
      this.#open_again();
    }
  }

  stop() {
    if (this.#loading) this.#loading.abort();
    this.#loading = null;
  }
  // Goes back to the page's own source.
  forget() {
    this.#given_text = this.#edited = null;
    this.source = null;
  }

  async load() {
    this.stop();
    this.#write_edits();
    const loading = (this.#loading = new AbortController());
    const { signal } = loading;
    this.#inside.begin();
    try {
      const engine = Betwixt.engine({ draws: true });  // loads in parallel with the source
      engine.catch(() => {});
      const source = await FilmSource.find(this.#player, this.#given_text, this.#given_files, this.#given_lets,
                                            signal);
      if (signal.aborted) return;
      if (!source) {
        this.#loading = null;
        this.#inside.stay_empty();
        return;
      }
      this.source = source;
      this.#engine = await engine;
      if (signal.aborted) return;
      const film = await source.open(this.#engine, signal);
      if (signal.aborted) film.dispose();
      else this.#inside.take(film);
    } catch (error) {
      if (!signal.aborted) this.#inside.fail(4, message_of(error));
    } finally {
      if (this.#loading === loading) this.#loading = null;
    }
  }

  // Opens a new text: at once, unless something must be fetched first.
  #open_again() {
    if (!this.source.is_prepared(this.#engine)) return this.#open_later();
    let film;
    try {
      film = this.source.open_now(this.#engine);
    } catch (error) {
      this.#inside.fail(3, message_of(error));
      return;
    }
    if (!this.source.missing(film).length) {
      this.#inside.take(film);
      return;
    }
    film.dispose();
    this.#open_later();
  }
  #open_later() {
    const loading = (this.#loading = new AbortController());
    this.source.open(this.#engine, loading.signal)
      .then((film) => (loading.signal.aborted ? film.dispose() : this.#inside.take(film)))
      .catch((error) => loading.signal.aborted || this.#inside.fail(3, message_of(error)))
      .finally(() => this.#loading === loading && (this.#loading = null));
  }
}
