// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Eases by polynomials, against the functions themselves.
#include "track/ease.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <vector>

#include "track/curve.h"
#include "track/twerpers.h"

namespace betwixt {
namespace {

// The value of a Bezier curve by bisection of its parameter.
long double by_bisection(long double u, const Ease::Arguments& a) {
  const auto at = [](long double p, long double q, long double s) {
    return 3 * (1 - s) * (1 - s) * s * p + 3 * (1 - s) * s * s * q + s * s * s;
  };
  long double low = 0, high = 1;
  for (int i = 0; i < 100; ++i) (at(a[0], a[2], (low + high) / 2) < u ? low : high) = (low + high) / 2;
  return at(a[1], a[3], (low + high) / 2);
}

TEST(Eases, AreNearTheirCurve) {
  std::mt19937_64 random(5);
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::vector<Ease::Arguments> all{{0.25, 0.1, 0.25, 1}, {0.42, 0, 0.58, 1}, {0.42, 0, 1, 1},  {0, 0, 0.58, 1},
                                   {0.9, 0, 0.1, 1},     {0, 1, 1, 0},       {0.5, -2, 0.5, 3}};
  for (int i = 0; i < 60; ++i) all.push_back({number(0, 1), number(-1, 2), number(0, 1), number(-1, 2)});
  for (const Ease::Arguments& a : all) {
    const auto ease = bezier_ease(a);
    for (int i = 0; i < 400; ++i) {
      const double u = i < 40 ? std::pow(10.0, -i / 4.0) : number(0, 1);
      // Where the curve is steep, u itself is exact to 1e-16 only.
      const double nudge = 4e-16;
      const auto slack =
          std::abs(by_bisection(std::min(1.0, u + nudge), a) - by_bisection(std::max(0.0, u - nudge), a));
      ASSERT_NEAR(ease->at(u), static_cast<double>(by_bisection(u, a)), 1e-12 + static_cast<double>(slack))
          << u << " " << a[0] << " " << a[2];
    }
    EXPECT_EQ(ease->at(0), 0);
    EXPECT_EQ(ease->at(1), 1);
  }
}

TEST(Eases, OfAllTwerpersAreNearTheirFunctions) {
  std::size_t costly = 0;
  for (const TwerperRow& row : twerpers()) {
    if (!row.factor || !row.arguments.empty()) continue;
    costly += row.costly;
    const Ease* ease = ease_of(*find_twerper(row.name));
    for (int i = 0; i <= 3000; ++i)
      ASSERT_NEAR(ease->at(i / 3000.0), row.factor(i / 3000.0, {}), 1e-12) << row.name << i;
  }
  EXPECT_GT(costly, 12u);
}

// Values have the same bits before an ease has its table, with it, and if there are too many eases for tables.
TEST(Eases, HaveOneValueByEveryRoute) {
  std::vector<std::shared_ptr<const Ease>> many;
  const Ease::Arguments a{0.3, 0.05, 0.2, 0.95};
  const auto first = [&](double u) { return Ease(bezier_factor, a, true).at(u); };
  std::vector<double> before;
  for (int i = 0; i < 500; ++i) before.push_back(first(i / 500.0));
  const auto same = [&](const Ease& ease) {
    for (int i = 0; i < 500; ++i) {
      const double now = ease.at(i / 500.0);
      ASSERT_EQ(std::memcmp(&now, &before[static_cast<std::size_t>(i)], sizeof now), 0) << i;
    }
  };
  const Ease often(bezier_factor, a, true);
  same(often), same(often);
  for (int i = 0; i < 4200; ++i) {
    many.push_back(bezier_ease({i / 5000.0, 0, 0.5, 1}));
    for (int k = 0; k < 20; ++k) many.back()->at(0.5);
  }
  const Ease late(bezier_factor, a, true);
  same(late);
  EXPECT_EQ(bezier_ease({0.1, 0, 0.5, 1}), many[500]) << "equal arguments give one ease";
}

}  // namespace
}  // namespace betwixt
