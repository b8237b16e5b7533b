// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Text as closed contours, through FreeType and HarfBuzz.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "exchange/typefaces.h"
#include "scene/outline.h"

namespace betwixt {

// `text` (UTF-8, lines end with \n) at 1 m an em, the first baseline at y = 0. A family that the machine lacks is
// replaced by DejaVu Sans, or any other it has.
Outline text_outline(const std::string& text, const std::string& family, const Letters& = {});

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
SetText set_text(const std::string& text, const std::string& family, const Letters& = {});

// What a text can be taken apart into, each a text of its own, in the order in which they are read; what draws nothing
// is left out.
enum class SplitInto : std::uint8_t { letters, words, lines };
struct TextPart {
  std::string text;
  Vec3 at;  // where it stands, set by itself and centred, as it stood in the whole
};
std::vector<TextPart> text_parts(const std::string& text, const std::string& family, const Letters&, SplitInto);

}  // namespace betwixt
