// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares integrals of curves with Simpson's rule on ever smaller intervals.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "support/events.h"
#include "track/curve.h"

namespace betwixt {
namespace {

using Values = std::function<double(double)>;

double simpson(const Values& f, double a, double b, double fa, double fm, double fb, double within, int depth) {
  const double m = (a + b) / 2, fl = f((a + m) / 2), fr = f((m + b) / 2);
  const double whole = (b - a) / 6 * (fa + 4 * fm + fb), halves = (b - a) / 12 * (fa + 4 * fl + 2 * fm + 4 * fr + fb);
  if (depth == 0 || std::abs(halves - whole) < 15 * within) return halves + (halves - whole) / 15;
  return simpson(f, a, m, fa, fl, fm, within / 2, depth - 1) + simpson(f, m, b, fm, fr, fb, within / 2, depth - 1);
}
// In so many parts that each has one jump at most.
double integral(const Values& f, double to) {
  constexpr int parts = 101;
  double sum = 0;
  for (int i = 0; i < parts; ++i) {
    const double a = to * i / parts, b = to * (i + 1) / parts;
    sum += simpson(f, a, b, f(a), f((a + b) / 2), f(b), 1e-12 * to / parts, 26);
  }
  return sum;
}

// A long segment, so that times can be as fine as they are wanted.
constexpr double seconds = 4e5;

struct Sum {
  CurveSet set;
  Curve curve;
  Sum(Event from, Event to, std::vector<std::shared_ptr<const Routine>> own = {}) {
    curve = set.add(track({std::move(from), std::move(to)}), Type::scalar);
    set.own = std::move(own);
  }
  double rate(double u) const {
    double n[4];
    set.evaluate(curve, from_seconds(u * seconds), n);
    return n[0];
  }
  // Of a segment that goes 5 up or down; where an ease ends at rest, what jumps at the end jumps 1e-8 before it.
  void expect(double u, const std::string& what) const {
    double n[4];
    set.integrate(curve, 0, u, n);
    EXPECT_NEAR(n[0] / seconds, integral([&](double x) { return rate(x); }, u), 5e-9) << what << " until " << u;
  }
};

struct Eased {
  double out, in;
};
constexpr Eased every_ease[] = {{0, 0}, {0.3, 0}, {0, 0.3}, {0.2, 0.5}, {0.9, 0.8}};

void expect_sums(Event from, Event to, const std::string& what) {
  for (const Eased& e : every_ease) {
    from.detail.edit().ease_out = from_seconds(e.out * seconds),
    to.detail.edit().ease_in = from_seconds(e.in * seconds);
    const Sum sum(from, to);
    for (const double u : {1.0, 0.61, 0.1}) sum.expect(u, fmt::format("{} {} {}", what, e.out, e.in));
  }
}

Event from_here(Twerper t, TwerperArguments a = {}) {
  Event e = event(0, 2.0, t);
  e.detail.edit().arguments = std::move(a);
  return e;
}

// shows: G49 G71 R-T5
TEST(Sums, AreThoseOfTheValuesWhateverTheTwerper) {
  for (std::size_t i = 1; i < twerpers().size(); ++i) {
    const TwerperRow& row = twerpers()[i];
    Event from = from_here(static_cast<Twerper>(i)), to = event(seconds, -3.0);
    if (row.steps) from.detail.edit().arguments = {7, 3, 0, 0};
    from.detail.edit().tangent_out = 5.0 / seconds, to.detail.edit().tangent_in = -8.0 / seconds;
    if (row.name == "fcurve") {
      from.detail.edit().handle_out = from_seconds(0.7 * seconds), from.detail.edit().tangent_out = 4.0;
      to.detail.edit().handle_in = from_seconds(seconds), to.detail.edit().tangent_in = -1.0;
    }
    expect_sums(from, to, std::string(row.name));
  }
}

TEST(Sums, AreThoseOfTheValuesWhateverTheBezier) {
  const auto curve = [](std::array<double, 4> xy, const char* what) {
    expect_sums(from_here(Twerper::bezier, xy), event(seconds, -3.0), what);
  };
  curve({0.42, 0, 1, 1}, "plain"), curve({0, 1, 0, 1}, "upright first"), curve({1, 0, 1, 0}, "upright last");
  curve({0, 1, 1, 0}, "upright twice"), curve({1, 0, 0, 1}, "upright half way"), curve({1, -2, 0, 3}, "and far off");
  std::mt19937 random(11);
  std::uniform_real_distribution<double> part(0, 1), far(-1, 2);
  for (int i = 0; i < 6; ++i) curve({part(random), far(random), part(random), far(random)}, "random");
}

TEST(Sums, KnowWhereStopsAndStepsAre) {
  TwerperArguments a;
  a.stops = std::make_shared<const Stops>(Stops{{-10, 0}, {25, 0.4}, {25, -0.2}, {31, 1.5}, {77, 1.5}, {100, 0.8}});
  expect_sums(from_here(Twerper::linear, a), event(seconds, -3.0), "stops");
  for (const double jumps : {0.0, 1.0, 2.0, 3.0})
    expect_sums(from_here(*find_twerper("steps"), {33, jumps, 0, 0}), event(seconds, -3.0), "steps");
  // As many as there may be: on the average half a step below the line.
  const Sum many(from_here(*find_twerper("steps"), {1e5, 0, 0, 0}), event(seconds, -3.0));
  double n[4];
  many.set.integrate(many.curve, 0, 1, n);
  EXPECT_NEAR(n[0] / seconds, 2 - 5.0 / 2 * (1 - 1e-5), 1e-9);
}

// The author's own may have corners and jumps of which nobody knows.
TEST(Sums, FindTheJumpsOfATwerperOfTheAuthors) {
  struct Jump : Routine {
    Result<double> blend(double u) const override { return u < 0.7 ? std::abs(u - 0.31) : std::sqrt(1 - u); }
  };
  Event to = event(seconds, -3.0);
  for (const double ease : {0.0, 0.4}) {
    to.detail.edit().ease_in = from_seconds(ease * seconds);
    const Sum sum(from_here(static_cast<Twerper>(first_own_twerper)), to, {std::make_shared<Jump>()});
    for (const double u : {0.2, 0.8, 1.0}) sum.expect(u, "own");
  }
}

// A linear bezier is linear, whose eased integral is known: it comes to rest in the last quarter.
TEST(Sums, OfABezierThatIsALineAreTheLines) {
  Event to = event(seconds, 1.0);
  to.detail.edit().ease_in = from_seconds(seconds / 4);
  Event from = from_here(Twerper::bezier, {0, 0, 1, 1});
  from.value = 0.0;
  const Sum sum(from, to);
  double n[4];
  sum.set.integrate(sum.curve, 0, 1, n);
  // v = 8/7: a triangle to 3/4, then 1 - v/2 (1-u)²/b
  const double v = 8.0 / 7;
  EXPECT_NEAR(n[0] / seconds, v * 9 / 32 + 0.25 - v * 0.25 * 0.25 / 6, 1e-12);
}

}  // namespace
}  // namespace betwixt
