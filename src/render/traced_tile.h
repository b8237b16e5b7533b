// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Some pixels that are sampled together. With adaptive sampling, a pixel gets more samples until the standard error of
// its brightness is below a share of it. The error is estimated from the samples of the tile alone, so threads do not
// matter.
#pragma once

#include "render/traced_pixel.h"

namespace betwixt::traced {

// Adaptive sampling: the bound of a pixel's standard error, relative to its brightness. Pixels that are darker than
// `dark` count as that bright: their noise is not seen.
struct NoiseBound {
  static constexpr double relative = 0.03, dark = 0.05;
  static constexpr std::uint32_t fewest = 16, most = 1024;  // samples
};

struct SamplePlan {
  std::uint32_t samples = 64;  // a pixel; 0: adaptive
  bool halved = false;         // whether there are two independent halves
  bool unclamped = false;
};

struct TileOfPixels {
  static constexpr int side = 8;
  // The halves of the samples; all of them are in the first one if they are not halved.
  std::array<std::array<PixelSums, 2>, side * side> halves;
  int left = 0, top = 0, columns = side, rows = side;  // those within the picture
};

// Samples the tile whose corner is given.
void sample_tile(const ExposedTracer&, const FilterSampler&, int width, int height, const SamplePlan&, TileOfPixels&);

}  // namespace betwixt::traced
