// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The light of a pixel: a mean of samples.
#pragma once

#include <span>

#include "render/exposed_tracer.h"
#include "render/filter_sampler.h"

namespace betwixt::traced {

// Sums over samples. `weight` is the sum of the signs of their weights; the light is divided by it.
struct PixelSums {
  Vec3 lit, plain, albedo;
  double clear = 0, weight = 0;
  Vec3 lit_square;     // of single samples, as are the rest
  Vec3 lit_sample;     // before bright light rolls off
  Vec3 normal, place;  // each times its part
  double seen = 0, seen_square = 0;
  double far = 0, far_square = 0;      // the distance of the surfaces, times their part
  double whole = 0, whole_square = 0;  // the brightness of all light
  double samples = 0;

  PixelSums& operator+=(const PixelSums&);
  double divisor() const { return weight == 0 ? 1 : weight; }  // a few samples whose signs may cancel
};

// Which samples of a pixel are taken together: `count` of the `all` samples of a block. Blocks are independent, but for
// the places in the pixel, which are a segment of one sequence, so that edges are smooth.
struct SampleBlock {
  std::uint32_t block = 0, first = 0, count = 1, all = 1, segment = 0;
};

struct PixelPlace {
  std::uint32_t number;  // in the picture
  double x, y;           // its corner
  double width, height;  // of the picture
};

// Adds the samples of one block to the first half, or of two, one to each half. Rolls off bright light unless
// `unclamped`: by as much in both halves, since fewer samples would roll off more.
void sample_pixel(const ExposedTracer&, const FilterSampler&, const PixelPlace&, std::span<const SampleBlock>,
                  bool unclamped, std::array<PixelSums, 2>& halves);

}  // namespace betwixt::traced
