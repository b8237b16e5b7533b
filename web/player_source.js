// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The source of a <betwixt-player>: the film's text and files, in the page or beside it.
const script_query = 'script[type="text/betwixt"]';
const files_query = 'script[type="application/json"][data-betwixt-files]';

const text_of = (script) =>
  script.textContent.replace(/^\r?\n/, "").replace(/<\\(\\*(?:\/script|script|!--))/gi, "<$1");
const as_bytes = (held) =>
  typeof held === "string" ? new TextEncoder().encode(held)
  : ArrayBuffer.isView(held) ? new Uint8Array(held.buffer, held.byteOffset, held.byteLength)
  : new Uint8Array(held);
const clamp = (x, low, high) => Math.min(Math.max(x, low), high);
const message_of = (error) => (error && error.message) || String(error);

// Returns the first comment of a script, without the file name in front.
const first_comment = (script) => {
  const lines = [];
  for (const line of script.split("\n")) {
    const words = line.match(/^\s*#(?:\s(.*))?$/); // `#ffcc00` is a colour
    if (!words) break;
    lines.push((words[1] ?? "").trim());
  }
  return lines.join(" ").replace(/^[\w.-]+\.bx\s*[—:-]+\s*/, "").trim();
};

// Returns the URL of a file, or null if it is not in the script's folder or below it.
const below = (base, path) => {
  const url = new URL(path.split("/").map(encodeURIComponent).join("/"), base);
  return url.href.startsWith(base.href) ? url : null;
};
const folder_of = (url) => {
  const folder = new URL(".", url);
  folder.search = folder.hash = "";
  return folder;
};

async function fetched(url, signal) {
  if (url.protocol === "file:")
    throw new Error(
      `A page that was opened from a disk may not read ${url.pathname.split("/").pop()}.\n` +
        "betwixt web FILE -o page.html makes a page that holds its film and plays anywhere; " +
        "or serve this folder: python3 -m http.server");
  let answer;
  try {
    answer = await fetch(url, { signal });
  } catch (error) {
    if (signal.aborted) throw error;
    throw new Error(`${url} cannot be fetched: ${message_of(error)}`);
  }
  if (!answer.ok) throw new Error(`${url} cannot be fetched: the server answered ${answer.status}`);
  return new Uint8Array(await answer.arrayBuffer());
}

// A film's text, its name, its folder, its files by their names in the script, and why files could not be fetched.
class FilmSource {
  text = "";
  name = "film.bx";
  url = "";
  base = folder_of(document.baseURI);
  files = new Map();
  lets = {};
  language = null;
  failed = [];

  // Returns the source of a player, or null if it has none.
  static async find(player, given_text, given_files, given_lets, signal) {
    // The children exist once the page has been parsed.
    if (!player.hasAttribute("src") && given_text === null && document.readyState === "loading")
      await new Promise((done) => document.addEventListener("DOMContentLoaded", done, { once: true, signal }));
    const inline = player.querySelector(script_query);
    const src = player.getAttribute("src");
    const here = new FilmSource();
    const held = { ...(src === null ? inline_files_of(player) : {}), ...given_files };
    here.files = new Map(Object.entries(held));
    if (inline && inline.dataset.name) here.name = inline.dataset.name;
    here.lets = { ...JSON.parse((src === null && inline?.dataset.lets) || "{}"), ...given_lets };
    if (src === null) here.language = inline?.dataset.language ?? null;
    if (src !== null) {
      const url = new URL(src, document.baseURI);
      here.url = url.href;
      here.name = decodeURIComponent(url.pathname.split("/").pop()) || here.name;
      here.base = folder_of(url);
      here.text = given_text ?? new TextDecoder().decode(await fetched(url, signal));
    } else if (given_text !== null || inline) {
      here.text = given_text ?? text_of(inline);
    } else {
      return null;
    }
    return here;
  }

  // Opens the film and fetches the files that it lacks, until no missing file can be fetched.
  async open(engine, signal) {
    for (const tried = new Set(); ;) {
      await engine.prepare(Object.fromEntries(this.files), this.text);
      const film = this.open_now(engine);
      const missing = this.missing(film).filter((path) => !tried.has(path));
      if (!missing.length) return film;
      film.dispose();
      await Promise.all(missing.map(async (path) => {
        tried.add(path);
        const url = below(this.base, path);
        if (!url) return;
        try {
          this.files.set(path, await fetched(url, signal));
        } catch (error) {
          if (signal.aborted) throw error;
          this.failed.push({ path, words: message_of(error) });
        }
      }));
    }
  }
  // Returns whether the engine can open the film at once.
  is_prepared(engine) { return engine.is_prepared(Object.fromEntries(this.files), this.text); }
  open_now(engine) {
    return engine.open(this.text, { name: this.name, files: Object.fromEntries(this.files), lets: this.lets,
                                    language: this.language });
  }
  missing(film) {
    return film.wants.filter((path) => !this.files.has(path) && !this.failed.some((f) => f.path === path));
  }
  failed_files(film) {
    const bad = this.failed.filter((f) => film.wants.includes(f.path));
    return bad.length ? "\n" + bad.map((f) => f.words).join("\n") : "";
  }
}

// The bytes of a page's files by the elements that hold them: all players share them, and what is decoded of them.
const inline_files = new WeakMap();
const files_in = (script) => {
  const text = script.textContent, known = inline_files.get(script);
  if (known?.text === text) return known.files;
  const files = Object.fromEntries(Object.entries(JSON.parse(text)).map(([name, held]) => [name, bytes_of(held)]));
  inline_files.set(script, { text, files });
  return files;
};

function inline_files_of(player) {
  const all = [...document.querySelectorAll(files_query)].filter(
    (script) => player.contains(script) || !script.closest("betwixt-player"));
  return Object.assign({}, ...all.map(files_in));
}

