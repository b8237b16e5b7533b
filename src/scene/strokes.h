// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Lines, and strokes along contours: the parts that are drawn, by length, and the areas that a stroke covers.
#pragma once

#include <optional>
#include <utility>

#include "scene/extent.h"
#include "scene/flat_shapes.h"

namespace betwixt {

inline constexpr double most_dashes = 10'000;  // of a contour; more are drawn as one line

// The parts of a line that are drawn.
struct Dashes {
  double dash = 0, gap = 0;  // metres; no dashes if both are 0
  double from = 0, to = 1;   // shares of the whole
  bool whole() const { return !(gap > 0) && from <= 0 && to >= 1 - 1e-12; }
};
Dashes dashes_of(const Shape&);
// Returns the intervals of a line of this length. Dashes start where the line starts, whatever the trim.
std::vector<std::pair<double, double>> drawn_parts(double length, const Dashes&);

struct DrawnPart {
  std::vector<Vec3> points;
  bool closed = false;
};
std::vector<DrawnPart> stretches(const std::vector<Vec3>& line, bool closed, const Dashes&);

// The stroke of a shape.
struct Pen {
  bool fills = true;
  double width = 0;           // 0 if there is none
  std::optional<Vec3> color;  // its own, linear light; nullopt: the object's
  Dashes dashes;
  bool round = false;  // corners and ends
};
Pen pen_of(const Shape&);
// Interpolates the strokes of two shapes; a stroke that only one has grows or shrinks.
Pen between(const Pen& a, const Pen& b, double s);
// Returns whether a shape is drawn by its contours; a disc only if it has a depth or a stroke, or is not filled.
bool by_contours(const Shape&);

// Returns the direction that a (nearly) flat outline faces: +z if it is at one z, otherwise by the area vector.
Vec3 facing(const Contours&);
// Returns contours around the area of the stroke along closed contours, anticlockwise as seen from `up`; together, by
// the non-zero rule, they are all of it. Ends are straight; corners are pointed if the point is at most four widths
// long. Or both are round.
Contours stroke_areas(const Contours&, const Pen&, Vec3 up);
// Returns the extent of everything drawn along and between contours.
Extent drawn_extent(const Contours&, const Shape&);

}  // namespace betwixt
