// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/curve.h"

#include <gtest/gtest.h>

#include <random>

#include "support/events.h"

namespace betwixt {
namespace {

using Numbers = std::array<double, 4>;
constexpr std::int64_t sec = flicks_per_second;
Time at(double seconds) { return from_seconds(seconds); }

Numbers all(const Track& t, Type type, Time time) {
  CurveSet set;
  Numbers n{};
  set.evaluate(set.add(t, type), time, n.data());
  return n;
}
double value(const Track& t, double seconds, Type type = Type::scalar) { return all(t, type, at(seconds))[0]; }
Quat turn(const Track& t, double seconds) {
  const auto n = all(t, Type::orientation, at(seconds));
  return {n[0], n[1], n[2], n[3]};
}
double angle_between(Quat a, Quat b) { return 2 * std::acos(std::min(1.0, std::abs(dot(a, b)))) * 180 / pi; }

// shows: G31 G45
TEST(Curve, IsDefinedEverywhereAndRightContinuous) {
  const Track t = track({event(1, 5.0, Twerper::hold), event(2, 7.0, Twerper::linear), event(3, 9.0)});
  EXPECT_EQ(value(t, -100), 5);
  EXPECT_EQ(value(t, 1), 5);
  EXPECT_EQ(all(t, Type::scalar, {2 * sec - 1})[0], 5);
  EXPECT_EQ(value(t, 2), 7);
  EXPECT_EQ(value(t, 2.5), 8);
  EXPECT_EQ(value(t, 3), 9);
  EXPECT_EQ(value(t, 1e9), 9);
  EXPECT_EQ(value(track({event(1, 5.0)}), 0), 5);
}

TEST(Curve, DoesNotDependOnWhereTimeBegins) {
  const double far = 4e9;  // seconds
  const std::vector<std::pair<double, double>> keys{{0, 0}, {0.5, 1}, {1.25, -3}, {2, 4}};
  Track near_track, far_track;
  for (const auto& [s, v] : keys) {
    near_track.events.put(event(s, v));
    Event e = event(s, v);
    e.time = e.time + at(far);
    far_track.events.put(std::move(e));
  }
  for (int i = 0; i < 200; ++i) {
    const Time t{i * 7'000'001};
    EXPECT_EQ(all(near_track, Type::scalar, t), all(far_track, Type::scalar, t + at(far)));
  }
}

// shows: G42
TEST(Curve, CutsHaveTwoValues) {
  Event cut = event(1, 10.0, Twerper::linear);
  cut.detail.edit().before = Value(4.0);
  const Track t = track({event(0, 0.0, Twerper::linear), cut, event(2, 20.0)});
  EXPECT_EQ(value(t, 0.5), 2);
  EXPECT_NEAR(all(t, Type::scalar, {sec - 1})[0], 4, 1e-8);
  EXPECT_EQ(value(t, 1), 10);
  EXPECT_EQ(value(t, 1.5), 15);
  // At the track's ends too: what it comes to holds before it, what it goes on from behind it.
  EXPECT_EQ(value(track({cut}), 0.5), 4);
  EXPECT_EQ(value(track({cut}), 1), 10);
  Track line = track({cut, event(2, 20.0)});
  line.before = Extrapolation::linear;
  EXPECT_EQ(value(line, 0), 4);
}

// shows: G20 G41 G43
TEST(Curve, SmoothReproducesParabolasBetweenUnevenEvents) {
  const auto f = [](double x) { return 3 * x * x - 7 * x + 2; };
  Track t;
  const double x[] = {0, 0.4, 1.5, 1.7, 3.2, 4};
  for (double s : x) t.events.put(event(s, f(s)));
  for (double s = 0.4; s <= 3.2; s += 0.01) EXPECT_NEAR(value(t, s), f(s), 1e-11);
  // At the ends the tangent is the chord's: there the slope is (f(0.4) - f(0)) / 0.4 at 0.
  const double d = 1e-5, chord = (f(0.4) - f(0)) / 0.4;
  EXPECT_NEAR((value(t, d) - value(t, 0)) / d, chord, 1e-3);
  EXPECT_NEAR(value(track({event(0, 1.0), event(2, 5.0)}), 0.5), 2, 1e-12);  // two events: a straight line
}

// shows: G12 G37
TEST(Curve, NeighboursEndAtCutsAndHolds) {
  // Between 1 and 2 with neighbours shut off on both sides, the phantom makes a straight line.
  Event cut = event(1, 0.0);
  cut.detail.edit().before = Value(50.0);
  const Track one = track({event(0, 9.0), cut, event(2, 1.0, Twerper::hold), event(3, -70.0)});
  const Track two = track({event(0, 9.0, Twerper::hold), event(1, 0.0), event(2, 1.0, Twerper::hold), event(3, -7.0)});
  for (double s = 1; s < 2; s += 0.125) {
    EXPECT_NEAR(value(one, s), s - 1, 1e-12);
    EXPECT_NEAR(value(two, s), s - 1, 1e-12);
  }
  // A change of twerper does not: the linear segment's far end still pulls.
  const Track three =
      track({event(0, 9.0, Twerper::linear), event(1, 0.0), event(2, 1.0, Twerper::hold), event(3, 0.0)});
  EXPECT_LT(value(three, 1.1), 0.0);
  // The neighbour behind a cut is the value that the track comes to.
  Event far_cut = event(3, 1000.0);
  far_cut.detail.edit().before = Value(9.0);
  const Track four = track({event(0, 0.0), event(1, 1.0), event(2, 4.0), far_cut});
  EXPECT_NEAR(value(four, 1.5), 2.25, 1e-12);
}

// The uniform cubic B-spline by its definition: convolutions of a box, as a recursion (Cox, de Boor).
double basis(int i, int degree, double x) {
  if (degree == 0) return x >= i && x < i + 1 ? 1 : 0;
  return (x - i) / degree * basis(i, degree - 1, x) + (i + degree + 1 - x) / degree * basis(i + 1, degree - 1, x);
}
// shows: G37 G41 G46
TEST(Curve, BsplineIsTheDefinition) {
  const double p[] = {1, -2, 5, 3, 8, 0};
  Track t;
  for (int i = 0; i < 6; ++i) t.events.put(event(i, p[i], Twerper::bspline));
  for (double s = 1; s < 4; s += 0.03) {
    double sum = 0;
    for (int i = 0; i < 6; ++i) sum += p[i] * basis(i - 2, 3, s);
    EXPECT_NEAR(value(t, s), sum, 1e-12);
  }
  EXPECT_NEAR(value(t, 0), 1, 1e-12);                            // the phantom brings it to its first event …
  EXPECT_NEAR(all(t, Type::scalar, {5 * sec - 1})[0], 0, 1e-7);  // … and to its last
}

TEST(Curve, BezierIsSolvedForTime) {
  std::mt19937 random(5);
  const auto pick = [&] { return static_cast<double>(random() % 10001) / 10000; };
  for (int i = 0; i < 50; ++i) {
    const std::array<double, 4> xy{pick(), 3 * pick() - 1, pick(), 3 * pick() - 1};
    for (double s = 0.001; s < 1; s += 0.0173) {  // go along the curve, and ask for the y of that x
      const double r = 1 - s, x = 3 * r * r * s * xy[0] + 3 * r * s * s * xy[2] + s * s * s;
      const double y = 3 * r * r * s * xy[1] + 3 * r * s * s * xy[3] + s * s * s;
      const double slope = 3 * r * r * xy[0] + 6 * r * s * (xy[2] - xy[0]) + 3 * s * s * (1 - xy[2]);
      EXPECT_NEAR(bezier_factor(x, xy), y, slope > 1e-3 ? 1e-10 : 1e-4);
    }
  }
  Event e = event(0, 10.0, Twerper::bezier);
  e.detail.edit().arguments = {0.42, 0, 0.58, 1};
  EXPECT_NEAR(value(track({e, event(2, 20.0)}), 1), 15, 1e-12);  // symmetrical
  EXPECT_EQ(bezier_factor(0, {1, 1, 0, 0}), 0);
  EXPECT_EQ(bezier_factor(1, {1, 1, 0, 0}), 1);
}

// shows: G35
TEST(Curve, HermiteTangentsArePerSecond) {
  const auto f = [](double x) { return x * x * x - 2 * x * x + 3; };  // a cubic is what hermite makes exactly
  const auto slope = [](double x) { return 3 * x * x - 4 * x; };
  Track t;
  for (double s : {0.0, 0.5, 2.0, 2.25}) {
    Event e = event(s, f(s), Twerper::hermite);
    e.detail.edit().tangent_in = e.detail.edit().tangent_out = Value(slope(s));
    t.events.put(std::move(e));
  }
  for (double s = 0; s < 2.25; s += 0.01) EXPECT_NEAR(value(t, s), f(s), 1e-12);
  EXPECT_NEAR(value(track({event(0, 0.0, Twerper::hermite), event(1, 1.0)}), 0.25), 0.15625, 1e-12);  // 3u² - 2u³
}

// shows: G35
TEST(Ease, IsATrapezoidOfSpeed) {
  const auto check = [](double out, double in, double a, double b) {  // asked for, and what fits
    EXPECT_EQ(ease(0, out, in), 0);
    EXPECT_NEAR(ease(1, out, in), 1, 1e-15);
    // The area under the speed, by adding it up.
    const double top = 1 / (1 - (a + b) / 2);
    double sum = 0;
    const int n = 100'000;
    for (int i = 0; i < n; ++i) {
      const double u = (i + 0.5) / n;
      sum += (u < a ? top * u / a : u > 1 - b ? top * (1 - u) / b : top) / n;
      if (i % 5000 == 0) {
        EXPECT_NEAR(ease((i + 1.0) / n, out, in), sum, 1e-8);
      }
    }
  };
  check(0.25, 0.5, 0.25, 0.5);
  check(0.2, 0, 0.2, 0);
  check(0, 0.6, 0, 0.6);
  check(1, 1, 0.5, 0.5);
  check(3, 1, 0.75, 0.25);
  // In a track: 12 seconds, out 2 s and in 4 s; the constant speed is 1/9 a second, so 1/9 of the way after 2 s.
  Event from = event(0, 0.0, Twerper::linear), to = event(12, 9.0);
  from.detail.edit().ease_out = at(2);
  to.detail.edit().ease_in = at(4);
  const Track t = track({from, to});
  EXPECT_NEAR(value(t, 2), 1, 1e-12);
  EXPECT_NEAR(value(t, 8), 7, 1e-12);
  EXPECT_NEAR(value(t, 10), 8.5, 1e-12);
}

// shows: G51 G70
TEST(Orientation, TakesTheShortWayAtConstantSpeed) {
  const double deg = pi / 180;
  const Quat a = axis_angle({0, 1, 0}, 0), b = axis_angle({0, 1, 0}, 20 * deg);
  for (const Quat& end : {b, -b}) {
    const Track t = track({event(0, a), event(1, end)});
    for (double s = 0; s <= 1; s += 0.1) EXPECT_NEAR(angle_between(turn(t, s), a), 20 * s, 1e-5);
  }
  const Track wide = track({event(0, a), event(4, axis_angle({1, 1, 0}, 170 * deg))});
  EXPECT_NEAR(angle_between(turn(wide, 1), a), 42.5, 1e-6);
  for (int i = 0; i < 40; ++i) EXPECT_NEAR(angle_between(turn(wide, i * 0.1), turn(wide, (i + 1) * 0.1)), 4.25, 1e-5);
}

// shows: G43 G51
TEST(Orientation, SquadPassesThroughItsKeysSmoothly) {
  const std::vector<Quat> keys{axis_angle({1, 0, 0}, 0.3), axis_angle({1, 2, 0}, 1.0), axis_angle({0, 1, 1}, 2.2),
                               axis_angle({1, 0, 1}, 1.4)};
  for (const Twerper twerper : {Twerper::squad, Twerper::smooth}) {
    Track t;
    for (std::size_t i = 0; i < keys.size(); ++i)
      t.events.put(event(static_cast<double>(i), i % 2 ? -keys[i] : keys[i], twerper));
    for (std::size_t i = 0; i < keys.size(); ++i)
      EXPECT_NEAR(angle_between(turn(t, static_cast<double>(i)), keys[i]), 0, 1e-5);
    const double d = 1e-4;
    for (double s : {1.0, 2.0}) {  // the angular velocities on both sides of a key
      const Quat left = conjugate(turn(t, s - d)) * turn(t, s), right = conjugate(turn(t, s)) * turn(t, s + d);
      EXPECT_NEAR(left.x / d, right.x / d, 2e-3);
      EXPECT_NEAR(left.y / d, right.y / d, 2e-3);
      EXPECT_NEAR(left.z / d, right.z / d, 2e-3);
    }
    for (double s = 0; s < 3; s += 0.01) EXPECT_NEAR(dot(turn(t, s), turn(t, s)), 1, 1e-12);
  }
}

TEST(Orientation, SplinesAboutOneAxisAreThoseOfTheAngle) {
  const double angles[] = {0, 0.4, 1.0, 1.2, 0.5};
  Track q, d;
  for (int i = 0; i < 5; ++i) {
    q.events.put(event(i, axis_angle({0, 0, 1}, angles[i]), Twerper::bspline));
    d.events.put(event(i, angles[i], Twerper::bspline));
  }
  for (double s = 0; s < 4; s += 0.05) {
    const Quat r = turn(q, s);
    EXPECT_NEAR(2 * std::atan2(r.z, r.w), value(d, s), 1e-12);
  }
}

TEST(Orientation, KeepsTurningAtItsEndSpeed) {
  Event last = event(1, axis_angle({0, 1, 0}, 0.5));
  Track t = track({event(0, Quat{}), last});
  t.before = t.after = Extrapolation::linear;
  EXPECT_NEAR(angle_between(turn(t, 5), axis_angle({0, 1, 0}, 2.5)), 0, 1e-5);
  EXPECT_NEAR(angle_between(turn(t, -3), axis_angle({0, 1, 0}, -1.5)), 0, 1e-5);
  // One that has come to rest stays there; one that has only started slowly goes on at its full speed.
  last.detail.edit().ease_in = at(0.5);
  t.events.put(last);
  EXPECT_NEAR(angle_between(turn(t, 5), axis_angle({0, 1, 0}, 0.5)), 0, 1e-5);
  Track slow = track({event(0, Quat{}), event(1, axis_angle({0, 1, 0}, 0.5))});
  slow.after = Extrapolation::linear;
  slow.events.edit_between({}, {}, [](Event& e) { e.detail.edit().ease_out = at(0.5); });
  // 0.5 in 1 s with half of it easing: full speed 0.5 / 0.75.
  EXPECT_NEAR(angle_between(turn(slow, 2), axis_angle({0, 1, 0}, 0.5 + 0.5 / 0.75)), 0, 1e-5);
}

TEST(Rotation, AnglesCountWholeTurns) {
  const Track t = track({event(0, Angles{}, Twerper::linear), event(1, Angles{{0, 6 * pi, 0}})});
  EXPECT_NEAR(all(t, Type::rotation, at(0.25))[1], 1.5 * pi, 1e-12);
  CurveSet set;
  EXPECT_EQ(set.add(t, Type::rotation).channels, 3);
  // With one orientation among them all are orientations.
  const Track mixed = track({event(0, Angles{}), event(1, axis_angle({0, 1, 0}, 1.0))});
  const Curve c = set.add(mixed, Type::rotation);
  EXPECT_EQ(c.channels, 4);
  EXPECT_TRUE(c.orientation);
}

// shows: G24 G50
TEST(Color, BlendsInLinearLight) {
  Track t = track({event(0, Color{0, 0, 0}), event(1, Color{1, 1, 1})});
  EXPECT_NEAR(value(t, 0.5, Type::color), 0.5, 1e-15);
  EXPECT_NEAR(to_srgb(value(t, 0.5, Type::color)), 0.735356983052449, 1e-12);
  t.srgb = true;
  EXPECT_NEAR(to_srgb(value(t, 0.5, Type::color)), 0.5, 1e-12);
  // An event that only changes the twerper stands on the curve, also on one of numbers as written.
  Event keep = event(0.5, 0.0, Twerper::hold);
  keep.keep = true;
  t.events.put(keep);
  EXPECT_NEAR(to_srgb(value(t, 0.75, Type::color)), 0.5, 1e-12);
  t.srgb = false;
  EXPECT_NEAR(value(t, 0.75, Type::color), 0.5, 1e-12);
}

TEST(Color, GoesThereAndBack) {
  for (int k = 0; k <= 255; ++k) EXPECT_EQ(to_srgb(to_linear(k / 255.0)), k / 255.0) << k;
  for (int k = -9999; k <= 9999; ++k) EXPECT_EQ(to_srgb(to_linear(k / 1000.0)), k / 1000.0) << k;
  for (int k = 0; k <= 100; ++k) EXPECT_EQ(to_srgb(to_linear(k * 1.0)), k * 1.0) << k;
  EXPECT_NEAR(to_linear(0.5), 0.21404114048223255, 1e-16);
  EXPECT_EQ(to_linear(-0.5), -to_linear(0.5));
}

// shows: G31
TEST(Extrapolation, RepeatsAsDefined) {
  const auto f = [](double s) { return s * s - 3 * s; };
  Track t;
  for (double s : {1.0, 1.5, 2.5, 3.0}) t.events.put(event(s, f(s), Twerper::linear));
  const Track inside = t;
  for (const bool bounce : {false, true}) {
    t.before = t.after = bounce ? Extrapolation::bounce : Extrapolation::cycle;
    for (double s = -9.03125; s < 12; s += 0.0625) {
      double x = s;  // by walking
      bool back = false;
      while (x < 1) x += 2, back = !back;
      while (x >= 3) x -= 2, back = !back;
      EXPECT_NEAR(value(t, s), value(inside, bounce && back ? 4 - x : x), 1e-9) << s;
    }
  }
  t.before = t.after = Extrapolation::linear;
  EXPECT_NEAR(value(t, 0), f(1) - (f(1.5) - f(1)) / 0.5, 1e-12);
  EXPECT_NEAR(value(t, 1003), f(3) + 1000 * (f(3) - f(2.5)) / 0.5, 1e-9);
  // A curve goes on with its slope; a held one is held; one at rest stays.
  Track s = track({event(0, 0.0), event(1, 1.0), event(2, 4.0)});
  s.before = s.after = Extrapolation::linear;
  EXPECT_NEAR(value(s, 3), 7, 1e-5);  // the chord's slope at the end
  Track held = track({event(0, 0.0, Twerper::hold), event(1, 5.0)});
  held.before = held.after = Extrapolation::linear;
  EXPECT_EQ(value(held, 1), 5);
  EXPECT_EQ(value(held, 2), 5);
  EXPECT_EQ(value(held, -2), 0);
  Event rest = event(1, 5.0);
  rest.detail.edit().ease_in = at(0.3);
  Track resting = track({event(0, 0.0, Twerper::linear), rest});
  resting.after = Extrapolation::linear;
  EXPECT_NEAR(value(resting, 9), 5, 1e-9);
  Track one = track({event(2, 5.0)});
  for (const Extrapolation e :
       {Extrapolation::hold, Extrapolation::linear, Extrapolation::cycle, Extrapolation::bounce}) {
    one.before = one.after = e;
    EXPECT_EQ(value(one, 0), 5);
    EXPECT_EQ(value(one, 9), 5);
  }
}

// shows: G48
TEST(Keep, ChangesTheTwerperOnly) {
  Event keep = event(1, 0.0, Twerper::hold);
  keep.keep = true;
  const Track t = track({event(0, 0.0, Twerper::linear), keep, event(4, 8.0)});
  EXPECT_NEAR(value(t, 0.5), 1, 1e-12);
  EXPECT_NEAR(value(t, 1), 2, 1e-12);
  EXPECT_NEAR(value(t, 3.9), 2, 1e-12);
  EXPECT_EQ(value(t, 4), 8);
}

// shows: G41 G69
TEST(StepTrack, NeverBlendWhatCannotBeBlended) {
  Track b = track({event(0, true, Twerper::linear), event(1, false, Twerper::smooth), event(2, true)});
  b.global = Twerper::linear;
  EXPECT_EQ(value(b, 0.9, Type::boolean), 1);
  EXPECT_EQ(value(b, 1.9, Type::boolean), 0);
  EXPECT_EQ(value(b, 2, Type::boolean), 1);
  const StepTrack texts(track({event(0, Text(std::string("a"))), event(1, Text(std::string("b")))}), Type::text);
  EXPECT_EQ(texts.at(at(0.999), {}).a, 0U);
  EXPECT_EQ(texts.at(at(0.999), {}).s, 0);
  EXPECT_EQ(texts.at(at(1), {}).a, 1U);
}

TEST(StepTrack, CutsHaveTwoValues) {
  Event cut = event(1, ObjectId{3}, Twerper::linear);
  cut.detail.edit().before = Value(ObjectId{2});
  const StepTrack s(track({event(0, ObjectId{1}, Twerper::linear), cut, event(2, ObjectId{4})}), Type::shape);
  const auto between = [&](double t) {
    const Between b = s.at(at(t), {});
    return std::tuple{std::get<ObjectId>(s.values()[b.a]).index, std::get<ObjectId>(s.values()[b.b]).index, b.s};
  };
  EXPECT_EQ(between(0.5), (std::tuple{1U, 2U, 0.5}));
  EXPECT_EQ(between(1), (std::tuple{3U, 4U, 0.0}));
  EXPECT_EQ(between(1.25), (std::tuple{3U, 4U, 0.25}));
  EXPECT_EQ(between(7), (std::tuple{4U, 4U, 0.0}));
  EXPECT_EQ(between(-7), (std::tuple{1U, 1U, 0.0}));
}

// shows: G44 G102
TEST(Twerpers, TheGlobalOneAlwaysWins) {
  Track t = track({event(0, 0.0, Twerper::hold), event(1, 1.0, Twerper::smooth), event(2, 8.0, Twerper::hold)});
  t.global = Twerper::linear;
  EXPECT_NEAR(value(t, 0.5), 0.5, 1e-12);
  EXPECT_NEAR(value(t, 1.5), 4.5, 1e-12);
  t.global = Twerper::bezier;
  t.arguments = {0.5, 0, 0.5, 0};
  EXPECT_NEAR(value(t, 0.5), bezier_factor(0.5, t.arguments), 1e-12);
  std::string why;
  EXPECT_FALSE(fits(Twerper::slerp, Type::vector, &why));
  EXPECT_EQ(why, "'slerp' is for orientations; this is a vector");
  EXPECT_FALSE(fits(Twerper::linear, Type::text, &why));
  EXPECT_EQ(why, "'linear' cannot blend a text: it changes only at its events");
}

}  // namespace
}  // namespace betwixt
