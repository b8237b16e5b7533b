// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Matrices taken apart into what other programs keep: a translation, a rotation, a scale.
#pragma once

#include "betwixt/math.h"

namespace betwixt {

// translation * rotation * scaling. What is mirrored is so along x; what is flat is turned in some way that fits.
struct Parts {
  Vec3 way, growth{1, 1, 1};
  Quat turn;
};
Parts parts_of(const Mat4&);
// Whether its axes are not at right angles: no such parts make it.
bool is_sheared(const Mat4&);

// translation * outer rotation * scaling * inner rotation: any affine matrix, by its singular values.
struct TurnedParts {
  Vec3 way, growth{1, 1, 1};
  Quat outer, inner;
};
// Of all that make the matrix, those which are as near to the given ones as may be.
TurnedParts turned_parts(const Mat4&, const TurnedParts& near);
TurnedParts blended(const TurnedParts&, const TurnedParts&, double t);
Mat4 put_together(const TurnedParts&);
// The largest difference of two elements.
double apart(const Mat4&, const Mat4&);

}  // namespace betwixt
