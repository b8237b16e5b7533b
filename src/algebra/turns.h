// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Angles of many turns, as whole turns and 2^-64ths of one. A fraction of such an angle is reduced to one turn before
// it is rounded, so its sine is as exact after a billion turns as in the first.
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>
#include <numbers>

namespace betwixt::algebra {

__extension__ using Wide = unsigned __int128;

// `whole` turns and `part` 2^-64ths of one; `part` is never negative.
struct Turns {
  std::int64_t whole = 0;
  std::uint64_t part = 0;
  friend auto operator<=>(const Turns&, const Turns&) = default;
  bool none() const { return whole == 0 && part == 0; }
};
// Beyond the largest number of whole turns the result is meaningless; the sum is computed in unsigned numbers so that
// it is defined.
inline Turns operator+(Turns a, Turns b) {
  const std::uint64_t part = a.part + b.part;
  const auto whole = static_cast<std::uint64_t>(a.whole) + static_cast<std::uint64_t>(b.whole) + (part < a.part);
  return {static_cast<std::int64_t>(whole), part};
}
inline Turns operator-(Turns a) {
  const auto whole = 0 - static_cast<std::uint64_t>(a.whole) - (a.part != 0);
  return {static_cast<std::int64_t>(whole), 0 - a.part};
}
inline Turns operator-(Turns a, Turns b) { return a + -b; }

// The most turns of an angle: beyond them a double cannot tell one turn from the next.
inline constexpr double most_turns = 0x1p53;

struct Turn {
  double sine = 0, cosine = 1;
  double versine = 0;  // 1 - cosine, exact even if it is tiny
};

// Returns sine and cosine of a part of a turn, in 2^-64. Quarters are exact.
inline Turn turn(std::uint64_t phase) {
  const std::uint64_t quarter = (phase + (std::uint64_t{1} << 61)) >> 62 & 3;
  const auto rest = static_cast<double>(static_cast<std::int64_t>(phase - (quarter << 62)));
  const double angle = std::ldexp(rest, -63) * std::numbers::pi, s = std::sin(angle), c = std::cos(angle);
  const double half = std::sin(angle / 2);
  if (quarter == 0) return {s, c, 2 * half * half};
  if (quarter == 1) return {c, -s, 1 + s};
  if (quarter == 2) return {-s, -c, 1 + c};
  return {-c, s, 1 - s};
}

// The same for an angle below an eighth of a turn in radians. A tiny angle keeps all its digits.
inline Turn small_turn(double angle) {
  const double half = std::sin(angle / 2);
  return {std::sin(angle), std::cos(angle), 2 * half * half};
}

// Returns the nearest Turns; 0 if x is too large to count.
inline Turns turns_in(long double x) {
  if (!(std::abs(x) < 0x1p62L)) return {};
  const long double whole = std::floor(x);
  const auto part = static_cast<Wide>(std::nearbyint(std::ldexp(x - whole, 64)));
  return {static_cast<std::int64_t>(whole) + static_cast<std::int64_t>(part >> 64), static_cast<std::uint64_t>(part)};
}
// Returns a b, losing only bits below 2^-64.
inline Turns product(long double a, long double b) {
  const long double high = a * b;
  return turns_in(high) + turns_in(std::fma(a, b, -high));
}
inline Turns scaled(Turns t, double by) {
  return product(static_cast<long double>(t.whole), by) +
         product(std::ldexp(static_cast<long double>(t.part), -64), by);
}
// Returns n/of, for numbers that do not overflow.
inline Turns fraction(std::int64_t n, std::int64_t of) {
  const std::int64_t left = (n % of + of) % of;
  const Wide part = ((static_cast<Wide>(left) << 64) + static_cast<Wide>(of / 2)) / static_cast<Wide>(of);
  return Turns{(n - left) / of, 0} + Turns{static_cast<std::int64_t>(part >> 64), static_cast<std::uint64_t>(part)};
}

// Returns an angle in radians, exactly as given.
inline Turns exact_turns(double angle) {
  constexpr long double high = 0xa2f9836e4e44152ap-66L, low = 0xf62a0b82b2c88fc9p-136L;  // 1/(2 pi)
  return product(angle, high) + product(angle, low);
}
// Returns an angle in radians plus its rounding error. If the error is unknown (0), a radian number means the part of a
// turn, down to thousandths of a degree, that rounds to it, so that 90deg and 1000000000turn end exactly.
inline Turns turns_of(double angle, double rest = 0) {
  if (rest != 0) return exact_turns(angle) + exact_turns(rest);
  const long double turns = angle / (2 * std::numbers::pi_v<long double>), rounding = std::abs(turns) * 0x1p-53L;
  for (const std::int64_t parts : {4, 360, 1000, 360'000}) {
    const auto of = static_cast<long double>(parts);
    if (!(rounding * of <= 0.001L)) break;  // too many candidates
    const long double meant = std::round(turns * of);
    if (std::abs(turns - meant / of) <= 3 * rounding) return fraction(static_cast<std::int64_t>(meant), parts);
  }
  return exact_turns(angle);
}

// Returns the phase within its turn at fraction t.
inline std::uint64_t phase(Turns turns, double t) { return scaled(turns, t).part; }
// Returns the phase of the k-th of n parts, exact for any k and n.
inline std::uint64_t phase(Turns turns, std::int64_t k, std::int64_t n) {
  if (k < 0) turns = -turns;
  const std::uint64_t ahead = k < 0 ? 0 - static_cast<std::uint64_t>(k) : static_cast<std::uint64_t>(k);
  const auto of = static_cast<Wide>(n), count = static_cast<Wide>(ahead);
  const auto whole = static_cast<Wide>((turns.whole % n + n) % n);
  const Wide left = whole * (count % of) % of;  // turns of k whole turns, without those that divide evenly
  return static_cast<std::uint64_t>(((left << 64) + count * turns.part + of / 2) / of);
}

}  // namespace betwixt::algebra
