// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A text by its lines, with what goes on over their ends: whoever asks about a place in a text begins here.
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
  std::size_t count() const { return starts_.size(); }  // a text that ends with a new line has an empty one behind it
  std::size_t start(std::size_t line) const { return starts_[line]; }
  // Without its end; a return in front of that is a part of the end.
  std::string_view line(std::size_t line) const;
  std::size_t line_of(std::size_t place) const;
  // What is open above a line: of a text that nobody changes meanwhile.
  LineState state_above(std::size_t line) const;
  // The line that a logical line, of which this is a part, begins with; the one behind its last.
  std::size_t first_of(std::size_t line) const;
  std::size_t behind(std::size_t line) const;
  // The line that opened the sheet or list that a line stands in; `count()`: none is open there.
  std::size_t opener_of(std::size_t line) const;

 private:
  void know_states() const;

  std::string text_;
  std::vector<std::size_t> starts_;
  mutable std::vector<LineState> above_;  // empty: nobody has asked
};

}  // namespace betwixt
