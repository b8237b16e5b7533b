// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The times of a section's block, and the sections that lines can speak of by name.
#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "betwixt/document.h"

namespace betwixt {

// The clock of a block: it begins at a time of the film, and runs `speed` times as fast as the film.
struct SectionClock {
  Time begin;
  double speed = 1;
  friend bool operator==(const SectionClock&, const SectionClock&) = default;

  // Return the length and the time of the film for those that are written in the block.
  Time film_length(Time l) const { return speed == 1 ? l : Time{std::llround(static_cast<double>(l.flicks) / speed)}; }
  Time film_time(Time t) const { return begin + film_length(t); }
  // Returns what to write in the block for a time of the film.
  Time own_time(Time t) const {
    const Time since = t - begin;
    return speed == 1 ? since : Time{std::llround(static_cast<double>(since.flicks) * speed)};
  }
};

inline SectionClock clock_of(const Section& s) { return {s.begin, s.speed}; }

// Returns the section of this name; nullptr if there is none.
inline const Section* find_section(const std::vector<Section>& all, std::string_view name) {
  for (const Section& s : all)
    if (s.name == name) return &s;
  return nullptr;
}

}  // namespace betwixt
