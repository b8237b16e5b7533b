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

// Of an angle in radians; of those that a rounded angle can mean, parts of a turn down to thousandths of a degree are
// taken at their word, so that 90deg and 1000000000turn end exactly.
inline long double turns_of(double angle) {
  const long double turns = angle / (2 * std::numbers::pi_v<long double>);
  const long double rounding = std::abs(turns) * 0x1p-53L;
  for (const long double parts : {4.0L, 360.0L, 1000.0L, 360'000.0L}) {
    if (rounding * parts > 0.001L) break;  // anything might be meant
    const long double meant = std::round(turns * parts) / parts;
    if (std::abs(turns - meant) <= 3 * rounding) return meant;
  }
  return turns;
}

// Where the k-th of n parts of so many turns ends within its turn; k = t and n = 1 for fraction t. 0 where that is
// beyond all numbers.
inline std::uint64_t phase(long double turns, long double k, long double n = 1) {
  const long double whole = turns * k, lost = std::fma(turns, k, -whole);
  long double part = n == 1 ? whole - std::floor(whole) + lost : (std::fmod(whole, n) + lost) / n;
  part -= std::floor(part);
  return part >= 0 && part <= 1 ? static_cast<std::uint64_t>(std::round(std::ldexp(part, 63))) << 1 : 0;
}

}  // namespace betwixt::algebra
