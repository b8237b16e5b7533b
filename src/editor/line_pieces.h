// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The tokens of a line and their meanings, for syntax colouring; no line is carried out. All words come from the tables
// of the language.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/document.h"
#include "syntax/tokens.h"

namespace betwixt {

enum class Meaning : std::uint8_t { comment, text, verb, kind, function, twerper, option, time, number, color, name };

struct LinePiece {
  std::size_t at = 0, length = 0;  // bytes
  Meaning meaning = Meaning::comment;
  friend bool operator==(const LinePiece&, const LinePiece&) = default;
};

// Returns the tokens of one line that have a meaning, in order. `state`: that of the line above; updated to that of
// this line. `row`: whether the line is a row of a sheet or list.
std::vector<LinePiece> line_pieces(std::string_view line, LineState& state, const Document&, bool row);
inline std::vector<LinePiece> line_pieces(std::string_view line, LineState& state, const Document& d) {
  return line_pieces(line, state, d, indented(line));
}

// Returns the words that are options in any line: to, by, keep-world …
const std::vector<std::string_view>& option_words();

// The number at a place of a line, with its sign and without its unit: "-0.50" of "(1 -0.50deg 3)".
struct NumberAt {
  std::size_t at = 0, length = 0;
};
std::optional<NumberAt> number_at(std::string_view line, std::size_t place);
// Returns a number as it is written, changed by `steps` of its last digit: "0.50" and 3 give "0.53". `finer`: adds a
// decimal digit first.
std::string stepped(std::string_view number, int steps, bool finer = false);
// Returns the time at a place of a line; in a segment, the end at that place. Returns nullopt if there is no time, or
// if it is relative to the row above.
std::optional<Time> time_at(std::string_view line, std::size_t place, const Document&);

}  // namespace betwixt
