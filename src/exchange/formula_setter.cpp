// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Lists of atoms, their spaces and scripts (rules 5 to 20 of appendix G).
#include "exchange/formula_setter.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/document.h"

namespace betwixt {
namespace {

// Spaces between two atoms: 1 thin, 2 medium, 3 thick; negative: only in display and text style. 9: cannot occur.
// The columns are ord op bin rel open close punct inner.
constexpr int spacing[8][8] = {
    {0, 1, -2, -3, 0, 0, 0, -1},      // ord
    {1, 1, 9, -3, 0, 0, 0, -1},       // op
    {-2, -2, 9, 9, -2, 9, 9, -2},     // bin
    {-3, -3, 9, 0, -3, 0, 0, -3},     // rel
    {0, 0, 9, 0, 0, 0, 0, 0},         // open
    {0, 1, -2, -3, 0, 0, 0, -1},      // close
    {-1, -1, 9, -1, -1, -1, -1, -1},  // punct
    {-1, 1, -2, -3, -1, 0, -1, -1},   // inner
};

double space_between(AtomClass a, AtomClass b, SetStyle s) {
  static constexpr double widths[] = {0, 3.0 / 18, 4.0 / 18, 5.0 / 18};
  const int n = spacing[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
  if (n == 9 || (n < 0 && s.level > 1)) return 0;
  return widths[std::abs(n)];
}

// Returns the classes of a list. A binary operator without something on both sides is an ordinary sign (rules 5, 6).
std::vector<AtomClass> classes_of(const FormulaList& list) {
  std::vector<AtomClass> out;
  AtomClass before = AtomClass::none;
  std::size_t last = 0;
  for (const FormulaAtom& a : list) {
    AtomClass is = a.is;
    if (is != AtomClass::none) {
      const bool no_left = before == AtomClass::none || before == AtomClass::bin || before == AtomClass::op ||
                           before == AtomClass::rel || before == AtomClass::open || before == AtomClass::punct;
      if (is == AtomClass::bin && no_left) is = AtomClass::ord;
      const bool no_right = is == AtomClass::rel || is == AtomClass::close || is == AtomClass::punct;
      if (no_right && before == AtomClass::bin) out[last] = AtomClass::ord;
      before = is, last = out.size();
    }
    out.push_back(is);
  }
  if (before == AtomClass::bin) out[last] = AtomClass::ord;
  return out;
}

}  // namespace

void put_box(SetBox& into, SetBox&& box, double x, double y) {
  for (SetMark& m : box.marks) {
    m.at = m.at + Vec3{x, y, 0};
    into.marks.push_back(std::move(m));
  }
}

void put_beside(SetBox& into, SetBox&& box, double y) {
  grow_box(into, box.height + y, box.depth - y);
  const double width = box.width;
  put_box(into, std::move(box), into.width, y);
  into.width += width;
}

void grow_box(SetBox& b, double top, double bottom) {
  b.height = std::max(b.height, top), b.depth = std::max(b.depth, bottom);
}

double FormulaSetter::size(SetStyle s) const {
  return s.level < 2    ? 1
         : s.level == 2 ? font_.share(HB_OT_MATH_CONSTANT_SCRIPT_PERCENT_SCALE_DOWN)
                        : font_.share(HB_OT_MATH_CONSTANT_SCRIPT_SCRIPT_PERCENT_SCALE_DOWN);
}

SetBox FormulaSetter::list(const FormulaList& all, SetStyle style) {
  SetBox out;
  const std::vector<AtomClass> classes = classes_of(all);
  std::optional<AtomClass> before;
  for (std::size_t i = 0; i < all.size() && failed.what.message.empty(); ++i) {
    const FormulaAtom& a = all[i];
    if (a.form == AtomForm::style) {
      style.level = a.level;
      continue;
    }
    if (a.form == AtomForm::space) {
      out.width += a.amount * size(style);
      continue;
    }
    if (before && classes[i] != AtomClass::none) out.width += space_between(*before, classes[i], style) * size(style);
    if (classes[i] != AtomClass::none) before = classes[i];
    const bool alone = all.size() == 1;
    SetBox box = atom(a, style);
    if (alone && !a.has_above && !a.has_below) return box;  // a single glyph stays known as one
    put_beside(out, std::move(box));
    if (out.marks.size() > most_letters) {
      failed = {fail(ErrorCode::range, fmt::format("a formula can have at most {} signs", most_letters)), a.at,
                a.length};
      return out;
    }
  }
  return out;
}

SetBox FormulaSetter::atom(const FormulaAtom& a, SetStyle style) {
  SetBox box = nucleus(a, style);
  if (!a.part.empty())
    for (SetMark& m : box.marks)
      if (m.part == nullptr) m.part = &a.part;
  const bool limits = a.limits == FormulaAtom::Limits::on ||
                      (a.limits == FormulaAtom::Limits::automatic && a.takes_limits && style.level == 0);
  if (limits && (a.has_above || a.has_below))
    return with_limits(a.has_above ? &a.above : nullptr, a.has_below ? &a.below_it : nullptr, std::move(box), style,
                       a.large);
  if (a.has_above || a.has_below) return with_scripts(a, std::move(box), style);
  if (!a.large) box.width += std::exchange(box.italics, 0);  // rule 17
  return box;
}

SetBox FormulaSetter::nucleus(const FormulaAtom& a, SetStyle style) {
  switch (a.form) {
    case AtomForm::symbol:
      return symbol(a, style);
    case AtomForm::letters:
      return letters(a, style);
    case AtomForm::group:
      return list(a.lists[0], style);
    case AtomForm::fraction:
      return fraction(a, style);
    case AtomForm::root:
      return root(a, style);
    case AtomForm::fenced:
      return fenced(a, style);
    case AtomForm::fence:
      return fence(a.symbol, a, 0.97 * a.amount, {1, style.cramped});
    case AtomForm::accent:
      return accent(a, style);
    case AtomForm::line:
      return line(a, style);
    case AtomForm::brace:
      return brace(a, style);
    case AtomForm::arrow:
      return arrow(a, style);
    case AtomForm::stack:
      return stack(a, style);
    case AtomForm::table:
      return table(a, style);
    case AtomForm::crossed:
      return crossed(a, style);
    case AtomForm::boxed:
      return boxed(a, style);
    case AtomForm::invisible:
      return invisible(a, style);
    default:
      return {};
  }
}

std::optional<std::uint32_t> FormulaSetter::glyph(char32_t c, const FormulaAtom& of) {
  const auto found = font_.glyph(c);
  if (!found && failed.what.message.empty())
    failed = {fail(ErrorCode::name,
                   fmt::format("the font of formulas has no sign U+{:04X} here", static_cast<std::uint32_t>(c))),
              of.at, of.length};
  return found;
}

SetBox FormulaSetter::symbol(const FormulaAtom& a, SetStyle style) {
  if (a.large) return big_operator(a, style);
  auto g = glyph(a.symbol, a);
  if (!g) return {};
  if (style.level > 1) g = font_.for_script(*g, style.level - 1);
  SetBox out = one_glyph(*g, a.symbol, size(style));
  // TeX centres no other signs; these would hang at the baseline.
  return out;
}

SetBox FormulaSetter::letters(const FormulaAtom& a, SetStyle style) {
  SetBox out;
  for (const char32_t c : a.letters) {
    if (c == ' ') {
      out.width += (a.is == AtomClass::op ? 1.0 / 6 : 1.0 / 3) * size(style);
      continue;
    }
    const auto g = glyph(c == '\'' ? U'\u2019' : c, a);
    if (!g) return {};
    SetBox one = one_glyph(*g, c, size(style));
    out.italics = one.italics;
    put_beside(out, std::move(one));
  }
  out.italics = 0;
  return out;
}

// Returns how far a script moves toward its base: the least of the distances that the font's corners allow.
double FormulaSetter::corner_kern(const SetBox& base, const SetBox& script, double shift, bool above,
                                  SetStyle s) const {
  if (!base.glyph) return 0;
  const double big = size(s), small = size(s.script());
  const auto own = above ? HB_OT_MATH_KERN_TOP_RIGHT : HB_OT_MATH_KERN_BOTTOM_RIGHT,
             other = above ? HB_OT_MATH_KERN_BOTTOM_LEFT : HB_OT_MATH_KERN_TOP_LEFT;
  const auto at = [&](double height) {
    const double theirs = script.glyph ? small * font_.kern(*script.glyph, other, (height - shift) / small) : 0;
    return big * font_.kern(*base.glyph, own, height / big) + theirs;
  };
  return above ? std::min(at(shift - script.depth), at(base.height))
               : std::min(at(shift + script.height), at(-base.depth));
}

// Rule 18.
SetBox FormulaSetter::with_scripts(const FormulaAtom& a, SetBox base, SetStyle s) {
  const auto c = [&](hb_ot_math_constant_t k) { return constant(k, s); };
  const bool single = base.glyph.has_value() && !a.large;
  double up = single ? 0 : base.height - c(HB_OT_MATH_CONSTANT_SUPERSCRIPT_BASELINE_DROP_MAX);
  double down = single ? 0 : base.depth + c(HB_OT_MATH_CONSTANT_SUBSCRIPT_BASELINE_DROP_MIN);
  SetBox above, below;
  if (a.has_above) above = list(a.above, s.script());
  if (a.has_below) below = list(a.below_it, s.below());
  up = std::max(
      {up, c(s.cramped ? HB_OT_MATH_CONSTANT_SUPERSCRIPT_SHIFT_UP_CRAMPED : HB_OT_MATH_CONSTANT_SUPERSCRIPT_SHIFT_UP),
       above.depth + c(HB_OT_MATH_CONSTANT_SUPERSCRIPT_BOTTOM_MIN)});
  down = std::max(down, c(HB_OT_MATH_CONSTANT_SUBSCRIPT_SHIFT_DOWN));
  if (!a.has_above) down = std::max(down, below.height - c(HB_OT_MATH_CONSTANT_SUBSCRIPT_TOP_MAX));
  if (a.has_above && a.has_below) {
    const double gap = c(HB_OT_MATH_CONSTANT_SUB_SUPERSCRIPT_GAP_MIN);
    const double between = (up - above.depth) - (below.height - down);
    if (between < gap) {
      down += gap - between;
      const double lift = c(HB_OT_MATH_CONSTANT_SUPERSCRIPT_BOTTOM_MAX_WITH_SUBSCRIPT) - (up - above.depth);
      if (lift > 0) up += lift, down -= lift;
    }
  }
  const double behind = a.large ? base.width : base.width + base.italics,
               under = a.large ? base.width - base.italics : base.width;
  const double up_x = behind + (a.has_above ? corner_kern(base, above, up, true, s) : 0),
               down_x = under + (a.has_below ? corner_kern(base, below, -down, false, s) : 0);
  SetBox out{base.width, base.height, base.depth};
  put_box(out, std::move(base), 0, 0);
  const double end = std::max(a.has_above ? up_x + above.width : 0, a.has_below ? down_x + below.width : 0);
  out.width = end + c(HB_OT_MATH_CONSTANT_SPACE_AFTER_SCRIPT);
  if (a.has_above) grow_box(out, up + above.height, above.depth - up), put_box(out, std::move(above), up_x, up);
  if (a.has_below)
    grow_box(out, below.height - down, below.depth + down), put_box(out, std::move(below), down_x, -down);
  return out;
}

// Rule 13a.
SetBox FormulaSetter::with_limits(const FormulaList* over, const FormulaList* under, SetBox base, SetStyle s,
                                  bool leans) {
  const auto c = [&](hb_ot_math_constant_t k) { return constant(k, s); };
  SetBox above, below;
  if (over != nullptr) above = list(*over, s.script());
  if (under != nullptr) below = list(*under, s.below());
  const double width = std::max({base.width, above.width, below.width}), lean = leans ? base.italics / 2 : 0;
  SetBox out{width, base.height, base.depth};
  const double top = base.height, bottom = base.depth;
  const double base_x = (width - base.width) / 2;
  put_box(out, std::move(base), base_x, 0);
  if (over != nullptr) {
    const double up = top + std::max(c(HB_OT_MATH_CONSTANT_UPPER_LIMIT_GAP_MIN) + above.depth,
                                     c(HB_OT_MATH_CONSTANT_UPPER_LIMIT_BASELINE_RISE_MIN));
    const double x = (width - above.width) / 2 + lean;
    grow_box(out, up + above.height, 0);
    put_box(out, std::move(above), x, up);
  }
  if (under != nullptr) {
    const double down = bottom + std::max(c(HB_OT_MATH_CONSTANT_LOWER_LIMIT_GAP_MIN) + below.height,
                                          c(HB_OT_MATH_CONSTANT_LOWER_LIMIT_BASELINE_DROP_MIN));
    const double x = (width - below.width) / 2 - lean;
    grow_box(out, 0, down + below.depth);
    put_box(out, std::move(below), x, -down);
  }
  return out;
}

}  // namespace betwixt
