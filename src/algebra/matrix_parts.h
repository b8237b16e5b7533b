// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Decomposes matrices as CSS does. Whole turns are lost.
#pragma once

#include <array>
#include <optional>

#include "betwixt/math.h"

namespace betwixt::algebra {

// The parts of a matrix. From right to left: scale, skews, rotation, translation, perspective.
struct MatrixParts {
  Vec3 way, growth{1, 1, 1};
  Vec3 skew;  // of y along x, of z along x, of z along y
  Quat turn;
  std::array<double, 4> sight{0, 0, 0, 1};  // the fourth row of the perspective
};

// Returns true if the matrix leaves z unchanged.
bool in_plane(const Mat4&);
// Decomposes a matrix; nullopt if it is singular. A reflection is along one axis in the plane, in space along all
// three.
std::optional<MatrixParts> taken_apart(const Mat4&, bool plane);
Mat4 put_together(const MatrixParts&);

// Interpolates two decompositions of one sort: t = 0 is the first, t = 1 the second.
MatrixParts mixed(const MatrixParts&, const MatrixParts&, double t, bool plane);
// Returns the sum of two decompositions.
MatrixParts added(const MatrixParts&, const MatrixParts&);

// Interpolates along the shorter rotation, and extrapolates by the same.
Quat short_way(Quat from, Quat to, double t);
Vec3 mix(Vec3, Vec3, double t);
// Returns the sum of two scales, each counted by how far it is above 1.
double added_growth(double, double);

}  // namespace betwixt::algebra
