// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Shapes that are blended point by point.
#pragma once

#include <span>

#include "betwixt/shape.h"

namespace betwixt {

// Of one topology: of one kind with as many points, or meshes with the same triangles between as many vertices. Never
// texts: their letters come from a font.
bool one_topology(const Shape&, const Shape&);

// A shape, and what it counts.
struct ShapeShare {
  const Shape* shape = nullptr;
  double weight = 0;
};
// The sum of shapes of one topology, whose weights have the sum 1. Of what is no number the first one's counts.
Shape sum_of(std::span<const ShapeShare>);

// The same of meshes that are stretched first.
struct MeshShare {
  const Mesh* mesh = nullptr;
  double weight = 0;
  Vec3 stretch{1, 1, 1};
};
Mesh sum_of(std::span<const MeshShare>);

}  // namespace betwixt
