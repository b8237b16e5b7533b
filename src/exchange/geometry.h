// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Shapes become triangles here.
#pragma once

#include <memory>

#include "betwixt/frame.h"
#include "scene/kinds.h"

namespace betwixt {

// A mesh and what stretches it to the shape's measures: spheres of any radius share one mesh.
struct Geometry {
  std::shared_ptr<const Mesh> mesh;  // never null; empty for what is not drawn
  Mat4 local;                        // mesh space to object space (a scaling, the identity for most)
};

// Triangles of `shape`. Equal shapes get the same mesh in the same detail as long as somebody holds it. Safe from any
// thread.
Geometry realise(const Shape& shape, const Detail& = {});

// The shape on the way from `a` (s = 0) to `b` (s = 1): vertex by vertex where both have the same number and triangles,
// contour by contour for text and polygons; otherwise `a` until s reaches 1, then `b`.
Geometry realise_blend(const Shape& a, const Shape& b, double s, const Detail& = {});
// Whether it is a blend and not a step; the reason if it is a step ("382 vertices against 2930").
bool can_blend(const Shape& a, const Shape& b, std::string* why = nullptr);

}  // namespace betwixt
