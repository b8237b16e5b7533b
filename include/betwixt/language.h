// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Text to documents and back. The language is described in docs/language.md.
//
// Room: language
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "betwixt/document.h"

namespace betwixt {

struct LoadOptions {
  bool read_anywhere = false;  // else a script reads files only below its own folder
  // A live host's commands about environments happen when they come: the time of those that give none.
  std::optional<Time> now = {};
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
Result<Time> parse_time(std::string_view text, const Document&);
// "24f" where t is on a frame, else seconds: "1.2345s".
std::string format_time(Time, const Document&);

// The targets a pattern names: "ball.position", "wheel*.{position,color}", "ball" (its position, rotation and scale …:
// all that is not at rest). Empty where nothing matches; an error where a name or a function does not exist.
Result<std::vector<Target>> find_targets(std::string_view pattern, const Document&);

}  // namespace betwixt
