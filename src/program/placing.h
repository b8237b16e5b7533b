// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The placement of an object, by its own tracks and by its parent.
#pragma once

#include "program/compiled.h"

namespace betwixt {

// The values of an object's own transform.
struct OwnTransform {
  Quat turn;
  Vec3 scale, pivot, position, attach;
  std::optional<Mat4> own;     // applied first, in its own space
  std::optional<Mat4> motion;  // applied last, in the space of its position
};

OwnTransform said_by(const Node&, const double* numbers);
// The same for one node alone. Without `turned`, evaluates only what its position needs.
OwnTransform own_transform_at(const Program::Compiled&, const Node&, Time, Asking&, bool turned = true);
// Returns the own transform: scales and rotates about the pivot, then translates.
Placed own_place(const OwnTransform&);
// Applies the attachment. `parent`: the parent's transform at this time, for hang, attach and couple.
Placed hang(const Placed& own, Vec3 attach, const CompiledSpan*, const Frozen*, const Placed* parent);

// Returns the rotation part of a matrix that rotates and scales.
Quat turn_of(const Mat4&);
inline Mat4 linear_part(Mat4 m) {
  m(0, 3) = m(1, 3) = m(2, 3) = 0;
  return m;
}

}  // namespace betwixt
