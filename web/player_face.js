// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The face of a <betwixt-player>: its parts, and what they show of its state: the size, the poster, words and errors.
class PlayerFace {
  parts;
  #player;
  #inside;          // functions of the player that pages do not have: source_name, text_until_edits, trouble
  #size = sheet();  // its size and its background
  #size_rule = "";

  constructor(player, look, inside) {
    this.#player = player;
    this.#inside = inside;
    const root = player.attachShadow({ mode: "open", delegatesFocus: true });
    root.append(player_insides());
    root.adoptedStyleSheets = [look, this.#size];
    const part = (name) => root.querySelector(name);
    this.parts = {
      stage: part(".stage"), canvas: part("canvas"), poster: part("img"), wait: part(".wait"),
      controls: part(".controls"), play: part("[data-do=toggle]"), time: part("input"), clock: part(".clock"),
      speed: part("select"), full: part("[data-do=fullscreen]"),
      mute: part("[data-do=mute]"), banner: part(".banner"), message: part(".message"),
    };
  }

  // Sets the size from the attributes until there is a film. A style of the page overrides it.
  show_size() {
    const player = this.#player, { width, height } = player.film ?? player;
    const aspect = width && height ? `aspect-ratio: ${width} / ${height};` : "";
    const side =
      player.width ? `width: ${player.width}px;` : player.height ? `width: auto; height: ${player.height}px;` : "";
    // The page shows through a transparent film.
    const behind = player.film?.clear ? "background: var(--betwixt-letterbox, transparent);" : "";
    const rule = `:host { ${aspect} ${side} ${behind} }`;
    if (this.#size_rule !== rule) this.#size.replaceSync((this.#size_rule = rule));
  }
  // `waits`: the film has not played yet.
  show_poster(waits) { this.parts.poster.hidden = !(waits && this.#player.poster && !this.#player.error); }

  show() {
    const player = this.#player, { message, banner, wait, stage, canvas, full } = this.parts;
    const said = player.error ? player.error.message : this.#inside.trouble(), source = this.#inside.source_name();
    message.hidden = !said;
    if (said) this.#show_message(said);
    const wrong = player.diagnostics.find((d) => d.severity === "error");
    banner.hidden = !!said || !wrong || player.hasAttribute("editing");
    if (!banner.hidden) banner.textContent = `line ${wrong.line}: ${wrong.text}`;
    wait.hidden = !(player.networkState === 2 && !player.film) || !!said;
    const words = player.alt || first_comment(this.#inside.text_until_edits()) || (source && `the film ${source}`) || "a film";
    stage.setAttribute("aria-label", player.getAttribute("aria-label") || `Film: ${source || words}`);
    canvas.setAttribute("aria-label", words);
    full.hidden = !document.fullscreenEnabled;
  }

  #show_message(said) {
    const broken = this.#player.error?.code === 3;
    this.parts.message.replaceChildren(
      element("strong", {}, broken ? "This film has errors" : "This film cannot be shown"),
      element("pre", {}, said.trim()));
    if (broken) return;
    const again = element("button", { type: "button" }, "Try again");
    again.addEventListener("click", () => this.#player.load());
    this.parts.message.append(again);
  }
}
