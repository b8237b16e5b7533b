// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Lists of CSS transforms: as motions, motions as such lists, and what a browser shows between any two of them.
// After CSS Transforms 1 and 2. The numbers stay those of CSS, whose y points down: there rotate(90deg) takes x to y,
// as in a motion, and it is the page that shows this as clockwise.
//
// Room: algebra
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/algebra.h"
#include "betwixt/math.h"
#include "betwixt/result.h"

namespace betwixt {

// One function, its lengths in pixels and its angles in radians.
struct CssFunction {
  // Functions of one kind are mixed number by number. translateX() is a translation, rotateY() a rotation; skewX() and
  // skewY() have nothing in common.
  enum class Kind : std::uint8_t { translate, rotate, scale, skew, skew_x, skew_y, perspective, matrix };
  Kind kind = Kind::translate;
  Vec3 by{};              // translate: the way; scale: the factors; skews: the angles along x and along y
  Vec3 axis{0, 0, 1};     // rotate
  double angle = 0;       // rotate: all of it, whole turns too
  double angle_rest = 0;  // rotate: what rounding took of it
  double nearness = 0;    // perspective: one divided by the distance; 0: none
  Mat4 matrix;            // matrix
  friend bool operator==(const CssFunction&, const CssFunction&) = default;
};
using CssList = std::vector<CssFunction>;  // empty: none

// What percentages are of: of an element on a page, its border box.
struct CssSize {
  double width = 0, height = 0;
};

// "translate(10px, 20px) rotate(90deg) scale(2)" or "none": every function of CSS Transforms 2, lengths in px and what
// is measured in inches or centimetres, calc(), min(), max() and clamp() of what is known. Errors: syntax, name, range,
// type (a unit that depends on the page, % without a size); place.column and place.length count characters.
Result<CssList> parse_css(std::string_view list, std::optional<CssSize> size = {});

// The product of the list. A perspective is in its fourth row: the place of a point is (x, y, z) divided by w.
Mat4 matrix_of(const CssList&);

// What a browser shows between two lists, at 0 the one, at 1 the other, before and beyond by the same rule: function by
// function as long as both are of one kind, the shorter list padded with functions that do nothing; what is left of
// both as a matrix each, taken apart and mixed.
struct CssBetween {
  Mat4 matrix;
  // The first function, counted from 1, of which whole turns are lost; 0: none.
  std::size_t mixed = 0;      // from here on the lists differ, and matrices are mixed
  std::size_t short_way = 0;  // it turns about two axes, and goes the short way from one to the other
  bool jumps = false;         // a matrix cannot be taken apart: one list is shown up to half way, then the other
};
CssBetween css_between(const CssList& from, const CssList& to, double t);

// animation-composition: accumulate: both at once, ways and angles added up, scale(2) and scale(3) making scale(4). The
// other composition, add, is one list behind the other. Where a matrix cannot be taken apart, `over` alone.
CssList css_accumulated(const CssList& under, const CssList& over);

// The motion that a browser shows from `none` to this list about `transform-origin`, in pixels. Scalings are by the
// linear law. Errors: as of `parse_css`; type: matrix(), skew(), perspective().
Result<Motion> from_css(std::string_view list, Vec3 origin = {}, std::optional<CssSize> size = {});

// A browser that goes from `from` to `to`, with `transform-origin: 0 0`, shows the motion. `to` alone is its end only:
// a centre is written as translate(centre) ... translate(-centre), and these stand still because both lists have them.
// Errors: those of `check`; a scaling by the exponential law, the name of an object as a centre (type).
struct CssLists {
  std::string from, to;
};
Result<CssLists> to_css(const Motion&);

}  // namespace betwixt
