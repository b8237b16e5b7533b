// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The characters of a script: which ones separate words, and where a comment, a word, or a text in quotes ends. The
// functions take a place and the end of the text, and are fast enough for a reader that looks at every byte once.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace betwixt {

// White space between words. A comma counts as white space.
inline bool blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == ','; }
inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

inline constexpr auto word_ends = [] {
  std::array<bool, 256> ends{};
  for (const char c : std::string_view(" \n\t\r,()=\"@")) ends[static_cast<unsigned char>(c)] = true;
  return ends;
}();
inline bool ends_word(char c) { return word_ends[static_cast<unsigned char>(c)]; }

inline std::string_view between(const char* from, const char* to) {
  return {from, static_cast<std::size_t>(to - from)};
}

// Returns the first line feed at or after `from`, or `end`.
inline const char* line_end(const char* from, const char* end) { return std::find(from, end, '\n'); }

// A comment is '#' before white space or the end of the text. `#ffcc00` is a color.
inline bool begins_comment(const char* at, const char* end) {
  return *at == '#' && (at + 1 == end || at[1] == ' ' || at[1] == '\t' || at[1] == '\n' || at[1] == '\r');
}

// Returns the end of the word that begins at `at`: a name, a pattern, a target, a number with its unit. Braces hold
// commas and blanks together. Returns `at` if a bracket, a quote or another separator is there.
inline const char* word_end(const char* at, const char* end) {
  for (int braces = 0; at < end && *at != '\n'; ++at) {
    braces += (*at == '{') - (*at == '}');
    if (braces <= 0 && ends_word(*at)) break;
  }
  return at;
}

// Skips white space and comments. Inside brackets this includes line feeds; outside it stops at them.
inline const char* space_end(const char* at, const char* end, bool in_brackets) {
  for (; at < end; ++at) {
    if (blank(*at) || (*at == '\n' && in_brackets)) continue;
    if (!begins_comment(at, end)) return at;
    at = line_end(at, end);
    if (at == end || !in_brackets) return at;
  }
  return at;
}

// A text in quotes is "…", which ends in its line, or a block, """…""", which may have several lines.
inline bool begins_block(const char* at, const char* end) {
  return end - at >= 3 && at[0] == '"' && at[1] == '"' && at[2] == '"';
}
// Returns the number of quotes that a text begins and ends with.
inline std::size_t quotes_of(std::string_view text) {
  return begins_block(text.data(), text.data() + text.size()) ? 3 : 1;
}
struct QuotedEnd {
  const char* at;       // after the closing quotes; if they are missing, the end of the line or of all text
  bool closed = false;  // the closing quotes are there
};
// Returns the end of a block whose opening quotes are before `at`.
inline QuotedEnd block_end(const char* at, const char* end) {
  const std::size_t close = between(at, end).find("\"\"\"");
  return close == std::string_view::npos ? QuotedEnd{end} : QuotedEnd{at + close + 3, true};
}
// Returns the end of the text whose opening quote is at `at`.
inline QuotedEnd quoted_end(const char* at, const char* end) {
  if (begins_block(at, end)) return block_end(at + 3, end);
  for (++at; at < end && *at != '\n'; ++at) {
    if (*at == '"') return {at + 1, true};
    if (*at == '\\' && at + 1 < end && at[1] != '\n') ++at;
  }
  return {at};
}
// Quick tests. They return true for quotes in a comment, too.
inline bool may_hold_text(std::string_view s) { return s.find('"') != std::string_view::npos; }
inline bool may_hold_block(std::string_view s) { return s.find("\"\"\"") != std::string_view::npos; }

// Returns whether the line begins with white space: it is a row of the sheet or list above it.
inline bool indented(std::string_view line) { return !line.empty() && blank(line[0]); }
// Returns how many bytes of white space the line begins with.
inline std::size_t indentation(std::string_view line) {
  std::size_t n = 0;
  while (n < line.size() && blank(line[n])) ++n;
  return n;
}
inline bool starts_like_time(char c) { return is_digit(c) || c == '-' || c == '+' || c == '.'; }

// Returns the place of the dot between an object's name and its function; npos if there is none. Skips dots inside
// braces ({1..100}).
inline std::size_t first_dot(std::string_view word) {
  int braces = 0;
  for (std::size_t i = 0; i < word.size(); ++i) {
    braces += (word[i] == '{') - (word[i] == '}');
    if (word[i] == '.' && braces <= 0) return i;
  }
  return std::string_view::npos;
}

}  // namespace betwixt
