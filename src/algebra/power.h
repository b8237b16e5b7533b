// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Powers of a whole motion of which only the matrix is known: the path of its N-th root, step by step. It ends where
// the motion ends, but loses turns and differs on the way.
#pragma once

#include <optional>

#include "betwixt/math.h"

namespace betwixt::algebra {

// Returns the principal M^t of a matrix of the plane, or nullopt if there is no real one.
std::optional<Mat4> power(const Mat4&, double t);

}  // namespace betwixt::algebra
