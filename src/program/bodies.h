// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Simple bodies: balls and boxes, and the gap between two of them. Collisions are computed with them.
#pragma once

#include <array>
#include <optional>

#include "betwixt/math.h"
#include "betwixt/shape.h"

namespace betwixt {

// A ball, or a box with any orientation, in world space.
struct Body {
  Vec3 middle;
  double radius = 0;         // of a ball; 0: a box
  std::array<Vec3, 3> axes;  // unit vectors
  Vec3 half;                 // half extents along the axes
  double size() const {      // about how far it reaches in its thinnest direction that has an extent
    if (radius > 0) return radius;
    double least = 1e300;
    for (int i = 0; i < 3; ++i)
      if (half[i] > 1e-9) least = std::min(least, half[i]);
    return least < 1e300 ? least : 1e-3;
  }
};

// The distance between two surfaces, negative inside, and the direction from the second body to the first.
struct Clearance {
  double wide = 0;
  Vec3 normal;
};

Clearance gap_between(const Body&, const Body&);
// Returns the body of a shape whose points a matrix moves into the world: a ball for round shapes, else the box around
// it that turns with it. Returns nullopt if the shape has no extent.
std::optional<Body> body_of(const Shape&, const Mat4& world);
bool same(const Body&, const Body&);
// Returns the body on the straight way from one to the other.
Body between(const Body&, const Body&, double share);

}  // namespace betwixt
