// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "algebra/power.h"

#include <gtest/gtest.h>

#include <random>

#include "betwixt/algebra.h"

namespace betwixt {
namespace {

double apart(const Mat4& a, const Mat4& b) {
  double worst = 0;
  for (const int row : {0, 1})
    for (const int column : {0, 1, 3}) worst = std::max(worst, std::abs(a(row, column) - b(row, column)));
  return worst;
}
Mat4 whole(const char* text) { return at(*parse_motion(text), 1); }

// The root is one: as many of it as it takes are the whole again.
TEST(Power, IsARoot) {
  std::mt19937 random(3);
  const auto number = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  };
  int roots = 0;
  for (int round = 0; round < 500; ++round) {
    Mat4 m;
    for (const int row : {0, 1})
      for (const int column : {0, 1, 3}) m(row, column) = number(-2, 3);
    if (round % 5 == 0) m = whole("S(2 2) T(3 1)"), m(0, 1) = number(-3, 3);  // two eigenvalues that are one
    if (round % 7 == 0) m(0, 0) = m(1, 1) = 1, m(1, 0) = 0;
    if (std::abs(m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0)) < 0.01) continue;
    const auto root = algebra::power(m, 1.0 / 13);
    if (!root) continue;
    ++roots;
    Mat4 product;
    for (int i = 0; i < 13; ++i) product = product * *root;
    EXPECT_LE(apart(product, m), 1e-8) << round;
    EXPECT_LE(apart(*algebra::power(m, 1), m), 1e-8) << round;
    EXPECT_LE(apart(*algebra::power(m, 0), Mat4{}), 1e-8) << round;
  }
  EXPECT_GT(roots, 200);
}

TEST(Power, OfOneFactorIsItsPart) {
  for (const char* text : {"T(3 -1)", "R(100deg @ 1 2)", "R(-179deg @ 1 2)", "R(180deg @ 3 1)", "S(2 0.5 @ 1 4)",
                           "S(3 @ 1 1)", "S(2 2) R(0.5turn)", "T(0 3) S(2 1 @ 3 0)"}) {
    const Motion motion = *parse_motion(text);
    for (const double t : {0.0, 0.1, 0.5, 0.9, 1.0})
      EXPECT_LE(apart(*algebra::power(at(motion, 1), t), at(motion, t)), 1e-9) << text << " at " << t;
  }
  // Whole turns cannot be seen in the whole: what is left is a straight way.
  EXPECT_LE(apart(*algebra::power(whole("R(1turn) T(3 0)"), 0.5), whole("T(1.5 0)")), 1e-12);
}

TEST(Power, MayNotExist) {
  EXPECT_FALSE(algebra::power(whole("S(2 0.5 @ 1 1) R(180deg)"), 0.5));  // -2 and -1/2
  EXPECT_FALSE(algebra::power(whole("S(-1 1 linear)"), 0.5));
  EXPECT_FALSE(algebra::power(whole("S(0 1 linear)"), 0.5));
  EXPECT_FALSE(algebra::power(whole("S(0 0 linear)"), 0.5));
}

}  // namespace
}  // namespace betwixt
