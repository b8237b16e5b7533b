// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands that work on many objects at once.
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
  double sum = 0, orderly = 0;
  for (int i = 1; i <= 20; ++i) {
    sum += r.numbers(fmt::format("b{}.radius", i), "12f")[0];
    orderly += i == 1 + static_cast<int>(r.numbers(fmt::format("b{}.radius", i), "12f")[0] == 2);
  }
  EXPECT_EQ(sum, 20 + 11);
}

}  // namespace
}  // namespace betwixt
