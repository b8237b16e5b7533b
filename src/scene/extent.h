// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "betwixt/shape.h"

namespace betwixt {

using Extent = Box;

// Returns a box in object space that contains the shape. Texts are estimated from their number of letters.
Extent extent(const Shape&);

}  // namespace betwixt
