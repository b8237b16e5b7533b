// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A font with a MATH table (OpenType): its constants, the taller and wider variants of its glyphs, and their contours.
// Lengths are in em. One thread at a time may use it.
#pragma once

#include <hb-ot.h>

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "exchange/font_face.h"

namespace betwixt {

// How far a glyph reaches from its origin; `depth` is positive below the baseline.
struct MathExtents {
  double left = 0, right = 0, height = 0, depth = 0;
};

// A piece of a glyph that is put together to any length.
struct MathPiece {
  std::uint32_t glyph = 0;
  double begin = 0, end = 0, length = 0;  // how far neighbours may overlap it at both ends, and its whole length
  bool repeats = false;
};

enum class Stretch : std::uint8_t { tall, wide };

class MathFont {
 public:
  explicit MathFont(std::unique_ptr<FontFace> face);
  bool usable() const { return maths_ != nullptr && hb_ot_math_has_data(hb_font_get_face(maths_)); }

  double constant(hb_ot_math_constant_t) const;
  double share(hb_ot_math_constant_t) const;  // a percentage, as a factor
  std::optional<std::uint32_t> glyph(char32_t) const;
  std::uint32_t for_script(std::uint32_t glyph, int level) const;  // its form for scripts (1) and their scripts (2)
  double advance(std::uint32_t glyph) const;
  double italics(std::uint32_t glyph) const;
  double accent_middle(std::uint32_t glyph) const;
  double kern(std::uint32_t glyph, hb_ot_math_kern_t corner, double height) const;
  const MathExtents& extents(std::uint32_t glyph);
  const Contours& contours(std::uint32_t glyph) { return face_->glyph(glyph); }

  // The glyphs that replace one, by increasing length, and the pieces for any length (from the bottom or the left).
  struct Longer {
    std::uint32_t glyph = 0;
    double length = 0;
  };
  std::vector<Longer> longer(std::uint32_t glyph, Stretch) const;
  std::vector<MathPiece> pieces(std::uint32_t glyph, Stretch) const;
  double least_overlap(Stretch) const;

 private:
  double em(hb_position_t n) const { return unit_ * n; }
  std::unique_ptr<FontFace> face_;
  hb_font_t* maths_ = nullptr;
  double unit_ = 0;
  std::map<std::uint32_t, MathExtents> extents_;
};

}  // namespace betwixt
