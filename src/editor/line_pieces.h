// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What the words of a line are, line by line, without carrying anything out: for editors that colour them. All words
// come from the tables that the language itself is read by.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/document.h"

namespace betwixt {

// What goes on over the end of a line.
struct LineState {
  int brackets = 0;   // open
  bool text = false;  // a """ is open
  bool goes_on() const { return text || brackets > 0; }
  friend bool operator==(const LineState&, const LineState&) = default;
};

enum class Meaning : std::uint8_t { comment, text, verb, kind, function, twerper, option, time, number, color, name };

struct LinePiece {
  std::size_t at = 0, length = 0;  // bytes
  Meaning meaning = Meaning::comment;
  friend bool operator==(const LinePiece&, const LinePiece&) = default;
};

// The pieces of one line that mean something, in order. `state`: of the line above, and then of this one.
std::vector<LinePiece> line_pieces(std::string_view line, LineState& state, const Document&);
// The state alone.
void pass_line(std::string_view line, LineState& state);

// Words that are options, wherever they stand in a line: to, by, keep-world …
const std::vector<std::string_view>& option_words();

// The number that stands at a place of a line, with its sign, without its unit: "-0.50" of "(1 -0.50deg 3)".
struct NumberAt {
  std::size_t at = 0, length = 0;
};
std::optional<NumberAt> number_at(std::string_view line, std::size_t place);
// A number as it is written, some steps of its last digit further: "0.50" and 3 are "0.53". `finer`: steps of one digit
// more behind the point.
std::string stepped(std::string_view number, int steps, bool finer = false);
// The time that stands at a place of a line; of a segment the end that is there. None: none does, or it counts from the
// row above.
std::optional<Time> time_at(std::string_view line, std::size_t place, const Document&);

}  // namespace betwixt
