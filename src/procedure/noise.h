// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Noise and chance that are functions: the same numbers in, the same number out, on every machine.
#pragma once

#include "betwixt/math.h"

namespace betwixt {

// Smooth (C2) gradient noise, -1 to 1, zero at whole numbers. `dimensions`: how many of x, y, z count.
double noise(Vec3 at, int dimensions);
// As good as random, 0 to 1 (1 excluded), from any three numbers.
double hashed(Vec3 seed);

}  // namespace betwixt
