// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Shapes become triangles here.
#pragma once

#include <string>

#include "betwixt/geometry.h"
#include "scene/kinds.h"

namespace betwixt {

// Triangles of `shape`. Equal shapes get the same mesh in the same detail as long as somebody holds it. Safe from any
// thread.
Geometry realise(const Shape& shape, const Detail& = {});

// The shape on the way from `a` (s = 0) to `b` (s = 1): vertex by vertex where both have the same number and triangles,
// contour by contour for text and polygons; otherwise `a` until s reaches 1, then `b`.
Geometry realise_blend(const Shape& a, const Shape& b, double s, const Detail& = {});
// Whether it is a blend and not a step; the reason if it is a step ("382 vertices against 2930").
bool can_blend(const Shape& a, const Shape& b, std::string* why = nullptr);

}  // namespace betwixt
