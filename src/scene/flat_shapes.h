// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Outlines of flat shapes, from numbers alone: contours in the plane z = 0, what is filled anticlockwise, holes the
// other way round. Nothing where the numbers make no shape.
#pragma once

#include <vector>

#include "betwixt/shape.h"

namespace betwixt {

using Contours = std::vector<std::vector<Vec3>>;

Contours disc_contours(const Shape&);
// The outline as it is; with holes it goes round anticlockwise, seen from where it faces, and they the other way.
Contours polygon_contours(const Shape&);
// Holes, one behind the other: each ends where its first point comes again, the last one also where the points do.
// The point that comes again is left out.
Contours rings(const std::vector<Vec3>&);
Contours rectangle_contours(const Shape&);
Contours ring_contours(const Shape&);
Contours arc_contours(const Shape&);
Contours regular_contours(const Shape&);
Contours star_contours(const Shape&);
// Teeth whose flanks are involutes, so that two gears of one module turn each other evenly (Euler 1765).
Contours gear_contours(const Shape&);
Contours arrow_contours(const Shape&);

}  // namespace betwixt
