// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Letters as closed contours.
#pragma once

#include <string>
#include <vector>

#include "betwixt/shape.h"

namespace betwixt {

// One closed line in the plane; filled by the non-zero rule together with the others of its outline.
using Contour = std::vector<Vec3>;
// What belongs together: a character with its accents, a ligature, a glyph or a bar of a formula.
struct Letter {
  std::size_t first = 0;  // of its contours; they end where the next letter's begin
  std::string text;       // as written (UTF-8); of a formula's: what tells one glyph from others
};
struct Outline {
  std::vector<Contour> contours;
  std::vector<Letter> letters;  // from left to right, line by line; blanks are left out
};

// The formula of a text in its size, aligned, so far as it is typed. There is one: `formula` of the shape.
Outline set_formula(const Shape&);

}  // namespace betwixt
