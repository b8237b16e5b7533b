// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/twerpers.h"

#include <gtest/gtest.h>

#include <algorithm>
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

// Keys with a turn each from the one before, all through `smooth` or `squad`.
struct Turned {
  CurveSet set;
  Curve curve;
  std::vector<double> times;
  std::vector<Quat> keys;
  Turned(const std::vector<double>& gaps, const std::vector<Vec3>& turns, Twerper twerper) {
    Track t;
    times.push_back(0), keys.push_back(axis_angle({1, 2, 3}, 0.7));
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      times.push_back(times.back() + gaps[i]);
      keys.push_back(keys.back() * axis_angle(turns[i], length(turns[i])));
    }
    for (std::size_t i = 0; i < keys.size(); ++i) {
      Event e;
      e.time = from_seconds(times[i]), e.value = keys[i], e.twerper = twerper;
      t.events.put(std::move(e));
    }
    curve = set.add(t, Type::orientation);
  }
  Quat at(Time t) const {
    double n[4];
    set.evaluate(curve, t, n);
    return {n[0], n[1], n[2], n[3]};
  }
  // The turn between two times close by, as a vector.
  Vec3 turn(Time from, Time to) const {
    const Quat d = conjugate(at(from)) * at(to);
    const double sign = d.w < 0 ? -2 : 2;
    return {sign * d.x, sign * d.y, sign * d.z};
  }
  // The speed at a key from one of its sides, by a formula that is exact for parabolas.
  Vec3 speed(std::size_t key, int side) const {
    const Time t = from_seconds(times[key]), step{side * 2000};
    const double d = step.seconds();
    return 1 / (2 * d) * (4 * turn(t, t + step) - turn(t, {t.flicks + 2 * step.flicks}));
  }
};

