// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Cubics: the numbers between two events, for every twerper of numbers.
#pragma once

#include <cstdint>

#include "track/ease.h"

namespace betwixt {

// c[0] + c[1] s + c[2] s² + c[3] s³.
struct Cubic {
  double c[4] = {};
  double at(double s) const { return ((c[3] * s + c[2]) * s + c[1]) * s + c[0]; }
};

// Returns the eased time of u, 0 to 1, for eases given as fractions of the segment.
inline double ease(double u, double a, double b) {
  if (a + b > 1) {
    const double fit = 1 / (a + b);
    a *= fit, b *= fit;
  }
  const double v = 1 / (1 - (a + b) / 2);  // the constant speed in between
  if (u < a) return v * u * u / (2 * a);
  if (u > 1 - b) return 1 - v * (1 - u) * (1 - u) / (2 * b);
  return v * (u - a / 2);
}

// A segment of up to three numbers. Each is a cubic of the share of the way. Valid from its first moment to just
// before `until`; empty if both are equal.
struct CubicSegment {
  double c[4][4] = {};  // c[power][channel]; the fourth channel has the ramps
  std::int64_t from = 0, until = 0;
  double length = 1;
  const Ease* ease = nullptr;  // of the share of the time, if it is not the share of the way
  std::uint32_t event = 0;     // at its beginning; the next search starts there
  bool moves : 1 = false;      // it is not constant
  bool ramps : 1 = false;      // it eases out and in, by these shares of the time
  double& ease_out() { return c[0][3]; }
  double& ease_in() { return c[1][3]; }
  bool has(std::int64_t t) const { return from <= t && t < until; }
  // Returns the share of the way at a time.
  double share(std::int64_t t) const {
    double s = static_cast<double>(t - from) / length;
    if (ramps) s = betwixt::ease(s, c[0][3], c[1][3]);
    return ease ? ease->at(s) : s;
  }
  // Returns one of the numbers at a share of the way.
  double at(std::size_t channel, double s) const {
    return Cubic{{c[0][channel], c[1][channel], c[2][channel], c[3][channel]}}.at(s);
  }
};

}  // namespace betwixt
