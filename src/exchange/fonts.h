// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Converts text to closed contours, through FreeType and HarfBuzz.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "exchange/typefaces.h"
#include "scene/outline.h"
#include "scene/own_font.h"

namespace betwixt {

// A font: one of the machine's, or the film's own.
struct FontName {
  FontName(std::string family) : name(std::move(family)) {}  // NOLINT: every family is one
  FontName(const char* family) : name(family) {}             // NOLINT
  FontName(std::string file, std::shared_ptr<const OwnFont> font) : name(std::move(file)), own(std::move(font)) {}
  std::string name;
  std::shared_ptr<const OwnFont> own;  // nullptr: the machine's
};
inline FontName font_of(const Shape& s) { return {*s.font, s.own_font}; }
// What tells fonts apart. The style has no effect on a font's file: it has one.
inline Typeface typeface_of(const FontName& font, const Letters& letters) {
  if (font.own) return {font.own->digest};
  return {font.name, letters.weight, letters.italic};
}

// Returns a shape's letters for the functions below, whose lengths are in em.
inline Letters letters_of(const Shape& s) {
  Letters letters = s.letters;
  if (s.size.y > 0) letters.wrap /= s.size.y;
  return letters;
}

// Returns the outline of `text` (UTF-8, lines end with \n) at 1 m an em, with the first baseline at y = 0. Uses DejaVu
// Sans, or any other font, if the machine lacks the family. Letters are missing if an own font is damaged.
Outline text_outline(const std::string& text, const FontName& font, const Letters& = {});

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
SetText set_text(const std::string& text, const FontName& font, const Letters& = {});

// The parts into which a text is split, each a text of its own, in reading order. Parts that draw nothing are left out.
enum class SplitInto : std::uint8_t { letters, words, lines };
struct TextPart {
  std::string text;
  Vec3 at;  // the position at which the part, centred, coincides with its place in the whole text
};
std::vector<TextPart> text_parts(const std::string& text, const FontName& font, const Letters&, SplitInto);

}  // namespace betwixt
