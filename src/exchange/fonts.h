// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Text as closed contours, through FreeType and HarfBuzz.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "betwixt/math.h"
#include "betwixt/result.h"

namespace betwixt {

// One closed line in the plane; filled by the non-zero rule together with the others of its outline.
using Contour = std::vector<Vec3>;
// What belongs together: a character with its accents, a ligature.
struct Letter {
  std::size_t first = 0;  // of its contours; they end where the next letter's begin
  std::string text;       // as written (UTF-8)
};
struct Outline {
  std::vector<Contour> contours;
  std::vector<Letter> letters;  // from left to right, line by line; blanks are left out
};

// Whether the machine has a font of this family name; a near miss goes into the error's hint.
Status find_font(const std::string& family);
// `text` (UTF-8, lines end with \n) at 1 m an em, centred about x = 0, the first baseline at y = 0. A family that the
// machine lacks is replaced by DejaVu Sans, or any other it has.
Outline text_outline(const std::string& text, const std::string& family);

// The same, each glyph that occurs once, and where they stand.
struct SetText {
  struct Glyph {
    std::uint32_t number = 0;  // of the font's
    Outline outline;           // without letters
  };
  struct Place {
    std::size_t glyph = 0;
    Vec3 at;
  };
  std::vector<Glyph> glyphs;
  std::vector<Place> places;
};
SetText set_text(const std::string& text, const std::string& family);

}  // namespace betwixt
