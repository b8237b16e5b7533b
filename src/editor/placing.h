// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Finds where in the author's text an edit by hand belongs: a changed event changes its row, new lines go to the end.
// Comments and layout stay.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/document.h"
#include "editor/step.h"

namespace betwixt {

// A replacement at a place of a text.
struct TextEdit {
  std::size_t at = 0;
  std::string removed, inserted;
  friend bool operator==(const TextEdit&, const TextEdit&) = default;
};
using TextEdits = std::vector<TextEdit>;  // applied one after the other
inline void put_into(std::string& text, const TextEdits& edits) {
  for (const TextEdit& e : edits) text.replace(e.at, e.removed.size(), e.inserted);
}
inline void take_back(std::string& text, const TextEdits& edits) {
  for (auto e = edits.rbegin(); e != edits.rend(); ++e) text.replace(e->at, e->inserted.size(), e->removed);
}

// Lines of a text that are replaced, counted from 1. If last = first - 1, the new lines are inserted before the first.
struct LineRange {
  int first = 1, last = 0;
};
// Errors: range (the text has no such lines).
Result<TextEdit> replace_lines(std::string_view text, LineRange, std::string_view others);
// The change from one text to another, as one run of lines.
struct LineChange {
  LineRange lines;
  std::string_view others;  // of the second text
};
LineChange change_between(std::string_view before, std::string_view after);

// The author's current text, and the edits of each step; those of undone steps come last.
struct PlacedText {
  std::string text;
  std::vector<TextEdits> edits;
};

// Returns the edits of rows with which a text that makes `before` makes `after`; nullopt if the change is not in rows.
std::optional<TextEdits> place_in_rows(const std::string& text, const Document& before, const Document& after);
// Returns the edits of a step: they turn a text that makes `before` into one that makes `after`. `makes` checks whether
// an edited text makes that.
TextEdits place(const std::string& text, const Step&, const Document& before, const Document& after,
                const std::function<bool(const std::string&, const TextEdits&)>& makes);
// Returns the same edit, extended to whole lines.
TextEdit whole_lines(std::string_view text, const TextEdit&);

// Merges the changes of two authors. Returns nullopt if both changed the same lines.
std::optional<std::string> merge(std::string_view base, std::string_view ours, std::string_view theirs);

}  // namespace betwixt
