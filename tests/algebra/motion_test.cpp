// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "algebra/precise.h"
#include "algebra/vectors.h"
#include "betwixt/algebra.h"
#include "support/motions.h"
#include "support/told.h"

namespace betwixt {
namespace {

TEST(Motion, IsAtThePlacesOfTheVectors) {
  ASSERT_EQ(vectors().size(), 12u);
  for (const Vector& v : vectors())
    for (const Vector::Frame& f : v.frames) {
      const auto m = frame(v.motion, f.k, v.steps);
      ASSERT_TRUE(m);
      const Mat4 sought = at(v.motion, static_cast<double>(f.k) / static_cast<double>(v.steps));
      for (std::size_t i = 0; i < v.points.size(); ++i) {
        EXPECT_LE(length(transform_point(*m, v.points[i]) - f.expected[i]), 1e-9) << v.name << " at " << f.k;
        EXPECT_LE(length(transform_point(sought, v.points[i]) - f.expected[i]), 1e-9) << v.name << " at " << f.k;
      }
    }
}

// Against quadruple precision with its own sines, in the plane and in space.
TEST(Motion, IsWhereManyDigitsPutIt) {
  std::mt19937 random(5);
  double worst = 0;
  for (int round = 0; round < 1000; ++round) {
    const Motion motion = random_motion(random, 1 + round % 9, round % 2 == 1);
    const std::int64_t steps = 1 + static_cast<std::int64_t>(random() % 1000);
    for (const std::int64_t k : {std::int64_t{0}, steps / 3, steps, 2 * steps + 1, -steps}) {
      const auto m = frame(motion, k, steps);
      ASSERT_TRUE(m);
      for (const Vec3 p : {Vec3{1, 0, 0}, Vec3{-0.5, 2, 1}, Vec3{3.25, -1.75, -2}}) {
        const precise::Point q = precise::moved(motion, k, steps, p);
        const double size = 1 + std::abs(q.at(0)) + std::abs(q.at(1)) + std::abs(q.at(2));
        const Vec3 r = transform_point(*m, p);
        for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(r[c] - q.at(c)) / (size * q.largest));
      }
    }
  }
  EXPECT_LE(worst, 1e-12);
}

TEST(Motion, OfManyTurnsIsAsExactAsOfOne) {
  Motion wheel;
  wheel.factors = {rotate_by(2 * pi * 1e9 * 0.75)};
  const auto quarter = frame(wheel, 333'333'333, 1'000'000'000);  // 249'999'999.75 turns
  ASSERT_TRUE(quarter);
  EXPECT_EQ((*quarter)(0, 0), 0);
  EXPECT_EQ((*quarter)(1, 0), -1);
  for (const char* text : {"R(1000000000turn)", "R(1000turn)", "R(3turn)", "R(360000000000deg)", "R(720deg)"})
    EXPECT_EQ(at(parsed(text), 1), Mat4()) << text;
  EXPECT_EQ(at(parsed("R(90deg)"), 1)(0, 0), 0);
  EXPECT_EQ(at(parsed("R(1e9turn)"), 0.25)(1, 0), 0);
}

// However many turns stand before it, a written fraction of a turn is that fraction.
TEST(Motion, OfManyTurnsKeepsTheirFraction) {
  struct Ended {
    const char* text;
    std::int64_t k, steps;
    double turns;  // of the last turn, worked out by hand
  };
  for (const Ended& e :
       {Ended{"R(123456789.12345turn)", 1, 1, 0.12345}, Ended{"R(123456789.12345turn)", 1, 2, 0.561725},
        Ended{"R(123456789.12345turn)", 2, 3, 0.0823}, Ended{"R(-123456789.12345turn)", 1, 1, -0.12345},
        Ended{"R(44444444404.442deg)", 1, 1, 4.442 / 360}, Ended{"R(1e15turn)", 1, 1, 0},
        Ended{"R(1e15turn)", 1, 3, 1.0 / 3}, Ended{"R(1000000000000000.125turn)", 1, 1, 0.125},
        Ended{"R(1.2345678912345e8turn)", 1, 1, 0.12345}, Ended{"R(0.7000000001turn)", 1, 1, 0.7000000001}}) {
    const double cosine = std::cos(2 * pi * e.turns), sine = std::sin(2 * pi * e.turns);
    const auto m = frame(parsed(e.text), e.k, e.steps);
    EXPECT_NEAR((*m)(0, 0), cosine, 1e-15) << e.text << " at " << e.k;
    EXPECT_NEAR((*m)(1, 0), sine, 1e-15) << e.text << " at " << e.k;
    if (e.steps == 3) continue;  // no third is a double
    const Mat4 sought = at(parsed(e.text), static_cast<double>(e.k) / static_cast<double>(e.steps));
    EXPECT_NEAR(sought(0, 0), cosine, 1e-15) << e.text;
    EXPECT_NEAR(sought(1, 0), sine, 1e-15) << e.text;
  }
  for (const char* text : {"R(123456789.123turn)", "R(-44444444404.442deg)", "R(1000000000000000.0003turn)"}) {
    EXPECT_EQ(to_string(parsed(text)), text);
    EXPECT_EQ(*inverse(*inverse(parsed(text))), parsed(text));
  }
  std::mt19937 random(21);
  for (int round = 0; round < 2000; ++round) {
    std::string text = "R(" + std::to_string(random() % 1000) + std::to_string(random()) + "." +
                       std::to_string(random()) + "e" + std::to_string(static_cast<int>(random() % 5) - 3);
    text += std::array{"turn)", "deg)", "rad)"}[random() % 3];
    EXPECT_EQ(parsed(to_string(parsed(text))), parsed(text)) << text << " as " << to_string(parsed(text));
  }
  const auto error = parse_motion("T(1 0) R(1e16turn)");
  ASSERT_FALSE(error);
  EXPECT_EQ(error.error().message, "'1e16turn' has more than 9007199254740992 turns");
  EXPECT_EQ(error.error().place.column, 10);
  EXPECT_FALSE(check({{rotate_by(1e17)}}));
}

// Every method too.
TEST(Motion, OfManyTurnsGoesFromStepToStepAsExactly) {
  const double x = 1, y = 0;
  for (const Method m : {Method::matrix, Method::geometric, Method::differences, Method::best}) {
    auto steps = Steps<double>::make(parsed("R(123456789.12345turn)"), 7, m, {&x, 1}, {&y, 1});
    ASSERT_TRUE(steps);
    for (int k = 1; k <= 5; ++k) {
      steps->step();
      const double turns = std::fmod(k * 123456789.0, 7) / 7 + k * 0.12345 / 7;
      EXPECT_NEAR(steps->x()[0], std::cos(2 * pi * turns), 1e-13) << name_of(m) << " at " << k;
      EXPECT_NEAR(steps->y()[0], std::sin(2 * pi * turns), 1e-13) << name_of(m) << " at " << k;
    }
  }
}

// About a centre far away what moves little still moves.
TEST(Motion, AboutAFarCentreLosesNothing) {
  const auto off = [](const char* text, double t) {
    const Vec3 p = translation_of(at(parsed(text), t));
    const auto q = precise::moved(parsed(text), static_cast<long long>(t * 4), 4, {0, 0, 0});
    double most = 0;
    for (int c = 0; c < 3; ++c)
      if (q.at(c) != 0) most = std::max(most, std::abs(p[c] / q.at(c) - 1));
    return most;
  };
  for (const char* text : {"R(1e-6deg @ 1e9 0)", "R(-3e-7rad @ 1e7 -2e8 3 axis 1 2 3)", "S(1.0000000001 @ 1e8 -1e9)",
                           "S(0.999999999 1.000000000001 @ 1e8 1e8 linear)"})
    for (const double t : {0.25, 0.5, 1.0}) EXPECT_LE(off(text, t), 1e-13) << text << " at " << t;
}

TEST(Motion, BeyondAllNumbersIsEndlessAndNeverNoNumber) {
  for (const char* text :
       {"S(1e300) T(1e300 0)", "S(1e300 @ 0 1) T(-1e300 1e300) S(1e-300)", "T(1e300 0) R(90deg) S(1e200)",
        "S(1e-300 @ 1e300 0) S(1e300)", "R(1rad @ 1e308 1e308) S(1e308 linear)"})
    for (const double t : {-3.0, -1.0, 0.5, 2.0, 1e300})
      for (const double x : at(parsed(text), t).m) EXPECT_FALSE(std::isnan(x)) << text << " at " << t;
}

TEST(Motion, BeginsAtRestAndEndsWithItsTotals) {
  const Motion m = parsed("T(10 -4) R(2.5turn @ 1 2) S(3 0.5 @ 1 2)");
  EXPECT_EQ(at(m, 0), Mat4());
  const Vec3 end = transform_point(at(m, 1), {2, 4, 0});  // scaled to (4, 3), turned about (1, 2) by half a turn, moved
  EXPECT_NEAR(end.x, -2 + 10, 1e-14);
  EXPECT_NEAR(end.y, 1 - 4, 1e-14);
  EXPECT_EQ(at(parsed("S(0.3 7)"), 1)(0, 0), 0.3);
}

TEST(Motion, ThatIsEmptyMovesNothing) {
  const Motion none = parsed("");
  for (const double t : {-3.0, 0.0, 0.5, 1.0, 1e9}) EXPECT_EQ(at(none, t), Mat4());
}

TEST(Motion, HasAnInverseThatUndoesEveryFrame) {
  std::mt19937 random(6);
  for (int round = 0; round < 200; ++round) {
    Motion motion = random_motion(random, 6, round % 2 == 1);
    for (Factor& f : motion.factors) f.law = Factor::Law::exponential;
    if (!check(motion)) continue;
    const auto back = inverse(motion);
    ASSERT_TRUE(back);
    for (const double t : {0.0, 0.3, 1.0, -0.7}) {
      const Mat4 both = at(*back, t) * at(motion, t);
      for (int i = 0; i < 16; ++i)
        EXPECT_NEAR(both.m[static_cast<std::size_t>(i)], i % 5 == 0 ? 1 : 0, 1e-8) << to_string(motion);
    }
  }
}

TEST(Motion, SaysWhatCannotBe) {
  const auto error = [](const Motion& m) {
    const auto status = check(m);
    return status ? std::string("fine") : status.error().message;
  };
  Motion m;
  m.factors = {translate_by({1, 2, 0}), scale_by({2, -1, 1})};
  EXPECT_EQ(error(m), "factor 2, S: a scaling by -1 along y has no in-between values");
  m.factors[1].law = Factor::Law::linear;
  EXPECT_EQ(error(m), "fine");
  m.factors[0].by.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error(m), "factor 1, T: its translation along y is not finite");
  m.factors[0] = rotate_by(std::numeric_limits<double>::infinity());
  EXPECT_EQ(error(m), "factor 1, R: its angle is not finite");
  m.factors[0] = rotate_by(1, {0, 0, 0}, {0, 0, 0});
  EXPECT_EQ(error(m), "factor 1, R: its axis has no direction");
  m.factors[0] = rotate_by(1, {0, std::numeric_limits<double>::infinity(), 0});
  EXPECT_EQ(error(m), "factor 1, R: its centre's y is not finite");
  EXPECT_EQ(frame(m, 0, 0).error().message, "the number of steps must be at least 1, not 0");
  EXPECT_EQ(told(frame(m, 0, -3)), "range");
  EXPECT_TRUE(mentions(frame(m, 0, -3), "-3"));
  EXPECT_EQ(inverse(parsed("T(1 1) S(2 2 linear)")).error().message,
            "factor 2, S: the inverse of a scaling by the linear law is not a motion");
}

TEST(Motion, IsReadAndWritten) {
  const Motion m = parsed("T(6.28 0) R(-1turn @ 0 1)S(2 0.5 @ 1 2 linear) * R(90deg @ (1 2 3) axis 0 1 0), S(3 @ sun)");
  ASSERT_EQ(m.factors.size(), 5u);
  EXPECT_EQ(m.factors[0], translate_by({6.28, 0, 0}));
  EXPECT_EQ(m.factors[1], rotate_by(-2 * pi, {0, 1, 0}));
  EXPECT_EQ(m.factors[2], scale_by({2, 0.5, 1}, {1, 2, 0}, Factor::Law::linear));
  EXPECT_EQ(m.factors[3], rotate_by(pi / 2, {1, 2, 3}, {0, 1, 0}));
  EXPECT_EQ(m.factors[4].about, "sun");
  EXPECT_EQ(m.factors[4].by, (Vec3{3, 3, 3}));
  EXPECT_EQ(to_string(m), "T(6.28 0) R(-1turn @ 0 1) S(2 0.5 @ 1 2 linear) R(90deg @ 1 2 3 axis 0 1 0) S(3 @ sun)");
  EXPECT_EQ(parsed("T(35mm 2cm 1m)").factors[0].by, (Vec3{0.035, 0.02, 1}));
  EXPECT_EQ(parsed("R(35°)").factors[0].angle, 35 * pi / 180);
  EXPECT_EQ(to_string(parsed("R(35deg)")), "R(35deg)");
  EXPECT_EQ(parsed("R(1rad axis y)").factors[0].axis, (Vec3{0, 1, 0}));
}

TEST(Motion, ReadsBackWhatItWrites) {
  std::mt19937 random(7);
  for (int round = 0; round < 2000; ++round) {
    const Motion motion = random_motion(random, round % 8, round % 2 == 1);
    EXPECT_EQ(parsed(to_string(motion)), motion) << to_string(motion);
  }
}

TEST(Motion, SaysWhereItsTextIsWrong) {
  const auto said = [](std::string_view text) {
    const auto motion = parse_motion(text);
    if (motion) return std::string("fine");
    const Error& e = motion.error();
    return std::to_string(e.place.column) + "+" + std::to_string(e.place.length) + " " + e.message +
           (e.hint.empty() ? "" : " | " + e.hint);
  };
  const std::pair<const char*, const char*> table[] = {
      {"T(1 0) Q(1)", "8+1 expected a string of T(…), R(…) and S(…) here | as in T(6.28 0) R(-1turn @ 0 1)"},
      {"r(90deg)", "1+1 'r' is not a factor of a motion | did you mean 'R'?"},
      {"T 1 0", "3+1 '(' is missing after T"},
      {"T(1)", "1+4 a translation must have two or three numbers | T(6 0) or T(6 0 0)"},
      {"T(1 0", "6+1 ')' is missing"},
      {"T(1 0 0 0)", "9+1 expected at most three numbers here"},
      {"R(90)", "3+2 an angle needs its unit: 90 | units are deg, °, turn, rad"},
      {"R(90grad)", "5+4 'grad' is not a unit of angle | units are deg, °, turn, rad"},
      {"R()", "3+1 expected a number here"},
      {"R(90deg @ 1)", "11+1 a centre must have two or three numbers"},
      {"R(90deg @ )", "11+1 expected a centre here | write @ 0 1, @ 0 1 2 or the name of an object"},
      {"R(90deg about z)", "9+5 'about' is not expected in a rotation | R(90deg @ 0 1) or R(90deg @ 0 1 0 axis 0 1 0)"},
      {"R(90deg axis 0 0 0)", "9+10 this axis has no direction"},
      {"S(2 -1)",
       "1+7 a scaling by -1 has no in-between values | use factors greater than 0, or the linear law: S(… linear)"},
      {"S(2 -1 linear)", "fine"},
      {"S()", "1+3 a scaling must have one, two or three numbers | S(2), S(2 1) or S(2 1 1)"},
      {"S(2 2 lin)", "7+3 'lin' is not expected in a scaling | S(2 2 @ 0 0 linear)"},
      {"T(1e999 0)", "3+5 '1e999' is not a finite number"},
      {"T(inf 0)", "3+3 'inf' is not a finite number"},
      {"T(0 nan)", "5+3 'nan' is not a finite number"},
      {"S(2cm)", "3+3 expected a plain number here, not 2cm"},
      {"S(50%)", "3+3 expected a plain number here, not 50%"},
      {"R(90 deg)", "3+2 an angle needs its unit: 90 | write the unit without a space: 90deg"},
      {"T(1 0 @ 0 0)", "7+1 '@' is not expected in a translation | T(6 0) or T(6 0 0)"},
      {"T(1 0 linear)", "7+6 'linear' is not expected in a translation | T(6 0) or T(6 0 0)"},
      {"R(90deg axis x @ 0 0)",
       "16+1 '@' is not expected in a rotation | R(90deg @ 0 1) or R(90deg @ 0 1 0 axis 0 1 0)"},
      {"S(2 2 linear linear)", "14+6 'linear' is not expected in a scaling | S(2 2 @ 0 0) or S(2 2 @ 0 0 linear)"},
      {"R(0) R(0 @ 1 1) R(1rad axis (0 1 0))", "fine"},
      {"R(35° @ ä)", "9+1 expected a centre here | write @ 0 1, @ 0 1 2 or the name of an object"}};
  for (const auto& [text, words] : table) EXPECT_EQ(said(text), words) << text;
}

}  // namespace
}  // namespace betwixt
