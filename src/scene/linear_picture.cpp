// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/linear_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace betwixt {
namespace {

double encoded(double c) { return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055; }

// Clamps to 0 to 1; NaN becomes 0.
float share(float x) { return x > 0 ? std::min(x, 1.0F) : 0.0F; }

// The sRGB curve at evenly spaced places: within a fortieth of a byte where it is steepest.
constexpr std::size_t steps = 1 << 16;
const std::array<std::uint8_t, steps + 1>& bytes_of_light() {
  static const auto table = [] {
    std::array<std::uint8_t, steps + 1> t;
    for (std::size_t i = 0; i <= steps; ++i)
      t[i] = static_cast<std::uint8_t>(std::lround(255 * encoded(static_cast<double>(i) / steps)));
    return t;
  }();
  return table;
}

// Returns the curve in steps of 16 bits, interpolated from the same places: off by a hundredth of a step.
float steps_of(float light) {
  static const auto table = [] {
    std::array<float, steps + 2> t;
    for (std::size_t i = 0; i < t.size(); ++i)
      t[i] = static_cast<float>(65535 * encoded(static_cast<double>(i) / steps));
    return t;
  }();
  const float place = light * steps;
  const auto below = static_cast<std::size_t>(place);
  return table[below] + (place - static_cast<float>(below)) * (table[below + 1] - table[below]);
}

// Calls f for each pixel with its straight light and its opacity, which is raised so far that straight light reaches
// it.
template <class F>
void each_pixel(const LinearPicture& picture, F&& f) {
  for (std::size_t i = 0; i + 4 <= picture.rgba.size(); i += 4) {
    const float* const p = &picture.rgba[i];
    const float opacity = std::max({share(p[0]), share(p[1]), share(p[2]), share(p[3])});
    const float whole = opacity > 0 ? 1 / opacity : 0;
    f(i, std::array{share(p[0] * whole), share(p[1] * whole), share(p[2] * whole)}, opacity);
  }
}

}  // namespace

void to_shown(const LinearPicture& picture, Picture& out) {
  out.width = picture.width, out.height = picture.height;
  out.rgba.resize(picture.rgba.size());
  const auto& table = bytes_of_light();
  each_pixel(picture, [&](std::size_t i, const std::array<float, 3>& light, float opacity) {
    for (std::size_t c = 0; c < 3; ++c) out.rgba[i + c] = table[static_cast<std::size_t>(light[c] * steps + 0.5F)];
    out.rgba[i + 3] = static_cast<std::uint8_t>(opacity * 255 + 0.5F);
  });
}

std::vector<std::uint16_t> to_shown_16(const LinearPicture& picture) {
  std::vector<std::uint16_t> out(picture.rgba.size());
  each_pixel(picture, [&](std::size_t i, const std::array<float, 3>& light, float opacity) {
    for (std::size_t c = 0; c < 3; ++c) out[i + c] = static_cast<std::uint16_t>(steps_of(light[c]) + 0.5F);
    out[i + 3] = static_cast<std::uint16_t>(opacity * 65535 + 0.5F);
  });
  return out;
}

}  // namespace betwixt
