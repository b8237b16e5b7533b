// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace betwixt {

// An interval in which a value changes, or an instant at which it jumps. Outside all its activities it is constant.
struct Activity {
  std::int64_t from = 0, until = 0;
  bool has(std::int64_t t) const { return from <= t && t < until; }
};
// Appends an activity; joins it with the last one if they meet. `first`: the first activity of the same value.
void add_activity(std::vector<Activity>&, std::size_t first, Activity);

}  // namespace betwixt
