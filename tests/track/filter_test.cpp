// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <random>

#include "track/track.h"

namespace betwixt {
namespace {

struct Film : Input {
  std::function<Value(double)> f;
  explicit Film(std::function<Value(double)> of) : f(std::move(of)) {}
  Value at(double seconds) override { return f(seconds); }
  Rate rate() const override { return {}; }
};
Filter filter(std::string name, Parameters parameters = {}) {
  Filter f;
  f.name = std::move(name), f.parameters = std::move(parameters);
  return f;
}
template <class T = double>
T filtered(const Filter& f, std::function<Value(double)> of, double seconds) {
  Film film(std::move(of));
  return std::get<T>(*apply(f, film, seconds));
}
double angle_between(Quat a, Quat b) { return 2 * std::acos(std::min(1.0, std::abs(dot(a, b)))); }
Value jump(double t) { return t < 1 ? 0.0 : 1.0; }

struct Doubler : Routine {
  Result<Value> filter(Input& input, double seconds, const Parameters& p) const override {
    if (p.empty()) return fail(ErrorCode::type, "it wants to know how much");
    return Value(std::get<double>(p[0].second) * std::get<double>(input.at(seconds)));
  }
};

// shows: G105 G46
TEST(Filter, SmoothLeavesConstantsAndLines) {
  const Filter f = filter("smooth", {{"width", 0.7}});
  for (const double t : {-3.21, 0.0, 0.1, 1.0, 2.71828, 100.003}) {
    EXPECT_EQ(filtered(
                  f, [](double) { return 0.1; }, t),
              0.1);
    EXPECT_NEAR(filtered(
                    f, [](double s) { return 3 - 2 * s; }, t),
                3 - 2 * t, 1e-12 * (1 + std::abs(t)));
  }
}

// shows: G105
TEST(Filter, SmoothWeakensASineAsItsKernelSays) {
  // The kernel as the density of the sum of four evenly spread numbers, integrated by brute force.
  const double width = 0.5;
  for (const double frequency : {0.5, 1.0, 3.0, 5.0}) {
    const double w = 2 * pi * frequency;
    double transform = 0;
    const int n = 20000;
    for (int k = 0; k < n; ++k) {
      const double x = 4 * (k + 0.5) / n;
      double density = 0, binomial = 1;
      for (int j = 0; j < 4 && j < x; binomial *= -(4.0 - j) / (j + 1), ++j)
        density += binomial * std::pow(x - j, 3) / 6;
      transform += 4.0 / n * density * std::cos(w * width / 4 * (x - 2));
    }
    for (const double t : {0.0, 0.123, 0.77, 1.4142})
      EXPECT_NEAR(filtered(
                      filter("smooth"), [w](double s) { return std::sin(w * s); }, t),
                  transform * std::sin(w * t), 2e-4)
          << frequency;
  }
}

// shows: G105 G46
TEST(Filter, SmoothMakesAJumpTwiceDifferentiableAndSpringOnce) {
  const double h = 1e-4;
  double highest = 0, kink = 0;
  for (double t = 0.7; t < 1.6; t += h) {
    const auto at = [&](double s) { return filtered(filter("smooth"), jump, s); };
    // The difference of neighbouring second derivatives is of the order of h, not of 1.
    const double third = at(t + 2 * h) - 3 * at(t + h) + 3 * at(t) - at(t - h);
    highest = std::max(highest, std::abs(third) / (h * h));
  }
  EXPECT_LT(highest, 2.0);
  // A weight on a spring is pulled at once, by (2 pi 2)² here; its speed has no jump.
  for (double t = 0.98; t < 1.04; t += h) {
    const auto at = [&](double s) { return filtered(filter("spring"), jump, s); };
    kink = std::max(kink, std::abs(at(t + h) - 2 * at(t) + at(t - h)) / h);
  }
  EXPECT_LT(kink, 1.1 * 16 * pi * pi * h);
  EXPECT_EQ(filtered(filter("smooth"), jump, 0.7), 0);
  EXPECT_EQ(filtered(filter("smooth"), jump, 1.3), 1);
}

// The share of its kernel, four evenly spread numbers added up, that lies before x, from -0.5 to 0.5 of the width.
double kernel_before(double x) {
  x = std::clamp(4 * (x + 0.5), 0.0, 4.0);
  double sum = 0, binomial = 1;
  for (int j = 0; j <= 4 && j < x; binomial *= -(4.0 - j) / (j + 1), ++j) sum += binomial * std::pow(x - j, 4) / 24;
  return sum;
}

// shows: G105
TEST(Filter, SmoothCountsAJumpFromWhereItIs) {
  EXPECT_NEAR(filtered(filter("smooth"), jump, 1), 0.5, 1e-7);
  std::mt19937 dice(7);
  const auto roll = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(dice); };
  for (int i = 0; i < 300; ++i) {
    const double width = roll(0.05, 3), at = i % 3 == 0 ? width / 32 * (i % 7) : roll(-1, 4), high = roll(-5, 5);
    const double slope = roll(-1, 1), t = at + roll(-0.6, 0.6) * width;
    const auto track = [&](double s) { return Value(slope * s + (s < at ? 0 : high)); };
    EXPECT_NEAR(filtered(filter("smooth", {{"width", width}}), track, t),
                slope * t + high * kernel_before((t - at) / width), 2e-6 + 0.05 * std::abs(slope) * width / 32)
        << width << " " << at << " " << t;
  }
}

TEST(Filter, SmoothCountsTheJumpOfAnOrientationFromWhereItIs) {
  // From one side to the other, halfway where it jumps; of the same turn the other quaternion is no jump.
  const auto turn = [](double s) {
    const Quat q = axis_angle({0, 1, 0}, 0.8);
    return Value(s < 1 ? axis_angle({0, 1, 0}, 0.2) : Quat{-q.w, -q.x, -q.y, -q.z});
  };
  const Quat half = filtered<Quat>(filter("smooth"), turn, 1);
  EXPECT_NEAR(angle_between(half, axis_angle({0, 1, 0}, 0.5)), 0, 1e-6);
}

// shows: G105
TEST(Filter, SmoothTakesAllThatIsNumbers) {
  const auto color = filtered<Color>(
      filter("smooth"),
      [](double t) {
        return to_srgb({t, 0.5, 1 - t});
      },
      0.25);
  EXPECT_NEAR(to_linear(color.r), 0.25, 1e-12);  // means are of light, not of the numbers written
  EXPECT_NEAR(to_linear(color.g), 0.5, 1e-12);
  const auto angles = filtered<Angles>(
      filter("smooth"),
      [](double t) {
        return Angles{{20 * t, 0, 1}};
      },
      2);
  EXPECT_NEAR(angles.xyz.x, 40, 1e-11);
  // A steady turn stays one, whichever sign its quaternions have, also where angles become orientations on the way.
  const auto turn = [](double t) -> Value {
    const Quat q = from_angles({0, 3 * t, 0});
    return static_cast<int>(std::floor(t * 50)) % 2 ? Value(q) : t < 1 ? Value(Angles{{0, 3 * t, 0}}) : Value(-q);
  };
  for (const double t : {0.3, 1.0, 1.7})
    EXPECT_LT(angle_between(filtered<Quat>(filter("smooth"), turn, t), from_angles({0, 3 * t, 0})), 1e-4);
}

// shows: G105
TEST(Filter, SpringIsTheOscillator) {
  // x'' = w² (u - x) - 2 d w x' by Runge and Kutta's method of the fourth order, from long before; one swing is 48
  // cells of the filter's grid. Inputs: a slow and a quick sine, and a jump, which the grid sees within half a cell.
  struct Case {
    std::function<double(double)> u;
    double tolerance;  // of the sines: for a gain of 1
  };
  const std::vector<Case> cases{{[](double t) { return std::sin(2 * t); }, 2e-4},
                                {[](double t) { return std::sin(2 * pi * 2 * t); }, 2e-3},
                                {[](double t) { return t < 1 ? 0.0 : 1.0; }, 0.06}};
  for (const double damping : {0.1, 0.3, 1.0, 2.5})
    for (const Case& c : cases) {
      const double w = 2 * pi * 2, h = 1e-4;
      const double gain = std::max(1.0, 1 / (2 * damping));  // where the mass swings along most
      const Filter f = filter("spring", {{"frequency", 2.0}, {"damping", damping}});
      double x = c.u(-20), v = 0;
      const auto pull = [&](double at, double place, double speed) {
        return w * w * (c.u(at) - place) - 2 * damping * w * speed;
      };
      for (int k = 0; k <= 230000; ++k) {
        const double t = -20 + k * h;
        if (k >= 195000 && k % 700 == 0) {
          EXPECT_NEAR(filtered(f, c.u, t), x, c.tolerance * (&c == &cases.back() ? 1 : gain)) << damping << " at " << t;
        }
        const double x1 = v, v1 = pull(t, x, v);
        const double x2 = v + h / 2 * v1, v2 = pull(t + h / 2, x + h / 2 * x1, x2);
        const double x3 = v + h / 2 * v2, v3 = pull(t + h / 2, x + h / 2 * x2, x3);
        const double x4 = v + h * v3, v4 = pull(t + h, x + h * x3, x4);
        x += h / 6 * (x1 + 2 * x2 + 2 * x3 + x4), v += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
      }
    }
}

// shows: G105
TEST(Filter, SpringKeepsConstantsAndLagsSteadilyBehindLines) {
  for (const double damping : {0.05, 0.3, 1.0, 4.0}) {
    const Filter f = filter("spring", {{"frequency", 1.5}, {"damping", damping}});
    const double lag = 2 * damping / (2 * pi * 1.5);
    EXPECT_EQ(filtered(
                  f, [](double) { return 0.1; }, 3.3),
              0.1);
    // What the mass did when it was let go has decayed below 1e-4 of how wrong it was then: the lag.
    const auto p = filtered<Vec3>(
        f,
        [](double t) {
          return Vec3{t, 2 - 3 * t, 7};
        },
        3.3);
    EXPECT_NEAR(p.x, 3.3 - lag, 1e-4 * std::max(lag, 1.0));
    EXPECT_NEAR(p.y, 2 - 3 * (3.3 - lag), 3e-4 * std::max(lag, 1.0));
    EXPECT_EQ(p.z, 7);
  }
  // A wheel that turns once a second: far more than half a turn within the window.
  const auto wheel = [](double t) { return from_angles({0, 0, 2 * pi * t}); };
  const double lag = 2 * 0.3 / (2 * pi * 2);
  const Quat late = filtered<Quat>(filter("spring"), wheel, 4.1), at = from_angles({0, 0, 2 * pi * (4.1 - lag)});
  EXPECT_LT(angle_between(late, at), 0.04);
}

// shows: G105
TEST(Filter, NoiseIsSmoothBoundedAndDiffersByComponentAndSeed) {
  const auto zero = [](double) { return Vec3{}; };
  const Filter f = filter("noise", {{"frequency", 2.0}});
  Vec3 sum, squares;
  double xy = 0, steepest = 0;
  const int n = 20000;
  for (int k = 0; k < n; ++k) {
    const double t = k * 0.01 - 50;
    const auto v = filtered<Vec3>(f, zero, t);
    for (int i = 0; i < 3; ++i) EXPECT_LE(std::abs(v[i]), 1);
    const auto next = filtered<Vec3>(f, zero, t + 1e-6);
    steepest = std::max(steepest, length(next - v) / 1e-6);
    sum = sum + v, squares = squares + v * v, xy += v.x * v.y;
  }
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT(std::abs(sum[i] / n), 0.05);
    EXPECT_GT(squares[i] / n, 0.03);
  }
  EXPECT_LT(std::abs(xy) / std::sqrt(squares.x * squares.y), 0.1);
  EXPECT_LT(steepest, 2 * 4 * std::sqrt(3.0));  // no jump anywhere
  // Second derivatives agree on both sides of the lattice's points (of x, at whole halves of seconds).
  const auto x = [&](double t) { return filtered<Vec3>(f, zero, t).x; };
  const double h = 1e-4;
  for (const double t : {-1.5, 0.0, 0.5, 7.0})
    EXPECT_NEAR((x(t + 2 * h) - 2 * x(t + h) + x(t)) / (h * h), (x(t) - 2 * x(t - h) + x(t - 2 * h)) / (h * h), 0.2);
  Filter other = f;
  other.parameters.push_back({"seed", 1.0});
  EXPECT_NE(filtered<Vec3>(other, zero, 0.3), filtered<Vec3>(f, zero, 0.3));
  // On one component alone it is what that component has of the whole; amounts are for each component.
  Filter one = f;
  one.component = 1;
  EXPECT_EQ(filtered(
                one, [](double) { return 0.0; }, 0.3),
            filtered<Vec3>(f, zero, 0.3).y);
  Filter flat = f;
  flat.parameters.push_back({"amount", Vec3{0, 2, 0}});
  EXPECT_EQ(filtered<Vec3>(flat, zero, 0.3), (Vec3{0, 2 * filtered<Vec3>(f, zero, 0.3).y, 0}));
}

