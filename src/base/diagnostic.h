// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Finds the place of a diagnostic in a text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "betwixt/result.h"

namespace betwixt {

// The line of a diagnostic, safe to show in a terminal or a page (utf8.h), the text before the place, and the length of
// the marked part.
struct ShownLine {
  std::string line, before;
  std::size_t length = 1;
};
ShownLine shown_line(const Diagnostic&);

// Sets the place to the first occurrence of `part` in the text. `part` may have several lines. Does nothing if the text
// does not contain it.
void point_at(Diagnostic&, std::string_view text, std::string_view part);

}  // namespace betwixt
