// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/track.h"

#include <cmath>

namespace betwixt {

double to_linear(double s) {
  const double a = std::abs(s);
  return std::copysign(a <= 0.04045 ? a / 12.92 : std::pow((a + 0.055) / 1.055, 2.4), s);
}

double to_srgb(double l) {
  const double a = std::abs(l);
  const double s = a <= 0.0031308 ? a * 12.92 : 1.055 * std::pow(a, 1 / 2.4) - 0.055;
  // Numbers written as eight bits or with up to twelve decimals come back exactly; the others are off by rounding.
  for (const double grid : {255.0, 1e12}) {
    const double near = std::round(s * grid) / grid;
    if (std::abs(near - s) < 1e-14 * std::max(1.0, s)) return std::copysign(near, l);
  }
  return std::copysign(s, l);
}

Color from_hsv(double turns, double s, double v) {
  const double h = (turns - std::floor(turns)) * 6;
  const auto channel = [&](double n) {
    const double k = std::fmod(n + h, 6);
    return v - v * s * std::max(0.0, std::min({k, 4 - k, 1.0}));
  };
  return {channel(5), channel(3), channel(1)};
}

Vec3 to_linear(Color c) { return {to_linear(c.r), to_linear(c.g), to_linear(c.b)}; }
Color to_srgb(Vec3 l) { return {to_srgb(l.x), to_srgb(l.y), to_srgb(l.z)}; }

}  // namespace betwixt
