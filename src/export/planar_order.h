// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What lies in front of what, for those who draw one thing over the other: a stack in which things that pass each other
// have several places, one of them at a time.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "betwixt/time.h"

namespace betwixt {

// How far in front a thing is from a time on; none: it is not seen.
using PlanarDepths = std::vector<std::pair<Time, std::optional<double>>>;
void put(PlanarDepths&, Time, std::optional<double>);

struct StackPlace {
  std::size_t thing = 0;
  // From when it is that place; with its end. Empty: all the time.
  std::vector<std::pair<Time, Time>> spans;
};
// From back to front; things as far in front as each other in their order. `whole`: false where that would be so many
// places that the order is that of the beginning.
std::vector<StackPlace> stack_of(const std::vector<PlanarDepths>&, Time until, bool& whole);

}  // namespace betwixt
