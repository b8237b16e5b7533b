// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Orientations as four numbers, and arithmetic on rotations.
#pragma once

#include "betwixt/math.h"

namespace betwixt {

inline Quat quat(const double* v) { return {v[0], v[1], v[2], v[3]}; }
inline void store(Quat q, double* out) { out[0] = q.w, out[1] = q.x, out[2] = q.y, out[3] = q.z; }

inline Quat log(Quat q) {  // of a unit quaternion; the result is pure
  const double l = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z);
  const double k = l > 1e-12 ? std::atan2(l, q.w) / l : 1;
  return {0, k * q.x, k * q.y, k * q.z};
}
inline Quat exp(Quat v) {
  const double a = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  const double k = a > 1e-12 ? std::sin(a) / a : 1;
  return {std::cos(a), k * v.x, k * v.y, k * v.z};
}

}  // namespace betwixt
