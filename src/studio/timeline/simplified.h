// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Finds the events (keys) of tracks that a tolerance makes unnecessary.
#pragma once

#include "studio/timeline/event_lines.h"

namespace betwixt::studio {

struct Simplified {
  std::vector<EventAt> gone;
  double error = 0;  // the largest difference of a number, as a share of its track's range
};
// Removes as many of the events as it can. No number of a track comes to differ by more than `tolerance`, a share of
// the range of the track's numbers. The first and the last event of a track stay.
Simplified simplified(const Document&, const std::vector<EventAt>&, double tolerance);

}  // namespace betwixt::studio
