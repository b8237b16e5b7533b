// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Values that are set, events with their time, and how a whole track goes on.
#include "commands/tracks.h"

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

}  // namespace
}  // namespace betwixt
