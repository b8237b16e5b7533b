// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/mesh.h"

namespace betwixt {

Box Mesh::box() const {
  if (positions.empty()) return {{}, {}};
  Box b;
  for (const auto& p : positions) b.add(Vec3{p[0], p[1], p[2]});
  return b;
}

}  // namespace betwixt
