// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Lists of CSS transforms: converts them to motions and back, and computes what a browser shows between two lists.
// Source: CSS Transforms 1 and 2. Numbers stay as in CSS: rotate(90deg) takes x to y, as in a motion. On a page this
// looks clockwise, since the y axis of CSS points down.
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

// One transform function. Lengths are in pixels, angles in radians.
struct CssFunction {
  // Functions of one kind are interpolated number by number. translateX() is of the kind translate, and rotateY() of
  // the kind rotate. skewX() and skewY() are different kinds.
  enum class Kind : std::uint8_t { translate, rotate, scale, skew, skew_x, skew_y, perspective, matrix };
  Kind kind = Kind::translate;
  Vec3 by{};              // translate: the displacement; scale: the factors; skews: the angles along x and y
  Vec3 axis{0, 0, 1};     // rotate
  double angle = 0;       // rotate: the total, whole turns included
  double angle_rest = 0;  // rotate: the rounding error of `angle`
  double nearness = 0;    // perspective: 1 / distance; 0: no perspective
  Mat4 matrix;            // matrix
  friend bool operator==(const CssFunction&, const CssFunction&) = default;
};
using CssList = std::vector<CssFunction>;  // an empty list is `none`

// What a list can refer to, in pixels. A unit whose reference is unknown is an error.
struct CssPage {
  std::optional<double> width = {}, height = {};                    // of the element's border box: %
  std::optional<double> font_size = {}, root_font_size = {};        // em; rem
  std::optional<double> viewport_width = {}, viewport_height = {};  // vw, vh, vmin, vmax
};

// Reads a list such as "translate(10px, 20px) rotate(90deg) scale(2)", or "none". Accepts every function of CSS
// Transforms 2, lengths in px, in the absolute units (inches, centimetres …) and in the units of the page, and calc(),
// min(), max() and clamp() of known values. Errors: syntax, name, range, type (a unit that the page does not know);
// place.column and place.length count characters.
Result<CssList> parse_css(std::string_view list, const CssPage& = {});

// Returns the product of the list. A perspective fills the fourth row: divide x, y and z of a point by its w.
Mat4 matrix_of(const CssList&);

// What a browser shows between two lists: at t = 0 the first list, at t = 1 the second. Other t are extrapolated.
// Functions are interpolated pairwise up to the first pair of different kinds; the shorter list is padded with
// functions that do nothing. From there on, each list is multiplied to one matrix, and the two matrices are decomposed
// and interpolated.
struct CssBetween {
  Mat4 matrix;
  // Whole turns can be lost in two ways. Each number is that of the first function, counted from 1; 0: not lost.
  std::size_t mixed = 0;      // from this function on the kinds differ, so matrices are interpolated
  std::size_t short_way = 0;  // these two rotations have different axes, so the short way is taken
  bool jumps = false;         // a matrix cannot be decomposed: the first list is shown before t = 0.5, then the second
};
CssBetween css_between(const CssList& from, const CssList& to, double t);

// Returns the list that `animation-composition: accumulate` makes of both: displacements and angles are added, and
// scale(2) with scale(3) gives scale(4). (For `add`, append `over` to `under`.) Returns `over` alone if a matrix cannot
// be decomposed.
CssList css_accumulated(const CssList& under, const CssList& over);

// Returns the motion that a browser shows from `none` to this list about `transform-origin`, in pixels. Scalings follow
// the linear law. Errors: those of `parse_css`; type if the list has matrix(), skew() or perspective().
Result<Motion> from_css(std::string_view list, Vec3 origin = {}, const CssPage& = {});

struct CssLists {
  std::string from, to;
};
// Returns two lists between which a browser shows the motion, with `transform-origin: 0 0`. A centre is written as
// translate(centre) ... translate(-centre) in both lists, so that it does not move; `to` alone gives only the end.
// Errors: those of `check`; type for a scaling under the exponential law or an object's name as a centre.
Result<CssLists> to_css(const Motion&);

}  // namespace betwixt
