// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A line that is drawn on, and perhaps goes at its other end: one line, of which a part is seen.
#pragma once

#include "export/planar_watch.h"

namespace betwixt {

struct DrawnOn {
  std::vector<Vec3> line;
  std::vector<std::pair<double, double>> shares;  // of each look: from where to where
};
// None: the looks are no such line. `tolerance`: how far off its ends may be, metres.
std::optional<DrawnOn> joined_lines(const PlanarLooks&, double tolerance);

}  // namespace betwixt
