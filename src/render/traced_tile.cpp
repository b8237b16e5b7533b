// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/traced_tile.h"

namespace betwixt::traced {
namespace {

constexpr std::size_t pixels = TileOfPixels::side * TileOfPixels::side;

struct Estimate {
  double brightness = 0, variance = 0;  // of the mean of all samples
};

// The variance as samples at random places would have it.
Estimate random_estimate(const std::array<PixelSums, 2>& halves) {
  const double n = halves[0].samples + halves[1].samples;
  const double mean = (halves[0].whole + halves[1].whole) / n;
  const double square = (halves[0].whole_square + halves[1].whole_square) / n;
  return {mean, std::max(square - mean * mean, 0.0) / (n - 1)};
}

// Returns how much smaller the variance of a tile is than that of samples at random places, by the difference between
// the two halves of each pixel.
double exactness(const TileOfPixels& t, const std::array<Estimate, pixels>& estimates) {
  double found = 0, random = 0;
  for (int y = 0; y < t.rows; ++y)
    for (int x = 0; x < t.columns; ++x) {
      const auto i = static_cast<std::size_t>(y * TileOfPixels::side + x);
      const auto& [a, b] = t.halves[i];
      const double off = a.whole / a.samples - b.whole / b.samples;
      found += 0.25 * off * off, random += estimates[i].variance;
    }
  return random > 0 ? std::min(found / random, 1.0) : 1;
}

// Calls `item` for the number of a pixel and those of its neighbours within the tile.
template <class Item>
void near_pixels(const TileOfPixels& t, int x, int y, const Item& item) {
  constexpr int reach = 2;
  for (int j = std::max(y - reach, 0); j <= std::min(y + reach, t.rows - 1); ++j)
    for (int i = std::max(x - reach, 0); i <= std::min(x + reach, t.columns - 1); ++i)
      item(static_cast<std::size_t>(j * TileOfPixels::side + i));
}

// The mean over a pixel and its neighbours within the tile. A pixel by itself must not decide whether it gets more
// samples: few samples may miss what is rare, and a picture whose pixels stop when they are dark is too dark.
Estimate estimate_near(const TileOfPixels& t, const std::array<Estimate, pixels>& estimates, int x, int y) {
  Estimate sum;
  double count = 0;
  near_pixels(t, x, y, [&](std::size_t k) {
    sum.variance += estimates[k].variance, sum.brightness += estimates[k].brightness, count += 1;
  });
  return {sum.brightness / count, sum.variance / count};
}

// Returns whether a pixel shows more than one surface, or a surface and the background. `unlit`: whether surfaces that
// need no light count too.
bool on_edge(const std::array<PixelSums, 2>& halves, bool unlit) {
  constexpr double part = 0.01, bent = 0.05, far = 0.02;  // variances; `far`: relative to the distance
  PixelSums all = halves[0];
  all += halves[1];
  if (!(all.seen > 0)) {
    const double whole = all.whole / all.samples;
    return unlit && all.whole_square / all.samples - whole * whole > part * NoiseBound::dark;
  }
  const double seen = all.seen / all.samples, away = all.far / all.seen;
  const Vec3 normal = 1 / all.seen * all.normal;
  return all.seen_square / all.samples - seen * seen > part || dot(normal, normal) < 1 - bent ||
         all.far_square / all.seen - away * away > far * far * away * away;
}

class Sampling {
 public:
  Sampling(const ExposedTracer& tracer, const FilterSampler& filter, int width, int height, const SamplePlan& plan,
           TileOfPixels& tile)
      : tracer_(tracer), filter_(filter), width_(width), height_(height), plan_(plan), tile_(tile) {}

  template <class Item>
  void for_pixels(const Item& item) const {
    for (int y = 0; y < tile_.rows; ++y)
      for (int x = 0; x < tile_.columns; ++x) item(x, y, static_cast<std::size_t>(y * TileOfPixels::side + x));
  }

  void sample(int x, int y, std::span<const SampleBlock> blocks) const {
    const int across = tile_.left + x, down = tile_.top + y;
    const PixelPlace place{
        static_cast<std::uint32_t>(down) * static_cast<std::uint32_t>(width_) + static_cast<std::uint32_t>(across),
        static_cast<double>(across), static_cast<double>(down), static_cast<double>(width_),
        static_cast<double>(height_)};
    sample_pixel(tracer_, filter_, place, blocks, plan_.unclamped,
                 tile_.halves[static_cast<std::size_t>(y * TileOfPixels::side + x)]);
  }

