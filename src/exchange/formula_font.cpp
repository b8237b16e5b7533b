// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/formula_font.h"

#include <algorithm>
#include <array>

namespace betwixt {
namespace {

hb_direction_t direction_of(Stretch s) { return s == Stretch::tall ? HB_DIRECTION_BTT : HB_DIRECTION_LTR; }

}  // namespace

MathFont::MathFont(std::unique_ptr<FontFace> face) : face_(std::move(face)) {
  maths_ = face_ ? face_->shaper() : nullptr;
  if (maths_ != nullptr) unit_ = 1 / (64.0 * hb_face_get_upem(hb_font_get_face(maths_)));
}

double MathFont::constant(hb_ot_math_constant_t c) const { return em(hb_ot_math_get_constant(maths_, c)); }
double MathFont::share(hb_ot_math_constant_t c) const { return hb_ot_math_get_constant(maths_, c) / 100.0; }

std::optional<std::uint32_t> MathFont::glyph(char32_t c) const {
  hb_codepoint_t out = 0;
  if (!hb_font_get_nominal_glyph(maths_, c, &out) || out == 0) return std::nullopt;
  return out;
}

std::uint32_t MathFont::for_script(std::uint32_t glyph, int level) const {
  static constexpr hb_tag_t scripts[] = {HB_OT_TAG_MATH_SCRIPT, HB_OT_TAG_DEFAULT_SCRIPT};
  hb_face_t* const face = hb_font_get_face(maths_);
  for (const hb_tag_t tag : scripts) {
    unsigned script = 0, feature = 0;
    hb_tag_t chosen = 0;
    if (!hb_ot_layout_table_select_script(face, HB_OT_TAG_GSUB, 1, &tag, &script, &chosen)) continue;
    if (!hb_ot_layout_language_find_feature(face, HB_OT_TAG_GSUB, script, HB_OT_LAYOUT_DEFAULT_LANGUAGE_INDEX,
                                            HB_TAG('s', 's', 't', 'y'), &feature))
      continue;
    unsigned lookups[4] = {}, count = 4;
    hb_ot_layout_feature_get_lookups(face, HB_OT_TAG_GSUB, feature, 0, &count, lookups);
    for (unsigned i = 0; i < count; ++i) {
      std::array<hb_codepoint_t, 2> forms{};
      unsigned found = static_cast<unsigned>(forms.size());
      hb_ot_layout_lookup_get_glyph_alternates(face, lookups[i], glyph, 0, &found, forms.data());
      if (found > 0) return forms[std::min<unsigned>(static_cast<unsigned>(level), found) - 1];
    }
  }
  return glyph;
}

double MathFont::advance(std::uint32_t glyph) const { return em(hb_font_get_glyph_h_advance(maths_, glyph)); }
double MathFont::italics(std::uint32_t glyph) const {
  return em(hb_ot_math_get_glyph_italics_correction(maths_, glyph));
}
double MathFont::accent_middle(std::uint32_t glyph) const {
  return em(hb_ot_math_get_glyph_top_accent_attachment(maths_, glyph));
}
double MathFont::kern(std::uint32_t glyph, hb_ot_math_kern_t corner, double height) const {
  return em(hb_ot_math_get_glyph_kerning(maths_, glyph, corner, static_cast<hb_position_t>(height / unit_)));
}

const MathExtents& MathFont::extents(std::uint32_t glyph) {
  const auto [at, fresh] = extents_.try_emplace(glyph);
  if (!fresh) return at->second;
  double low_x = 1e9, high_x = -1e9, low_y = 1e9, high_y = -1e9;
  for (const Contour& c : face_->glyph(glyph))
    for (const Vec3 p : c) {
      low_x = std::min(low_x, p.x), high_x = std::max(high_x, p.x);
      low_y = std::min(low_y, p.y), high_y = std::max(high_y, p.y);
    }
  if (high_x >= low_x) at->second = {low_x, high_x, high_y, -low_y};
  return at->second;
}

std::vector<MathFont::Longer> MathFont::longer(std::uint32_t glyph, Stretch s) const {
  std::array<hb_ot_math_glyph_variant_t, 32> all{};
  unsigned count = static_cast<unsigned>(all.size());
  hb_ot_math_get_glyph_variants(maths_, glyph, direction_of(s), 0, &count, all.data());
  std::vector<Longer> out;
  for (unsigned i = 0; i < count; ++i) out.push_back({all[i].glyph, em(all[i].advance)});
  return out;
}

std::vector<MathPiece> MathFont::pieces(std::uint32_t glyph, Stretch s) const {
  std::array<hb_ot_math_glyph_part_t, 16> all{};
  unsigned count = static_cast<unsigned>(all.size());
  hb_position_t italics = 0;
  hb_ot_math_get_glyph_assembly(maths_, glyph, direction_of(s), 0, &count, all.data(), &italics);
  std::vector<MathPiece> out;
  for (unsigned i = 0; i < count; ++i)
    out.push_back({all[i].glyph, em(all[i].start_connector_length), em(all[i].end_connector_length),
                   em(all[i].full_advance), (all[i].flags & HB_OT_MATH_GLYPH_PART_FLAG_EXTENDER) != 0});
  return out;
}

double MathFont::least_overlap(Stretch s) const {
  return em(hb_ot_math_get_min_connector_overlap(maths_, direction_of(s)));
}

}  // namespace betwixt
