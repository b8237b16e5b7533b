// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the signals of Display P3, BT.2020, PQ and HLG against published numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "betwixt/linear_picture.h"

namespace betwixt {
namespace {

std::array<double, 3> signals_of(float r, float g, float b, ColorCoding coding) {
  const auto all = to_coded_16({1, 1, {r, g, b, 1}}, coding);
  EXPECT_EQ(all[3], 65535);
  return {all[0] / 65535.0, all[1] / 65535.0, all[2] / 65535.0};
}
void expect_all(const std::array<double, 3>& is, double r, double g, double b, double within) {
  EXPECT_NEAR(is[0], r, within);
  EXPECT_NEAR(is[1], g, within);
  EXPECT_NEAR(is[2], b, within);
}

// BT.2408: diffuse white is 58 % in PQ and 75 % in HLG; BT.2100: 1000 nits are 0.7518 in PQ, black is 0.
TEST(ColorCodings, PlaceWhiteAndThePeakAsPublished) {
  const auto most = static_cast<float>(peak_nits / white_nits);
  expect_all(signals_of(1, 1, 1, ColorCoding::pq), 0.5807, 0.5807, 0.5807, 1e-4);
  expect_all(signals_of(most, most, most, ColorCoding::pq), 0.7518, 0.7518, 0.7518, 1e-4);
  expect_all(signals_of(1, 1, 1, ColorCoding::hlg), 0.75, 0.75, 0.75, 1e-3);
  expect_all(signals_of(most, most, most, ColorCoding::hlg), 1, 1, 1, 1e-5);
  expect_all(signals_of(99, 99, 99, ColorCoding::hlg), 1, 1, 1, 1e-5);
  for (const auto coding : {ColorCoding::p3, ColorCoding::rec2020, ColorCoding::pq, ColorCoding::hlg})
    expect_all(signals_of(0, -1, std::nanf(""), coding), 0, 0, 0, 2e-5);
}

// Red of sRGB in Display P3 is 234 51 35, as browsers show it. In BT.2020 (BT.2087) its light is 0.6274 0.0691 0.0164.
TEST(ColorCodings, ChangePrimaries) {
  expect_all(signals_of(1, 0, 0, ColorCoding::p3), 234 / 255.0, 51 / 255.0, 35 / 255.0, 0.5 / 255);
  const auto curve = [](double c) { return 1.055 * std::pow(c, 1 / 2.4) - 0.055; };
  expect_all(signals_of(1, 0, 0, ColorCoding::rec2020), curve(0.6274), curve(0.0691), curve(0.0164), 2e-4);
  for (const auto coding : {ColorCoding::p3, ColorCoding::rec2020})
    expect_all(signals_of(0.5F, 0.5F, 0.5F, coding), curve(0.5), curve(0.5), curve(0.5), 2e-5);
}

TEST(ColorCodings, ComeBackAsLight) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> share(0, 1);
  for (const auto coding : {ColorCoding::p3, ColorCoding::rec2020, ColorCoding::pq, ColorCoding::hlg}) {
    LinearPicture p{40, 40, {}};
    // HLG has less room for bright light of one colour.
    const float most = coding == ColorCoding::pq ? 4.5F : coding == ColorCoding::hlg ? 2.0F : 1.0F;
    for (int i = 0; i < 1600; ++i) {
      for (int c = 0; c < 3; ++c) p.rgba.push_back(most * share(random) * share(random));
      p.rgba.push_back(1);
    }
    const LinearPicture back = to_light(40, 40, to_coded_16(p, coding), coding);
    for (std::size_t i = 0; i < p.rgba.size(); ++i) ASSERT_NEAR(back.rgba[i], p.rgba[i], 5e-4 * (0.5 + p.rgba[i])) << i;
  }
}

TEST(ColorCodings, KeepOpacityStraight) {
  const auto all = to_coded_16({2, 1, {0.25F, 0.25F, 0.25F, 0.5F, 0, 0, 0, 0}}, ColorCoding::p3);
  EXPECT_NEAR(all[0] / 65535.0, 0.7354, 1e-4);  // 0.5 in sRGB's curve
  EXPECT_EQ(all[3], 32768);
  EXPECT_EQ(all[7], 0);
}

}  // namespace
}  // namespace betwixt
