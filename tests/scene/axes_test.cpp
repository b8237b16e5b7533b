// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the coordinates of axes, their ticks and their labels.
#include "scene/axes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace betwixt {
namespace {

Axis numbers(double low, double high, double step = 0, AxisScale scale = AxisScale::linear) {
  return {low, high, step, scale};
}
std::vector<std::string> labels(const Axis& a, double length) {
  std::vector<std::string> out;
  for (const double n : ticks_of(a, length)) out.push_back(tick_label(a, n, tick_step(a, length)));
  return out;
}
using Words = std::vector<std::string>;

TEST(Axes, ChooseReadableTicks) {
  EXPECT_EQ(labels(numbers(0, 10), 8), (Words{"0", "2", "4", "6", "8", "10"}));
  EXPECT_EQ(labels(numbers(-1, 1), 8), (Words{"−1.0", "−0.5", "0", "0.5", "1.0"}));
  EXPECT_EQ(labels(numbers(0, 24000), 8), (Words{"0", "5000", "10,000", "15,000", "20,000"}));
  EXPECT_EQ(labels(numbers(0, 3e9), 8), (Words{"0", "5·10⁸", "10⁹", "1.5·10⁹", "2·10⁹", "2.5·10⁹", "3·10⁹"}));
  EXPECT_EQ(labels(numbers(1, 10000, 0, AxisScale::log), 8), (Words{"1", "10", "100", "1000", "10000"}));
  EXPECT_EQ(labels(numbers(0, 3600, 0, AxisScale::time), 8),
            (Words{"0:00", "10:00", "20:00", "30:00", "40:00", "50:00", "1:00:00"}));
}

TEST(Axes, CountAGivenStepFromTheLowEndOrFrom0) {
  EXPECT_EQ(labels(numbers(1, 13, 3), 8), (Words{"1", "4", "7", "10", "13"}));
  EXPECT_EQ(labels(numbers(-2, 3, 2), 8), (Words{"−2", "0", "2"}));
  EXPECT_EQ(labels(numbers(10, 0, 5), 8), (Words{"0", "5", "10"}));  // reversed
}

TEST(Axes, NeverHaveTooManyTicks) {
  EXPECT_LE(ticks_of(numbers(0, 1, 1e-9), 8).size(), most_ticks);
  EXPECT_LE(ticks_of(numbers(-1e15, 1e15, 1), 8).size(), most_ticks);
  EXPECT_LE(ticks_of(numbers(1e-300, 1e300, 0, AxisScale::log), 8).size(), most_ticks);
  EXPECT_TRUE(ticks_of(numbers(2, 2), 8).empty());
  EXPECT_TRUE(ticks_of(numbers(-1, 5, 0, AxisScale::log), 8).empty());
  EXPECT_TRUE(ticks_of(numbers(0, HUGE_VAL), 8).empty());
}

AxesSpace random_space(std::mt19937_64& dice) {
  const auto one = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(dice); };
  AxesSpace s;
  const bool log = dice() % 3 == 0;
  const double power = std::pow(10, one(-6, 6));
  s.x = numbers(one(-5, 0) * power, one(0.1, 5) * power);
  if (log) s.x = numbers(std::pow(10, one(-4, 0)), std::pow(10, one(0.5, 6)), 0, AxisScale::log);
  s.y = numbers(one(-5, 5), one(6, 9));
  s.size = {one(2, 14), one(1, 8), 0};
  s.digits = one(0.1, 0.5);
  return s;
}

TEST(Axes, MapNumbersToPlacesAndBack) {
  std::mt19937_64 dice(37);
  for (int i = 0; i < 2000; ++i) {
    AxesSpace s = random_space(dice);
    if (i % 4 == 1) s.kind = Kind::plane_grid, s.right = {1, 0.5, 0}, s.up = {-0.3, 2, 0};
    if (s.kind == Kind::plane_grid && s.x.scale == AxisScale::log) continue;
    const Vec3 n{s.x.number_at(0.3), s.y.number_at(0.7), 0};
    const auto back = s.numbers_at(s.place(n));
    ASSERT_TRUE(back);
    EXPECT_NEAR(back->x, n.x, 1e-9 * (std::abs(n.x) + std::abs(s.x.high)));
    EXPECT_NEAR(back->y, n.y, 1e-9 * 20);
  }
  AxesSpace polar;
  polar.kind = Kind::polar_axes, polar.x = numbers(0, 2), polar.size = {6, 6, 0};
  EXPECT_NEAR(length(polar.place({1, pi / 2, 0}) - Vec3{0, 1.5, 0}), 0, 1e-12);
  EXPECT_NEAR(polar.numbers_at({0, 1.5, 0})->y, pi / 2, 1e-12);
}

// Labels of one axis never overlap, whatever the ends, the length and the size of the digits. A digit of the
// default font is 0.636 em wide.
TEST(Axes, LabelsDoNotOverlap) {
  std::mt19937_64 dice(1000);
  for (int i = 0; i < 1000; ++i) {
    const AxesSpace s = random_space(dice);
    const Ticks ticks = ticks_of(s, 'x');
    double end = -1e300;
    for (std::size_t k = 0; k < ticks.numbers.size(); ++k) {
      if (ticks.labels[k].empty()) continue;
      std::size_t letters = 0;
      for (const char c : ticks.labels[k]) letters += (c & 0xc0) != 0x80 ? 1 : 0;
      const double half = 0.318 * s.digits * static_cast<double>(letters), at = label_place(s, 'x', ticks.numbers[k]).x;
      EXPECT_GE(at - half, end) << i << ": " << ticks.labels[k] << " from " << s.x.low << " to " << s.x.high;
      end = at + half;
    }
    double below = -1e300;
    const Ticks up = ticks_of(s, 'y');
    for (std::size_t k = 0; k < up.numbers.size(); ++k) {
      if (up.labels[k].empty()) continue;
      const double at = label_place(s, 'y', up.numbers[k]).y;
      EXPECT_GE(at - below, 0.75 * s.digits) << i;
      below = at;
    }
  }
}

}  // namespace
}  // namespace betwixt
