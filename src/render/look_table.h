// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Colours of a ColorTable, between those that it has.
#pragma once

#include "betwixt/math.h"
#include "betwixt/setting.h"

namespace betwixt {

// `color`: as the table takes it. Returns signals from 0 to 1. Cubes are cut into tetrahedra, so that greys come from
// greys only.
Vec3 looked_up(const ColorTable&, Vec3 color);

}  // namespace betwixt
