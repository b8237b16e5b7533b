// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "betwixt/shape.h"

namespace betwixt {

struct Extent {
  Vec3 low{1, 1, 1}, high{-1, -1, -1};  // low > high: nothing
  bool empty() const { return low.x > high.x; }
};

// A box in object space that holds the shape. Texts are estimated from their number of letters.
Extent extent(const Shape&);

}  // namespace betwixt
