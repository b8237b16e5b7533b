// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/power.h"

#include <gtest/gtest.h>

#include <random>

namespace betwixt {
namespace {

constexpr double degree = pi / 180;

Mat4 about(Vec3 centre, Vec3 axis, double angle) {
  return translation(centre) * rotation(axis_angle(axis, angle)) * translation(-centre);
}
double difference(const Mat4& a, const Mat4& b) {
  double most = 0;
  for (std::size_t i = 0; i < 16; ++i) most = std::max(most, std::abs(a.m[i] - b.m[i]));
  return most;
}
double largest(const Mat4& a) {
  double most = 0;
  for (double e : a.m) most = std::max(most, std::abs(e));
  return most;
}

// M * M * ... in long double.
Mat4 literal(const Mat4& m, int n) {
  std::array<long double, 16> r{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  for (; n > 0; --n) {
    std::array<long double, 16> next{};
    for (std::size_t c = 0; c < 4; ++c)
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 4; ++k) next[c * 4 + i] += static_cast<long double>(m.m[k * 4 + i]) * r[c * 4 + k];
    r = next;
  }
  Mat4 out;
  for (std::size_t i = 0; i < 16; ++i) out.m[i] = static_cast<double>(r[i]);
  return out;
}

class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  double number(double low, double high) { return low + (high - low) * static_cast<double>(engine_()) * 0x1p-32; }
  Vec3 vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }
  Quat turn() { return axis_angle(vector(1), number(-4, 4)); }

 private:
  std::mt19937 engine_;
};

// shows: C31 R-E15
TEST(Power, KindsAreTold) {
  EXPECT_EQ(Power().kind(), Power::Kind::identity);
  EXPECT_EQ(Power(Mat4{}).kind(), Power::Kind::identity);
  EXPECT_EQ(Power(translation({1, 2, 3})).kind(), Power::Kind::translation);
  EXPECT_EQ(Power(rotation(axis_angle({0, 0, 1}, 1))).kind(), Power::Kind::similarity);
  EXPECT_EQ(Power(scaling({2, 2, 2})).kind(), Power::Kind::similarity);
  const Power mirror(scaling({-1, 1, 1}));
  EXPECT_EQ(mirror.kind(), Power::Kind::similarity);
  EXPECT_TRUE(mirror.similarity().mirrored);
  EXPECT_EQ(Power(scaling({2, 1, 1})).kind(), Power::Kind::general);
  EXPECT_EQ(Power(scaling({0, 0, 0})).kind(), Power::Kind::general);
  Mat4 projective;
  projective(3, 0) = 0.1;
  EXPECT_EQ(Power(projective).kind(), Power::Kind::general);
}

// shows: R-E15
TEST(Power, ATurnByDegreesIsThatForThousandsOfMillionsOfSteps) {
  double worst = 0;
  for (Vec3 axis : {Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{1, 2, 3}, Vec3{-0.3, 0.7, 0.1}})
    for (double degrees : {7.0, 10.0, 1.0, 0.1, 90.0, 120.0, 179.0, 33.3, 360.0 / 7})
      for (std::int64_t n : {1'000'000'000LL, 999'999'937LL, 2'000'000'011LL}) {
        const Vec3 centre{3, -2, 5};
        // In 2520ths of a degree all of them are whole.
        const auto unit = static_cast<std::int64_t>(std::llround(degrees * 2520));
        const double left = static_cast<double>(n % (360 * 2520) * unit % (360 * 2520)) / 2520;
        const Mat4 exact = about(centre, axis, left * degree);
        worst = std::max(worst, difference(Power(about(centre, axis, degrees * degree))(n), exact));
      }
  EXPECT_LT(worst, 1e-8);  // 2^-65 of a turn each step
}

// shows: R-E15
TEST(Power, AnyTurnIsRightToAMillionthAfterAThousandMillionSteps) {
  Dice dice(1);
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 axis = dice.vector(1);
    const double angle = dice.number(-pi, pi);
    const std::int64_t n = 1'000'000'000 - i;
    const auto left = static_cast<double>(
        std::fmod(static_cast<long double>(angle) * static_cast<long double>(n), 2 * std::numbers::pi_v<long double>));
    worst = std::max(worst, difference(Power(rotation(axis_angle(axis, angle)))(n), rotation(axis_angle(axis, left))));
  }
  EXPECT_LT(worst, 1e-6);
}

