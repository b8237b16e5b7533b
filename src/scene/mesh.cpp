// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/mesh.h"

#include <algorithm>

namespace betwixt {

Mesh::Box Mesh::box() const {
  if (positions.empty()) return {};
  Box b{positions.front(), positions.front()};
  for (const auto& p : positions)
    for (std::size_t i = 0; i < 3; ++i) {
      b.low[i] = std::min(b.low[i], p[i]);
      b.high[i] = std::max(b.high[i], p[i]);
    }
  return b;
}

}  // namespace betwixt
