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

// Its line as a terminal or a page may show it (utf8.h): what stands before the place, and how long the marked part is.
struct ShownLine {
  std::string line, before;
  std::size_t length = 1;
};
ShownLine shown_line(const Diagnostic&);

// Gives it the place at which a part, of one line or of several, first stands in a text; where it is not in it, none.
void point_at(Diagnostic&, std::string_view text, std::string_view part);

}  // namespace betwixt
