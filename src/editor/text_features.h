// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What an editor shows about a text: hover text, usage, completions, symbols, folds and colours.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/value.h"
#include "editor/completion.h"
#include "editor/text_names.h"

namespace betwixt {

// A word and its hover text, in lines.
struct Hover {
  Span word;
  std::string said;
};
std::optional<Hover> hover_at(const TextNames&, const FilmText&, std::size_t text, std::size_t place, const Document&);

// The usage of a line's command. Returns nullopt if the line has no known verb.
struct Usage {
  std::string_view written, sentence;
};
std::optional<Usage> usage_at(const ScriptText&, std::size_t place);

// Returns the file name at a place, as the line writes it; nullopt if there is none.
std::optional<std::string> used_at(const ScriptText&, std::size_t place);

// The completions of the word before a place; `from` is where the word begins.
struct Completions {
  std::size_t from = 0;
  std::vector<std::string> words;
  std::optional<Kind> kind;  // the kind whose functions they name, if they name any
};
Completions completions_at(const ScriptText&, std::size_t place, const Document&, const std::filesystem::path& folder);

// The symbols of a text in order: names that lines define, and sheets.
struct TextSymbol {
  std::string name, detail;      // as in the text
  std::optional<NameKind> made;  // nullopt for a sheet
  Span word, whole;              // `whole`: full lines, with the rows below
};
std::vector<TextSymbol> symbols(const ScriptText&);

// Lines that can be folded into the first: a sheet with its rows, a logical line over several lines, or comments.
struct Fold {
  std::size_t first = 0, last = 0;
  bool remark = false;
};
std::vector<Fold> folds(const ScriptText&);

// Returns the text with the part that `Span` touches tidied: whole commands, and sheets with their rows.
std::string tidied_in(const ScriptText&, Span);

struct ColorAt {
  Span span;
  Color color;
};
std::vector<ColorAt> colors_in(const ScriptText&, const Document&);
// Returns the ways to write a colour, the shortest first.
std::vector<std::string> ways_to_write(Color);

}  // namespace betwixt
