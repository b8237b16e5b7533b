// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Diagnostics and problems in words, and the place of a diagnostic in a text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/problem.h"
#include "betwixt/result.h"

namespace betwixt {

// The line of a diagnostic, safe to show in a terminal or a page (utf8.h), the text before the place, and the length of
// the marked part.
struct ShownLine {
  std::string line, before;
  std::size_t length = 1;
};
ShownLine shown_line(const Diagnostic&);

// Sets the place to the problem's line in the first occurrence of its code in the text. The place then says the line,
// so the problem's becomes 0. `code`: as the text has it. Does nothing if the text does not contain it.
void point_at(Diagnostic&, Problem&, std::string_view text, std::string_view code);

// Returns "line 3: message" for an error in code of several lines; the message alone for line 0.
std::string with_line(int line, const std::string& message);
std::vector<std::string> to_strings(const std::vector<Problem>&);

}  // namespace betwixt
