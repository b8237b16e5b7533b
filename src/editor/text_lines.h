// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A text as lines, with the lexical state at each line's start. All lookups by place in a text use it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "editor/line_pieces.h"
#include "editor/text_rows.h"

namespace betwixt {

class TextLines {
 public:
  explicit TextLines(std::string text = {}) { take(std::move(text)); }
  void take(std::string text);
  void replace(Span, std::string_view others);

  const std::string& text() const { return text_; }
  std::size_t count() const { return starts_.size(); }  // a text that ends with a new line has an empty last line
  std::size_t start(std::size_t line) const { return starts_[line]; }
  // Returns the line without its line ending; a carriage return belongs to the ending.
  std::string_view line(std::size_t line) const;
  std::size_t line_of(std::size_t place) const;
  // Returns the lexical state above a line. Do not change the text at the same time.
  LineState state_above(std::size_t line) const;
  // Returns the first line of the logical line that contains this line; behind(): the line after its last.
  std::size_t first_of(std::size_t line) const;
  std::size_t behind(std::size_t line) const;
  // Returns the line that opened the sheet or list around a line, or `count()` if none is open.
  std::size_t opener_of(std::size_t line) const;

 private:
  void know_states() const;

  std::string text_;
  std::vector<std::size_t> starts_;
  mutable std::vector<LineState> above_;  // cached; empty until the first call
};

}  // namespace betwixt
