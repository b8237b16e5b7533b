// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Text to documents and back. The language is described in docs/language.md.
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

struct LoadOptions {
  // Else a script reads files only below its own folder, and those that unpack to at most 100 times their size and 64
  // MiB, and to 1 GiB in all.
  bool read_anywhere = false;
  // Lines of a live host happen when they come. Where this is set, `animate`, `halt`, `kill` and `cancel` that give no
  // time happen now; `set` puts what it names into environments (`environments`, `drive`) now, as `at` would; and a
  // `begin` below `make` or `edit` belongs to the environment that has the name now. In a history each of them stands
  // with this time, in ticks. What a line runs that its author did not write (files that it uses, commands of their
  // own) is not the host's: it happens as it stands.
  std::optional<Time> now = {};
  bool read_nothing = false;  // no files at all
  // Told the real path of each file that is asked for and may be read, whether it is there or not; some more than once.
  std::function<void(const std::string& path)> asked_for = {};
  bool tex = false;     // formulas are set by the programs latex and dvisvgm; else they are errors
  bool counts = false;  // a notice says of each command how many its pattern named, where that is more than one
  // What a script that is used (its real path) says by now, where somebody is writing it; none: what is in the file.
  std::function<std::optional<std::string>(const std::string& path)> written = {};
};

// Loads a plug-in (include/betwixt/plugin.h) for good: from now on its twerpers, filters, commands and functions are
// words of every script that is read. A script itself cannot do this: plug-ins are programs.
Status use_plugin(const std::string& path);

struct Loaded {
  Document document;        // what could be carried out
  Diagnostics diagnostics;  // everything there is to say, in the order of the text
};

// Never fails as a whole: what is wrong is among the diagnostics, each with its place.
Loaded load_file(const std::string& path, const LoadOptions& = {});
Loaded load_text(std::string_view text, const std::string& name, const LoadOptions& = {});

// The same script in canonical form; comments and commands stay. A text whose words, brackets or rows cannot be told
// apart comes back as it was; whether its commands can be carried out is not asked.
std::string tidy(std::string_view text);

// A script that makes this document: load_text(write(d)) == d.
std::string write(const Document&);

// "24f", "2.5s", "00:01:02.5" … at the document's rates.
// How long a shutter is open, in seconds: 180deg (of 360 a frame), 10ms, 0.5f or off. Errors: syntax, range.
Result<double> parse_shutter(std::string_view, const Document&);
Result<Time> parse_time(std::string_view text, const Document&);
// "24f" where t is on a frame, else seconds: "1.2345s".
std::string format_time(Time, const Document&);

// The targets a pattern names: "ball.position", "wheel*.{position,color}", "ball" (its position, rotation and scale …:
// all that is not at rest). Empty where nothing matches; an error where a name or a function does not exist.
Result<std::vector<Target>> find_targets(std::string_view pattern, const Document&);

}  // namespace betwixt