// shows: G105
TEST(Filter, WobbleAddsASine) {
  const Filter f = filter("wobble", {{"amount", 0.5}, {"frequency", 3.0}, {"phase", 0.25}});
  for (const double t : {-1.1, 0.0, 0.4, 9.99})
    EXPECT_NEAR(filtered(
                    f, [](double s) { return 2 * s; }, t),
                2 * t + 0.5 * std::cos(6 * pi * t), 1e-12);
  const Filter nod = filter("wobble", {{"amount", Vec3{0.2, 0, 0}}});
  const Quat base = from_angles({0, 1, 0});
  const Quat q = filtered<Quat>(
      nod, [&](double) { return base; }, 0.25);
  EXPECT_LT(angle_between(q, base * axis_angle({1, 0, 0}, 0.2)), 1e-7);
  const auto dark = filtered<Color>(
      filter("wobble"),
      [](double) {
        return Color{0.5, 0, 0.25};
      },
      0.75);
  EXPECT_EQ(dark, (Color{0, 0, 0}));
}

// shows: G105
TEST(Filter, DelayAndStepsTakeAnyValue) {
  const auto word = [](double t) { return Text(t < 1 ? "before" : "after"); };
  EXPECT_EQ(*filtered<Text>(filter("delay"), word, 1.2), "before");
  EXPECT_EQ(*filtered<Text>(filter("delay"), word, 1.25), "after");
  EXPECT_EQ(filtered(
                filter("delay", {{"by", -0.5}}), [](double t) { return t * t; }, 1.5),
            4);
  EXPECT_EQ(*filtered<Text>(filter("steps", {{"rate", 0.75}}), word, 1.3), "before");
  // On twos: the frames of 24 a second in pairs, at every frame of an hour, rounded to flicks.
  const Rate film{24, 1};
  for (int frame = 0; frame < 24 * 3600; frame += 7) {
    const double t = film.span(frame).seconds();
    EXPECT_NEAR(filtered(
                    filter("steps"), [](double s) { return s; }, t),
                frame / 2 / 12.0, 1e-9)
        << frame;
  }
  // Smooth has nothing to say of texts.
  for (const char* name : {"smooth", "spring", "noise", "wobble", "limit", "quantise"})
    EXPECT_EQ(*filtered<Text>(filter(name), word, 1.01), "after") << name;
}

