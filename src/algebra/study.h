// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What there is to tell of a motion: other ways to its end, and what the methods lose.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "betwixt/algebra.h"

namespace betwixt::algebra {

using Places = std::vector<Vec3>;

// The same with every scaling by the linear law.
Motion by_linear_law(Motion);

// Whether all of it can be shown: how many factors there are, and how far any of them take anything. Errors: those of
// `check`; range.
Status can_be_shown(const Motion&, const Places& points);
// 1, 2 or 5 times a power of ten: the size of a figure that can be seen beside all ways, centres and points.
double unit_for(const Motion&, const Places& points);

// A_k by a method, k from 0 to `steps`. Empty where the method refuses. For the plane.
std::vector<Mat4> stepped(const Motion&, Method, std::int64_t steps);

// How far frames have the points from where the motion has them, at the worst of its moments.
struct Gap {
  double most = 0;
  double at = 0;  // t
};
Gap gap_between(const Motion&, const std::vector<Mat4>& frames, const Places& points);

// Another way to the same end.
struct OtherWay {
  enum class Kind : std::uint8_t {
    root,     // the t-th power of the whole
    no_root,  // there is none
    scheme,   // the geometric method of ST and SR, beside the motion by the linear law
    law,      // the linear law for the exponential one
  };
  Kind kind = Kind::root;
  bool beside_linear = false;  // what it is compared with is the motion by the linear law
  std::vector<Mat4> frames;    // at even times from 0 to 1
  Gap gap;
};
std::vector<OtherWay> other_ways(const Motion&, const Places& points);

// Steps at which a drift is told: 1, 2, 5, 10, ... and the last but one of `steps`; the last is the closed form's.
std::vector<std::int64_t> drift_marks(std::int64_t steps);
// How far rounding has taken the points by each of the marks, at the worst until then: infinite where it is beyond all
// numbers. Empty where the method refuses.
template <class Number>  // float, double
std::vector<double> drift(const Motion&, Method, std::int64_t steps, const Places& points, bool renewed);

}  // namespace betwixt::algebra
