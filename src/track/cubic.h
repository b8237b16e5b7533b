// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Cubics: what numbers between two events are, whichever twerper of numbers blends them.
#pragma once

#include <cstdint>

namespace betwixt {

// c[0] + c[1] s + c[2] s² + c[3] s³.
struct Cubic {
  double c[4] = {};
  double at(double s) const { return ((c[3] * s + c[2]) * s + c[1]) * s + c[0]; }
};

// A segment of up to three numbers, each a cubic of the part of it that has gone by: good from its first moment to
// before `until`; nowhere where both are equal.
struct CubicSegment {
  double c[4][4] = {};  // c[power][channel]
  std::int64_t from = 0, until = 0;
  double length = 1;
  std::uint32_t event = 0;  // it begins with: where the next look begins
  bool has(std::int64_t t) const { return from <= t && t < until; }
  // One of its numbers.
  double at(std::size_t channel, std::int64_t t) const {
    const Cubic one{{c[0][channel], c[1][channel], c[2][channel], c[3][channel]}};
    return one.at(static_cast<double>(t - from) / length);
  }
};

}  // namespace betwixt
