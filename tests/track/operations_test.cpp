// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/operations.h"

#include <gtest/gtest.h>

#include "support/events.h"
#include "support/told.h"
#include "track/curve.h"

namespace betwixt {
namespace {

Time at(double seconds) { return from_seconds(seconds); }
Event shaped(Event e, double ease_in, double ease_out) {
  e.detail.edit().ease_in = at(ease_in), e.detail.edit().ease_out = at(ease_out);
  return e;
}
std::vector<std::pair<double, double>> content(const Track& t) {
  std::vector<std::pair<double, double>> out;
  t.events.each([&](const Event& e) { out.emplace_back(e.time.seconds(), std::get<double>(e.value)); });
  return out;
}
using List = std::vector<std::pair<double, double>>;

std::array<double, 4> value(const Track& t, Type type, Time time) {
  CurveSet set;
  std::array<double, 4> n{};
  set.evaluate(set.add(t, type), time, n.data());
  return n;
}

// shows: G95
TEST(Copy, ShiftsEveryCopyAndReplacesItsRange) {
  Track t = track({event(0, 1.0), event(1, 5.0), event(2, 3.0), event(3.5, 100.0), event(9, 9.0)});
  const auto done = copy_segment(t, {at(0), at(2)}, t, at(2), Value(10.0), 2);
  ASSERT_TRUE(done);
  EXPECT_EQ(done->events, 6U);
  EXPECT_EQ(content(t), (List{{0, 1}, {1, 5}, {2, 11}, {3, 15}, {4, 21}, {5, 25}, {6, 23}, {9, 9}}));
}

TEST(Copy, KeepsTheEaseInThatItFindsAtTheSeam) {
  Track t = track({shaped(event(0, 1.0), 0.1, 0.2), shaped(event(1, 2.0), 0.3, 0.4)});
  ASSERT_TRUE(copy_segment(t, {at(0), at(1)}, t, at(1), std::nullopt, 1));
  const Event* seam = t.events.find(at(1));
  ASSERT_TRUE(seam);
  EXPECT_EQ(std::get<double>(seam->value), 1);
  EXPECT_EQ(seam->detail->ease_in, at(0.3));
  EXPECT_EQ(seam->detail->ease_out, at(0.2));
  EXPECT_EQ(t.events.find(at(2))->detail->ease_in, at(0.3));
}

TEST(Copy, GoesOntoOtherTracksAndCarriesCuts) {
  Event cut = event(1, 2.0);
  cut.detail.edit().before = Value(7.0);
  const Track from = track({event(0, 1.0), cut});
  Track into = track({event(10, 0.0), event(10.5, 0.0), event(12, 0.0)});
  ASSERT_TRUE(copy_segment(from, {at(0), at(1)}, into, at(10), Value(1.0), 1));
  EXPECT_EQ(content(into), (List{{10, 2}, {11, 3}, {12, 0}}));
  EXPECT_EQ(std::get<double>(*into.events.find(at(11))->detail->before), 8);
}

TEST(Operations, ThatFailChangeNothing) {
  Track t = track({event(0, Vec3{1, 2, 3}), event(1, Vec3{1e300, 0, 0})}), before = t;
  EXPECT_FALSE(copy_segment(t, {at(0), at(1)}, t, at(2), Value(true), 1));
  EXPECT_FALSE(copy_segment(t, {at(0), at(1)}, t, at(4.6e9), std::nullopt, 3));
  EXPECT_FALSE(move_segment(t, {at(0), at(1)}, at(4.6e9)));
  EXPECT_FALSE(stretch_segment(t, {at(0), at(1)}, 1e12));
  EXPECT_FALSE(stretch_segment(t, {at(0), at(1)}, 1e300));
  const auto huge = scale_segment(t, {at(0), at(1)}, Value(1e300));
  ASSERT_FALSE(huge);
  EXPECT_EQ(told(huge), "range");
  EXPECT_EQ(translate_segment(t, {at(0), at(1)}, Value(true)).error().message, "this cannot be moved by this");
  EXPECT_EQ(told(move_segment(t, {at(0), at(1)}, at(4.6e9))), "range");
  EXPECT_EQ(t, before);
  Track b = track({event(0, true), event(1, false)}), was = b;
  EXPECT_FALSE(scale_segment(b, {at(0), at(1)}, Value(2.0)));
  EXPECT_FALSE(rotate_segment(b, {at(0), at(1)}, Quat{}, {}));
  EXPECT_EQ(b, was);
}

// shows: G39
TEST(Move, TakesEventsAlongAndReplacesOthers) {
  Track t = track({event(0, 0.0), event(1, 1.0), event(2, 2.0), event(3, 3.0)});
  const auto done = move_segment(t, {at(1), at(2)}, at(1));
  ASSERT_TRUE(done);
  EXPECT_EQ(done->events, 2U);
  EXPECT_EQ(done->replaced, 1U);
  EXPECT_EQ(content(t), (List{{0, 0}, {2, 1}, {3, 2}}));
  ASSERT_TRUE(move_segment(t, {at(2), at(3)}, at(-1.5)));
  EXPECT_EQ(content(t), (List{{0, 0}, {0.5, 1}, {1.5, 2}}));
}

// shows: G40
TEST(Stretch, MultipliesEasesAndDividesTangents) {
  Event e = shaped(event(3, 5.0, Twerper::hermite), 0.2, 0.4);
  e.detail.edit().tangent_in = Value(6.0);
  e.detail.edit().tangent_out = Value(-4.0);
  Track t = track({event(1, 0.0, Twerper::hermite), e, event(4, 1.0, Twerper::hermite), event(9, 0.0)});
  const Track before = t;
  ASSERT_TRUE(stretch_segment(t, {at(1), at(4)}, 2));
  EXPECT_EQ(content(t), (List{{1, 0}, {5, 5}, {7, 1}, {9, 0}}));
  const EventDetail& d = *t.events.find(at(5))->detail;
  EXPECT_EQ(d.ease_in, at(0.4));
  EXPECT_EQ(d.ease_out, at(0.8));
  EXPECT_EQ(std::get<double>(*d.tangent_in), 3);
  EXPECT_EQ(std::get<double>(*d.tangent_out), -2);
  for (double s = 1; s < 4; s += 0.05)  // the same way, slower
    EXPECT_NEAR(value(t, Type::scalar, at(1 + 2 * (s - 1)))[0], value(before, Type::scalar, at(s))[0], 1e-9);
  Track third = track({event(0, 0.0), Event(event(1, 1.0))});
  ASSERT_TRUE(stretch_segment(third, {at(0), at(1)}, 1e-12));  // all at one time: the last one stays
  EXPECT_EQ(third.events.size(), 1U);
}

// The value at t is what stood at from + to - t.
void expect_reversed(Track t, Type type, double from, double to) {
  const Track before = t;
  ASSERT_TRUE(reverse_segment(t, {at(from), at(to)}));
  for (double s = from + 0.00123; s < to; s += 0.01) {
    const auto a = value(t, type, at(s)), b = value(before, type, at(from) + at(to) - at(s));
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(a[i], b[i], 1e-9) << s;
  }
  Track twice = t;
  ASSERT_TRUE(reverse_segment(twice, {at(from), at(to)}));
  for (double s = from; s < to; s += 0.01) {
    const auto a = value(twice, type, at(s)), b = value(before, type, at(s));
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(a[i], b[i], 1e-9) << s;
  }
}

TEST(Reverse, RunsEveryTwerperTheSameWayBack) {
  using enum Twerper;
  for (const Twerper twerper : {hold, linear, smooth, bspline, hermite, bezier}) {
    SCOPED_TRACE(name_of(twerper));
    expect_reversed(
        track({event(1, 3.0, twerper), event(1.5, 7.0, twerper), event(3, -2.0, twerper), event(4, 1.0, twerper)}),
        Type::scalar, 1, 4);
    Track global = track({event(1, 3.0), event(1.5, 7.0), event(3, -2.0), event(4, 1.0)});
    global.global = twerper;
    if (twerper != bezier) expect_reversed(global, Type::scalar, 1, 4);
  }
  // All at once: eases, a bezier of its own, tangents, cuts, holds, changes of twerper.
  Event a = shaped(event(0, 1.0, linear), 0, 0.3), b = shaped(event(1, 4.0, bezier), 0.2, 0.1);
  b.detail.edit().arguments = {0.9, 0.1, 0.7, 0.3};
  Event c = event(2, 0.0, hermite);
  c.detail.edit().tangent_in = Value(3.0), c.detail.edit().tangent_out = Value(-5.0);
  Event d = event(3, 2.0, smooth);
  d.detail.edit().before = Value(-3.0);
  d.detail.edit().tangent_in = Value(9.0);
  Event f = shaped(event(5, 6.0, hold), 0.5, 0);
  Event g = event(6, 9.0, bspline);
  g.detail.edit().before = Value(8.0);
  expect_reversed(track({a, b, c, d, event(4, 7.0, smooth), f, g, event(7, 1.0, smooth), event(7.5, 2.0),
                         event(8, 0.0, hold), event(9, 4.0, hold), event(10, 5.0)}),
                  Type::scalar, 0, 10);
}

// A corner, `V cut V`, is one in both directions; what lies beside the segment is what it was.
TEST(Reverse, KeepsCornersAndWhatLiesBeside) {
  Event corner = event(2, 5.0, Twerper::smooth);
  corner.detail.edit().before = Value(5.0);
  expect_reversed(track({event(1, 0.0, Twerper::smooth), corner, event(4, -3.0, Twerper::smooth), event(5, 1.0)}),
                  Type::scalar, 1, 5);
  Event left = shaped(event(2, 2.0, Twerper::linear), 0, 0.5), came = shaped(event(1, 1.0, Twerper::linear), 0.25, 0);
  left.detail.edit().tangent_out = Value(3.0);
  const Track before =
      track({event(0, 4.0, Twerper::linear), came, left, event(3, 3.0, Twerper::linear), event(4, 1.0)});
  Track t = before;
  ASSERT_TRUE(reverse_segment(t, {at(1), at(2)}));
  EXPECT_EQ(t.events.find(at(1))->detail->ease_in, came.detail->ease_in);
  EXPECT_EQ(t.events.find(at(2))->detail->ease_out, left.detail->ease_out);
  EXPECT_EQ(t.events.find(at(2))->detail->tangent_out, left.detail->tangent_out);
  EXPECT_EQ(t.events.find(at(1))->detail->ease_out, Time{});
  for (const double s : {2.1, 2.4, 2.5, 2.75}) {  // from 1 now, in the same manner
    const double was = (value(before, Type::scalar, at(s))[0] - 2) / (3 - 2),
                 is = (value(t, Type::scalar, at(s))[0] - 1) / (3 - 1);
    EXPECT_NEAR(is, was, 1e-12) << s;
  }
  ASSERT_TRUE(reverse_segment(t, {at(1), at(2)}));
  EXPECT_TRUE(t == before);
}

TEST(Reverse, OrientationsColorsAndSwitches) {
  using enum Twerper;
  // (Not bspline: products of turns depend on their order.)
  for (const Twerper twerper : {hold, slerp, squad, bezier, hermite, unset})
    expect_reversed(track({event(0, axis_angle({1, 0, 0}, 0.5), twerper), event(1, axis_angle({0, 1, 0}, 1.0), twerper),
                           event(3, axis_angle({1, 1, 1}, 2.0), twerper), event(3.5, Quat{}, twerper)}),
                    Type::orientation, 0, 3.5);
  expect_reversed(track({event(0, Color{1, 0, 0}), event(1, Color{0, 1, 0}, smooth), event(2, Color{0, 0, 1})}),
                  Type::color, 0, 2);
  expect_reversed(track({event(0, true), event(1, false), event(1.5, true), event(2, false)}), Type::boolean, 0, 2);
  // The segment may reach further than its events.
  Track on = track({event(1, true), event(2, false)});
  ASSERT_TRUE(reverse_segment(on, {at(0), at(4)}));
  EXPECT_EQ(value(on, Type::boolean, at(1.9))[0], 0);
  EXPECT_EQ(value(on, Type::boolean, at(2))[0], 1);
  EXPECT_EQ(value(on, Type::boolean, at(9))[0], 1);
}

// shows: G92
TEST(Scale, MultipliesValuesCutsAndTangents) {
  Event e = event(1, Vec3{1, 2, 3});
  e.detail.edit().before = Value(Vec3{4, 5, 6});
  e.detail.edit().tangent_in = Value(Vec3{1, 1, 1});
  Track t = track({event(0, Vec3{1, 1, 1}), e, event(2, Vec3{1, 1, 1})});
  ASSERT_TRUE(scale_segment(t, {at(0.5), at(1.5)}, Value(Vec3{1, -1, 2})));
  const Track kept = t;
  const Event* got = kept.events.find(at(1));
  EXPECT_EQ(std::get<Vec3>(got->value), (Vec3{1, -2, 6}));
  EXPECT_EQ(std::get<Vec3>(*got->detail->before), (Vec3{4, -5, 12}));
  EXPECT_EQ(std::get<Vec3>(*got->detail->tangent_in), (Vec3{1, -1, 2}));
  EXPECT_EQ(std::get<Vec3>(t.events.find(at(2))->value), (Vec3{1, 1, 1}));
  ASSERT_TRUE(translate_segment(t, {at(1), at(1)}, Value(Vec3{0, 1, 0})));
  EXPECT_EQ(std::get<Vec3>(got->value), (Vec3{1, -2, 6}));  // the copy is as it was
  EXPECT_EQ(std::get<Vec3>(t.events.find(at(1))->value), (Vec3{1, -1, 6}));
  EXPECT_EQ(std::get<Vec3>(*t.events.find(at(1))->detail->tangent_in), (Vec3{1, -1, 2}));  // tangents do not move
}

// shows: G94 G95
TEST(Rotate, TurnsVectorsAboutACentreAndOrientationsFromTheRight) {
  Event e = event(0, Vec3{3, 1, 0});
  e.detail.edit().tangent_out = Value(Vec3{1, 0, 0});
  Track t = track({e});
  ASSERT_TRUE(rotate_segment(t, {at(0), at(0)}, axis_angle({0, 0, 1}, pi / 2), {1, 1, 0}));
  const Vec3 p = std::get<Vec3>(t.events.front().value), v = std::get<Vec3>(*t.events.front().detail->tangent_out);
  EXPECT_NEAR(length(p - Vec3{1, 3, 0}), 0, 1e-15);
  EXPECT_NEAR(length(v - Vec3{0, 1, 0}), 0, 1e-15);
  const Quat x = axis_angle({1, 0, 0}, 0.3), y = axis_angle({0, 1, 0}, 0.4);
  Track q = track({event(0, x)});
  ASSERT_TRUE(rotate_segment(q, {at(0), at(0)}, y, {}));
  EXPECT_NEAR(dot(std::get<Quat>(q.events.front().value), x * y), 1, 1e-15);
  Track angles = track({event(0, Angles{})});
  EXPECT_EQ(rotate_segment(angles, {at(0), at(0)}, y, {}).error().message, "this cannot be rotated");
}

}  // namespace
}  // namespace betwixt