  // `samples` of each pixel.
  void sample_all(std::uint32_t samples) const {
    const std::uint32_t first = (samples + 1) / 2, second = samples / 2;
    const SampleBlock whole[] = {{0, 0, samples, samples}};
    const SampleBlock two[] = {{0, 0, first, first}, {1, 0, second, second, 1}};
    for_pixels([&](int x, int y, std::size_t) { plan_.halved ? sample(x, y, two) : sample(x, y, whole); });
  }

  void double_samples(int x, int y, std::uint32_t round) const {
    const PixelSums& half = tile_.halves[static_cast<std::size_t>(y * TileOfPixels::side + x)][0];
    const auto count = static_cast<std::uint32_t>(half.samples);
    const SampleBlock two[] = {{2 * round, 0, count, count, 2}, {2 * round + 1, 0, count, count, 3}};
    sample(x, y, two);
  }

  // Pixels on edges get four times as many samples: no neighbours can tell what they show. Their light is no reason:
  // whoever samples bright pixels again, but not dark ones, makes the picture darker.
  void refine_edges() const {
    for_pixels([&](int x, int y, std::size_t i) {
      if (!on_edge(tile_.halves[i], false)) return;
      for (const std::uint32_t round : {1U, 2U}) double_samples(x, y, round);
    });
  }

  // What moves or is out of focus has wide edges. There, pixels get up to four times as many samples if they are too
  // noisy.
  void refine_blur() const {
    std::array<bool, pixels> edges{}, near{};
    for_pixels([&](int, int, std::size_t i) { edges[i] = on_edge(tile_.halves[i], true); });
    for_pixels([&](int x, int y, std::size_t i) {
      near_pixels(tile_, x, y, [&](std::size_t k) { near[i] = near[i] || edges[k]; });
    });
    for (std::uint32_t round = 1; round <= 2 && refine(round, 4 * plan_.samples, near);) ++round;
  }

  // Doubles the samples of pixels that are too noisy, up to `most`; returns whether there are any.
  bool refine(std::uint32_t round, std::uint32_t most, const std::array<bool, pixels>& among) const {
    std::array<Estimate, pixels> estimates;
    for_pixels([&](int, int, std::size_t i) { estimates[i] = random_estimate(tile_.halves[i]); });
    const double exact = exactness(tile_, estimates);
    bool any = false;
    for_pixels([&](int x, int y, std::size_t i) {
      auto& halves = tile_.halves[i];
      const auto count = static_cast<std::uint32_t>(halves[0].samples);
      const Estimate near = estimate_near(tile_, estimates, x, y);
      const double bound = NoiseBound::relative * std::max(near.brightness, NoiseBound::dark);
      if (!among[i] || 2 * count >= most || exact * near.variance <= bound * bound) return;
      any = true;
      double_samples(x, y, round);
    });
    return any;
  }
  bool refine(std::uint32_t round) const {
    std::array<bool, pixels> all;
    all.fill(true);
    return refine(round, NoiseBound::most, all);
  }

 private:
  const ExposedTracer& tracer_;
  const FilterSampler& filter_;
  const int width_, height_;
  const SamplePlan& plan_;
  TileOfPixels& tile_;
};

}  // namespace

void sample_tile(const ExposedTracer& tracer, const FilterSampler& filter, int width, int height,
                 const SamplePlan& plan, TileOfPixels& tile) {
  const bool adaptive = plan.samples == 0;
  tile.columns = std::min(TileOfPixels::side, width - tile.left);
  tile.rows = std::min(TileOfPixels::side, height - tile.top);
  for (auto& halves : tile.halves) halves = {};
  const Sampling sampling(tracer, filter, width, height, plan, tile);
  sampling.sample_all(adaptive ? NoiseBound::fewest : plan.samples);
  if (plan.halved && !adaptive) tracer.blurs() ? sampling.refine_blur() : sampling.refine_edges();
  for (std::uint32_t round = 1; adaptive && sampling.refine(round);) ++round;
}

}  // namespace betwixt::traced
