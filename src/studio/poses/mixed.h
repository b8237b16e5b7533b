// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Values between two values, and values as a hand would write them.
#pragma once

#include "betwixt/value.h"

namespace betwixt::studio {

// Returns the value at a share of the way from a to b: 0 is a, 1 is b, beyond these it goes on. Orientations turn,
// colours mix in linear light. Values that are not numbers change over in the middle.
Value mixed(const Value& a, const Value& b, double share);
// Rounds numbers to six decimals, and angles to six decimals of a degree; no one can see a finer difference. `angle`:
// a number is an angle.
Value written_plain(const Value&, bool angle = false);

}  // namespace betwixt::studio
