// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/twerpers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <tuple>

#include "track/curve.h"

namespace betwixt {
namespace {

Event event(double seconds, Value v, Twerper twerper) {
  Event e;
  e.time = from_seconds(seconds);
  e.value = std::move(v);
  e.twerper = twerper;
  return e;
}

TEST(Twerpers, NamesAreNumbers) {
  const std::pair<Twerper, std::string_view> named[] = {
      {Twerper::unset, "unset"},   {Twerper::hold, "hold"},       {Twerper::linear, "linear"},
      {Twerper::smooth, "smooth"}, {Twerper::bspline, "bspline"}, {Twerper::hermite, "hermite"},
      {Twerper::bezier, "bezier"}, {Twerper::slerp, "slerp"},     {Twerper::squad, "squad"}};
  for (const auto& [t, name] : named) EXPECT_EQ(name_of(t), name);
  for (std::size_t i = 1; i < twerpers().size(); ++i) {
    EXPECT_EQ(find_twerper(twerpers()[i].name), static_cast<Twerper>(i));
    EXPECT_FALSE(twerpers()[i].sentence.empty()) << twerpers()[i].name;
    EXPECT_FALSE(twerpers()[i].example.empty()) << twerpers()[i].name;
  }
  EXPECT_EQ(find_twerper("unset"), std::nullopt);
  EXPECT_EQ(find_twerper("swing"), std::nullopt);
}

// Whatever the row: all but one go through their events, numbers and orientations alike.
TEST(Twerpers, GoThroughTheirEvents) {
  const Quat turns[] = {axis_angle({0, 1, 0}, 0.3), axis_angle({1, 1, 0}, 1.1), axis_angle({0, 1, 1}, 2.0)};
  const double numbers[] = {1, 5, -2};
  for (std::size_t i = 1; i < twerpers().size(); ++i) {
    const auto t = static_cast<Twerper>(i);
    if (t == Twerper::bspline) continue;  // comes near its events only
    Track track, turning;
    for (int k = 0; k < 3; ++k) {
      track.events.put(event(k * 1.5, numbers[k], t));
      turning.events.put(event(k * 1.5, turns[k], t));
    }
    CurveSet set;
    const Curve number = set.add(track, Type::scalar), turn = set.add(turning, Type::orientation);
    for (int k = 0; k < 3; ++k) {
      double n[4];
      set.evaluate(number, from_seconds(k * 1.5), n);
      EXPECT_NEAR(n[0], numbers[k], 1e-12) << name_of(t);
      set.evaluate(turn, from_seconds(k * 1.5), n);
      EXPECT_NEAR(std::abs(dot(Quat{n[0], n[1], n[2], n[3]}, turns[k])), 1, 1e-12) << name_of(t);
    }
  }
}

// Where a value from 0 to 1 is, by name.
double eased(std::string_view name, double u, std::array<double, 4> arguments = {0.25, 0.1, 0.25, 1}) {
  Track t;
  Event from = event(0, 0.0, *find_twerper(name));
  from.detail.edit().arguments = arguments;
  t.events.put(from), t.events.put(event(1, 1.0, Twerper::linear));
  CurveSet set;
  const Curve c = set.add(t, Type::scalar);
  double n[4];
  set.evaluate(c, from_seconds(u), n);
  return n[0];
}

// Penner's formulas as he wrote them (of t, b = 0, c = 1, d = 1), and CSS's curves by bisection.
TEST(Twerpers, FamiliesAreThoseThatEverybodyKnows) {
  const auto power = [](double p) { return [p](double t) { return std::pow(t, p); }; };
  const auto bounce_out = [](double t) {
    if (t < 1 / 2.75) return 7.5625 * t * t;
    if (t < 2 / 2.75) return 7.5625 * (t - 1.5 / 2.75) * (t - 1.5 / 2.75) + .75;
    if (t < 2.5 / 2.75) return 7.5625 * (t - 2.25 / 2.75) * (t - 2.25 / 2.75) + .9375;
    return 7.5625 * (t - 2.625 / 2.75) * (t - 2.625 / 2.75) + .984375;
  };
  struct Family {
    std::string name;
    std::function<double(double)> in, in_out;
  };
  const double s = 1.70158, s2 = s * 1.525;
  const std::vector<Family> families = {
      {"sine", [](double t) { return -std::cos(t * pi / 2) + 1; },
       [](double t) { return -(std::cos(pi * t) - 1) / 2; }},
      {"quad", power(2), {}},
      {"cubic", power(3), {}},
      {"quart", power(4), {}},
      {"quint", power(5), {}},
      {"expo", [](double t) { return t == 0 ? 0 : std::pow(2, 10 * (t - 1)); }, {}},
      {"circ", [](double t) { return -(std::sqrt(1 - t * t) - 1); }, {}},
      {"back", [=](double t) { return t * t * ((s + 1) * t - s); },
       [=](double t) {
         t *= 2;
         return t < 1 ? t * t * ((s2 + 1) * t - s2) / 2 : ((t - 2) * (t - 2) * ((s2 + 1) * (t - 2) + s2) + 2) / 2;
       }},
      {"elastic",
       [](double t) {
         return t == 0 || t == 1 ? t : -(std::pow(2, 10 * (t - 1)) * std::sin((t - 1 - .3 / 4) * 2 * pi / .3));
       },
       [](double t) {
         t *= 2;
         const double p = .3 * 1.5, w = std::sin((t - 1 - p / 4) * 2 * pi / p);
         return t == 0 || t == 2 ? t / 2
                : t < 1          ? -.5 * std::pow(2, 10 * (t - 1)) * w
                                 : std::pow(2, -10 * (t - 1)) * w * .5 + 1;
       }},
      {"bounce", [&](double t) { return 1 - bounce_out(1 - t); }, {}}};
  for (const Family& f : families)
    for (int k = 0; k <= 40; ++k) {
      const double u = k / 40.0;
      EXPECT_NEAR(eased(f.name + "-in", u), f.in(u), 1e-9) << f.name << u;
      EXPECT_NEAR(eased(f.name + "-out", u), 1 - f.in(1 - u), 1e-9) << f.name << u;
      const double both = f.in_out ? f.in_out(u) : u < 0.5 ? f.in(2 * u) / 2 : 1 - f.in(2 - 2 * u) / 2;
      // Elastic's two halves meet a thousandth apart, in Penner's formula too.
      EXPECT_NEAR(eased(f.name + "-in-out", u), both, f.name == "elastic" ? 1e-3 : 1e-9) << f.name << u;
    }
  const std::tuple<const char*, double, double, double, double> css[] = {{"ease", .25, .1, .25, 1},
                                                                         {"ease-in", .42, 0, 1, 1},
                                                                         {"ease-out", 0, 0, .58, 1},
                                                                         {"ease-in-out", .42, 0, .58, 1}};
  for (const auto& [name, x1, y1, x2, y2] : css)
    for (int k = 1; k < 20; ++k) {
      const double u = k / 20.0;
      double low = 0, high = 1;
      for (int i = 0; i < 60; ++i) {
        const double t = (low + high) / 2;
        (3 * (1 - t) * (1 - t) * t * x1 + 3 * (1 - t) * t * t * x2 + t * t * t < u ? low : high) = t;
      }
      EXPECT_NEAR(eased(name, u),
                  3 * (1 - low) * (1 - low) * low * y1 + 3 * (1 - low) * low * low * y2 + low * low * low, 1e-9)
          << name << u;
    }
}

TEST(Twerpers, StepsJumpAsInCss) {
  // At the fifths of four steps: end, start, none, both.
  const double want[4][4] = {
      {0, 0.25, 0.5, 0.75}, {0.25, 0.5, 0.75, 1}, {0, 1 / 3.0, 2 / 3.0, 1}, {0.2, 0.4, 0.6, 0.8}};
  for (std::size_t where = 0; where < 4; ++where)
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(eased("steps", (static_cast<double>(k) + 0.5) / 4, {4, static_cast<double>(where), 0, 0}),
                  want[where][k], 1e-12)
          << where << k;
}

// Random events: between two of them the value never leaves what lies between theirs, and has no corner.
TEST(Twerpers, AutoNeverOvershoots) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-5, 5), gap(0.05, 2);
  for (int round = 0; round < 50; ++round) {
    Track t;
    std::vector<double> times, values;
    double at = 0;
    for (int k = 0; k < 8; ++k, at += gap(random)) {
      times.push_back(at), values.push_back(k % 3 == 2 ? values.back() : any(random));
      t.events.put(event(at, values.back(), *find_twerper("auto")));
    }
    CurveSet set;
    const Curve c = set.add(t, Type::scalar);
    const auto value = [&](double s) {
      double n[4];
      set.evaluate(c, from_seconds(s), n);
      return n[0];
    };
    for (std::size_t k = 0; k + 1 < times.size(); ++k)
      for (int i = 0; i <= 50; ++i) {
        const double v = value(times[k] + (times[k + 1] - times[k]) * i / 50);
        EXPECT_LE(v, std::max(values[k], values[k + 1]) + 1e-9);
        EXPECT_GE(v, std::min(values[k], values[k + 1]) - 1e-9);
      }
    for (std::size_t k = 1; k + 1 < times.size(); ++k) {
      const double d = 1e-6, before = (value(times[k]) - value(times[k] - d)) / d,
                   after = (value(times[k] + d) - value(times[k])) / d;
      EXPECT_NEAR(before, after, 1e-2 * (1 + std::abs(before)));
    }
  }
}

