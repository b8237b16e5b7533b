// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the denoiser on made pictures whose light without noise is known.
#include "render/denoise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace betwixt {
namespace {

using traced::denoise;
using traced::NoisyPicture;

struct Made {
  double light = 1, albedo = 1;
  std::array<double, 3> normal{0, 0, 1};
  double depth = -10;
};

constexpr int width = 70, height = 45;  // no multiples of a tile

// A picture whose two halves have noise of this standard deviation, relative to the light.
NoisyPicture noisy(double noise, const std::function<Made(int, int)>& at) {
  NoisyPicture p(width, height);
  std::mt19937 random(11);
  std::normal_distribution<double> any(0, 1);
  p.pixel = 0.01;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Made m = at(x, y);
      const std::array<double, 3> place{0.1 * (x - width / 2), 0.1 * (height / 2 - y), m.depth};
      p.seen.row(y)[x] = 1, p.samples.row(y)[x] = 16;
      for (std::size_t c = 0; c < 3; ++c) {
        const double lit = m.light * m.albedo;
        p.albedo[c].row(y)[x] = static_cast<float>(m.albedo);
        p.first[c].row(y)[x] = static_cast<float>(lit * (1 + noise * any(random)));
        p.second[c].row(y)[x] = static_cast<float>(lit * (1 + noise * any(random)));
        p.variance[c].row(y)[x] = static_cast<float>(lit * lit * noise * noise / 2);
        p.normal[c].row(y)[x] = static_cast<float>(m.normal[c]), p.place[c].row(y)[x] = static_cast<float>(place[c]);
      }
    }
  return p;
}

// The root of the mean square of the difference from the light without noise, relative to it.
double error(const NoisyPicture& p, const std::function<Made(int, int)>& at, bool before = false) {
  double sum = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double wanted = at(x, y).light * at(x, y).albedo, a = p.first[1].row(y)[x], b = p.second[1].row(y)[x];
      sum += std::pow((before ? 0.5 * (a + b) : a) / wanted - 1, 2);
    }
  return std::sqrt(sum / (width * height));
}

TEST(Denoise, WhatHasNoNoiseStaysAsItIs) {
  for (const double light : {0.0, 0.3, 40.0}) {
    NoisyPicture p = noisy(0, [&](int, int) { return Made{light, 0.5}; });
    denoise(p, 2);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) EXPECT_NEAR(p.first[0].row(y)[x], 0.5 * light, 5e-6 * light) << x << " " << y;
  }
}

// A mean of n independent pixels has a noise that is smaller by the root of n.
TEST(Denoise, NoiseBecomesMuchLessAndTheMeanStays) {
  const auto flat = [](int, int) { return Made{0.7, 0.5}; };
  for (const double noise : {0.05, 0.2, 0.5}) {
    NoisyPicture p = noisy(noise, flat);
    const double before = error(p, flat, true);
    EXPECT_NEAR(before, noise / std::sqrt(2), 0.05 * noise);
    denoise(p, 2);
    EXPECT_LT(error(p, flat), before / 5) << noise;
    double sum = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) sum += p.first[2].row(y)[x];
    // The mean of so many samples is known to noise / sqrt(2 * pixels).
    EXPECT_NEAR(sum / (width * height) / 0.35, 1, 4 * noise / std::sqrt(2.0 * width * height)) << noise;
  }
}

TEST(Denoise, TexturesStay) {
  const auto chequered = [](int x, int y) { return Made{0.7, (x + y) % 2 == 0 ? 0.9 : 0.1}; };
  NoisyPicture p = noisy(0.2, chequered);
  denoise(p, 2);
  EXPECT_LT(error(p, chequered), 0.03);
}

// Each of the edges alone separates the light of both sides: an edge of a shadow, a fold, and an object before another.
TEST(Denoise, EdgesStay) {
  const auto right = [](int x) { return x >= 33; };
  const std::function<Made(int, int)> edges[] = {
      [&](int x, int) { return Made{right(x) ? 0.2 : 1.0}; },
      [&](int x, int) {
        return right(x) ? Made{0.9, 1, {1, 0, 0}} : Made{1, 1, {0, 1, 0}};
      },
      [&](int x, int) {
        return right(x) ? Made{0.9, 1, {0, 0, 1}, -20} : Made{1, 1, {0, 0, 1}, -10};
      }};
  for (const auto& edge : edges) {
    NoisyPicture p = noisy(0.1, edge);
    denoise(p, 2);
    double left = 0, rest = 0;
    for (int y = 0; y < height; ++y) left += p.first[0].row(y)[32] / height, rest += p.first[0].row(y)[33] / height;
    EXPECT_NEAR(left, edge(32, 0).light, 0.02);
    EXPECT_NEAR(rest, edge(33, 0).light, 0.02);
    EXPECT_LT(error(p, edge), 0.03);
  }
}

