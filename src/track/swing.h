// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Finds where a smooth curve overshoots two equal events by far, which authors do not intend.
#pragma once

#include <optional>

#include "betwixt/time.h"
#include "track/track.h"

namespace betwixt {

struct Swing {
  Time from, to;     // the two events, whose value is `rest`
  Time at;           // the whole frame between them with the largest distance
  int number = 0;    // the index of the number in the value
  double rest = 0;   // the number of both events
  double value = 0;  // the curve's number at that frame
};

// The largest overshoot that is no finding, as a share of the range of these two events and their neighbours. Intended
// follow-through is smaller.
inline constexpr double widest_follow_through = 0.15;

// Returns the widest overshoot of a track in the author's numbers, or nullopt if all are smaller. Colours and
// orientations have none. `component`: the track is that of a component of the type.
std::optional<Swing> widest_swing(const Track&, Type, bool component, Rate);

}  // namespace betwixt
