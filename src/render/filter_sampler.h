// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Places for the samples of a pixel filter: as dense as the filter is far from zero, with the sign of its weight.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "scene/pixel_filter.h"

namespace betwixt::traced {

class FilterSampler {
 public:
  explicit FilterSampler(const PixelFilter& filter) : filter_(filter), box_(&filter == &pixel_filters().front()) {
    sums_.push_back(0);
    for (int k = 0; k < steps; ++k) sums_.push_back(sums_.back() + std::abs(filter.weight(middle(k))));
  }

  // Returns the place along an axis for a random number from 0 to 1, in pixels from the pixel's beginning, and 1 or -1.
  std::pair<double, double> at(double u) const {
    if (box_) return {u, 1};
    const double sum = u * sums_.back();
    const auto above = std::upper_bound(sums_.begin() + 1, sums_.end() - 1, sum);
    const auto k = static_cast<std::size_t>(above - sums_.begin()) - 1;
    const double width = sums_[k + 1] - sums_[k], inside = width > 0 ? (sum - sums_[k]) / width : 0.5;
    const double x = middle(static_cast<int>(k)) + (inside - 0.5) * 2 * filter_.radius / steps;
    return {0.5 + x, filter_.weight(middle(static_cast<int>(k))) < 0 ? -1 : 1};
  }

 private:
  static constexpr int steps = 1024;
  double middle(int k) const { return filter_.radius * ((2 * k + 1.0) / steps - 1); }

  const PixelFilter& filter_;
  bool box_;
  std::vector<double> sums_;  // of the absolute weights
};

}  // namespace betwixt::traced
