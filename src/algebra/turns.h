// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Angles of many turns. A fraction of such an angle is reduced to one turn before it is rounded, so that its sine is as
// good after a billion turns as in the first.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace betwixt::algebra {

struct Turn {
  double sine = 0, cosine = 1;
};

// Of a part of a turn, in 2^-64. The quarters are exact.
inline Turn turn(std::uint64_t phase) {
  const std::uint64_t quarter = (phase + (std::uint64_t{1} << 61)) >> 62 & 3;
  const auto rest = static_cast<double>(static_cast<std::int64_t>(phase - (quarter << 62)));
  const double angle = std::ldexp(rest, -63) * std::numbers::pi, s = std::sin(angle), c = std::cos(angle);
  if (quarter == 0) return {s, c};
  if (quarter == 1) return {c, -s};
  if (quarter == 2) return {-s, -c};
  return {-c, s};
}

inline long double turns_of(double angle) { return angle / (2 * std::numbers::pi_v<long double>); }

// Where the k-th of n parts of so many turns ends within its turn; k = t and n = 1 for fraction t. 0 where that is
// beyond all numbers.
inline std::uint64_t phase(long double turns, long double k, long double n = 1) {
  const long double whole = turns * k, lost = std::fma(turns, k, -whole);
  long double part = n == 1 ? whole - std::floor(whole) + lost : (std::fmod(whole, n) + lost) / n;
  part -= std::floor(part);
  return part >= 0 && part <= 1 ? static_cast<std::uint64_t>(std::round(std::ldexp(part, 63))) << 1 : 0;
}

}  // namespace betwixt::algebra
