// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the conversion of linear light to the screen and back by the sRGB standard.
#include "betwixt/linear_picture.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace betwixt {
namespace {

double encoded(double l) { return l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055; }
double decoded(double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); }

std::array<int, 4> shown(std::array<float, 4> light) {
  Picture p;
  to_shown({1, 1, {light[0], light[1], light[2], light[3]}}, p);
  return {p.rgba[0], p.rgba[1], p.rgba[2], p.rgba[3]};
}
std::array<int, 4> shown_16(std::array<float, 4> light) {
  const auto p = to_shown_16({1, 1, {light[0], light[1], light[2], light[3]}});
  return {p[0], p[1], p[2], p[3]};
}

TEST(LinearPicture, ShowsEveryByteAsTheStandardSays) {
  for (int b = 0; b < 256; ++b) {
    const auto light = static_cast<float>(decoded(b / 255.0));
    EXPECT_EQ(shown({light, light, light, 1}), (std::array{b, b, b, 255}));
    EXPECT_EQ(shown_16({light, light, light, 1}), (std::array{257 * b, 257 * b, 257 * b, 65535}));
  }
}

TEST(LinearPicture, ShowsLightToTheNearestStep) {
  std::mt19937 random(9);
  std::uniform_real_distribution<float> share(0, 1);
  for (int i = 0; i < 20000; ++i) {
    const float dark = i % 2 ? 1.0F : 0.01F, light = dark * share(random), opacity = 0.02F + 0.98F * share(random);
    const auto bytes = shown({opacity * light, 0, 0, opacity}), wide = shown_16({opacity * light, 0, 0, opacity});
    EXPECT_NEAR(bytes[0], 255 * encoded(light), 0.53) << light;  // a table looks it up
    EXPECT_NEAR(bytes[3], 255 * static_cast<double>(opacity), 0.501);
    EXPECT_NEAR(wide[0], 65535 * encoded(light), 0.6) << light << " through " << opacity;
    EXPECT_NEAR(wide[3], 65535 * static_cast<double>(opacity), 0.51);
  }
}

TEST(LinearPicture, WhatIsShownComesBack) {
  std::vector<std::uint16_t> all;
  for (int v = 0; v < 65536; ++v)
    for (const int c : {v, 65535 - v, v * 7919 % 65536, v % 2 ? 65535 : std::max(v, 1)})
      all.push_back(static_cast<std::uint16_t>(c));
  const LinearPicture light = to_light(256, 256, all);
  EXPECT_EQ(light.width, 256);
  EXPECT_EQ(light.height, 256);
  for (std::size_t i = 0; i < all.size(); i += 4)
    ASSERT_NEAR(light.rgba[i], decoded(all[i] / 65535.0) * all[i + 3] / 65535.0, 1e-7);
  EXPECT_EQ(to_shown_16(light), all);
}

TEST(LinearPicture, WhatIsTooBrightIsWhiteAndWhatIsNoLightBlack) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), endless = std::numeric_limits<float>::infinity();
  EXPECT_EQ(shown({7, 1.0001F, endless, 1}), (std::array{255, 255, 255, 255}));
  EXPECT_EQ(shown({-1, -endless, nan, 1}), (std::array{0, 0, 0, 255}));
  EXPECT_EQ(shown({nan, nan, nan, nan}), (std::array{0, 0, 0, 0}));
  EXPECT_EQ(shown({0, 0, 0, 2}), (std::array{0, 0, 0, 255}));
  EXPECT_EQ(shown({0, 0, 0, -1}), (std::array{0, 0, 0, 0}));
  EXPECT_EQ(shown_16({nan, 7, -1, 1}), (std::array{0, 65535, 0, 65535}));
  EXPECT_EQ(shown_16({0, 0, 0, 0}), (std::array{0, 0, 0, 0}));
}

// Straight colours end at white: over black it is shown as bright as it is all the same.
TEST(LinearPicture, HighlightsOnGlassStay) {
  for (const auto& [light, opacity] : {std::pair{0.5F, 0.1F}, {0.25F, 0.0F}, {0.9F, 0.3F}}) {
    const auto p = shown_16({light, light / 2, 0, opacity});
    EXPECT_NEAR(decoded(p[0] / 65535.0) * p[3] / 65535.0, light, 1e-4);
    EXPECT_NEAR(decoded(p[1] / 65535.0) * p[3] / 65535.0, light / 2, 1e-4);
    EXPECT_NEAR(p[3] / 65535.0, light, 1e-4);  // no more opaque than that takes
  }
}

TEST(LinearPicture, APictureThatWasLargerIsMadeToMeasure) {
  Picture p{9, 9, std::vector<std::uint8_t>(4 * 81, 7)};
  to_shown({2, 1, {0, 0, 0, 1, 1, 1, 1, 1}}, p);
  EXPECT_EQ(p.width, 2);
  EXPECT_EQ(p.height, 1);
  EXPECT_EQ(p.rgba, (std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255, 255, 255}));
}

}  // namespace
}  // namespace betwixt
