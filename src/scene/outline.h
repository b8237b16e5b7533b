// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Letters as closed contours.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "betwixt/shape.h"

namespace betwixt {

// A closed line in the plane, filled by the non-zero rule together with the others of its outline.
using Contour = std::vector<Vec3>;
// The contours of one unit: a character with its accents, a ligature, or a glyph or bar of a formula.
struct Letter {
  std::size_t first = 0;  // its first contour; they end where the next letter's begin
  std::string text;       // as written (UTF-8); for formulas, an identification of the glyph
  std::string part = {};  // the part of a formula or of code that it belongs to (formula_parts.h); "": to none
  std::size_t at = 0;     // of texts: its first byte
};
struct Outline {
  std::vector<Contour> contours;
  std::vector<Letter> letters;  // from left to right, line by line, without blanks
};

inline constexpr double line_spacing = 1.2;     // em
inline constexpr double capital_height = 0.73;  // em; that of DejaVu Sans, and nearly that of most fonts
// Returns the y of the first baseline, in em.
inline double first_baseline(Anchor anchor, double lines) {
  const double last = line_spacing * (lines - 1);
  switch (anchor) {
    case Anchor::top:
      return -capital_height;
    case Anchor::middle:
      return (last - capital_height) / 2;
    case Anchor::bottom:
      return last;
    default:
      return 0;
  }
}

// Leaves out the letters of parts that the shape does not draw.
void keep_shown_parts(Outline&, const Shape&);
// Returns the formula of a text in its size, aligned, as far as it is typed. The shape must have a `formula`.
Outline set_formula(const Shape&);
// Whether the shape draws the letters of a part (""; those of none).
bool shows_part(const Shape&, std::string_view part);

}  // namespace betwixt
