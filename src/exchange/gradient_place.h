// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where a gradient lies on a shape.
#pragma once

#include <array>

#include "betwixt/gradient.h"
#include "betwixt/shape.h"

namespace betwixt {

// Returns the box, in object space, on which the gradients of a shape or of its blend lie: that of the whole shape,
// filled, without its stroke, however much of it is drawn or typed.
Box gradient_box(const Shape&, const Shape* toward, double blend);

// Rows for (x y 1) of the object space to the gradient's own plane: the first number of a linear one is the place on
// it, the length of a radial one is, and the angle of a conic one is the part of a turn.
struct GradientPlane {
  std::array<double, 3> x{}, y{};
};
GradientPlane plane_of(const Gradient&, const Box&);

// Returns the gradient that colours a part of a mesh, or null if none does.
inline const Gradient* gradient_of(const Gradients* all, bool tinted, bool stroke) {
  if (all == nullptr) return nullptr;
  if (stroke && all->stroke.kind != GradientKind::none) return &all->stroke;
  return tinted && all->fill.kind != GradientKind::none ? &all->fill : nullptr;
}

}  // namespace betwixt
