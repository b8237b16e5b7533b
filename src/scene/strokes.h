// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Lines, and strokes along contours: what of them is drawn, by its length, and which areas a stroke covers.
#pragma once

#include <optional>
#include <utility>

#include "scene/extent.h"
#include "scene/flat_shapes.h"

namespace betwixt {

inline constexpr double most_dashes = 10'000;  // of a contour; more are drawn as one line

// What is drawn of a line, by its length.
struct Dashes {
  double dash = 0, gap = 0;  // metres; both 0: no gaps
  double from = 0, to = 1;   // parts of the whole
  bool whole() const { return !(gap > 0) && from <= 0 && to >= 1 - 1e-12; }
};
Dashes dashes_of(const Shape&);
// Of a line so long: from where to where. They begin where the line does, whatever is trimmed.
std::vector<std::pair<double, double>> drawn_parts(double length, const Dashes&);

struct DrawnPart {
  std::vector<Vec3> points;
  bool closed = false;
};
std::vector<DrawnPart> stretches(const std::vector<Vec3>& line, bool closed, const Dashes&);

// What a shape is drawn with.
struct Pen {
  bool fills = true;
  double width = 0;           // of the stroke; 0: there is none
  std::optional<Vec3> color;  // its own, linear light; none: that of the object
  Dashes dashes;
  bool round = false;  // its corners and ends
};
Pen pen_of(const Shape&);
// Of shapes on their way; a stroke that only one has grows or wanes.
Pen between(const Pen& a, const Pen& b, double s);
// Whether a shape is drawn by its contours: a disc only where it has a depth or a stroke, or is not filled.
bool by_contours(const Shape&);

// Where a (nearly) flat outline faces: +z if it lies in a plane of one z, else by the turn of its contours.
Vec3 facing(const Contours&);
// Contours round what the stroke along closed contours covers, anticlockwise seen from `up`; together, by the non-zero
// rule, all of it. Ends are cut off straight; corners come to a point if that is no longer than four times the width.
// Or both are round.
Contours stroke_areas(const Contours&, const Pen&, Vec3 up);
// Of what is drawn along and between contours.
Extent drawn_extent(const Contours&, const Shape&);

}  // namespace betwixt
