// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Properties of a motion for the lesson: other ways to its end, and the errors of the methods.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "betwixt/algebra.h"

namespace betwixt::algebra {

using Places = std::vector<Vec3>;

// Returns the motion with all scalings by the linear law.
Motion by_linear_law(Motion);

// Checks whether the lesson can show the motion: how many factors it has, and how far they move anything. Errors: those
// of `check`; range.
Status can_be_shown(const Motion&, const Places& points);
// Returns 1, 2 or 5 times a power of ten: a size for a figure beside all displacements, centres and points.
double unit_for(const Motion&, const Places& points);

// Returns A_k by a method, k from 0 to `steps`, or an empty list if the method refuses. For the plane.
std::vector<Mat4> stepped(const Motion&, Method, std::int64_t steps);

// The largest distance between the points of the frames and those of the motion.
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
    law,      // the linear law in place of the exponential one
  };
  Kind kind = Kind::root;
  bool beside_linear = false;  // if true, it is compared with the motion by the linear law
  std::vector<Mat4> frames;    // at even times from 0 to 1
  Gap gap;
};
std::vector<OtherWay> other_ways(const Motion&, const Places& points);

// Returns the steps for which drift is reported: 1, 2, 5, 10, ... and the last but one; the last is the closed form's.
std::vector<std::int64_t> drift_marks(std::int64_t steps);
// Returns the largest error of the points up to each of the marks, which may be infinite. Returns an empty list if the
// method refuses.
template <class Number>  // float, double
std::vector<double> drift(const Motion&, Method, std::int64_t steps, const Places& points, bool renewed);

}  // namespace betwixt::algebra
