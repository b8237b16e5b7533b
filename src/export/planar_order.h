// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The drawing order, for formats that draw objects one over the other: a stack in which objects that pass each other
// have several places, one at a time.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "betwixt/time.h"

namespace betwixt {

// The depth of an object from a time on; nullopt: it is not visible.
using PlanarDepths = std::vector<std::pair<Time, std::optional<double>>>;
void put(PlanarDepths&, Time, std::optional<double>);

struct StackPlace {
  std::size_t thing = 0;
  // When it uses that place: beginnings and ends. Empty: always.
  std::vector<std::pair<Time, Time>> spans;
};
// Returns the places from back to front; objects at the same depth in their own order. `whole`: false if there would be
// so many places that the order of the beginning is used.
std::vector<StackPlace> stack_of(const std::vector<PlanarDepths>&, Time until, bool& whole);

}  // namespace betwixt
