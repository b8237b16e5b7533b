// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/ik.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace betwixt {
namespace {

struct ChainDice {
  std::mt19937 random;
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
  Vec3 place(double far) { return {number(-far, far), number(-far, far), number(-far, far)}; }
  std::vector<Vec3> chain(int bones) {
    std::vector<Vec3> out{place(2)};
    for (int i = 0; i < bones; ++i) out.push_back(out.back() + place(1));
    return out;
  }
};

std::vector<double> bones(const std::vector<Vec3>& chain) {
  std::vector<double> out;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) out.push_back(length(chain[i + 1] - chain[i]));
  return out;
}

// How near the end of such bones can come to something so far off: not beyond their sum, nor nearer than the longest
// one is longer than all others.
double least_gap(const std::vector<double>& bones, double far) {
  double sum = 0, longest = 0;
  for (const double b : bones) sum += b, longest = std::max(longest, b);
  return std::max({0.0, far - sum, 2 * longest - sum - far});
}

// The angle at the elbow is that of the law of cosines, the elbow stays in the plane it was in, on its side.
TEST(Reaching, TwoBonesAreATriangle) {
  ChainDice dice{std::mt19937(7)};
  for (int round = 0; round < 2000; ++round) {
    const auto before = dice.chain(2);
    const Vec3 goal = before[0] + dice.place(2);
    const auto is = solve_ik(before, {goal, {}, 1, {1, 0, 0}});
    const double a = bones(before)[0], b = bones(before)[1], far = length(goal - before[0]);
    EXPECT_EQ(is[0], before[0]);
    EXPECT_NEAR(bones(is)[0], a, 1e-12);
    EXPECT_NEAR(bones(is)[1], b, 1e-12);
    EXPECT_NEAR(length(is[2] - goal), least_gap({a, b}, far), 1e-12);
    if (far > a + b || far < std::abs(a - b)) continue;
    const double cosine = (a * a + b * b - far * far) / (2 * a * b);
    EXPECT_NEAR(dot(is[0] - is[1], is[2] - is[1]) / (a * b), cosine, 1e-12);
  }
}

TEST(Reaching, ThePoleSaysTheSide) {
  ChainDice dice{std::mt19937(8)};
  for (int round = 0; round < 500; ++round) {
    const int n = 2 + round % 5;
    const auto before = dice.chain(n);
    const auto lengths = bones(before);
    const Vec3 goal = before[0] + dice.place(0.3 * n), pole = before[0] + dice.place(3);
    const auto is = solve_ik(before, {goal, pole, 1, {1, 0, 0}});
    const Vec3 along = normalize(is.back() - is.front());
    Vec3 middle;
    for (const Vec3 p : is) middle = middle + (p - is.front() - dot(p - is.front(), along) * along);
    if (length(middle) < 1e-6) continue;
    const Vec3 wanted = pole - before[0] - dot(pole - before[0], along) * along;
    EXPECT_NEAR(dot(normalize(middle), normalize(wanted)), 1, 1e-9);
    EXPECT_NEAR(length(is.back() - goal), least_gap(lengths, length(goal - before[0])), 1e-6);
  }
}

// Longer ones come to the goal, or as near as any could; their bones stay as long as they are.
TEST(Reaching, LongChainsComeAsNearAsCanBe) {
  ChainDice dice{std::mt19937(9)};
  for (int round = 0; round < 3000; ++round) {
    const auto before = dice.chain(3 + round % 10);
    const auto lengths = bones(before);
    double sum = 0;
    for (const double b : lengths) sum += b;
    const double far = round % 4 == 0 ? 1.2 * sum : round % 4 == 1 ? 0.05 * sum : sum;
    const Vec3 goal = before[0] + dice.number(0, far) * normalize(dice.place(1));
    const auto is = solve_ik(before, {goal, {}, 1, {1, 0, 0}});
    EXPECT_EQ(is[0], before[0]);
    for (std::size_t i = 0; i < lengths.size(); ++i) EXPECT_NEAR(bones(is)[i], lengths[i], 1e-9);
    EXPECT_NEAR(length(is.back() - goal), least_gap(lengths, length(goal - before[0])), 1e-6) << round;
  }
}

