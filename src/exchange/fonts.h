// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Converts text to closed contours, through FreeType and HarfBuzz.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "exchange/typefaces.h"
#include "scene/outline.h"

namespace betwixt {

// Returns the outline of `text` (UTF-8, lines end with \n) at 1 m an em, with the first baseline at y = 0. Uses DejaVu
// Sans, or any other font, if the machine lacks the family.
Outline text_outline(const std::string& text, const std::string& family, const Letters& = {});

// The same text as distinct glyphs and their places.
struct SetText {
  struct Glyph {
    std::uint32_t number = 0;  // in the font
    Outline outline;           // without letters
  };
  struct Place {
    std::size_t glyph = 0;
    Vec3 at;
  };
  std::vector<Glyph> glyphs;
  std::vector<Place> places;
};
SetText set_text(const std::string& text, const std::string& family, const Letters& = {});

// The parts into which a text is split, each a text of its own, in reading order. Parts that draw nothing are left out.
enum class SplitInto : std::uint8_t { letters, words, lines };
struct TextPart {
  std::string text;
  Vec3 at;  // the position at which the part, centred, coincides with its place in the whole text
};
std::vector<TextPart> text_parts(const std::string& text, const std::string& family, const Letters&, SplitInto);

}  // namespace betwixt
