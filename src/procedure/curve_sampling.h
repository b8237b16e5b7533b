// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Samples a curve so finely that straight pieces are closer to it than the eye sees. Poles, jumps and the ends of
// domains are found by halving.
#pragma once

#include <functional>
#include <vector>

#include "betwixt/math.h"

namespace betwixt {

// A point of a curve at a parameter. A point that is not finite is a break.
struct CurvePoint {
  double at = 0;
  Vec3 place;
  bool breaks() const;
};

struct CurveSampling {
  std::function<Vec3(double)> place;  // NaN where the curve has no point
  double from = 0, to = 1;
  double tolerance = 1e-3;         // metres
  Vec3 half{1e300, 1e300, 1e300};  // what is outside this box about the origin need not be fine
  int pieces = 48;
  int most = 20'000;  // evaluations; what is left after them is straight
};
std::vector<CurvePoint> sampled(const CurveSampling&);

// Cuts off what is outside a box about the origin, in x and y.
std::vector<CurvePoint> clipped(const std::vector<CurvePoint>&, Vec3 half);

// Returns the lines along which a function of two numbers is 0: marching squares over places in the box, each crossing
// found by halving. `place` maps the unit square to numbers.
std::vector<CurvePoint> level_lines(const std::function<double(double, double)>& at, int columns, int rows,
                                    const std::function<Vec3(double, double)>& place);

}  // namespace betwixt
