// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where in a script events and values are said: rows of sheets, `at` and `set` lines, what stands where a thing is
// created.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "betwixt/document.h"

namespace betwixt {

// A part of the text.
struct Span {
  std::size_t at = 0, size = 0;
  std::size_t end() const { return at + size; }
};
// A row, or an `at` line, of which one event each comes.
struct RowText {
  Span line;  // with its new line
  Span time, rest;
  Time when;
  bool relative = false;  // +12f
};
// A sheet with its rows, or a line that stands alone.
struct SheetText {
  std::vector<Target> targets;
  Span opener;
  std::vector<RowText> rows;
  bool alone = false;
};
// What is said of a value for the whole film: of its target alone.
struct ValueText {
  Target target;
  Span value;
};
// What of a text has to do with some targets.
struct TextRows {
  std::vector<SheetText> sheets;
  std::vector<ValueText> values;
};

// All that speaks of the targets, in the order of the text. What cannot be told apart, as rows with formulas for times,
// is left out with its sheet.
TextRows rows_about(const std::string& text, const Document&, std::span<const Target>);

}  // namespace betwixt
