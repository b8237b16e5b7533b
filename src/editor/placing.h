// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where in the author's text stands what was done by hand: an event that was changed changes its row, what is new goes
// to the end. Comments and layout stay.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/document.h"
#include "editor/step.h"

namespace betwixt {

// At a place of a text some of it is replaced.
struct TextEdit {
  std::size_t at = 0;
  std::string removed, inserted;
  friend bool operator==(const TextEdit&, const TextEdit&) = default;
};
using TextEdits = std::vector<TextEdit>;  // one after the other
void put_into(std::string& text, const TextEdits&);
void take_back(std::string& text, const TextEdits&);

// Lines of a text, the first is 1, that are replaced by others; last = first - 1: these stand before the first.
struct LineRange {
  int first = 1, last = 0;
};
// Errors: range (there are no such lines).
Result<TextEdit> replace_lines(std::string_view text, LineRange, std::string_view others);
// What takes one text to another in lines that follow each other.
struct LineChange {
  LineRange lines;
  std::string_view others;  // of the second text
};
LineChange change_between(std::string_view before, std::string_view after);

// The author's text as it is by now, and what each step did to it; those that were undone are behind.
struct PlacedText {
  std::string text;
  std::vector<TextEdits> edits;
};

// The rows of a text that makes `before` say what is otherwise in `after`; none where it is not in rows.
std::optional<TextEdits> place_in_rows(const std::string& text, const Document& before, const Document& after);
// What a step does to a text that makes `before`, so that it makes `after`. `makes`: whether a text makes that, which
// comes of such edits.
TextEdits place(const std::string& text, const Step&, const Document& before, const Document& after,
                const std::function<bool(const std::string&, const TextEdits&)>& makes);
// The same edit of the lines that it touches as wholes.
TextEdit whole_lines(std::string_view text, const TextEdit&);

// Two authors have changed a text; none where they have changed the same lines.
std::optional<std::string> merge(std::string_view base, std::string_view ours, std::string_view theirs);

}  // namespace betwixt
