// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Time is an exact whole number of flicks; a flick is 1/705,600,000 s. A frame at any common frame rate is a whole
// number of flicks, and so is a tick of 1/30 s.
//
// Room: base
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>
#include <limits>

namespace betwixt {

inline constexpr std::int64_t flicks_per_second = 705'600'000;

// A point in time, or a length of time, in flicks.
struct Time {
  std::int64_t flicks = 0;
  friend constexpr auto operator<=>(Time, Time) = default;
  constexpr double seconds() const { return static_cast<double>(flicks) / static_cast<double>(flicks_per_second); }
};
constexpr Time operator+(Time a, Time b) { return {a.flicks + b.flicks}; }
constexpr Time operator-(Time a, Time b) { return {a.flicks - b.flicks}; }
constexpr Time operator-(Time a) { return {-a.flicks}; }

// The largest |seconds| in a document (about 146 years). Sums of a few such times do not overflow.
inline constexpr double longest_seconds = 4.6e9;
constexpr bool in_reach(Time t) { return t.seconds() <= longest_seconds && t.seconds() >= -longest_seconds; }

// Returns the nearest flick. The caller has checked that |s| <= longest_seconds.
inline Time from_seconds(double s) { return {std::llround(s * static_cast<double>(flicks_per_second))}; }

// Frames or ticks a second, as a fraction: 24/1, 30000/1001.
struct Rate {
  std::int64_t num = 24, den = 1;
  friend constexpr bool operator==(Rate, Rate) = default;
  double per_second() const { return static_cast<double>(num) / static_cast<double>(den); }
  // Returns the length of n frames. Exact if n is whole and a frame is a whole number of flicks; else the nearest
  // flick.
  Time span(double n) const {
    const std::int64_t whole = flicks_per_second * den;
    if (n == std::floor(n) && whole % num == 0 && std::abs(n) < 9e18 / static_cast<double>(whole / num))
      return {static_cast<std::int64_t>(n) * (whole / num)};
    return {static_cast<std::int64_t>(
        std::llroundl(static_cast<long double>(n) * static_cast<long double>(whole) / static_cast<long double>(num)))};
  }
  // Returns how many whole frames fit before t: the n with span(n) <= t < span(n + 1).
  std::int64_t whole(Time t) const {
    const long double n = std::floor(static_cast<long double>(t.flicks) * static_cast<long double>(num) /
                                     (static_cast<long double>(flicks_per_second) * static_cast<long double>(den)));
    const auto guess = static_cast<std::int64_t>(n);
    std::int64_t k = guess + 1;
    while (k >= guess && span(static_cast<double>(k)) > t) --k;
    return k;
  }
  // Returns the time of frame n; frame 1 is at time 0.
  Time frame(double n) const { return span(n - 1); }
  // Returns the frame number at t. It is a whole number exactly on frames.
  double frame_number(Time t) const {
    const double n =
        static_cast<double>(static_cast<long double>(t.flicks) * static_cast<long double>(num) /
                            (static_cast<long double>(flicks_per_second) * static_cast<long double>(den))) +
        1;
    const double near = std::round(n);
    return frame(near) == t ? near : n;
  }
};

}  // namespace betwixt
