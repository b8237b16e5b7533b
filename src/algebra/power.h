// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Powers of a whole motion, of which only the matrix is known: the path that its N-th root takes, step by step. It
// ends where the motion ends, but turns are lost, and on the way it is somewhere else.
#pragma once

#include <optional>

#include "betwixt/math.h"

namespace betwixt::algebra {

// M^t, the principal one, of a matrix of the plane; none where no real one exists.
std::optional<Mat4> power(const Mat4&, double t);

}  // namespace betwixt::algebra
