// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Matrices as CSS takes them apart: of whole turns nothing is known any more.
#pragma once

#include <array>
#include <optional>

#include "betwixt/math.h"

namespace betwixt::algebra {

// Applied from the right to the left: growths, skews, a turn, a way, a perspective.
struct MatrixParts {
  Vec3 way, growth{1, 1, 1};
  Vec3 skew;  // of y along x, of z along x, of z along y
  Quat turn;
  std::array<double, 4> sight{0, 0, 0, 1};  // the fourth row of the perspective
};

// A matrix that leaves z alone.
bool in_plane(const Mat4&);
// None: it is flat. In the plane what is mirrored is so along one axis, in space along all three.
std::optional<MatrixParts> taken_apart(const Mat4&, bool plane);
Mat4 put_together(const MatrixParts&);

// Of both at once, taken apart in one way: at 0 the one, at 1 the other.
MatrixParts mixed(const MatrixParts&, const MatrixParts&, double t, bool plane);
// One added to the other.
MatrixParts added(const MatrixParts&, const MatrixParts&);

// The short way from one to the other, and on by the same turn.
Quat short_way(Quat from, Quat to, double t);
Vec3 mix(Vec3, Vec3, double t);
// Two factors that are each so much more than 1.
double added_growth(double, double);

}  // namespace betwixt::algebra
