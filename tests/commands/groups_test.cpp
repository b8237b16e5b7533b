// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests commands that work on many objects at once.
#include "betwixt/track.h"
#include "commands/tracks.h"

namespace betwixt {
namespace {

// shows: G2
TEST(Groups, StaggerAndSpread) {
  const LoadedFilm s(
      "create b{1..3} sphere\nb*.radius\n 1f 1 linear\n 5f 5\nstagger b*.radius by 2f\n"
      "spread b*.position from (0 0 0) to (10 20 0)\n");
  expect_track(s, "b1.radius", 1, {1, 2, 3, 4, 5});
  expect_track(s, "b2.radius", 1, {1, 1, 1, 2, 3, 4, 5});
  expect_track(s, "b3.radius", 1, {1, 1, 1, 1, 1, 2, 3, 4, 5});
  expect_numbers(
      s, {{"b1.position", "1f", {0, 0, 0}}, {"b2.position", "1f", {5, 10, 0}}, {"b3.position", "1f", {10, 20, 0}}});
  const char* random = "create b{1..20} sphere\nb*.radius\n 1f 1 hold\n 2f 2\nstagger b*.radius by 1f random 7\n";
  EXPECT_EQ(read(random).document, read(random).document);
  // The same starts, in another order: at frame 12 the eleven that have started are among any eleven.
  const LoadedFilm r(random);
  double sum = 0;
  for (int i = 1; i <= 20; ++i) sum += r.numbers(fmt::format("b{}.radius", i), "12f")[0];
  EXPECT_EQ(sum, 20 + 11);
}

// The frames at which five boxes begin.
std::vector<double> begins(const std::string& how) {
  const LoadedFilm s(
      "rate 24\ncreate b{1..5} box position=(i*2 0 0)\ncreate post group position=(4 0 0)\nb*.scale\n  1f (1 1 "
      "1)\nstagger b*.scale by " +
      how + "\n");
  std::vector<double> out;
  for (int i = 1; i <= 5; ++i)
    out.push_back(events(s.loaded.document, (*find_targets(fmt::format("b{}.scale", i), s.loaded.document))[0])[0]
                          .time.seconds() *
                      24 +
                  1);
  return out;
}

TEST(Stagger, FromWhereTheTurnsBegin) {
  using Frames = std::vector<double>;
  EXPECT_EQ(begins("2f"), (Frames{1, 3, 5, 7, 9}));
  EXPECT_EQ(begins("2f from first"), (Frames{1, 3, 5, 7, 9}));
  EXPECT_EQ(begins("2f from last"), (Frames{9, 7, 5, 3, 1}));
  EXPECT_EQ(begins("2f from centre"), (Frames{5, 3, 1, 3, 5}));
  EXPECT_EQ(begins("2f from edges"), (Frames{1, 3, 5, 3, 1}));
  EXPECT_EQ(begins("2f from random 7"), begins("2f random 7"));
  EXPECT_EQ(begins("3f per 1m from (4 0 0)"), (Frames{7, 1, 7, 13, 19}));
  EXPECT_EQ(begins("3f per 100cm from post"), (Frames{7, 1, 7, 13, 19}));
  const std::string two = "create a{1..3} box\na*.scale\n  1f (1 1 1)\n";
  EXPECT_EQ(told(two + "stagger a*.scale by 2f from midle\n"), "type 4:29 midle");
  EXPECT_EQ(told(two + "stagger a*.scale by 2f per 0m from (0 0 0)\n"), "range 4:28 0m");
  EXPECT_EQ(told(two + "stagger a*.scale by 2f per 1m\n"), "syntax 4:30");
  EXPECT_EQ(told(two + "stagger a*.scale by 2f per 1m from nobody\n"), "name 4:36 nobody");
  EXPECT_EQ(told(two + "stagger a*.scale by 1000000s per 1e-9m from (1 0 0)\n"), "range 4:9 a*.scale");
}

}  // namespace
}  // namespace betwixt
