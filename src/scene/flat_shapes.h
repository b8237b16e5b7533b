// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Outlines of flat shapes, from numbers alone: contours in the plane z = 0, filled areas anticlockwise, holes
// clockwise. Returns no contours if the numbers make no shape.
#pragma once

#include <vector>

#include "betwixt/shape.h"

namespace betwixt {

using Contours = std::vector<std::vector<Vec3>>;

Contours disc_contours(const Shape&);
// Returns the outline as it is; with holes, anticlockwise as seen from the side that it faces, and the holes clockwise.
Contours polygon_contours(const Shape&);
// Splits holes that are one behind the other: each ends where its first point is repeated, the last one also where the
// points end. The repeated point is left out.
Contours rings(const std::vector<Vec3>&);
Contours rectangle_contours(const Shape&);
Contours video_contours(const Shape&);
Contours ring_contours(const Shape&);
Contours arc_contours(const Shape&);
Contours regular_contours(const Shape&);
Contours star_contours(const Shape&);
// Returns teeth with involute flanks, so that two gears of one module turn each other evenly (Euler 1765).
Contours gear_contours(const Shape&);
Contours arrow_contours(const Shape&);
// Returns the rings of a list of points in which a point that is not finite ends a ring.
Contours broken_contours(const Shape&);
// Returns a rectangle that grows from the origin along its longer growth: size x by y, either may be negative.
Contours bar_contours(const Shape&);
Contours brace_contours(const Shape&);
// Splits points where one is not finite.
std::vector<std::vector<Vec3>> unbroken(const std::vector<Vec3>&);

}  // namespace betwixt