// shows: C41 C47 C48 C50 R-E15
TEST(Power, SimilaritiesAreTheirLiteralProducts) {
  Dice dice(2);
  double worst = 0;
  for (int i = 0; i < 400; ++i) {
    const double scale = i % 4 == 0 ? 1 : dice.number(0.99, 1.01);
    const double flip = i % 3 == 0 ? -1 : 1;
    const Quat turn = i % 5 == 0 ? Quat{} : dice.turn();
    const Mat4 m = translation(dice.vector(3)) * rotation(turn) * scaling({flip * scale, scale, scale});
    const Power power(m);
    ASSERT_NE(power.kind(), Power::Kind::general) << i;
    EXPECT_FALSE(unrounded(m));
    for (int n : {0, 1, 2, 3, 10, 999, 1000}) {
      const Mat4 want = literal(m, n);
      worst = std::max(worst, difference(power(n), want) / std::max(1.0, largest(want)));
    }
  }
  EXPECT_LT(worst, 1e-11);
}

TEST(Power, MirrorsHaveParity) {
  const Power glide(translation({1, 4, 0}) * scaling({1, -1, 1}));
  EXPECT_LT(difference(glide(1'000'000'000), translation({1e9, 0, 0})), 1e-6);
  EXPECT_LT(difference(glide(7), translation({7, 4, 0}) * scaling({1, -1, 1})), 1e-14);
  const Power point(translation({2, 2, 2}) * scaling({-1, -1, -1}));
  EXPECT_LT(difference(point(1'000'000'000'000), Mat4{}), 1e-14);
  EXPECT_LT(difference(point(1'000'000'000'001), translation({2, 2, 2}) * scaling({-1, -1, -1})), 1e-14);
}

TEST(Power, PowersAdd) {
  Dice dice(3);
  for (int i = 0; i < 300; ++i) {
    const Mat4 m = translation(dice.vector(1)) * rotation(dice.turn()) * scaling({i % 2 == 0 ? 1.0 : -1.0, 1, 1});
    const Power power(m);
    const auto a = static_cast<std::int64_t>(dice.number(0, 1e6)), b = static_cast<std::int64_t>(dice.number(0, 1e6));
    const Mat4 whole = power(a + b);
    EXPECT_LT(difference(whole, power(a) * power(b)), 1e-12 * std::max(1.0, largest(whole)));
  }
}

TEST(Power, SmallTurnsHaveFarCentresAndKeepTheirDigits) {
  for (double angle : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15}) {
    const Mat4 m = translation({1, 0, 0}) * rotation(axis_angle({0, 0, 1}, angle));
    // The sum of the first n powers of e^(i angle), by its half angles.
    const double n = 1000, reach = std::sin(n * angle / 2) / std::sin(angle / 2), way = (n - 1) * angle / 2;
    const Mat4 got = Power(m)(1000);
    EXPECT_NEAR(got(0, 3), reach * std::cos(way), 1e-10) << angle;
    EXPECT_NEAR(got(1, 3), reach * std::sin(way), 1e-10) << angle;
    EXPECT_NEAR(got(1, 0), std::sin(n * angle), 1e-13 * n * angle + 1e-15) << angle;
  }
}

// shows: C49 R-E13 R-E15
TEST(Power, GrowthIsAboutTheFixedPointAndAdvancesAsASumOfPowers) {
  const double s = 1.001;
  const Power power(translation({0, 0, 2}) * rotation(axis_angle({0, 0, 1}, 0.3)) * scaling({s, s, s}));
  const double grown = std::pow(s, 5000);
  EXPECT_NEAR(power(5000)(2, 3), 2 * (grown - 1) / (s - 1), 1e-9 * grown / (s - 1));
  const Vec3 fixed{1, -2, 3};
  const Power shrink(translation(fixed) * scaling({0.5, 0.5, 0.5}) * translation(-fixed));
  EXPECT_LT(length(transform_point(shrink(50), {100, 100, 100}) - fixed), 1e-12);
}

// shows: C85 R-E15
TEST(Power, GeneralMatricesClimbTheLadder) {
  Dice dice(4);
  for (int i = 0; i < 200; ++i) {
    Mat4 m;
    for (double& e : m.m) e += dice.number(-0.01, 0.01);
    const Power power(m);
    ASSERT_EQ(power.kind(), Power::Kind::general);
    for (int n : {0, 1, 2, 7, 100}) {
      const Mat4 want = literal(m, n);
      EXPECT_LT(difference(power(n), want), 1e-12 * std::max(1.0, largest(want)));
    }
  }
  Mat4 shear;
  shear(0, 1) = 0.25;
  Mat4 want;
  want(0, 1) = 0.25e15;
  EXPECT_EQ(Power(shear)(1'000'000'000'000'000), want);
  const Power flat(scaling({1, 1, 0}));
  EXPECT_EQ(flat(std::numeric_limits<std::int64_t>::max()), scaling({1, 1, 0}));
}

// shows: R-E15
TEST(Power, NothingGrowsWithoutBound) {
  const Power grow(scaling({2, 2, 2}));
  EXPECT_FALSE(grow.clamped(59));
  EXPECT_EQ(grow(10)(0, 0), 1024);
  EXPECT_TRUE(grow.clamped(60));
  EXPECT_NEAR(grow(1'000'000)(1, 1), 1e18, 1e4);
  const Power shrink(scaling({0.5, 0.5, 0.5}));
  EXPECT_TRUE(shrink.clamped(1'000'000));
  EXPECT_NEAR(shrink(1'000'000)(1, 1), 1e-18, 1e-31);
  // A stretch in x leaves the way along y alone.
  const Power stretch(translation({0, 1, 0}) * scaling({-3, 1, 1}));
  EXPECT_TRUE(stretch.clamped(1001));
  EXPECT_EQ(stretch(1001)(0, 0), -1e18);
  EXPECT_EQ(stretch(1001)(1, 3), 1001);
  Mat4 wild;
  for (double& e : wild.m) e = -1e300;
  for (std::int64_t n : {std::int64_t{1}, std::int64_t{1000}, std::numeric_limits<std::int64_t>::max()})
    for (double e : Power(wild)(n).m) EXPECT_LE(std::abs(e), 1e18);
}

// shows: R-E15
TEST(Power, NearlyRigidMatricesAreMadeRigid) {
  Mat4 m = about({1, 2, 3}, {1, 1, 0}, 0.4);
  for (double& e : m.m) e = static_cast<float>(e);
  EXPECT_EQ(Power(m).kind(), Power::Kind::general);
  const auto meant = unrounded(m);
  ASSERT_TRUE(meant && meant->noticeable);
  EXPECT_FALSE(unrounded(meant->matrix));
  const Power power(meant->matrix);
  const Mat4 late = power(100'000'000);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(length({late(i, 0), late(i, 1), late(i, 2)}), 1, 1e-14);
    EXPECT_LT(std::abs(late(i, 3)), 10);
  }
  EXPECT_LT(difference(power(1), m), 1e-6);
  // Too far from rigid: as it is.
  m(0, 0) += 1e-4;
  EXPECT_FALSE(unrounded(m));
  EXPECT_EQ(Power(m).kind(), Power::Kind::general);
  EXPECT_TRUE(unrounded(scaling({1, 1, 1 + 9e-8})));
  EXPECT_FALSE(unrounded(scaling({1, 1, 1.000001})));
  // An even scale is meant, however small.
  EXPECT_FALSE(unrounded(scaling({1.000001, 1.000001, 1.000001})));
  const Power slow(scaling({1.000001, 1.000001, 1.000001}));
  EXPECT_NEAR(slow(1'000'000)(2, 2), std::pow(1.000001, 1e6), 1e-9);
}

// shows: R-E15
TEST(Power, WhatManyProductsLeaveIsTakenAwayQuietly) {
  Mat4 turned = scaling({1.5, 1.5, 1.5});
  const Mat4 third = rotation(axis_angle({1, 2, 3}, 2 * pi / 3));
  for (int i = 0; i < 300; ++i) turned = turned * third;
  turned(0, 0) += 1e-13;
  const auto meant = unrounded(turned);
  ASSERT_TRUE(meant);
  EXPECT_FALSE(meant->noticeable);
  EXPECT_LT(difference(meant->matrix, scaling({1.5, 1.5, 1.5})), 1e-12);
  EXPECT_EQ(Power(meant->matrix).kind(), Power::Kind::similarity);
}

// shows: R-E1d
TEST(Power, BetweenTheStepsMotionIsSmooth) {
  Dice dice(5);
  for (int i = 0; i < 200; ++i) {
    const double s = i % 2 == 0 ? 1 : dice.number(0.9, 1.1);
    const Quat turn = i % 5 == 0 ? Quat{} : dice.turn();
    const Power power(translation(dice.vector(1)) * rotation(turn) * scaling({s, s, s}));
    const double n = dice.number(0, 40);
    const Mat4 half = *power.real(n / 2), whole = *power.real(n);
    EXPECT_LT(difference(half * half, whole), 1e-12 * std::max(1.0, largest(whole)));
    EXPECT_LT(difference(*power.real(17), power(17)), 1e-14 * std::max(1.0, largest(power(17))));
  }
  EXPECT_LT(difference(*Power(translation({1, 2, 3})).real(1.5), translation({1.5, 3, 4.5})), 1e-15);
  EXPECT_EQ(Power().real(2.5), Mat4{});
  EXPECT_FALSE(Power(scaling({-1, 1, 1})).real(0.5));
  EXPECT_FALSE(Power(scaling({2, 1, 1})).real(0.5));
}

}  // namespace
}  // namespace betwixt
