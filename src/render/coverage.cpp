// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/coverage.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace betwixt {
namespace {

// Less than this cannot be seen; without it, rounding would show in the middle of areas.
constexpr float least_share = 1.0F / 4096;

// Adds a line that crosses a part of one row, from x0 to x1. `d` is the height of this part, with the sign of the edge.
void add_to_row(std::span<float> sums, float x0, float x1, float d) {
  const float a = std::min(x0, x1), b = std::max(x0, x1), first = std::floor(a), after = std::ceil(b);
  const auto i = static_cast<std::size_t>(first), end = static_cast<std::size_t>(after);
  if (end <= i + 1) {
    const float beyond = d * (0.5F * (a + b) - first);
    sums[i] += d - beyond, sums[i + 1] += beyond;
    return;
  }
  // The line crosses several pixels. In each it covers a triangle or a trapezoid.
  const float s = 1 / (b - a), from = a - first, to = b - after + 1;
  const float in_first = 0.5F * s * (1 - from) * (1 - from), in_last = 0.5F * s * to * to;
  sums[i] += d * in_first;
  if (end == i + 2) {
    sums[i + 1] += d * (1 - in_first - in_last);
  } else {
    const float in_second = s * (1.5F - from);
    sums[i + 1] += d * (in_second - in_first);
    for (std::size_t k = i + 2; k + 1 < end; ++k) sums[k] += d * s;
    sums[end - 1] += d * (1 - in_second - static_cast<float>(end - i - 3) * s - in_last);
  }
  sums[end] += d * in_last;
}

// Most pixels of a row lie between edges.
bool nothing_in_eight(const float* sums) {
  std::uint64_t bits[4];
  std::memcpy(bits, sums, sizeof bits);
  return (bits[0] | bits[1] | bits[2] | bits[3]) == 0;
}

}  // namespace

void Area::add_inside(float x0, float y0, float x1, float y1, float sign) {
  if (!(y0 < y1)) return;
  left_ = std::min({left_, x0, x1}), right_ = std::max({right_, x0, x1});
  top_ = std::min(top_, static_cast<int>(y0)), bottom_ = std::max(bottom_, static_cast<int>(std::ceil(y1)));
  edges_.push_back({x0, y0, y1, (x1 - x0) / (y1 - y0), sign});
}

// Cuts the edge at the borders of the picture. What is left of it becomes its border; what is right of it is not seen.
void Area::add(float x0, float y0, float x1, float y1) {
  if (y0 == y1) return;
  const float sign = y0 < y1 ? 1.F : -1.F;
  if (sign < 0) std::swap(x0, x1), std::swap(y0, y1);
  if (!(y1 > 0) || !(y0 < height_)) return;
  const float slope = (x1 - x0) / (y1 - y0);
  if (y0 < 0) x0 -= y0 * slope, y0 = 0;
  if (y1 > height_) x1 += (height_ - y1) * slope, y1 = height_;
  const auto y_at = [&](float x) { return std::clamp(y0 + (x - x0) / slope, y0, y1); };
  const auto clamped = [&](float x) { return std::clamp(x, 0.F, width_); };
  float cuts[4] = {y0, y0, y1, y1};
  if ((x0 < 0) != (x1 < 0)) (x0 < x1 ? cuts[1] : cuts[2]) = y_at(0);
  if ((x0 > width_) != (x1 > width_)) (x0 < x1 ? cuts[2] : cuts[1]) = y_at(width_);
  const float at[4] = {clamped(x0), clamped(x0), clamped(x1), clamped(x1)};
  for (int i = 0; i < 3; ++i)
    if (at[i] < width_ || at[i + 1] < width_)
      add_inside(at[i], cuts[i], at[i + 1], cuts[i + 1], sign);
    else if (cuts[i] < cuts[i + 1])
      right_ = width_;
}

void Area::finish() {
  std::sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) { return a.top < b.top; });
}

RowCoverage CoverageRows::next(int row, std::span<float> sums, std::span<float> room) {
  const auto y = static_cast<float>(row);
  const std::vector<Area::Edge>& edges = area_->edges_;
  while (begun_ < edges.size() && edges[begun_].top < y + 1) active_.push_back(static_cast<std::uint32_t>(begun_++));
  const auto width = static_cast<float>(sums.size() - 2);
  float low = width, high = 0;
  std::size_t left = 0;
  for (const std::uint32_t i : active_) {
    const Area::Edge& e = edges[i];
    const float from = std::max(e.top, y), to = std::min(e.bottom, y + 1);
    if (to > from) {
      const float x0 = std::clamp(e.x + (from - e.top) * e.slope, 0.F, width);
      const float x1 = std::clamp(e.x + (to - e.top) * e.slope, 0.F, width);
      low = std::min({low, x0, x1}), high = std::max({high, x0, x1});
      add_to_row(sums, x0, x1, e.sign * (to - from));
    }
    if (e.bottom > y + 1) active_[left++] = i;
  }
  active_.resize(left);
  if (high < low) return {};
  const std::size_t pixels = sums.size() - 2, first = std::min(static_cast<std::size_t>(low), pixels);
  const std::size_t end = std::min(static_cast<std::size_t>(high) + 2, sums.size());
  float sum = 0, share = 0;
  for (std::size_t i = first; i < end; ++i) {
    while (i + 8 <= end && nothing_in_eight(&sums[i]))
      std::fill_n(room.begin() + static_cast<std::ptrdiff_t>(i), 8, share), i += 8;
    if (i == end) break;
    sum += sums[i];
    sums[i] = 0;
    share = std::min(std::abs(sum), 1.F);
    share = share < least_share ? 0 : share > 1 - least_share ? 1 : share;
    room[i] = share;
  }
  // An area that goes on behind the right border has no edge there.
  if (share > 0) std::fill(room.begin() + static_cast<std::ptrdiff_t>(end), room.end(), share);
  const std::size_t shown = share > 0 ? pixels : std::min(end, pixels);
  return {static_cast<int>(first), room.subspan(first, shown - first)};
}

}  // namespace betwixt