// shows: G16 G105
TEST(Filter, LimitAndQuantise) {
  const auto line = [](double t) { return t; };
  const auto at = [&](Parameters p, double t) { return filtered(filter("limit", std::move(p)), line, t); };
  EXPECT_EQ(at({}, 1e9), 1e9);
  EXPECT_EQ(at({{"low", 2.0}}, -1), 2);
  EXPECT_EQ(at({{"low", 2.0}}, 1e9), 1e9);
  EXPECT_EQ(at({{"high", 3.0}}, 7), 3);
  EXPECT_EQ(at({{"high", 3.0}}, -7), -7);
  EXPECT_EQ(at({{"low", 5.0}, {"low", 2.0}, {"high", 3.0}}, 1), 2);  // the last counts
  const auto v = filtered<Vec3>(
      filter("quantise", {{"by", 0.25}}),
      [](double) {
        return Vec3{0.3, -0.4, 7};
      },
      0);
  EXPECT_EQ(v, (Vec3{0.25, -0.5, 7}));
  EXPECT_EQ(filtered(
                filter("quantise"), [](double) { return 1e300; }, 0),
            1e300);
  const Quat q = from_angles({0.1, 0.2, 0.3});
  Film turned([&](double) { return q; });  // it has no angles of its own, and that is said
  for (const char* name : {"limit", "quantise"}) {
    const auto made = apply(filter(name), turned, 0);
    ASSERT_FALSE(made);
    EXPECT_NE(made.error().message.find("an orientation has no separate angles"), std::string::npos);
  }
}

