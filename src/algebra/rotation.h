// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Rotations about a centre.
#pragma once

#include "algebra/turns.h"
#include "betwixt/math.h"

namespace betwixt::algebra {

// Returns a rotation about an axis through the centre, after Rodrigues. The displacement of the origin is computed from
// the angle, not as centre - M centre, which would cancel for a small rotation about a centre far away.
inline Mat4 rotated(Turn by, Vec3 axis, Vec3 centre = {}) {
  const Vec3 a = normalize(axis);
  const double s = by.sine, c = by.cosine, v = by.versine;
  Mat4 m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m(i, j) = v * a[i] * a[j] + (i == j ? c : 0);
  m(0, 1) -= s * a.z, m(0, 2) += s * a.y, m(1, 0) += s * a.z;
  m(1, 2) -= s * a.x, m(2, 0) -= s * a.y, m(2, 1) += s * a.x;
  const Vec3 moved = v * (centre - dot(a, centre) * a) - s * cross(a, centre);
  m(0, 3) = moved.x, m(1, 3) = moved.y, m(2, 3) = moved.z;
  return m;
}

}  // namespace betwixt::algebra
