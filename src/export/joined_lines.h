// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A line that is drawn on, and perhaps erased at its other end: one line, of which a part is visible.
#pragma once

#include "export/planar_watch.h"

namespace betwixt {

struct DrawnOn {
  std::vector<Vec3> line;
  std::vector<std::pair<double, double>> shares;  // for each look: the visible part
};
// Returns nullopt if the looks are no such line. `tolerance`: of the ends, metres.
std::optional<DrawnOn> joined_lines(const PlanarLooks&, double tolerance);

}  // namespace betwixt