// That nothing comes nearer: a million poses of a chain of three, drawn by lot.
TEST(Reaching, NothingComesNearer) {
  ChainDice dice{std::mt19937(10)};
  for (const double far : {0.05, 0.9, 4.0}) {
    const std::vector<Vec3> before{{0, 0, 0}, {2, 0, 0}, {2, 0.5, 0}, {2, 0.5, 0.7}};
    const Vec3 goal{0, far, 0};
    const double is = length(solve_ik(before, {goal, {}, 1, {1, 0, 0}}).back() - goal);
    double best = 1e300;
    for (int i = 0; i < 300'000; ++i) {
      Vec3 end;
      for (const double b : {2.0, 0.5, 0.7}) end = end + b * normalize(dice.place(1));
      best = std::min(best, length(end - goal));
    }
    EXPECT_LE(is, best + 1e-9) << far;
    EXPECT_NEAR(is, best, 0.1) << far;  // which lots come near to, too
  }
}

TEST(Reaching, StraightAndFoldedAndOnTheSpot) {
  const std::vector<Vec3> straight{{0, 0, 0}, {0, -1, 0}, {0, -2, 0}};
  // A straight leg bends to the side that it is told.
  const auto knee = solve_ik(straight, {{0, -std::sqrt(2.0), 0}, {}, 1, {1, 0, 0}});
  EXPECT_NEAR(knee[1].x, std::sqrt(0.5), 1e-12);
  for (int n = 2; n < 9; ++n) {
    std::vector<Vec3> line;
    for (int i = 0; i <= n; ++i) line.push_back({0, -1.0 * i, 0});
    for (const double far : {n - 0.001, 0.5 * n, 0.01, 0.0, n + 1.0}) {
      const auto is = solve_ik(line, {{0, -far, 0}, {}, 1, {1, 0, 0}});
      EXPECT_NEAR(length(is.back() - Vec3{0, -far, 0}),
                  least_gap(std::vector<double>(static_cast<std::size_t>(n), 1), far), 1e-6)
          << n << ' ' << far;
      for (const double b : bones(is)) EXPECT_NEAR(b, 1, 1e-9);
      if (far > 0 && far < n) {
        EXPECT_GT(is[1].x, 0) << n << ' ' << far;
      }
    }
  }
  // Bones of no length at all.
  const std::vector<Vec3> nothing(4, Vec3{1, 2, 3});
  EXPECT_EQ(solve_ik(nothing, {{5, 5, 5}, {}, 1, {1, 0, 0}}), nothing);
  // A part of the way is on the straight line to it; no part is where it was.
  ChainDice dice{std::mt19937(11)};
  for (int n = 2; n < 6; ++n) {
    const auto before = dice.chain(n);
    const Vec3 goal = before[0] + 0.4 * (before[static_cast<std::size_t>(n)] - before[0]) + Vec3{0.1, 0.2, 0};
    for (const double share : {0.0, 1e-6, 0.25, 0.5, 1.0}) {
      const auto is = solve_ik(before, {goal, Vec3{9, 9, 9}, share, {1, 0, 0}});
      const Vec3 wanted = before.back() + share * (goal - before.back());
      EXPECT_NEAR(length(is.back() - wanted), 0, 1e-6);
      for (std::size_t i = 0; share < 1e-5 && i < is.size(); ++i) EXPECT_NEAR(length(is[i] - before[i]), 0, 1e-3);
    }
  }
}

TEST(Reaching, TheShortestTurn) {
  ChainDice dice{std::mt19937(12)};
  for (int i = 0; i < 200; ++i) {
    const Vec3 a = dice.place(1), b = i % 10 == 0 ? -2.0 * a : dice.place(3);
    const Quat q = shortest_turn(a, b);
    EXPECT_NEAR(length(normalize(transform_vector(rotation(q), a)) - normalize(b)), 0, 1e-9);
    EXPECT_NEAR(2 * std::acos(std::min(1.0, std::abs(q.w))),
                std::acos(std::clamp(dot(normalize(a), normalize(b)), -1.0, 1.0)), 1e-6);
  }
  EXPECT_EQ(shortest_turn({}, {1, 0, 0}), Quat{});
}

}  // namespace
}  // namespace betwixt
