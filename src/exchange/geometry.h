// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Converts shapes to triangles.
#pragma once

#include <string>

#include "betwixt/geometry.h"
#include "scene/kinds.h"

namespace betwixt {

// Returns the triangles of `shape`. Equal shapes share one mesh for each level of detail while someone holds it. Safe
// from any thread.
Geometry realise(const Shape& shape, const Detail& = {});

// Returns the shape between `a` (s = 0) and `b` (s = 1). Blends vertex by vertex if both have as many vertices and the
// same triangles, and contour by contour for text and polygons. Otherwise returns `a` until s reaches 1, then `b`.
Geometry realise_blend(const Shape& a, const Shape& b, double s, const Detail& = {});
// Returns whether the two blend; if they step instead, sets `why` ("382 vertices against 2930").
bool can_blend(const Shape& a, const Shape& b, std::string* why = nullptr);

}  // namespace betwixt
