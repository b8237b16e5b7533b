// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/curves.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace betwixt {
namespace {

constexpr int curve_steps = 4096;
using CurveTable = std::array<double, curve_steps + 2>;

template <class F>
CurveTable tabulated(const F& f) {
  CurveTable t;
  for (int i = 0; i < curve_steps + 2; ++i) t[static_cast<std::size_t>(i)] = f(static_cast<double>(i) / curve_steps);
  return t;
}

double on_curve(const CurveTable& table, double share) {
  const double place = share * curve_steps;
  const auto below = static_cast<std::size_t>(place);
  return table[below] + (place - static_cast<double>(below)) * (table[below + 1] - table[below]);
}

double to_one(double x) { return x > 0 ? (x < 1 ? x : 1) : 0; }

}  // namespace

double own_log2(double x) {
  // x = m · 2^n with m from √½ to √2; ln m = 2 artanh((m - 1) / (m + 1)).
  const auto bits = std::bit_cast<std::uint64_t>(x);
  constexpr std::uint64_t half_root = 0x3fe6a09e667f3bcd;  // √½
  const std::int64_t n = static_cast<std::int64_t>(bits - half_root) >> 52;
  const double m = std::bit_cast<double>(bits - (static_cast<std::uint64_t>(n) << 52));
  const double t = (m - 1) / (m + 1), s = t * t;
  const double series =
      1 + s * (1.0 / 3 + s * (1.0 / 5 + s * (1.0 / 7 + s * (1.0 / 9 + s * (1.0 / 11 + s * (1.0 / 13 + s / 15))))));
  return static_cast<double>(n) + 2 * std::numbers::log2e * t * series;
}

double own_exp2(double x) {
  const double n = std::floor(x + 0.5), y = (x - n) * std::numbers::ln2;
  double sum = 1;
  for (int k = 13; k > 0; --k) sum = 1 + y / k * sum;
  return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + static_cast<std::int64_t>(n)) << 52) * sum;
}

double signal_of(double light) {
  const double c = to_one(light);
  if (c <= 0.0031308) return 12.92 * c;
  // Over the root of the light the curve is nearly straight.
  static const CurveTable table =
      tabulated([](double root) { return root > 0 ? 1.055 * own_power(root, 2 / 2.4) - 0.055 : -0.055; });
  return on_curve(table, std::sqrt(c));
}

double light_of_signal(double signal) {
  const double s = to_one(signal);
  if (s <= 0.04045) return s / 12.92;
  static const CurveTable table = tabulated([](double is) { return own_power((is + 0.055) / 1.055, 2.4); });
  return on_curve(table, s);
}

}  // namespace betwixt
