// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Blends shapes point by point.
#pragma once

#include <span>

#include "betwixt/shape.h"

namespace betwixt {

// Returns whether two shapes have one topology: the same kind with as many points, or meshes with the same triangles
// between as many vertices. Never true for texts, whose letters come from a font.
bool one_topology(const Shape&, const Shape&);

// A shape and its weight.
struct ShapeShare {
  const Shape* shape = nullptr;
  double weight = 0;
};
// Returns the weighted sum of shapes of one topology; the weights add up to 1. Fields that are not numbers are those of
// the first shape.
Shape sum_of(std::span<const ShapeShare>);

// The same for meshes that are scaled first.
struct MeshShare {
  const Mesh* mesh = nullptr;
  double weight = 0;
  Vec3 stretch{1, 1, 1};
};
Mesh sum_of(std::span<const MeshShare>);

}  // namespace betwixt
