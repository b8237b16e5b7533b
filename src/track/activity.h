// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace betwixt {

// A time in which a value goes on changing; an instant where it jumps. Outside all of its activities it stays as it is.
struct Activity {
  std::int64_t from = 0, until = 0;
  bool has(std::int64_t t) const { return from <= t && t < until; }
};
// Adds one behind the others; those that meet become one. `first`: where those of the same value begin.
void add_activity(std::vector<Activity>&, std::size_t first, Activity);

}  // namespace betwixt