// Back again: each twerper turned round is what it says.
TEST(Twerpers, ReversedTheyGoTheSameWayBack) {
  for (std::size_t i = 1; i < twerpers().size(); ++i) {
    const TwerperRow& row = twerpers()[i];
    if (!row.factor || row.cubics) continue;
    Twerper t = static_cast<Twerper>(i);
    TwerperArguments there{0.2, 0.7, 0.4, 1.1}, back = there;
    if (row.name == "steps") there = back = {4, 0, 0, 0};
    reverse(t, back);
    for (int k = 0; k < 40; ++k) {
      const double u = (k + 0.5) / 40.25;
      EXPECT_NEAR(row_of(t).factor(1 - u, back), 1 - row.factor(u, there), 1e-9) << row.name << u;
    }
  }
}

// What fits is what the row says: those with a stand-in for numbers turn orientations only.
TEST(Twerpers, FitWhatTheyBlend) {
  EXPECT_FALSE(fits(Twerper::slerp, Type::scalar));
  EXPECT_FALSE(fits(Twerper::squad, Type::vector));
  EXPECT_TRUE(fits(Twerper::squad, Type::rotation));
  EXPECT_TRUE(fits(Twerper::bezier, Type::scalar));
  EXPECT_FALSE(fits(Twerper::bezier, Type::text));
  EXPECT_TRUE(fits(Twerper::hold, Type::text));
}