// shows: G105
TEST(Filter, TheSameQuestionHasTheSameAnswerInAnyOrder) {
  std::vector<double> times;
  for (int k = 0; k < 200; ++k) times.push_back(k / 24.0 - 2);
  for (const FilterSpec& spec : built_in_filters()) {
    Film film([](double t) { return Vec3{std::sin(3 * t), t < 1 ? 0.0 : 1.0, t * t}; });
    const Filter f = filter(std::string(spec.name));
    std::vector<std::pair<double, Value>> forth, mixed;
    for (const double t : times) forth.emplace_back(t, *apply(f, film, t));
    std::shuffle(times.begin(), times.end(), std::mt19937(7));
    for (const double t : times) mixed.emplace_back(t, *apply(f, film, t));
    std::sort(mixed.begin(), mixed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::sort(times.begin(), times.end());
    EXPECT_EQ(forth, mixed) << spec.name;
  }
}

// shows: G105
TEST(Filter, OnlyWithinItsSegmentBothEndsIncluded) {
  Filter f = filter("delay", {{"by", 1.0}});
  f.segment = std::pair{from_seconds(2), from_seconds(3)};
  const auto line = [](double t) { return t; };
  const double flick = 1.0 / static_cast<double>(flicks_per_second);
  EXPECT_EQ(filtered(f, line, 2 - flick), 2 - flick);
  EXPECT_EQ(filtered(f, line, 2), 1);
  EXPECT_EQ(filtered(f, line, 3), 2);
  EXPECT_EQ(filtered(f, line, 3 + flick), 3 + flick);
}

// shows: G105
TEST(Filter, CodeOfTheAuthorsIsAsked) {
  Filter f = filter("twice", {{"by", 2.0}});
  f.code = std::make_shared<Doubler>();
  Film film([](double t) { return t; });
  EXPECT_EQ(std::get<double>(*apply(f, film, 4)), 8);
  f.parameters.clear();
  const auto wrong = apply(f, film, 4);
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().message, "it wants to know how much");
  f.segment = std::pair{from_seconds(0), from_seconds(1)};
  EXPECT_EQ(std::get<double>(*apply(f, film, 4)), 4);
  EXPECT_EQ(filtered(
                filter("nobody"), [](double t) { return t; }, 4),
            4);
}

