// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The tokens of a script. Every byte belongs to exactly one token, so the tokens of a text, put together, are the text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "syntax/characters.h"

namespace betwixt {

enum class TokenKind : std::uint8_t {
  space,    // blanks, tabs, commas, returns
  feed,     // a line feed
  comment,  // from '#' to the end of the line
  text,     // "…" or """…"""; of a single line, the part in this line
  open,     // (
  close,    // )
  sign,     // = or @
  word,     // anything else: a name, a pattern, a target, a number with its unit, a color
};

struct Token {
  std::size_t at = 0, size = 0;  // bytes, from the beginning of the text
  TokenKind kind = TokenKind::space;
  bool closed = true;  // false for a text without its closing quotes
  std::size_t end() const { return at + size; }
  friend bool operator==(const Token&, const Token&) = default;
};
inline bool is_space(const Token& t) { return t.kind == TokenKind::space || t.kind == TokenKind::feed; }

// What a line leaves open for the next one.
struct LineState {
  int brackets = 0;   // the number of open brackets
  bool text = false;  // a """ is open
  bool goes_on() const { return text || brackets > 0; }
  friend bool operator==(const LineState&, const LineState&) = default;
};

// Splits a line, or a text of several lines, into tokens. Accepts any bytes.
class Lexer {
 public:
  // `state`: that at the end of the line above.
  explicit Lexer(std::string_view text, LineState state = {}) : text_(text), state_(state) {}
  // Returns nullopt at the end of the text. Then state() is what the text leaves open.
  std::optional<Token> next();
  const LineState& state() const { return state_; }
  std::string_view of(const Token& t) const { return text_.substr(t.at, t.size); }

 private:
  std::string_view text_;
  LineState state_;
  std::size_t at_ = 0;
};

// Returns the tokens of a line. `state`: that of the line above; updated to that of this line.
std::vector<Token> tokens_of(std::string_view line, LineState& state);
// Updates the state only.
void pass_line(std::string_view line, LineState& state);
// Returns the last token that begins before a place of a line and is not white space.
std::optional<Token> token_before(std::string_view line, std::size_t place);

// A logical line from its beginning. Brackets and blocks join several lines.
struct LogicalLine {
  const char* end;    // its line feed, or the end of the text
  bool open = false;  // a bracket or a """ is still open at the end of the text
  int depth = 0;      // the number of brackets that are never closed
  bool whole = true;  // false if something is never closed; then `end` is the end of the first line
  const char* next(const char* text_end) const { return end == text_end ? end : end + 1; }
};
// Returns the logical line that the text begins with. If a bracket or a text in it is never closed, only its first line
// counts, so that the lines below keep their meaning.
LogicalLine logical_line(std::string_view text);

// Returns the words of the first line of a text, for commands that are not of the language (of the shell, of a host).
// Adjacent tokens make one word; a text in quotes is a word by itself, without its quotes. Leaves out comments.
std::vector<std::string> line_words(std::string_view text);
// Takes the next piece of a logical line: adjacent tokens, and everything that brackets enclose, such as a time or a
// value. Returns an empty text at the end of the line or before a comment.
std::string_view take_piece(std::string_view& rest);
inline std::string_view first_word(std::string_view line) { return take_piece(line); }
// Returns the end of the bracket that opens at `at`, or `at` if it is never closed.
const char* bracket_end(const char* at, const char* end);
// Returns a logical line without the white space and the comment at its end.
std::string_view without_comment(std::string_view line);
// Returns a line without the white space before its first word.
std::string_view without_indent(std::string_view line);
// Returns whether the first line of a text has no word: it holds nothing but white space and a comment.
bool empty_line(std::string_view text);
// Returns a text as one word of a line: in quotes if it would be several without.
std::string as_one_word(const std::string& text);

// Returns a script without the byte order mark that it may begin with.
std::string_view without_mark(std::string_view script);
// Returns the length of a first line that names the program for a script, "#!…", without its line feed; 0 if there is
// none. `script` has no byte order mark.
std::size_t program_line(std::string_view script);

}  // namespace betwixt
