// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// When an environment is updated, and how often that has been by a given tick: in closed form, without stepping.
//
// All times are whole ticks that have elapsed since the Animate, never below 0. After an update at u the next one is
// at u + D(u), D(u) = max(1, interval + change * floor(u / period)): the interval is looked at when an update is made,
// not between updates. Speeding up ends at 1 tick (terminal velocity). Slowing down ends at the ceiling: an update
// after which D(u) >= ceiling is the last.
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
  std::int64_t change = 0;    // ticks that the interval grows by every `period` ticks; below 0: faster
  std::int64_t period = 1;
  std::int64_t ceiling = 30;  // means something where change > 0 only
  friend bool operator==(const Timing&, const Timing&) = default;
};

class Pace {
 public:
  // Where `change` is not 0 all four are at most this (1100 years of ticks), and an interval may change so many times.
  static constexpr std::int64_t largest = std::int64_t{1} << 40;
  static constexpr std::size_t most_rows = 4096;

  Pace() = default;  // every tick
  // `first`: when the first update is, instead of after `interval` (what is left of an older interval).
  static Result<Pace> make(const Timing&, std::optional<std::int64_t> first = std::nullopt);

  // Updates in (0, elapsed].
  std::int64_t count(std::int64_t elapsed) const;
  // The first update after `elapsed`; nothing where there is none, or none within 64 bits.
  std::optional<std::int64_t> due(std::int64_t elapsed) const;
  // The interval now running; after the last update the ceiling that ended it (`interval` where that is larger).
  std::int64_t interval(std::int64_t elapsed) const;

  // From `begin` on there is an update every `interval` ticks, the first one at begin + interval; `count` were before.
  struct Row {
    std::int64_t begin = 0, count = 0, interval = 1;
    bool ended = false;  // no more updates
    friend bool operator==(const Row&, const Row&) = default;
  };
  // The row for `elapsed`.
  Row row(std::int64_t elapsed) const;

 private:
  Row only_;                                      // where the interval never changes
  std::shared_ptr<const std::vector<Row>> rows_;  // else; ascending, the first begins at 0
  std::int64_t shown_ = 1;                        // what the first row's interval is called
};

}  // namespace betwixt
