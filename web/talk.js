// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A page that shows a film as a talk: it plays from one step to the next, and waits there. `betwixt web --present` makes it.
(() => {
  const player = document.querySelector("betwixt-player"), talk = document.getElementById("talk");
  const blank = document.getElementById("blank"), where = document.getElementById("where");
  const said = JSON.parse(document.getElementById("stops").textContent);
  let stops = [], at = 0, playing = false, notes = null, begun = Date.now();

  const last_time = () => Math.max(0, player.duration - 1 / player.film.fps);
  const time_of = (stop) => stops[stop].seconds;
  const prepare = () => {
    const last = last_time();
    stops = said.filter((s) => s.seconds <= last + 1e-6).map((s) => ({ ...s }));
    if (!stops.length || stops[0].seconds > 0) stops.unshift({ seconds: 0, text: "", note: "" });
    if (stops.at(-1).seconds < last - 1e-6) stops.push({ seconds: last, text: "", note: "" });
    document.documentElement.style.setProperty("--shape", player.videoWidth / player.videoHeight);
    go_to(0);
  };
  const show = () => {
    where.textContent = `${at + 1} / ${stops.length}`;
    show_notes();
  };
  const go_to = (stop) => {
    at = Math.min(Math.max(stop, 0), stops.length - 1);
    playing = false;
    player.pause();
    player.currentTime = time_of(at);
    show();
  };
  // Waits at the next step. Shows no picture behind it: a timer ends before the frame that would.
  let timer = 0;
  const watch = () => {
    clearTimeout(timer);
    if (!playing || player.paused) return;
    const left = time_of(at + 1) - player.currentTime;
    if (left <= 0.004 || player.ended) return go_to(at + 1);
    timer = setTimeout(watch, Math.max(1, 1000 * left - 3));
  };
  const next = () => {
    if (playing) return go_to(at + 1);
    if (at + 1 >= stops.length) return;
    playing = true;
    // The first picture that differs, at once.
    player.currentTime = Math.min(time_of(at) + 1 / player.film.fps, time_of(at + 1));
    player.play().catch(() => {});
    watch();
  };
  const previous = () => go_to(playing ? at : at - 1);
  const hold = () => {
    if (!playing) return;
    if (player.paused) player.play().catch(() => {}), watch();
    else player.pause();
  };

  // ---- The second window

  const part = (name) => notes.document.getElementById(name);
  const open_notes = () => {
    if (notes && !notes.closed) return notes.focus();
    notes = open("", "betwixt-notes", "width=900,height=600");
    if (!notes) return void (where.textContent = "the browser has blocked the window of the notes");
    const page = notes.document;
    page.title = `${document.title} – notes`;
    page.body.replaceChildren();
    const look = { background: "#14181d", color: "#e6edf3", font: "20px/1.5 system-ui, sans-serif", padding: "1rem" };
    Object.assign(page.body.style, look);
    for (const [name, tag] of [["clock", "h1"], ["count", "p"], ["step", "h2"], ["note", "p"], ["coming", "h3"], ["next", "canvas"]]) {
      const one = page.createElement(tag);
      one.id = name;
      if (name === "note") one.style.whiteSpace = "pre-wrap";
      page.body.append(one);
    }
    notes.addEventListener("keydown", press);
    show_notes();
  };
  const two = (n) => String(Math.floor(n)).padStart(2, "0");
  const show_notes = () => {
    if (!notes || notes.closed || !stops.length) return;
    const seconds = (Date.now() - begun) / 1000, coming = stops[at + 1];
    part("clock").textContent = `${two(seconds / 60)}:${two(seconds % 60)}`;
    part("count").textContent = `${at + 1} / ${stops.length}`;
    part("step").textContent = stops[at].text;
    part("note").textContent = stops[at].note;
    part("coming").textContent = coming ? `next: ${coming.text}` : "the end";
    show_next(coming);
  };
  // The picture of the next step is drawn by a small player of its own, and copied into the window.
  const preview = document.createElement("betwixt-player");
  preview.setAttribute("aria-hidden", "true");
  preview.setAttribute("loading", "eager");
  preview.className = "preview";
  const show_next = (coming) => {
    if (!preview.isConnected) {
      preview.files = player.files;
      preview.script = player.script;
      talk.prepend(preview);
    }
    if (coming && preview.readyState > 2 && preview.currentTime !== coming.seconds) preview.currentTime = coming.seconds;
    const from = preview.shadowRoot?.querySelector("canvas"), to = part("next");
    to.hidden = !coming;
    if (!coming || !from || from.width < 2) return;
    to.width = from.width;
    to.height = from.height;
    to.getContext("2d").drawImage(from, 0, 0);
  };
  setInterval(show_notes, 250);

  // ---- Keys, clicks and touches

  const keys = {
    ArrowRight: next, ArrowDown: next, PageDown: next, " ": next, Enter: next,
    ArrowLeft: previous, ArrowUp: previous, PageUp: previous, Backspace: previous,
    Home: () => go_to(0), End: () => go_to(stops.length - 1), p: hold, n: open_notes,
    b: () => (blank.hidden = !blank.hidden), ".": () => (blank.hidden = !blank.hidden),
    f: () => (document.fullscreenElement ? document.exitFullscreen() : talk.requestFullscreen?.()),
  };
  function press(event) {
    const does = keys[event.key];
    if (!does || !stops.length || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    if (event.key !== "b" && event.key !== ".") blank.hidden = true;
    does();
  }
  addEventListener("keydown", press);
  let touched = null;
  talk.addEventListener("pointerdown", (e) => (touched = { x: e.clientX, y: e.clientY }));
  talk.addEventListener("pointerup", (e) => {
    if (!touched || !stops.length || e.button > 0) return;
    const by = e.clientX - touched.x;
    blank.hidden = true;
    if (Math.abs(by) > 40) return by < 0 ? next() : previous();  // a swipe
    return e.clientX < innerWidth / 4 ? previous() : next();
  });
  talk.addEventListener("contextmenu", (e) => (e.preventDefault(), stops.length && previous()));

  if (player.readyState > 0) prepare();
  else player.addEventListener("loadedmetadata", prepare, { once: true });
  talk.focus();
})();
