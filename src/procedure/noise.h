// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Deterministic noise and random numbers: the same arguments give the same result on every machine.
#pragma once

#include "betwixt/math.h"

namespace betwixt {

// Returns smooth (C2) gradient noise from -1 to 1, zero at whole numbers. `dimensions`: how many of x, y, z are used.
double noise(Vec3 at, int dimensions);
// Returns a pseudorandom number from 0 to 1 (1 excluded) for three numbers.
double hashed(Vec3 seed);

}  // namespace betwixt
