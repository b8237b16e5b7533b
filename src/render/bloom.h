// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Light that spreads in the lens and in the eye: a share of all light, dark and bright, goes to a sum of blurs that are
// each twice as wide as the one before. No light is lost, not even at the borders.
#pragma once

#include <cstddef>
#include <functional>

#include "betwixt/linear_picture.h"

namespace betwixt {

// Spreads this share of the light, 0 to 1. Opacities stay.
void spread_light(LinearPicture&, double share);

// Blurs the light and the opacity by a Gaussian with a standard deviation of about `deviation` pixels. The sum stays.
void blur_light(LinearPicture&, double deviation);

// Calls work(first, end) for ranges of rows, on several threads if there are many pixels.
void for_rows(int width, int height, const std::function<void(int first, int end)>& work);
// Calls f with the index of each pixel's first number, in several threads.
template <class F>
void each_pixel_of(LinearPicture& p, const F& f) {
  for_rows(p.width, p.height, [&](int first, int end) {
    const std::size_t row = 4 * static_cast<std::size_t>(p.width);
    for (std::size_t i = row * static_cast<std::size_t>(first); i < row * static_cast<std::size_t>(end); i += 4) f(i);
  });
}

}  // namespace betwixt
