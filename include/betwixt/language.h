// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Converts text to documents and back. docs/language.md describes the language.
//
// Room: language
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/document.h"

namespace betwixt {

// A value for a `let` of a script, instead of the script's own.
struct GivenLet {
  std::string name, value;  // the value as the script would write it; a text needs no quotes
  // It is a cell of a table, at this place: no formula, and no error if the script has no such `let`.
  bool data = false;
  Place place = {};
};

struct LoadOptions {
  // Allows any file. Otherwise a script reads only files below its own folder. A packed file may then unpack to at most
  // 100 times its size plus 64 MiB, and to at most 1 GiB.
  bool read_anywhere = false;
  // The time, in ticks, at which a live host sends its lines. If it is set, it is the time of every `animate`, `halt`,
  // `kill` and `cancel` that has none. It is also the time from which `set` puts objects into environments
  // (`environments`, `drive`). A `begin` below `make` or `edit` means the environment that has the name at this time.
  // The history stores each of these lines with this time. Lines that the host did not write itself (in files that it
  // uses, in own commands) are not affected.
  std::optional<Time> now = {};
  bool read_nothing = false;  // reads no files at all
  // Called with the real path of each file that is requested and allowed, whether it exists or not. A path may come
  // several times.
  std::function<void(const std::string& path)> asked_for = {};
  bool tex = false;     // typesets formulas with the programs latex and dvisvgm; otherwise formulas are errors
  bool counts = false;  // adds a notice if the pattern of a command names several objects: how many
  // Returns the current text of a used script (by its real path) while someone edits it, or nullopt to read the file.
  std::function<std::optional<std::string>(const std::string& path)> written = {};
  std::vector<GivenLet> lets = {};
  // The .po file with the translations of the film's texts, instead of that of the command `language`. "": none, and
  // the texts stay as they are written. nullopt: the script decides.
  std::optional<std::string> language = {};
  // Called with each text that is shown and can be translated, as it is written, and its place.
  std::function<void(const std::string& text, const Place&)> shows = {};
};

// Loads a plug-in (include/betwixt/plugin.h), which stays loaded until the program ends. From then on every script can
// use its twerpers (interpolations), filters, commands and functions. A script cannot load plug-ins itself, since they
// can do anything that a program can.
Status use_plugin(const std::string& path);

struct Loaded {
  Document document;        // everything that could be carried out
  Diagnostics diagnostics;  // all messages, in the order of the text
};

// Read a script. They never fail as a whole: each error is among the diagnostics, with its place.
Loaded load_file(const std::string& path, const LoadOptions& = {});
Loaded load_text(std::string_view text, const std::string& name, const LoadOptions& = {});

// Returns the script in canonical form. Comments and commands are kept. If the text has words, brackets or rows that
// the reader cannot separate, it is returned unchanged. The commands are not carried out, so they may have errors.
std::string tidy(std::string_view text);

// Returns a script that makes this document: load_text(write(d)) == d.
std::string write(const Document&);

// Reads how long a shutter is open: 180deg (360deg is a frame), 10ms, 0.5f or off. Returns seconds; off is 0. Errors:
// syntax, range.
Result<double> parse_shutter(std::string_view, const Document&);
// Reads a time such as "24f", "2.5s" or "00:01:02.5", at the document's rates. Errors: syntax, range.
Result<Time> parse_time(std::string_view text, const Document&);
// Returns "24f" if t is on a frame, otherwise seconds: "1.2345s".
std::string format_time(Time, const Document&);

// Returns the targets that a pattern names: "ball.position", "wheel*.{position,color}", or "ball" for all its display
// functions that are not at rest (position, rotation, scale …). Returns an empty list if nothing matches. Errors: name,
// if an object or a function does not exist.
Result<std::vector<Target>> find_targets(std::string_view pattern, const Document&);

}  // namespace betwixt
