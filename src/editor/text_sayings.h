// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What an editor shows of a text beside its letters: what a word is, what there is in the text, its colours, and where
// it can be folded.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/value.h"
#include "editor/completion.h"
#include "editor/text_names.h"

namespace betwixt {

// A word and what there is to say about it, as lines.
struct Saying {
  Span word;
  std::string said;
};
std::optional<Saying> said_at(const TextNames&, const FilmText&, std::size_t text, std::size_t place, const Document&);

// How the command of a line is written; none where it has no verb that is known.
struct Usage {
  std::string_view written, sentence;
};
std::optional<Usage> usage_at(const TextLines&, std::size_t place);

// The file that the line uses, as it is written, where the place is in that.
std::optional<std::string> used_at(const TextLines&, std::size_t place);

// What the word in front of a place can become; `from` is where it begins.
struct Completions {
  std::size_t from = 0;
  std::vector<std::string> words;
};
Completions completions_at(const TextLines&, std::size_t place, const Document&, const std::filesystem::path& folder);

// What there is in a text, in its order: what lines make, and sheets.
struct TextSymbol {
  std::string name, detail;      // as they are written
  std::optional<NameKind> made;  // none: it is a sheet
  Span word, whole;              // `whole`: lines, with the rows below
};
std::vector<TextSymbol> symbols(const TextLines&);

// Lines that follow each other and can be hidden but for the first: sheets with their rows, what goes on over the end
// of a line, remarks.
struct Fold {
  std::size_t first = 0, last = 0;
  bool remark = false;
};
std::vector<Fold> folds(const TextLines&);

// The text where what a part of it touches is tidy: whole commands, and sheets with their rows.
std::string tidied_in(const TextLines&, Span);

struct ColorAt {
  Span span;
  Color color;
};
std::vector<ColorAt> colors_in(const TextLines&, const Document&);
// The ways to write a colour, the shortest first.
std::vector<std::string> ways_to_write(Color);

}  // namespace betwixt
