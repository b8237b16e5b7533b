// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/pixel_filter.h"

#include <algorithm>
#include <cmath>

#include "betwixt/math.h"

namespace betwixt {
namespace {

double sinc(double x) { return x == 0 ? 1 : std::sin(pi * x) / (pi * x); }

// Mitchell and Netravali, with B = C = 1/3.
double mitchell(double x) {
  const double a = std::abs(x);
  if (a < 1) return (7 * a * a * a - 12 * a * a + 16.0 / 3) / 6;
  return (-7.0 / 3 * a * a * a + 12 * a * a - 20 * a + 32.0 / 3) / 6;
}

constexpr PixelFilter table[] = {
    {"box", "the mean of the pixel's own samples: sharp, and the fastest", 0.5, [](double) { return 1.0; }},
    {"tent", "falls in a straight line over one pixel: softer than box", 1, [](double x) { return 1 - std::abs(x); }},
    {"gaussian", "a bell of radius 1.5: soft, with the least stair-stepping", 1.5,
     [](double x) { return std::exp(-2 * x * x) - std::exp(-2 * 1.5 * 1.5); }},
    {"mitchell", "Mitchell and Netravali's cubic of radius 2: soft edges, slightly sharpened", 2, mitchell},
    {"lanczos", "a windowed sinc of radius 3: the sharpest; bright edges may ring", 3,
     [](double x) { return sinc(x) * sinc(x / 3); }},
};

}  // namespace

std::span<const PixelFilter> pixel_filters() { return table; }

const PixelFilter* find_pixel_filter(std::string_view name) {
  const auto* at =
      std::find_if(std::begin(table), std::end(table), [&](const PixelFilter& f) { return f.name == name; });
  return at == std::end(table) ? nullptr : at;
}

}  // namespace betwixt
