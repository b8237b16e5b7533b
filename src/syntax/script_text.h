// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A script as lines and tokens. Lines are numbered from 0. An edit lexes only the logical lines that it touches, and
// those that a missing bracket or quote above makes uncertain.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "syntax/tokens.h"

namespace betwixt {

// A part of a text, in bytes.
struct Span {
  std::size_t at = 0, size = 0;
  std::size_t end() const { return at + size; }
};

class ScriptText {
 public:
  explicit ScriptText(std::string text = {}) { assign(std::move(text)); }
  void assign(std::string text);
  // Replaces a part of the text.
  void replace(Span, std::string_view by);

  const std::string& text() const { return text_; }
  // A text that ends with a line feed has an empty line after it.
  std::size_t count() const { return starts_.size(); }
  std::size_t start(std::size_t line) const { return starts_[line]; }
  // Returns a line without its end: the line feed, and the return before that.
  std::string_view line(std::size_t line) const;
  // Returns the line that contains a place, in bytes.
  std::size_t line_of(std::size_t place) const;

  // Returns what the line above leaves open. The lines below a bracket or a text that is never closed start anew, as
  // they do for the reader.
  const LineState& state_above(std::size_t line) const { return above_[line]; }
  // Returns the tokens of a line with its end; their places count from the beginning of the line. The tokens of all
  // lines, put together, are the text.
  std::vector<Token> tokens(std::size_t line) const;
  // Returns the token that contains a place of a line, or that ends there. Where two tokens meet, returns the second.
  std::optional<Token> token_at(std::size_t line, std::size_t place_in_line) const;

  // Returns the first line of the logical line that contains this line, and the line after its last.
  std::size_t first_of(std::size_t line) const;
  std::size_t behind(std::size_t line) const;
  // Returns the first line of the command that is written up to a place. Unlike first_of(), takes a bracket that is
  // still open there as one that will be closed, if the lines since then are indented.
  std::size_t first_before(std::size_t place) const;
  // Returns whether a line holds nothing but a comment; nothing but a comment or white space.
  bool only_comment(std::size_t line) const;
  bool empty(std::size_t line) const;

 private:
  std::string_view with_end(std::size_t line) const;
  std::size_t head() const;
  std::size_t lex(std::size_t line);
  void lex_from(std::size_t line, std::size_t last);

  std::string text_;
  std::vector<std::size_t> starts_;
  std::vector<LineState> above_;
  std::vector<bool> broken_;  // of lines with a bracket or a text that is never closed
};

// Returns the starts of the lines of a text, each with its line feed. The empty text has none.
std::vector<std::size_t> line_starts(std::string_view text);
// Returns the line that begins at a place, with its line feed.
std::string_view line_at(std::string_view text, std::size_t start);

}  // namespace betwixt
