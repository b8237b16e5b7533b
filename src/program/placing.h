// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How an object is placed: by its own tracks, and by what it hangs on. (rules, section 5)
#pragma once

#include "program/compiled.h"

namespace betwixt {

// What the tracks of one object say about its place.
struct Said {
  Quat turn;
  Vec3 scale, pivot, position, attach;
  std::optional<Mat4> own;     // what moves it in its own space first
  std::optional<Mat4> motion;  // and what moves it where its position is
};

Said said_by(const Node&, const double* numbers);
// The same of one node alone; not `turned`: what says where it is.
Said said_at(const Program::Compiled&, const Node&, Time, Asking&, bool turned = true);
// By these alone: scale and rotation about the pivot, then the move (R-H7).
Placed own_place(const Said&);
// R-H1 to R-H5. `parent`: of hang, attach and couple, at this time.
Placed hang(const Placed& own, Vec3 attach, const CompiledSpan*, const Frozen*, const Placed* parent);

// The turning part of a matrix that turns and scales.
Quat turn_of(const Mat4&);
inline Mat4 linear_part(Mat4 m) {
  m(0, 3) = m(1, 3) = m(2, 3) = 0;
  return m;
}

}  // namespace betwixt
