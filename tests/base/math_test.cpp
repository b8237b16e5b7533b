// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/math.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace betwixt {
namespace {

Quat some_turn() {
  const auto number = [] { return static_cast<double>(*rc::gen::inRange(-1000, 1000)); };
  return axis_angle({number(), number(), 1001 + number()}, 0.003 * number());
}

void expect_same(Quat a, Quat b) {
  EXPECT_NEAR(a.w, b.w, 1e-12);
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
  EXPECT_NEAR(a.z, b.z, 1e-12);
}

RC_GTEST_PROP(Quaternions, PowersAreTurnsOneAfterTheOther, ()) {
  const Quat q = some_turn();
  expect_same(power(q, 3), q * q * q);
  expect_same(power(q, -1), conjugate(q));
  expect_same(power(q, 0.25) * power(q, 0.75), q);
  expect_same(power(q, 0), {});
}

TEST(Quaternions, PowersTakeTheWholeAngle) {
  const Quat far = axis_angle({0, 1, 0}, 1.5 * pi);
  expect_same(power(far, 0.5), axis_angle({0, 1, 0}, 0.75 * pi));
  expect_same(power(-far, 0.5), axis_angle({0, 1, 0}, -0.25 * pi));
  expect_same(power({}, 7), {});
  expect_same(power(axis_angle({1, 0, 0}, 1e-200), 1e200), axis_angle({1, 0, 0}, 1));
}

TEST(Angles, SineAndCosineAreThoseOfTheLibrary) {
  for (int k = -4000; k <= 4000; ++k)
    for (const double angle : {k * 0.01, k * pi / 8, k * 247.3, k * 1e-7, k * 1e9}) {
      const auto [sine, cosine] = sine_cosine(angle);
      EXPECT_NEAR(sine, std::sin(angle), 3e-16) << angle;
      EXPECT_NEAR(cosine, std::cos(angle), 3e-16) << angle;
    }
  EXPECT_EQ(sine_cosine(0).sine, 0);
  EXPECT_EQ(sine_cosine(pi / 2).sine, 1);
  EXPECT_TRUE(std::isnan(sine_cosine(INFINITY).sine));
}

RC_GTEST_PROP(Quaternions, AnglesAreTurnsAboutXThenYThenZ, ()) {
  const auto angle = [] { return 0.01 * static_cast<double>(*rc::gen::inRange(-2000, 2000)); };
  const Vec3 a{angle(), angle(), angle()};
  expect_same(from_angles(a), axis_angle({1, 0, 0}, a.x) * axis_angle({0, 1, 0}, a.y) * axis_angle({0, 0, 1}, a.z));
}

RC_GTEST_PROP(Matrices, InversesUndo, ()) {
  const auto factor = [] { return *rc::gen::element(-3.0, 0.01, 0.5, 1.0, 40.0); };
  const Vec3 s{factor(), factor(), factor()};
  const Mat4 m = translation({4, -5, 6}) * rotation(some_turn()) * scaling(s) * rotation(some_turn());
  EXPECT_NEAR(determinant(m), s.x * s.y * s.z, 1e-9 * std::abs(s.x * s.y * s.z));
  const auto back = inverse(m);
  RC_ASSERT(back.has_value());
  const Mat4 one = *back * m;
  for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(one.m[i], Mat4{}.m[i], 1e-9);
}

TEST(Matrices, WhatIsFlatHasNoInverse) {
  EXPECT_FALSE(inverse(scaling({1, 0, 1})));
  EXPECT_FALSE(inverse(scaling({0, 0, 0})));
  EXPECT_FALSE(inverse(scaling({1, NAN, 1})));
  EXPECT_TRUE(inverse(scaling({1e-9, 1e-9, 1e-9}))) << "small is not flat";
}

TEST(Numbers, AreFiniteOrNot) {
  EXPECT_TRUE(finite(Vec3{1, -1e300, 0}));
  for (const double bad : {double(INFINITY), -double(INFINITY), double(NAN)})
    for (int i = 0; i < 3; ++i) {
      Vec3 v{1, 2, 3};
      v[i] = bad;
      EXPECT_FALSE(finite(v));
      Mat4 m;
      m(3, i) = bad;
      EXPECT_FALSE(finite(m));
      EXPECT_FALSE(finite({&bad, 1}));
    }
  EXPECT_TRUE(finite(Mat4{}));
  EXPECT_TRUE(finite(std::span<const double>{}));
}

TEST(Boxes, HoldWhatIsAdded) {
  Box b;
  EXPECT_TRUE(b.empty());
  b.add(Box{});
  EXPECT_TRUE(b.empty());
  b.add(Vec3{5, 6, 7});
  EXPECT_EQ(b.low, b.high);
  b.add(Vec3{3, 8, 7});
  EXPECT_EQ(b.low, (Vec3{3, 6, 7}));
  EXPECT_EQ(b.high, (Vec3{5, 8, 7}));
  EXPECT_EQ(b.middle(), (Vec3{4, 7, 7}));
  EXPECT_EQ(b.half(), (Vec3{1, 1, 0}));
  Box all{{0, 0, 0}, {1, 1, 1}};
  all.add(b);
  EXPECT_EQ(all.low, (Vec3{0, 0, 0}));
  EXPECT_EQ(all.high, (Vec3{5, 8, 7}));
}

}  // namespace
}  // namespace betwixt
