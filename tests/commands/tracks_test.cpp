// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests values that are set, events with their times, and extrapolation of a track.
#include "commands/tracks.h"

#include "support/loaded_film.h"

namespace betwixt {
namespace {

TEST(Tracks, SetIsTheValueWithoutEvents) {
  expect_numbers(LoadedFilm("create b sphere\nset b.position (1 2 3)\n"), "b.position", "9f", {1, 2, 3});
  expect_numbers(LoadedFilm("create b sphere\nset b.position.y 2\n"), "b.position", "9f", {0, 2, 0});
  expect_numbers(after_ramp("set b.position (9 8 7)"), "b.position", "5f", {4, 8, 7});
}

// shows: G32 G53
TEST(Tracks, AtIsARowInOneLine) {
  const LoadedFilm s(
      "create b sphere\nat 1f b.radius 1 linear\nat 5f b.radius 3\nat 3f b.radius 9\nat 3f b.radius 5 linear\n");
  expect_track(s, "b.radius", 1, {1, 3, 5, 4, 3, 3});
}

TEST(Tracks, Extrapolation) {
  const LoadedFilm cycle = after_ramp("extend b.position.x cycle after\nextend b.position.x linear before");
  expect_track(cycle, "b.position.x", 9, {0, 1, 2, 3, 4, 3, 2, 1, 0, 1});
  expect_numbers(cycle, "b.position.x", "-1f", {-2}, 1e-9);
  const LoadedFilm half("create b sphere\nb.position.x\n 1f 0 linear\n 5f 4\nextend b.position.x bounce\n");
  expect_track(half, "b.position.x", 3, {2, 3, 4, 3, 2, 1, 0, 1});
  expect_numbers(half, "b.position.x", "-1f", {2}, 1e-9);
  expect_track(after_ramp("extend b.position.x cycle\nextend b.position.x hold"), "b.position.x", 9, {0, 0, 0});
}

// The parabola through 0, 1, 1 at 10f, 20f, 60f leads past 1: transparency stays where it means something.
TEST(Tracks, ValuesStayWithinWhatTheFunctionCanBe) {
  const LoadedFilm s(
      "create a sphere\na.transparency\n 1f 0\n 10f 0\n 20f 1\n 60f 1\na.radius\n 1f 1\n 10f 0\n 60f 0.1\n");
  for (int f = 1; f <= 60; ++f) {
    const auto at = std::to_string(f) + "f";
    EXPECT_GE(s.numbers("a.transparency", at)[0], 0) << at;
    EXPECT_LE(s.numbers("a.transparency", at)[0], 1) << at;
    EXPECT_GE(s.numbers("a.radius", at)[0], 0) << at;
  }
  expect_numbers(s, "a.transparency", "40f", {1});
}

TEST(Tracks, LookAtHasComponents) {
  const LoadedFilm s("create c camera position=(0 0 10)\nc.look-at.x\n 1f 0 linear\n 11f 10\nc.look-at.y\n 1f 2\n");
  expect_numbers(s, "c.look-at", "6f", {5, 2, 0});
  expect_numbers(s, "c.look-at.x", "6.5f", {5.5});
}

// What was set holds until the first event; what is not interpolated begins with its default (it was the first
// event's).
TEST(Beginning, WhatWasSetHoldsUntilTheFirstEvent) {
  const LoadedFilm s(
      "create ball sphere radius=2\ncreate other sphere\ncreate label text text=\"before\"\n"
      "at 24f hide ball\nat 24f ball.radius 5\nat 30f ball.radius 6\nat 24f other.radius 5\n"
      "at 24f label.text \"after\"\nset ball.position (1 2 3)\nat 12f ball.position.y 7 linear\n"
      "at 24f ball.position.y 9\nset ball.rotation axis(0 1 0, 90deg)\nat 10f ball.rotation (0 0 45deg)\n");
  for (const char* t : {"0f", "1f", "23.99f"}) {
    EXPECT_EQ(s.read("ball.display", t), Value(true)) << t;
    expect_numbers(s, "ball.radius", t, {2});
    expect_numbers(s, "other.radius", t, {5});  // of numbers that nobody set the first event's
    EXPECT_EQ(s.text("label.text", t), "before") << t;
  }
  EXPECT_EQ(s.read("ball.display", "24f"), Value(false));
  EXPECT_EQ(s.text("label.text", "24f"), "after");
  expect_numbers(s, {{"ball.radius", "24f", {5}},
                     {"ball.position", "11.9f", {1, 2, 3}},
                     {"ball.position", "12f", {1, 7, 3}},
                     {"ball.position", "18f", {1, 8, 3}},
                     {"ball.rotation", "9f", {0, pi / 2, 0}},
                     {"ball.rotation", "10f", {0, 0, pi / 4}}});
  // Another road: a frame, forward and back.
  EXPECT_EQ(s.frame("23f").items.size(), 3u);
  EXPECT_EQ(s.frame("24f").items.size(), 2u);
  EXPECT_EQ(s.frame("23f").items.size(), 3u);
}

TEST(Beginning, GivesWayToAnExtensionBeforeAndToACut) {
  const LoadedFilm s(
      "create a sphere radius=9\na.radius\n  10f 1 linear\n  20f 2\nextend a.radius linear before\n"
      "create b sphere radius=9\nb.radius\n  10f 1 linear\n  20f 2\nextend b.radius cycle\n"
      "create c sphere radius=9\nc.radius\n  10f 4 cut 1 linear\n  20f 2\n");
  expect_numbers(s, {{"a.radius", "5f", {0.5}}, {"b.radius", "5f", {1.5}}, {"c.radius", "5f", {4}}});
}

TEST(Beginning, OfALayerIsWhatLiesBelow) {
  const LoadedFilm s(
      "create b box\nhide b\nlayer l mix\non l at 24f show b\ncreate p box\nset p.position.x 3\nlayer m add\n"
      "on m at 24f p.position (1 0 0)\n");
  EXPECT_EQ(s.read("b.display", "1f"), Value(false));
  EXPECT_EQ(s.read("b.display", "24f"), Value(true));
  expect_numbers(s, "p.position", "1f", {4, 0, 0});
}

TEST(Beginning, OfAVelocityIsWhatWasSet) {
  const LoadedFilm s(
      "rate 24\ncreate a sphere\nset a.position (5 0 0)\nat 25f a.position.velocity (1 0 0)\n"
      "at 73f a.position (0 0 0)\n");
  expect_numbers(s, {{"a.position", "1f", {5, 0, 0}}, {"a.position", "49f", {6, 0, 0}}});
}

TEST(Extend, CycleBeginsAnewAtTheLastEvent) {
  const LoadedFilm s(
      "create a sphere\na.radius\n  1f 1 linear\n  11f 2\nextend a.radius cycle\n"
      "create t text\nt.text\n  1f \"a\"\n  6f \"b\"\n  11f \"c\"\nextend t.text cycle\n");
  for (const auto& [time, wanted] : {std::pair("10.9f", 1.99), {"11f", 1.0}, {"21f", 1.0}, {"-9f", 1.0}, {"12f", 1.1}})
    expect_numbers(s, "a.radius", time, {wanted});
  EXPECT_EQ(s.text("t.text", "11f"), "a");
  EXPECT_EQ(s.text("t.text", "16f"), "b");
  EXPECT_EQ(s.text("t.text", "21f"), "a");
  // Forward play crosses the seam as a seek does.
  for (const char* time : {"10.5f", "11f", "11.5f"})
    EXPECT_EQ(s.frame(time).items[0].shape->radius, s.numbers("a.radius", time)[0]);
}

// A sine by its values only: through the seam as through all other events.
TEST(Extend, ASmoothCycleHasNoCornerAtItsSeam) {
  const LoadedFilm s(
      "rate 24\ncreate a sphere\na.position.x\n  1f 0 smooth\n  7f 1\n  13f 0\n  19f -1\n  25f 0\n"
      "extend a.position.x cycle\ncreate b sphere\nb.rotation\n  1f axis(0 1 0, 0deg) squad\n"
      "  9f axis(0 1 0, 80deg)\n  17f axis(0 1 0, 200deg)\n  25f axis(0 1 0, 360deg)\nextend b.rotation cycle\ntwerper "
      "b.rotation squad\n");
  const auto at = [&](const char* target, double frame) { return s.numbers(target, fmt::format("{}f", frame)); };
  const auto slope = [&](double frame) {
    return (at("a.position.x", frame + 1e-3)[0] - at("a.position.x", frame)[0]) / 1e-3;
  };
  // Neighbours of 0 at the seam are -1 and 1, six frames away: Catmull and Rom's slope there is 2 / 12.
  for (const double seam : {1.0, 25.0, 49.0}) {
    EXPECT_NEAR(slope(seam), 1.0 / 6, 1e-3) << seam;
    EXPECT_NEAR(slope(seam - 2e-3), 1.0 / 6, 1e-3) << seam;
  }
  const auto turn = [&](double frame) {
    const auto a = at("b.rotation", frame), b = at("b.rotation", frame + 1e-3);
    double cosine = 0;
    for (std::size_t i = 0; i < 4; ++i) cosine += a[i] * b[i];
    return std::sqrt(std::max(0.0, 2 - 2 * std::abs(cosine))) * 2 / 1e-3;
  };
  EXPECT_NEAR(turn(25), turn(25 - 2e-3), 1e-3);
}

TEST(Extend, LinearGoesOnWithTheTangent) {
  const LoadedFilm s(
      "rate 24\ncreate a sphere\na.position.x\n  1f 0 bezier(0 1.5 1 1.5)\n  25f 100\nextend a.position.x linear\n"
      "create b sphere\nb.position.x\n  1f 0 bezier(0.25 0.5 0.5 0.5)\n  25f 10\nextend b.position.x linear\n"
      "create c sphere\nc.position.x\n  1f 0 smooth\n  25f 1\n  49f 4\nextend c.position.x linear\n"
      "create d sphere\nd.position.x\n  1f 0 linear ease-out=6f\n  25f 1 ease-in=6f\nextend d.position.x linear\n");
  // Upright tangents hold; 1 - y2 over 1 - x2 is 1, y1 over x1 is 2: per second 10 and 20.
  expect_numbers(s, {{"a.position.x", "32.176f", {100}},
                     {"a.position.x", "-10f", {0}},
                     {"b.position.x", "49f", {20}},
                     {"b.position.x", "-23f", {-20}},
                     {"d.position.x", "49f", {1}},
                     {"d.position.x", "-23f", {0}}});
  // 0, 1, 4: a parabola at its ends, whose slopes are by reflection 1 and 3 a second.
  expect_numbers(s, "c.position.x", "73f", {7});
  expect_numbers(s, "c.position.x", "-23f", {-1});
}

TEST(Extend, OfAnAttachmentIsRefusedWithTheWayToDoIt) {
  const Loaded l = read("create a sphere\ncreate b box\nat 1f attach a to b\nextend a.attachment cycle\n");
  ASSERT_EQ(all_told(l), std::vector<std::string>{"type 4:21 cycle"});
  EXPECT_NE(said(l.diagnostics).find("copy a.attachment 1f..24f to 25f times 3"), std::string::npos);
}

TEST(Tracks, ThatWhatIsSetIsNotSeenIsSaid) {
  const std::string keyed = "create b sphere\nb.radius\n  1f 1\n  9f 2\n";
  EXPECT_EQ(remarks_told(keyed + "set b.radius 3\n"), std::vector<std::string>{"warning syntax 5:5 b.radius"});
  EXPECT_TRUE(read("create b sphere\nb.radius\n  9f 2\nset b.radius 3\n").diagnostics.empty());
  EXPECT_TRUE(read(keyed + "set b.color red\n").diagnostics.empty());
}

}  // namespace
}  // namespace betwixt