struct RandomKeys {
  std::mt19937 random{41};
  double pick(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
  // Times that lie together and far apart.
  std::vector<double> gaps(std::size_t n) {
    std::vector<double> out;
    for (std::size_t i = 0; i < n; ++i) out.push_back(std::exp(pick(std::log(0.03), std::log(3.0))));
    return out;
  }
  // Small and large ones, also next to half a turn, and none.
  double angle() {
    const double kind = pick(0, 1);
    return kind < 0.1 ? 0 : kind < 0.2 ? 0.9999 * pi : kind < 0.6 ? pick(0, 0.1) : pick(0, 0.9999 * pi);
  }
};

// shows: G51
TEST(Twerpers, SquadHasNoCornerWhateverTheTimesOfItsKeys) {
  RandomKeys any;
  for (int round = 0; round < 200; ++round) {
    std::vector<Vec3> turns;
    const auto away = [&] { return any.pick(-1, 1); };
    for (int i = 0; i < 6; ++i) turns.push_back(any.angle() * normalize(Vec3{away(), away(), away()}, {1, 0, 0}));
    const Turned t(any.gaps(6), turns, round % 2 ? Twerper::squad : Twerper::smooth);
    for (std::size_t k = 1; k < 6; ++k) {
      const Vec3 before = t.speed(k, -1), after = t.speed(k, 1);
      EXPECT_LT(length(after - before), 1e-3 * (1 + length(before))) << round << " " << k;
    }
    for (std::size_t k = 0; k < 7; ++k) EXPECT_NEAR(std::abs(dot(t.at(from_seconds(t.times[k])), t.keys[k])), 1, 1e-12);
  }
}

// Keys about one axis that go one way are gone through that way, and so are those that wait.
TEST(Twerpers, SquadNeverTurnsBack) {
  RandomKeys any;
  const Vec3 axis = normalize(Vec3{1, -2, 0.5});
  for (int round = 0; round < 300; ++round) {
    std::vector<Vec3> turns;
    const std::size_t n = 1 + static_cast<std::size_t>(round % 6);
    const double way = round % 3 ? 1 : -1;
    for (std::size_t i = 0; i < n; ++i) turns.push_back(way * any.angle() * axis);
    const Turned t(round % 4 ? any.gaps(n) : std::vector<double>(n, 0.5), turns, Twerper::smooth);
    for (std::size_t k = 0; k < n; ++k) {
      double gone = 0, least = 0;
      const Time from = from_seconds(t.times[k]), to = from_seconds(t.times[k + 1]);
      const auto at = [&](int i) { return Time{from.flicks + (to - from).flicks * i / 200}; };
      for (int i = 0; i < 200; ++i) {
        const double step = way * dot(t.turn(at(i), at(i + 1)), axis);
        gone += step, least = std::min(least, step);
      }
      EXPECT_GT(least, -1e-9) << round << " " << k;
      EXPECT_NEAR(gone, length(turns[k]), 1e-3) << round << " " << k;
    }
  }
}

// At 0, 60, 120 degrees after 6 and 24 frames the parabola's slope at the middle is (10 * 24 + 2.5 * 6) / 30 degrees a
// frame; three times the slower one's 2.5 is less.
TEST(Twerpers, SquadIsAsFastAtAKeyAsItsNeighboursAllow) {
  const Vec3 turn = pi / 3 * Vec3{0, 1, 0};
  for (const int side : {-1, 1}) {
    EXPECT_NEAR(length(Turned({6, 24}, {turn, turn}, Twerper::squad).speed(1, side)) * 180 / pi, 7.5, 1e-5);
    EXPECT_NEAR(length(Turned({12, 24}, {turn, turn}, Twerper::squad).speed(1, side)) * 180 / pi,
                (5.0 * 24 + 2.5 * 12) / 36, 1e-5);
  }
}

// Half a turn from rest to rest, though there its control points are opposite.
TEST(Twerpers, SquadTurnsHalfATurnFromRestToRest) {
  const Turned t({1, 1, 1}, {{}, {0, 0, pi}, {}}, Twerper::squad);
  for (double s = 0; s <= 1; s += 0.05)
    EXPECT_NEAR(length(t.turn(from_seconds(1), from_seconds(1 + s))), 2 * std::sin(s * s * (3 - 2 * s) * pi / 2), 1e-9);
}

// Shoemake's formula, where keys lie evenly and no turn is five times the other.
TEST(Twerpers, SquadBetweenEvenTimesIsShoemakes) {
  RandomKeys any;
  const auto logarithm = [](Quat q) {
    const Vec3 v{q.x, q.y, q.z};
    return std::atan2(length(v), q.w) * normalize(v, {});
  };
  const auto power_of = [&](Quat q, double s) {
    const Vec3 v = s * logarithm(q);
    return axis_angle(normalize(v, {1, 0, 0}), 2 * length(v));
  };
  const auto between = [&](Quat a, Quat b, double s) { return a * power_of(conjugate(a) * b, s); };
  for (int round = 0; round < 50; ++round) {
    std::vector<Vec3> turns;
    for (int i = 0; i < 3; ++i)
      turns.push_back(any.pick(0.3, 1.2) * normalize(Vec3{any.pick(-1, 1), any.pick(-1, 1), any.pick(-1, 1)}));
    const Turned t({1, 1, 1}, turns, Twerper::squad);
    const auto control = [&](std::size_t k) {
      const Quat &q = t.keys[k], back = conjugate(q);
      const Vec3 both = -0.25 * (logarithm(back * t.keys[k + 1]) + logarithm(back * t.keys[k - 1]));
      return q * axis_angle(normalize(both, {1, 0, 0}), 2 * length(both));
    };
    for (double s = 0.05; s < 1; s += 0.1) {
      const Quat wanted =
          between(between(t.keys[1], t.keys[2], s), between(control(1), control(2), s), 2 * s * (1 - s));
      EXPECT_NEAR(std::abs(dot(t.at(from_seconds(1 + s)), wanted)), 1, 1e-12);
    }
  }
}

}  // namespace
}  // namespace betwixt
