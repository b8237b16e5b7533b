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

Contours rectangle_contours(const Shape&);
Contours ring_contours(const Shape&);
Contours arc_contours(const Shape&);
Contours regular_contours(const Shape&);
Contours star_contours(const Shape&);
// Teeth whose flanks are involutes, so that two gears of one module turn each other evenly (Euler 1765).
Contours gear_contours(const Shape&);
Contours arrow_contours(const Shape&);

}  // namespace betwixt
