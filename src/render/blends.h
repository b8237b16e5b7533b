// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Blends, as shaders have them.
#pragma once

#include <algorithm>

#include "betwixt/math.h"

namespace betwixt {

inline Vec3 mix(Vec3 a, Vec3 b, double s) { return (1 - s) * a + s * b; }
inline double smoothstep(double from, double to, double x) {
  const double s = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

}  // namespace betwixt
