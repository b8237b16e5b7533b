// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Decomposes matrices into the parts of other programs: translation, rotation, scale.
#pragma once

#include "betwixt/math.h"

namespace betwixt {

// translation * rotation * scaling. A reflection is along x; a singular matrix gets some rotation that fits.
struct Parts {
  Vec3 way, growth{1, 1, 1};
  Quat turn;
};
Parts parts_of(const Mat4&);
// Returns whether the axes are not perpendicular, so that no such parts exist.
bool is_sheared(const Mat4&);

// translation * outer rotation * scaling * inner rotation: any affine matrix, by its singular values.
struct TurnedParts {
  Vec3 way, growth{1, 1, 1};
  Quat outer, inner;
};
// Returns, of all parts of the matrix, those nearest to the given ones.
TurnedParts turned_parts(const Mat4&, const TurnedParts& near);
TurnedParts blended(const TurnedParts&, const TurnedParts&, double t);
Mat4 put_together(const TurnedParts&);
// Returns the largest difference of two elements.
double apart(const Mat4&, const Mat4&);

}  // namespace betwixt