// shows: G105
TEST(Filter, EqualIsWhatSaysTheSame) {
  const auto code = [](std::string source) {
    auto r = std::make_shared<Doubler>();
    r->source = std::move(source);
    return r;
  };
  Filter a = filter("f", {{"by", 1.0}}), b = a;
  a.code = code("x"), b.code = code("x");
  EXPECT_EQ(a, b);
  b.code = code("y");
  EXPECT_FALSE(a == b);
  b = a, b.parameters[0].second = 2.0;
  EXPECT_FALSE(a == b);
  b = a, b.component = 0;
  EXPECT_FALSE(a == b);
  b = a, b.segment = std::pair{Time{0}, Time{1}};
  EXPECT_FALSE(a == b);
}

// shows: G105
TEST(Filter, WhatSuitsWhat) {
  const auto ok = [](std::string_view name, Type type) { return suits(*find_filter(name), type); };
  EXPECT_EQ(find_filter("nobody"), nullptr);
  for (const FilterSpec& spec : built_in_filters()) {
    for (const Type t : {Type::scalar, Type::angle, Type::pair, Type::vector, Type::color, Type::rotation})
      EXPECT_TRUE(suits(spec, t)) << spec.name;
    const bool any = spec.name == "delay" || spec.name == "steps";
    for (const Type t : {Type::text, Type::shape, Type::boolean, Type::points, Type::aim})
      EXPECT_EQ(suits(spec, t), any) << spec.name;
    EXPECT_FALSE(suits(spec, Type::attachment));
  }
  for (const char* name : {"smooth", "spring", "noise", "wobble", "delay", "steps"})
    EXPECT_TRUE(ok(name, Type::orientation)) << name;
  for (const char* name : {"limit", "quantise"}) EXPECT_FALSE(ok(name, Type::orientation)) << name;
}

// shows: G105
TEST(Filter, NothingItIsToldOrAskedHarmsIt) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const FilterSpec& spec : built_in_filters())
    for (const double bad : {nan, inf, -inf, 0.0, -1.0, 1e308})
      for (const double t : {0.0, longest_seconds, -longest_seconds, 1e300}) {
        Filter f = filter(std::string(spec.name));
        for (const FilterParameter& p : spec.parameters) f.parameters.push_back({std::string(p.name), bad});
        f.component = 17;
        Film film([](double s) { return s; });
        if (spec.name == "spring") f.parameters.push_back({"damping", 0.5});  // else a few thousand samples each
        EXPECT_TRUE(apply(f, film, t)) << spec.name;
      }
  EXPECT_EQ(filtered(
                filter("delay", {{"by", Text("soon")}}), [](double t) { return t; }, 1),
            0.75);
}

// The oscillator's own answer to a step, in closed form: 1 - exp(-d w t) (cos + d / sqrt(1 - d d) sin).
TEST(Filter, SpringAnswersAStepAsTheOscillatorDoes) {
  const double frequency = 2, damping = 0.3, w = 2 * pi * frequency, r = std::sqrt(1 - damping * damping);
  for (const double when : {1.0, 1.003, 1.0077}) {
    const auto step = [&](double t) { return t < when ? 0.0 : 1.0; };
    double worst = 0;
    for (double t = when - 0.1; t < when + 2; t += 0.013) {
      const double since = std::max(0.0, t - when);
      const double wanted =
          1 - std::exp(-damping * w * since) * (std::cos(r * w * since) + damping / r * std::sin(r * w * since));
      worst = std::max(worst, std::abs(filtered(filter("spring"), step, t) - wanted));
    }
    EXPECT_LT(worst, 2e-3) << when;
  }
}

}  // namespace
}  // namespace betwixt
