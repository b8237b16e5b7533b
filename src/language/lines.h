// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Texts by their lines: where a logical line ends, whether a text can be read at all, and what there is to say about a
// place in it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "betwixt/result.h"

namespace betwixt {

inline std::string_view between(const char* from, const char* to) {
  return {from, static_cast<std::size_t>(to - from)};
}

// From a line's beginning on: brackets and texts in """ hold lines together.
struct LogicalLine {
  const char* end;    // at the new line behind it, or at the end of the text
  bool open = false;  // a bracket or a """ is open where the text ends: it goes on
  int depth = 0;      // brackets that are open there; then `end` is that of the first line
  const char* next(const char* text_end) const { return end == text_end ? end : end + 1; }
};
LogicalLine logical_line(std::string_view text);

// A text that is being read, and its name.
class Source {
 public:
  Source() = default;
  Source(std::string_view words, std::string called) : text(words), name(std::move(called)) {}

  std::string_view text;
  std::string name;

  // With the place of `about`, a part of the text, and the line around it.
  Diagnostic diagnose(Severity, Error, std::string_view about);

 private:
  const char* counted_ = nullptr;  // lines are counted up to here
  int lines_ = 1;
};

// Where a text holds what no text holds. Errors: file.
struct Unsound {
  std::size_t at;  // byte
  Error why;
};
std::optional<Unsound> unsound(std::string_view text);

}  // namespace betwixt
