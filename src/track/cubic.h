// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Cubics: the numbers between two events, for every twerper of numbers.
#pragma once

#include <cstdint>

namespace betwixt {

// c[0] + c[1] s + c[2] s² + c[3] s³.
struct Cubic {
  double c[4] = {};
  double at(double s) const { return ((c[3] * s + c[2]) * s + c[1]) * s + c[0]; }
};

// A segment of up to three numbers. Each is a cubic of the share of the time. Valid from its first moment to just
// before `until`; empty if both are equal.
struct CubicSegment {
  double c[4][4] = {};  // c[power][channel]
  std::int64_t from = 0, until = 0;
  double length = 1;
  std::uint32_t event = 0;  // at its beginning; the next search starts there
  bool has(std::int64_t t) const { return from <= t && t < until; }
  // Returns one of the numbers.
  double at(std::size_t channel, std::int64_t t) const {
    const Cubic one{{c[0][channel], c[1][channel], c[2][channel], c[3][channel]}};
    return one.at(static_cast<double>(t - from) / length);
  }
};

}  // namespace betwixt