// A mirrored light of one pixel without noise is no outlier.
TEST(Denoise, SharpHighlightsStay) {
  const auto lights = [](int x, int y) { return Made{x % 9 == 4 && y % 9 == 4 ? 6.0 : 0.5}; };
  NoisyPicture p = noisy(0.05, lights);
  denoise(p, 1);
  for (int y = 4; y < height; y += 9)
    for (int x = 4; x < width; x += 9) EXPECT_NEAR(p.first[1].row(y)[x], 6, 1) << x << " " << y;
  EXPECT_NEAR(p.first[1].row(8)[8], 0.5, 0.05);
}

// One sample in very many found a small light. Its pixel may be wrong, but none of those around it.
TEST(Denoise, SparksDoNotSpread) {
  const auto flat = [](int, int) { return Made{0.7, 0.5}; };
  NoisyPicture p = noisy(0.1, flat);
  const auto spark = [&](int x, int y, float first, float second) {
    for (std::size_t c = 0; c < 3; ++c) {
      p.first[c].row(y)[x] = first, p.second[c].row(y)[x] = second;
      p.variance[c].row(y)[x] = 0.25F * (first + second) * (first + second);  // one of all samples
    }
  };
  spark(15, 15, 800, 0.35F), spark(40, 20, 0.35F, 90), spark(43, 22, 200, 0.35F);
  spark(20, 35, 300, 200), spark(21, 35, 200, 300);  // a highlight: both halves have it, in many samples
  for (const int x : {20, 21})
    for (auto& plane : p.variance) plane.row(35)[x] = 2500;
  spark(50, 35, 90, 120);  // both halves have it, but in one sample each
  denoise(p, 2);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (y == 35 && (x == 20 || x == 21))
        EXPECT_NEAR(p.first[1].row(y)[x], 250, 10) << x;
      else
        EXPECT_NEAR(p.first[1].row(y)[x], 0.35, 0.05) << x << " " << y;
}

// Where the light has little noise and changes from pixel to pixel, few pixels are alike: a noisy one must not count
// more.
TEST(Denoise, NoisyPixelsDoNotSpreadOverCalmOnes) {
  const auto slope = [](int x, int y) { return Made{0.5 + 0.03 * x + 0.02 * y}; };
  NoisyPicture p = noisy(0.004, slope);
  for (std::size_t c = 0; c < 3; ++c) {
    p.first[c].row(20)[30] = 16, p.second[c].row(20)[30] = 9;
    p.variance[c].row(20)[30] = 12;
  }
  denoise(p, 2);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (x != 30 || y != 20) EXPECT_NEAR(p.first[1].row(y)[x], slope(x, y).light, 0.06) << x << " " << y;
}

TEST(Denoise, PixelsWithoutSurfacesAreNotMixedIn) {
  const auto flat = [](int, int) { return Made{0.7, 0.5}; };
  NoisyPicture p = noisy(0.1, flat);
  for (int y = 0; y < height; ++y)
    for (int x = 30; x < 40; ++x) {
      p.seen.row(y)[x] = 0;
      for (auto* planes : {&p.first, &p.second, &p.albedo, &p.normal, &p.place, &p.variance})
        for (auto& plane : *planes) plane.row(y)[x] = 0;
    }
  denoise(p, 2);
  for (int y = 0; y < height; ++y) {
    EXPECT_EQ(p.first[0].row(y)[35], 0);
    EXPECT_NEAR(p.first[0].row(y)[29], 0.35, 0.02);
    EXPECT_NEAR(p.first[0].row(y)[40], 0.35, 0.02);
  }
}

TEST(Denoise, AnyNumberOfThreadsMakesTheSamePicture) {
  const auto wave = [](int x, int y) { return Made{1 + 0.5 * std::sin(0.2 * x + 0.1 * y)}; };
  NoisyPicture one = noisy(0.3, wave);
  denoise(one, 1);
  for (const unsigned threads : {2U, 3U, 7U}) {
    NoisyPicture p = noisy(0.3, wave);
    denoise(p, threads);
    for (int y = 0; y < height; ++y)
      EXPECT_TRUE(std::equal(p.first[0].row(y), p.first[0].row(y) + width, one.first[0].row(y))) << threads;
  }
}

TEST(Denoise, TakesPicturesOfAnySize) {
  for (const auto& [wide, tall] : {std::pair{1, 1}, {2, 40}, {33, 1}, {32, 32}}) {
    NoisyPicture p(wide, tall);
    for (int y = 0; y < tall; ++y)
      for (int x = 0; x < wide; ++x) {
        p.seen.row(y)[x] = 1, p.samples.row(y)[x] = 4, p.normal[2].row(y)[x] = 1;
        for (std::size_t c = 0; c < 3; ++c)
          p.first[c].row(y)[x] = p.second[c].row(y)[x] = 0.25F, p.albedo[c].row(y)[x] = 0.5F;
      }
    denoise(p, 2);
    EXPECT_NEAR(p.first[2].row(tall - 1)[wide - 1], 0.25, 1e-6);
  }
}

}  // namespace
}  // namespace betwixt
