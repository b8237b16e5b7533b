// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Sets a formula: the rules of The TeXbook, appendix G, with the constants of the font's MATH table. Lengths are in em
// of the whole formula.
#pragma once

#include <set>

#include "exchange/formula_font.h"
#include "exchange/formula_symbols.h"

namespace betwixt {

// A glyph or an area of a formula that is set.
struct SetMark {
  std::uint32_t glyph = 0;
  double size = 1;
  Vec3 at;
  Contours area = {};   // in place of a glyph
  char32_t sign = 0;    // what it shows, in any size
  bool joined = false;  // to the mark before it: both show one sign
  const std::string* part = nullptr;
};

struct SetBox {
  double width = 0, height = 0, depth = 0;
  std::vector<SetMark> marks = {};
  // Of a single glyph.
  std::optional<std::uint32_t> glyph = {};
  double italics = 0, middle = 0;  // the correction behind it; where an accent stands
};

// The style: level 0 display, 1 text, 2 script, 3 script of a script.
struct SetStyle {
  int level = 0;
  bool cramped = false;
  SetStyle script() const { return {std::min(std::max(level, 1) + 1, 3), cramped}; }
  SetStyle tight() const { return {level, true}; }
  SetStyle below() const { return script().tight(); }
};

class FormulaSetter {
 public:
  explicit FormulaSetter(MathFont& font) : font_(font) {}
  SetBox list(const FormulaList&, SetStyle);
  FormulaError failed;

 private:
  double size(SetStyle) const;
  double constant(hb_ot_math_constant_t c, SetStyle s) const { return size(s) * font_.constant(c); }
  double axis(SetStyle s) const { return constant(HB_OT_MATH_CONSTANT_AXIS_HEIGHT, s); }

  // formula_setter.cpp
  SetBox atom(const FormulaAtom&, SetStyle);
  SetBox nucleus(const FormulaAtom&, SetStyle);
  SetBox symbol(const FormulaAtom&, SetStyle);
  SetBox letters(const FormulaAtom&, SetStyle);
  SetBox with_scripts(const FormulaAtom&, SetBox, SetStyle);
  SetBox with_limits(const FormulaList* above, const FormulaList* below, SetBox, SetStyle, bool leans);
  std::optional<std::uint32_t> glyph(char32_t, const FormulaAtom&);
  double corner_kern(const SetBox& base, const SetBox& script, double shift, bool above, SetStyle) const;

  // formula_stretched.cpp
  SetBox one_glyph(std::uint32_t glyph, char32_t sign, double scale);
  SetBox stretched(char32_t sign, const FormulaAtom& of, Stretch, double least, double scale, bool any_shorter = false);
  SetBox assembled(std::uint32_t glyph, char32_t sign, Stretch, double least, double scale);
  SetBox fence(char32_t sign, const FormulaAtom& of, double least, SetStyle);
  SetBox bar(double width, double bottom, double thickness, char32_t sign) const;
  SetBox big_operator(const FormulaAtom&, SetStyle);

  // formula_structures.cpp
  SetBox fraction(const FormulaAtom&, SetStyle);
  SetBox root(const FormulaAtom&, SetStyle);
  SetBox fenced(const FormulaAtom&, SetStyle);
  SetBox accent(const FormulaAtom&, SetStyle);
  SetBox line(const FormulaAtom&, SetStyle);
  SetBox brace(const FormulaAtom&, SetStyle);
  SetBox arrow(const FormulaAtom&, SetStyle);
  SetBox stack(const FormulaAtom&, SetStyle);
  SetBox crossed(const FormulaAtom&, SetStyle);
  SetBox boxed(const FormulaAtom&, SetStyle);
  SetBox invisible(const FormulaAtom&, SetStyle);
  SetBox table(const FormulaAtom&, SetStyle);

  MathFont& font_;
  std::set<std::string> parts_;  // of cells, which are copies
};

// Adds the marks of a box, moved. Does not change the measures.
void put_box(SetBox& into, SetBox&& box, double x, double y);
// Puts a box to the right, or the middle of a box at x.
void put_beside(SetBox& into, SetBox&& box, double y = 0);
void grow_box(SetBox&, double top, double bottom);  // `bottom` as a depth
Contour area_of(double left, double bottom, double right, double top);

}  // namespace betwixt
