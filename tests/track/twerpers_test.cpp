// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/twerpers.h"

#include <gtest/gtest.h>

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
