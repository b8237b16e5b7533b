// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Glyphs of any size: variants, and pieces that are put together.
#include <algorithm>
#include <cmath>

#include "exchange/formula_setter.h"

namespace betwixt {

Contour area_of(double left, double bottom, double right, double top) {
  return {{left, bottom, 0}, {right, bottom, 0}, {right, top, 0}, {left, top, 0}};
}

SetBox FormulaSetter::one_glyph(std::uint32_t glyph, char32_t sign, double scale) {
  const MathExtents& e = font_.extents(glyph);
  SetBox out;
  out.width = scale * font_.advance(glyph), out.height = scale * e.height, out.depth = scale * e.depth;
  out.glyph = glyph, out.italics = scale * font_.italics(glyph), out.middle = scale * font_.accent_middle(glyph);
  out.marks.push_back({.glyph = glyph, .size = scale, .at = {}, .sign = sign});
  return out;
}

SetBox FormulaSetter::bar(double width, double bottom, double thickness, char32_t sign) const {
  SetBox out{width, bottom + thickness, -bottom};
  SetMark mark;
  mark.area.push_back(area_of(0, bottom, width, bottom + thickness)), mark.sign = sign;
  out.marks.push_back(std::move(mark));
  return out;
}

// The glyph, its first variant that is long enough, or pieces. `any_shorter`: the longest that is not too long.
SetBox FormulaSetter::stretched(char32_t sign, const FormulaAtom& of, Stretch way, double least, double scale,
                                bool any_shorter) {
  const auto g = glyph(sign, of);
  if (!g) return {};
  std::uint32_t best = *g;
  for (const auto& [longer, length] : font_.longer(*g, way)) {
    if (any_shorter && scale * length > least) break;
    best = longer;
    if (!any_shorter && scale * length >= least) return one_glyph(best, sign, scale);
  }
  if (any_shorter) return one_glyph(best, sign, scale);
  SetBox pieces = assembled(*g, sign, way, least, scale);
  return pieces.marks.empty() ? one_glyph(best, sign, scale) : pieces;
}

SetBox FormulaSetter::assembled(std::uint32_t glyph, char32_t sign, Stretch way, double least, double scale) {
  const auto pieces = font_.pieces(glyph, way);
  const double overlap = font_.least_overlap(way), target = least / scale;
  double fixed = 0, more = 0;  // lengths of the pieces that are there once, and of those that repeat
  int once = 0, repeating = 0;
  for (const MathPiece& p : pieces) (p.repeats ? more : fixed) += p.length, ++(p.repeats ? repeating : once);
  if (pieces.empty() || more - repeating * overlap <= 0) return {};
  const double short_of = target - (fixed - (once - 1) * overlap);
  const int times = std::clamp(static_cast<int>(std::ceil(short_of / (more - repeating * overlap))), 0, 2000);
  std::vector<const MathPiece*> all;
  for (const MathPiece& p : pieces)
    for (int i = 0; i < (p.repeats ? times : 1); ++i) all.push_back(&p);
  if (all.empty()) return {};
  const double longest = fixed + times * more - static_cast<double>(all.size() - 1) * overlap;
  const double spare = all.size() > 1 ? std::max(0.0, longest - target) / static_cast<double>(all.size() - 1) : 0;
  SetBox out;
  double pen = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0) pen -= std::min(overlap + spare, std::max(overlap, std::min(all[i - 1]->end, all[i]->begin)));
    const MathExtents& e = font_.extents(all[i]->glyph);
    const Vec3 at = way == Stretch::tall ? Vec3{0, pen + e.depth, 0} : Vec3{pen - e.left, 0, 0};
    out.marks.push_back({.glyph = all[i]->glyph, .size = scale, .at = scale * at, .sign = sign, .joined = i > 0});
    pen += all[i]->length;
    if (way == Stretch::tall)
      out.width = std::max(out.width, scale * font_.advance(all[i]->glyph));
    else
      grow_box(out, scale * e.height, scale * e.depth);
  }
  if (way == Stretch::tall)
    out.height = scale * pen;
  else
    out.width = scale * pen;
  if (way == Stretch::wide && all.size() > 0 && out.depth == 0) {
    double bottom = 1e9;
    for (const MathPiece* p : all) bottom = std::min(bottom, -font_.extents(p->glyph).depth);
    out.depth = -scale * bottom;
  }
  return out;
}

// A delimiter at least so tall, with its middle on the axis.
SetBox FormulaSetter::fence(char32_t sign, const FormulaAtom& of, double least, SetStyle s) {
  if (sign == 0) return {.width = 0.12};
  SetBox box = stretched(sign, of, Stretch::tall, least, size(s));
  const double up = axis(s) - (box.height - box.depth) / 2;
  SetBox out{box.width, box.height + up, box.depth - up};
  put_box(out, std::move(box), 0, up);
  return out;
}

SetBox FormulaSetter::big_operator(const FormulaAtom& a, SetStyle s) {
  const double least = s.level == 0 ? constant(HB_OT_MATH_CONSTANT_DISPLAY_OPERATOR_MIN_HEIGHT, s) : 0;
  SetBox box = stretched(a.symbol, a, Stretch::tall, least, size(s));
  const double up = axis(s) - (box.height - box.depth) / 2;
  box.height += up, box.depth -= up;
  for (SetMark& m : box.marks) m.at.y += up;
  return box;
}

}  // namespace betwixt
