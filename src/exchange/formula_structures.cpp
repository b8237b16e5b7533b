// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Fractions, roots, delimiters, accents, arrows (rules 9 to 15 and 19 of appendix G).
#include <algorithm>

#include "exchange/formula_setter.h"

namespace betwixt {
namespace {

constexpr double around_fraction = 0.12;  // em, TeX's \nulldelimiterspace
constexpr char32_t root_sign = 0x221A;
// What bars show. They are no characters of the formula, but they are the same sign in any length.
constexpr char32_t fraction_bar = 0x2015, over_bar = 0x203E, under_bar = 0x203F, box_frame = 0x25AD, crossing = 0x2571;

SetStyle upper(SetStyle s) { return s.level == 0 ? SetStyle{1, s.cramped} : s.script(); }

void centre_box(SetBox& into, SetBox&& box, double width, double y) {
  const double x = (width - box.width) / 2;
  put_box(into, std::move(box), x, y);
}

}  // namespace

SetBox FormulaSetter::fraction(const FormulaAtom& a, SetStyle s) {
  if (a.level >= 0) s.level = a.level;
  SetBox over = list(a.lists[0], upper(s)), under = list(a.lists[1], upper(s).tight());
  const bool display = s.level == 0;
  const auto c = [&](hb_ot_math_constant_t in_display, hb_ot_math_constant_t otherwise) {
    return constant(display ? in_display : otherwise, s);
  };
  const double thick = constant(HB_OT_MATH_CONSTANT_FRACTION_RULE_THICKNESS, s), middle = axis(s);
  double up = 0, down = 0;
  if (a.rule) {
    const double gap_over = c(HB_OT_MATH_CONSTANT_FRACTION_NUM_DISPLAY_STYLE_GAP_MIN,
                              HB_OT_MATH_CONSTANT_FRACTION_NUMERATOR_GAP_MIN),
                 gap_under = c(HB_OT_MATH_CONSTANT_FRACTION_DENOM_DISPLAY_STYLE_GAP_MIN,
                               HB_OT_MATH_CONSTANT_FRACTION_DENOMINATOR_GAP_MIN);
    up = std::max(c(HB_OT_MATH_CONSTANT_FRACTION_NUMERATOR_DISPLAY_STYLE_SHIFT_UP,
                    HB_OT_MATH_CONSTANT_FRACTION_NUMERATOR_SHIFT_UP),
                  middle + thick / 2 + gap_over + over.depth);
    down = std::max(c(HB_OT_MATH_CONSTANT_FRACTION_DENOMINATOR_DISPLAY_STYLE_SHIFT_DOWN,
                      HB_OT_MATH_CONSTANT_FRACTION_DENOMINATOR_SHIFT_DOWN),
                    gap_under + under.height - (middle - thick / 2));
  } else {
    up = c(HB_OT_MATH_CONSTANT_STACK_TOP_DISPLAY_STYLE_SHIFT_UP, HB_OT_MATH_CONSTANT_STACK_TOP_SHIFT_UP);
    down = c(HB_OT_MATH_CONSTANT_STACK_BOTTOM_DISPLAY_STYLE_SHIFT_DOWN, HB_OT_MATH_CONSTANT_STACK_BOTTOM_SHIFT_DOWN);
    const double short_of = c(HB_OT_MATH_CONSTANT_STACK_DISPLAY_STYLE_GAP_MIN, HB_OT_MATH_CONSTANT_STACK_GAP_MIN) -
                            ((up - over.depth) - (under.height - down));
    if (short_of > 0) up += short_of / 2, down += short_of / 2;
  }
  const double width = std::max(over.width, under.width);
  SetBox inside{width, over.height + up, under.depth + down};
  centre_box(inside, std::move(over), width, up);
  if (a.rule) put_box(inside, bar(width, middle - thick / 2, thick, fraction_bar), 0, 0);
  centre_box(inside, std::move(under), width, -down);
  const bool fences = a.left != 0;
  const double tall = display ? 2.4 : 1.0;  // rule 15e, plain TeX's \delimiter sizes
  SetBox out = fences ? fence(a.left, a, tall * size(s), s) : SetBox{.width = around_fraction};
  put_beside(out, std::move(inside));
  put_beside(out, fences ? fence(a.right, a, tall * size(s), s) : SetBox{.width = around_fraction});
  return out;
}

SetBox FormulaSetter::root(const FormulaAtom& a, SetStyle s) {
  SetBox inside = list(a.lists[0], s.tight());
  const double thick = constant(HB_OT_MATH_CONSTANT_RADICAL_RULE_THICKNESS, s);
  double gap = constant(
      s.level == 0 ? HB_OT_MATH_CONSTANT_RADICAL_DISPLAY_STYLE_VERTICAL_GAP : HB_OT_MATH_CONSTANT_RADICAL_VERTICAL_GAP,
      s);
  SetBox sign = stretched(root_sign, a, Stretch::tall, inside.height + inside.depth + gap + thick, size(s));
  const double tall = sign.height + sign.depth, spare = tall - thick - (inside.height + inside.depth + gap);
  if (spare > 0) gap += spare / 2;
  const double top = inside.height + gap + thick;  // of the bar
  SetBox out;
  if (!a.lists[1].empty()) {
    SetBox degree = list(a.lists[1], {3, false});
    const double before = constant(HB_OT_MATH_CONSTANT_RADICAL_KERN_BEFORE_DEGREE, s),
                 behind = constant(HB_OT_MATH_CONSTANT_RADICAL_KERN_AFTER_DEGREE, s);
    const double up =
        top - tall + font_.share(HB_OT_MATH_CONSTANT_RADICAL_DEGREE_BOTTOM_RAISE_PERCENT) * tall + degree.depth;
    out.width = std::max(0.0, before);
    put_beside(out, std::move(degree), up);
    out.width = std::max(0.0, out.width + behind);
  }
  const double sign_up = top - sign.height;
  put_beside(out, std::move(sign), sign_up);
  put_box(out, bar(inside.width, top - thick, thick, over_bar), out.width, 0);
  grow_box(out, top + constant(HB_OT_MATH_CONSTANT_RADICAL_EXTRA_ASCENDER, s), 0);
  put_beside(out, std::move(inside));
  return out;
}

SetBox FormulaSetter::fenced(const FormulaAtom& a, SetStyle s) {
  std::vector<SetBox> inside;
  double reach = 0;  // from the axis
  for (const FormulaList& l : a.lists) {
    inside.push_back(list(l, s));
    reach = std::max({reach, inside.back().height - axis(s), inside.back().depth + axis(s)});
  }
  const double least = std::max(2 * reach * 0.901, 2 * reach - 0.5);  // rule 19, plain TeX's parameters
  SetBox out;
  for (std::size_t i = 0; i < a.fences.size(); ++i) {
    put_beside(out, fence(a.fences[i], a, least, s));
    if (i < inside.size()) put_beside(out, std::move(inside[i]));
  }
  return out;
}

// Rule 12.
SetBox FormulaSetter::accent(const FormulaAtom& a, SetStyle s) {
  SetBox base = list(a.lists[0], s.tight());
  const double width = base.width, height = base.height, middle = base.glyph ? base.middle : width / 2;
  SetBox mark = a.wide ? stretched(a.symbol, a, Stretch::wide, width, size(s), a.symbol < 0x20D0) : SetBox{};
  if (!a.wide) {
    const auto g = glyph(a.symbol, a);
    if (!g) return {};
    mark = one_glyph(*g, a.symbol, size(s));
  }
  const double up = height - std::min(height, constant(HB_OT_MATH_CONSTANT_ACCENT_BASE_HEIGHT, s));
  const double attach = mark.glyph ? mark.middle : mark.width / 2;
  SetBox out{width, base.height, base.depth};
  out.glyph = base.glyph, out.italics = base.italics, out.middle = base.middle;
  const double top = mark.height;
  put_box(out, std::move(base), 0, 0);
  put_box(out, std::move(mark), middle - attach, up);
  grow_box(out, up + top, 0);
  return out;
}

SetBox FormulaSetter::line(const FormulaAtom& a, SetStyle s) {
  SetBox out = list(a.lists[0], a.below ? s : s.tight());
  out.width += std::exchange(out.italics, 0), out.glyph.reset();
  const double thick = constant(
                   a.below ? HB_OT_MATH_CONSTANT_UNDERBAR_RULE_THICKNESS : HB_OT_MATH_CONSTANT_OVERBAR_RULE_THICKNESS,
                   s),
               gap = constant(
                   a.below ? HB_OT_MATH_CONSTANT_UNDERBAR_VERTICAL_GAP : HB_OT_MATH_CONSTANT_OVERBAR_VERTICAL_GAP, s);
  const double bottom = a.below ? -out.depth - gap - thick : out.height + gap;
  put_box(out, bar(out.width, bottom, thick, a.below ? under_bar : over_bar), 0, 0);
  grow_box(out, bottom + 2 * thick, a.below ? thick - bottom : 0);
  return out;
}

SetBox FormulaSetter::brace(const FormulaAtom& a, SetStyle s) {
  SetBox inside = list(a.lists[0], s);
  SetBox mark = stretched(a.symbol, a, Stretch::wide, inside.width, size(s));
  const double gap = 0.1 * size(s), width = std::max(inside.width, mark.width);
  SetBox out{width, inside.height, inside.depth};
  const double tall = mark.height + mark.depth;
  const double y = a.below ? -inside.depth - gap - mark.height : inside.height + gap + mark.depth;
  centre_box(out, std::move(inside), width, 0);
  centre_box(out, std::move(mark), width, y);
  a.below ? grow_box(out, 0, out.depth + gap + tall) : grow_box(out, out.height + gap + tall, 0);
  return out;
}

SetBox FormulaSetter::arrow(const FormulaAtom& a, SetStyle s) {
  SetBox above = list(a.lists[0], s.script()), below = list(a.lists[1], s.below());
  const double least = std::max({above.width, below.width, 0.6}) + 0.8 * size(s);
  SetBox mark = stretched(a.symbol, a, Stretch::wide, least, size(s));
  const double width = std::max(mark.width, least), gap = 0.11 * size(s);
  const double high = mark.height, low = mark.depth;
  SetBox out{width, high, low};
  centre_box(out, std::move(mark), width, 0);
  const double up = high + gap + above.depth, down = low + gap + below.height;
  if (!a.lists[0].empty()) grow_box(out, up + above.height, 0), centre_box(out, std::move(above), width, up);
  if (!a.lists[1].empty()) grow_box(out, 0, down + below.depth), centre_box(out, std::move(below), width, -down);
  return out;
}

SetBox FormulaSetter::stack(const FormulaAtom& a, SetStyle s) {
  const FormulaList* const beside = &a.lists[1];
  return with_limits(a.below ? nullptr : beside, a.below ? beside : nullptr, list(a.lists[0], s), s, false);
}

SetBox FormulaSetter::crossed(const FormulaAtom& a, SetStyle s) {
  SetBox out = list(a.lists[0], s);
  out.width += std::exchange(out.italics, 0), out.glyph.reset();
  const double over = 0.1, half = 0.024;  // em: how far a line stands out, half its thickness
  const auto add = [&](double from_y, double to_y) {
    const Vec3 from{-over / 2, from_y, 0}, to{out.width + over / 2, to_y, 0}, way = normalize(to - from);
    const Vec3 side{-half * way.y, half * way.x, 0};
    SetMark mark;
    mark.area.push_back({from - side, to - side, to + side, from + side}), mark.sign = crossing;
    out.marks.push_back(std::move(mark));
  };
  if (a.symbol != '\\') add(-out.depth - over, out.height + over);
  if (a.symbol != '/') add(out.height + over, -out.depth - over);
  return out;
}

SetBox FormulaSetter::boxed(const FormulaAtom& a, SetStyle s) {
  SetBox inside = list(a.lists[0], s);
  const double gap = 0.3, thick = 0.04;
  SetBox out{inside.width + 2 * (gap + thick), inside.height + gap + thick, inside.depth + gap + thick};
  SetMark mark;
  mark.sign = box_frame;
  Contour hole = area_of(thick, thick - out.depth, out.width - thick, out.height - thick);
  std::reverse(hole.begin(), hole.end());
  mark.area = {area_of(0, -out.depth, out.width, out.height), std::move(hole)};
  out.marks.push_back(std::move(mark));
  put_box(out, std::move(inside), gap + thick, 0);
  return out;
}

SetBox FormulaSetter::invisible(const FormulaAtom& a, SetStyle s) {
  SetBox out = list(a.lists[0], s);
  out.marks.clear(), out.glyph.reset();
  if (a.wide) out.height = out.depth = 0;
  if (a.below) out.width = 0;
  return out;
}

}  // namespace betwixt
