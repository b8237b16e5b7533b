// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/said_line.h"

#include "language/line_words.h"
#include "language/reader.h"

namespace betwixt {
namespace {

// Where the first logical line of a text ends, and whether it is still open there.
struct LogicalLine {
  const char* end;
  bool open = false;
};
LogicalLine logical_line(std::string_view text) {
  Cursor c(text);
  while (c.at < c.end) {
    c.space();
    if (c.at == c.end) break;
    if (*c.at == '\n') return {c.at};
    if (*c.at == '"') {
      const char* start = c.at;
      const bool block = text.substr(static_cast<std::size_t>(start - text.data())).starts_with("\"\"\"");
      std::string ignored;
      if (!c.text(ignored)) return {line_end(start, c.end), block};
      continue;
    }
    if (*c.at == '(') ++c.depth;
    if (*c.at == ')' && c.depth > 0) --c.depth;
    if (c.depth > 200) return {line_end(c.at, c.end)};
    if (c.word().empty()) ++c.at;
  }
  return {c.end, c.depth > 0};
}

}  // namespace

SaidLine look_at(std::string_view text) {
  const LogicalLine line = logical_line(text);
  return {text, first_word(text), line_words(text), indented(text), line.open, line.end != text.data() + text.size()};
}

bool is_verb(std::string_view word) {
  for (const auto& [verb, usage] : Reader::words())
    if (verb == word) return true;
  return false;
}

bool goes_on(std::string_view text) { return logical_line(text).open; }

}  // namespace betwixt