// Orientations about one axis are numbers: squad through them goes as a smooth track does, whose speed has no jump. At
// 0, 60, 120 degrees after 6 and 24 frames the parabola's slope at the middle is (10 * 24 + 2.5 * 6) / 30 degrees.
TEST(Twerpers, SquadHasNoCornerBetweenUnevenTimes) {
  Track t;
  const auto put = [&](std::int64_t frame, double degrees) {
    Event e;
    e.time = {frame * 29'400'000};
    e.value = axis_angle({0, 1, 0}, degrees * pi / 180);
    e.twerper = Twerper::squad;
    t.events.put(std::move(e));
  };
  put(1, 0), put(7, 60), put(31, 120);
  CurveSet set;
  const Curve c = set.add(t, Type::orientation);
  const auto degrees = [&](double frame) {
    double n[4];
    set.evaluate(c, {std::llround(frame * 29'400'000)}, n);
    return 2 * std::atan2(n[2], n[0]) * 180 / pi;
  };
  const double before = (degrees(7) - degrees(6.999)) / 0.001, after = (degrees(7.001) - degrees(7)) / 0.001;
  EXPECT_NEAR(before, (10.0 * 24 + 2.5 * 6) / 30, 0.02);
  EXPECT_NEAR(after, before, 0.02);
}

}  // namespace
}  // namespace betwixt
