// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where a smooth curve swings far away from two events that are alike: nobody who wrote them meant that.
#pragma once

#include <optional>

#include "betwixt/time.h"
#include "track/track.h"

namespace betwixt {

struct Swing {
  Time from, to;     // the two events; both have `rest`
  Time at;           // the whole frame between them at which it is farthest away
  int number = 0;    // which number of the value
  double rest = 0;   // what both events say
  double value = 0;  // what the curve has at that frame
};

// How far it may go beyond them, as a share of the range of these two events and the ones beside them. Follow-through
// that an author wants is less.
inline constexpr double widest_follow_through = 0.15;

// The widest one of a track, whose numbers are as the author writes them; none where it stays nearer. Colours and
// orientations have none. `component`: the track is one of the type's component.
std::optional<Swing> widest_swing(const Track&, Type, bool component, Rate);

}  // namespace betwixt
