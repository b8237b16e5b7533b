// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "algebra/counted.h"
#include "algebra/precise.h"
#include "algebra/stepper.h"
#include "betwixt/algebra.h"
#include "support/motions.h"

namespace betwixt {
namespace {

struct Cloud {
  std::vector<double> x, y;
};
Cloud cloud(int count, unsigned seed = 3) {
  std::mt19937 random(seed);
  Cloud c;
  for (int i = 0; i < count; ++i)
    for (auto* v : {&c.x, &c.y}) v->push_back(static_cast<double>(random() % 20'000) / 1000.0 - 10);
  return c;
}

// The largest distance from A_k of all frames looked at, in parts of how large numbers grow on the way.
double worst(const Motion& motion, std::int64_t steps, Method method, bool seeking = false, bool end_only = false) {
  const Cloud c = cloud(19);
  auto stepped = Steps<double>::make(motion, steps, method, c.x, c.y);
  EXPECT_TRUE(stepped) << to_string(motion) << ": " << (stepped ? "" : stepped.error().message);
  if (!stepped) return 1e9;
  double most = 0;
  std::mt19937 random(4);
  for (std::int64_t k = 0; k <= steps + steps / 3; ++k) {
    if (k > 0 && !seeking) stepped->step();
    if (seeking) stepped->seek(static_cast<std::int64_t>(random() % static_cast<unsigned>(2 * steps)));
    if (end_only ? k != steps : k > 2 && k != steps && random() % 8 != 0) continue;
    const std::int64_t now = stepped->frame();
    for (std::size_t i = 0; i < c.x.size(); i += 9) {
      const precise::Point p = precise::moved(motion, now, steps, {c.x[i], c.y[i], 0});
      most = std::max(most, std::hypot(stepped->x()[i] - p.at(0), stepped->y()[i] - p.at(1)) / p.largest);
    }
  }
  return most;
}

TEST(Steps, OfEveryMethodGoWhereTheMotionIs) {
  std::mt19937 random(11);
  double stepped = 0, sought = 0;
  for (int round = 0; round < 1000; ++round) {
    const Motion motion = random_motion(random, round % 8, false);
    const std::int64_t steps = 1 + round % 60;
    for (const Method method : {Method::matrix, Method::best}) {
      stepped = std::max(stepped, worst(motion, steps, method));
      sought = std::max(sought, worst(motion, steps, method, true));
    }
  }
  EXPECT_LE(stepped, 1e-9);
  EXPECT_LE(sought, 1e-11);
}

// Terms that differ in one number only, and those that cancel.
TEST(Steps, GoWhereTheMotionIsThoughFactorsFallTogether) {
  for (const char* text :
       {"S(1 2 @ 7 8) R(90deg @ 3 4)", "S(0.001 1 @ 1 7) R(90deg @ 2 0)", "S(3 1 @ -3 7) S(0.001 1 @ 1 100 linear)",
        "S(1 3 @ 100 7) S(0.5 1 @ 100 -3) R(35deg @ 1 2)",
        "R(180deg @ 2 7) S(0.5 @ 100 0) S(0.001 2 @ 0 0) S(3 1.5 @ 7 7)", "R(90deg @ 1 2) R(-90deg @ 3 4)",
        "S(2 @ 1 1) T(1 2) S(0.5 @ 5 5)", "R(1turn @ 1 0) T(0 1) R(-1turn @ 2 0) T(3 0)",
        "S(2 1 @ 1 1) S(0.5 1 @ 4 4) T(0 2)", "T(1 0) T(-1 0)", "R(1turn @ 5 5) R(-1turn @ 5 5) T(1 1)"})
    for (const Method method : {Method::matrix, Method::best})
      for (const std::int64_t steps : {1, 2, 7})
        EXPECT_LE(worst(parsed(text), steps, method), 1e-11) << text << " by " << name_of(method);
}

TEST(Steps, StayWhereTheyBelongThroughManyRenewals) {
  for (const char* text :
       {"R(40turn @ 1 2)", "R(40turn) T(5 1)", "S(4 0.3) R(31turn @ 1 0)", "R(10turn) R(30turn @ 1 0)",
        "R(31turn @ 1 0) S(2 @ 1 0)", "T(1 2) R(31turn) S(2 3)", "S(2 3 linear) R(3turn) T(1 1)"})
    for (const Method method : {Method::matrix, Method::best})
      EXPECT_LE(worst(parsed(text), 3000, method), 1e-9) << text;
}

TEST(Steps, OfTheSourceGoWhereTheMotionIs) {
  for (const char* text :
       {"T(6 1)", "S(3 0.5 @ 1 2 linear)", "R(250deg @ 1 2)", "T(6 1) S(3 0.5 @ 1 2 linear)", "T(6 1) R(250deg @ 1 2)",
        "R(250deg @ 1 2) T(6 1)", "R(250deg @ 1 2) S(3 0.5 @ -1 1 linear)",
        "T(6 1) R(250deg @ 1 2) S(3 0.5 @ -1 1 linear)", "R(1turn @ 0 0) R(12turn @ 3 0) R(-2turn @ 4 1)"}) {
    EXPECT_LE(worst(parsed(text), 50, Method::geometric), 1e-12) << text;
    EXPECT_LE(worst(parsed(text), 50, Method::geometric, true), 1e-12) << text;
  }
  for (const char* text : {"T(6 1)", "S(3 0.5 @ 1 2)", "R(250deg @ 1 2)", "", "R(2turn @ 1 1) S(2 @ 1 1)",
                           "T(0 3) S(2 1 @ 3 0)", "R(1turn @ 1 1) R(0.3turn @ 1 1)"})
    for (const bool seeking : {false, true})
      EXPECT_LE(worst(parsed(text), 50, Method::differences, seeking), 1e-12) << text;
}

// What the source excepts itself: turns that come out even at every step, and one step.
TEST(Steps, ByDifferencesWhereTurnsAreWholeOrThereIsOneStep) {
  for (const char* text :
       {"R(10turn) T(1 1)", "R(-20turn @ 3 4) S(2 3 @ 1 1)", "T(1 2) R(30turn @ 1 0) T(0 5) R(10turn)"})
    for (const bool seeking : {false, true})
      EXPECT_LE(worst(parsed(text), 10, Method::differences, seeking), 1e-12) << text;
  EXPECT_FALSE(Steps<double>::make(parsed("R(10turn) T(1 1)"), 20, Method::differences, {}, {}));
  // No other method does more than that.
  EXPECT_EQ(count_operations(parsed("R(10turn) T(1 1)"), 10, Method::best, 1000)->step, (Cost{2, 0}));
  for (const char* text :
       {"R(0.3turn) T(1 1)", "S(2 3) R(1rad @ 1 2)", "S(2 3 linear) T(1 0)", "R(180deg) S(2 3 @ 1 1)"}) {
    EXPECT_LE(worst(parsed(text), 1, Method::differences), 1e-13) << text;
    EXPECT_LE(worst(parsed(text), 1, Method::differences, true), 1e-13) << text;
    EXPECT_EQ(count_operations(parsed(text), 1, Method::differences, 1000)->step, (Cost{8, 0})) << text;
  }
}

// Two rows of the source's table meet the motion at its end, and leave it on the way.
TEST(Steps, OfTheSourceMayMeetTheEndOnly) {
  for (const char* text : {"S(3 0.5 @ 1 2 linear) T(6 1)", "S(3 0.5 @ 1 2 linear) R(250deg @ 1 2)"}) {
    EXPECT_LE(worst(parsed(text), 50, Method::geometric, false, true), 1e-12) << text;
    const Motion m = parsed(text);
    const Cloud c = cloud(1);
    auto steps = Steps<double>::make(m, 50, Method::geometric, c.x, c.y);
    ASSERT_TRUE(steps);
    steps->seek(25);
    const Vec3 p = transform_point(at(m, 0.5), {c.x[0], c.y[0], 0});
    EXPECT_GT(std::hypot(steps->x()[0] - p.x, steps->y()[0] - p.y), 0.5) << text;
    // The scheme itself, one step beyond the end and back by the closed form of its own states.
    if (!std::string_view(text).ends_with("T(6 1)")) continue;
    auto own = Steps<double>::make(m, 50, Method::geometric, c.x, c.y);
    double x[2], y[2];
    for (int side : {0, 1}) {
      own->seek(side == 0 ? 49 : 51);
      x[side] = own->x()[0], y[side] = own->y()[0];
    }
    const Vec3 end = transform_point(at(m, 1), {c.x[0], c.y[0], 0});  // equal differences: the middle of the two
    EXPECT_NEAR((x[0] + x[1]) / 2, end.x, 1e-11) << text;
    EXPECT_NEAR((y[0] + y[1]) / 2, end.y, 1e-11) << text;
  }
}

TEST(Steps, BeginAndEndToTheLastBit) {
  std::mt19937 random(12);
  for (int round = 0; round < 200; ++round) {
    const Motion motion = random_motion(random, round % 6, false);
    const Cloud c = cloud(5);
    auto steps = Steps<double>::make(motion, 7, Method::best, c.x, c.y);
    ASSERT_TRUE(steps);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(steps->x()[i], c.x[i]);
    for (int k = 0; k < 7; ++k) steps->step();
    const Mat4 whole = at(motion, 1);
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_EQ(steps->x()[i], whole(0, 0) * c.x[i] + whole(0, 1) * c.y[i] + whole(0, 3));
      EXPECT_EQ(steps->y()[i], whole(1, 0) * c.x[i] + whole(1, 1) * c.y[i] + whole(1, 3));
    }
  }
}

// Many points go by vectors and threads, one point goes alone: the same bits.
TEST(Steps, AreTheSameForManyPointsAndForOne) {
  constexpr int count = 1'200'003;
  const Cloud c = cloud(count);
  for (const char* text :
       {"T(1 2)", "S(2 3 @ 1 1)", "S(2 3 @ 1 1 linear)", "R(1turn @ 1 1)", "R(1turn @ 1 1) S(2 @ 1 1)",
        "S(2 3) R(1turn @ 1 1)", "R(1turn) S(2 3 @ 1 1)", "T(1 1) S(2 3 linear) T(2 1)"}) {
    auto many = Steps<double>::make(parsed(text), 10, Method::best, c.x, c.y);
    ASSERT_TRUE(many);
    for (int k = 0; k < 3; ++k) many->step();
    for (const std::size_t i : {std::size_t{0}, std::size_t{599'999}, std::size_t{600'007}, std::size_t{count - 1}}) {
      auto one = Steps<double>::make(parsed(text), 10, Method::best, std::span(&c.x[i], 1), std::span(&c.y[i], 1));
      for (int k = 0; k < 3; ++k) one->step();
      // A plan for one point may be another one.
      EXPECT_NEAR(one->x()[0], many->x()[i], 1e-12) << text;
      EXPECT_NEAR(one->y()[0], many->y()[i], 1e-12) << text;
    }
  }
}

// Table 1 of the source, the columns "matrix reachable" and "best exact": figures worked out by hand.
TEST(Counts, ReachWhatCanBeReached) {
  struct Row {
    const char* text;
    const char *matrix, *best;
  };
  const Row rows[] = {
      {"T(5 3)", "2Np + 2", "2Np"},
      {"S(2 3 @ 1 4)", "4Np + 2", "4Np"},
      {"R(1rad @ 1 4)", "8Np + 4", "6Np"},
      {"T(5 3) S(2 3 @ 1 4)", "4Np + 4", "4Np + 2"},
      {"S(2 3 @ 1 4) T(5 3)", "4Np + 8", "4Np + 7"},
      {"T(5 3) R(1rad @ 1 4)", "8Np + 6", "6Np + 2"},
      {"R(1rad @ 1 4) T(5 3)", "8Np + 13", "6Np + 9"},
      {"R(1rad @ 1 4) S(2 3 @ 5 2)", "8Np + 16", "8Np + 16"},
      {"S(2 3 @ 5 2) R(1rad @ 1 4)", "8Np + 14", "8Np + 4"},
      {"T(5 3) R(1rad @ 1 4) S(2 3 @ 5 2)", "8Np + 18", "8Np + 18"},
      {"R(1rad @ 1 4) R(2rad @ 5 2)", "8Np + 10", "6Np + 6"},
      {"R(1rad @ 1 4) R(2rad @ 5 2) R(0.3rad @ 2 2)", "8Np + 16", "6Np + 12"},
  };
  for (const Row& row : rows) {
    const auto matrix = count_operations(parsed(row.text), 50, Method::matrix, 1000);
    const auto best = count_operations(parsed(row.text), 50, Method::best, 1000);
    ASSERT_TRUE(matrix && best);
    EXPECT_EQ(to_string(matrix->step), row.matrix) << row.text;
    EXPECT_EQ(to_string(best->step), row.best) << row.text;
  }
  Motion chain;
  for (int n = 0; n < 16; ++n) chain.factors.push_back(rotate_by(1 + n, {n * n + 1.0, n + 0.5, 0}));
  EXPECT_EQ(count_operations(chain, 50, Method::best, 1000)->step, (Cost{6, 90}));
}

// What the source prints for its geometric method, but for R…R, whose arms are added up one by one.
TEST(Counts, OfTheGeometricMethodAreThoseOfTheSource) {
  for (const char* text :
       {"T(5 3)", "S(2 3 @ 1 4 linear)", "R(1rad @ 1 4)", "T(5 3) S(2 3 @ 1 4 linear)", "S(2 3 @ 1 4 linear) T(5 3)",
        "T(5 3) R(1rad @ 1 4)", "R(1rad @ 1 4) T(5 3)", "R(1rad @ 1 4) S(2 3 @ 5 2 linear)",
        "S(2 3 @ 5 2 linear) R(1rad @ 1 4)", "T(5 3) R(1rad @ 1 4) S(2 3 @ 5 2 linear)"}) {
    const auto counted = count_operations(parsed(text), 50, Method::geometric, 1000);
    ASSERT_TRUE(counted) << text;
    EXPECT_EQ(counted->step, printed_costs(parsed(text))->geometric) << text;
  }
  const Motion chain = parsed("R(1rad @ 1 4) R(2rad @ 5 2) R(0.3rad @ 2 2)");
  EXPECT_EQ(to_string(count_operations(chain, 50, Method::geometric, 1000)->step), "8Np + 16");
  EXPECT_EQ(to_string(printed_costs(chain)->geometric), "8Np + 20");
}

// What is counted is what the plan says: no operation is done that is not of the scheme.
TEST(Counts, AreThoseOfThePlan) {
  std::mt19937 random(13);
  for (int round = 0; round < 300; ++round) {
    const Motion motion = random_motion(random, round % 9, false);
    for (const auto family : {algebra::Family::matrix, algebra::Family::any}) {
      const std::size_t points = round % 3 == 0 ? 1 : 100;
      const auto plan = algebra::compile<double>(motion, 50, family, points);
      const auto counted =
          count_operations(motion, 50, family == algebra::Family::any ? Method::best : Method::matrix, points);
      ASSERT_TRUE(counted);
      EXPECT_EQ(counted->step, (Cost{plan.per_point(), plan.per_step(), 0})) << to_string(motion);
    }
  }
}

// No plan of the compiler costs more than the one that multiplies everything out.
TEST(Counts, OfTheBestAreNeverAboveTheMatrix) {
  std::mt19937 random(14);
  for (int round = 0; round < 120; ++round) {
    const Motion motion = random_motion(random, round % 12, false);
    for (const std::size_t points : {std::size_t{1}, std::size_t{10}, std::size_t{100'000}}) {
      const auto cost = [&](Method m) {
        const Cost c = count_operations(motion, 50, m, points)->step;
        return c.per_point * static_cast<long long>(points) + c.besides;
      };
      EXPECT_LE(cost(Method::best), cost(Method::matrix)) << to_string(motion);
    }
  }
}

TEST(Steps, SayWhatCannotBe) {
  const std::vector<double> x{1}, y{2};
  const auto said = [&](const char* text, Method m, std::int64_t steps = 10) {
    const auto made = Steps<double>::make(parsed(text), steps, m, x, y);
    return made ? std::string("fine") : made.error().message + " | " + made.error().hint;
  };
  struct Case {
    const char* text;
    Method method;
    const char* words;
    std::int64_t steps = 10;
  };
  const std::pair<const char*, const char*> no_one_matrix[] = {
      {"R(1turn) T(1 1)",
       "a translation and a rotation do not commute, so the root of the whole is an arc instead of this path"},
      {"S(2 2) T(1 1)", "a translation and a scaling do not commute, so the root of the whole takes another path"},
      {"S(2 3) R(1turn)", "its factors do not commute, so the root of the whole takes another path"},
      {"S(2 3 linear)", "the steps of a scaling by the linear law differ"}};
  for (const auto& [text, why] : no_one_matrix)
    EXPECT_EQ(said(text, Method::differences), std::string("no single matrix makes all steps of this motion: ") + why +
                                                   " | the method `best` supports every string")
        << text;
  const Case table[] = {
      {"S(2 3)", Method::geometric,
       "the geometric method needs the linear law for scalings | write S(… linear), or use the method `matrix`"},
      {"T(1 1) T(1 1)", Method::geometric,
       "the geometric method does not support TT | it supports T, S, R, TS, ST, TR, RT, RS, SR, TRS and R…R; `best` "
       "supports every string"},
      {"R(5turn)", Method::geometric, "shears cannot make half a turn in one step | use more steps"},
      {"T(1 1 1)", Method::best, "this motion leaves the plane | steps work only in the plane"},
      {"T(1 1)", Method::best,
       "the number of steps must be at least 1, not 0 | frame 0 is the start and frame 1 the end", 0}};
  for (const Case& c : table) EXPECT_EQ(said(c.text, c.method, c.steps), c.words) << c.text;
}

}  // namespace
}  // namespace betwixt
