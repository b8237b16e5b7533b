// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The lines of a text: the ends of logical lines, invalid characters, and diagnostics with a place.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "betwixt/result.h"

namespace betwixt {

// A text that is being read, and its name.
class Source {
 public:
  Source() = default;
  Source(std::string_view words, std::string called) : text(words), name(std::move(called)) {}

  std::string_view text;
  std::string name;

  // Returns a diagnostic with the place of `about`, a part of the text, and the line around it.
  Diagnostic diagnose(Severity, Error, std::string_view about);

 private:
  const char* counted_ = nullptr;  // lines are counted up to here
  int lines_ = 1;
};

// Finds a byte that no text may contain. Returns nullopt if there is none. Errors: file.
struct Unsound {
  std::size_t at;  // byte
  Error why;
};
std::optional<Unsound> unsound(std::string_view text);

}  // namespace betwixt
