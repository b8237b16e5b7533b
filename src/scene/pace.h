// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The updates of an environment: when they come, and how many there were until a tick, in closed form, without
// stepping.
//
// Times are whole ticks since the Animate, never negative. After an update at u the next one is at u + D(u),
// D(u) = max(1, interval + change * floor(u / period)): the interval is evaluated at an update, not between updates.
// Speeding up ends at 1 tick (terminal velocity). Slowing down ends at the ceiling: an update after which
// D(u) >= ceiling is the last.
//
// Source: Animation Imaging Model 3.3.1 (intervals) and 5.1 (acceleration: Animate's further parameters).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "betwixt/result.h"

namespace betwixt {

struct Timing {
  std::int64_t interval = 1;  // ticks from one update to the next, at first
  std::int64_t change = 0;    // ticks by which the interval grows every `period` ticks; below 0 it shrinks
  std::int64_t period = 1;
  std::int64_t ceiling = 30;  // used if change > 0
  friend bool operator==(const Timing&, const Timing&) = default;
};

class Pace {
 public:
  // The limit of all four if `change` is not 0 (1100 years of ticks), and of the number of changes.
  static constexpr std::int64_t largest = std::int64_t{1} << 40;
  static constexpr std::size_t most_rows = 4096;

  Pace() = default;  // every tick
  // `first`: the time of the first update, if not `interval` (for the remainder of an older interval).
  static Result<Pace> make(const Timing&, std::optional<std::int64_t> first = std::nullopt);

  // Returns the number of updates in (0, elapsed].
  std::int64_t count(std::int64_t elapsed) const;
  // Returns the first update after `elapsed`, or nullopt if there is none within 64 bits.
  std::optional<std::int64_t> due(std::int64_t elapsed) const;
  // Returns the current interval; after the last update the ceiling that ended it (or `interval` if that is larger).
  std::int64_t interval(std::int64_t elapsed) const;

  // Updates at begin + interval, begin + 2 interval, ...; `count` updates were before.
  struct Row {
    std::int64_t begin = 0, count = 0, interval = 1;
    bool ended = false;  // no more updates
    friend bool operator==(const Row&, const Row&) = default;
  };
  // Returns the row at `elapsed`.
  Row row(std::int64_t elapsed) const;

 private:
  Row only_;                                      // if the interval never changes
  std::shared_ptr<const std::vector<Row>> rows_;  // otherwise; ascending, the first begins at 0
  std::int64_t shown_ = 1;                        // the interval of the first row as given
};

}  // namespace betwixt
