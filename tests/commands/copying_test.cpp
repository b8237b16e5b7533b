// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests copies of segments of tracks.
#include "commands/tracks.h"

namespace betwixt {
namespace {

// shows: G93 G95
TEST(Copying, CopyTimesShiftOn) {
  const LoadedFilm s = after_ramp("copy b.position.x 1f..9f to 9f shift 10 times 2");
  expect_track(s, "b.position.x", 1, {0, 1, 2, 3, 4});
  expect_numbers(s, "b.position.x", "9f", {10}, 1e-9);
  expect_numbers(s, "b.position.x", "13f", {14}, 1e-9);
  expect_numbers(s, "b.position.x", "17f", {20}, 1e-9);
  expect_numbers(s, "b.position.x", "21f", {24}, 1e-9);
  expect_numbers(s, "b.position.x", "25f", {20}, 1e-9);
  const LoadedFilm on = after_ramp("create c sphere\ncopy b.position.x 1f..5f to 11f on c.position.y");
  expect_track(on, "c.position.y", 10, {0, 0, 1, 2, 3, 4, 4});
  expect_track(on, "b.position.x", 1, {0, 1, 2, 3, 4, 3, 2, 1, 0});
  // What stood in the range gives way.
  const LoadedFilm over("create b sphere\nb.radius\n 1f 1 linear\n 3f 3\n 6f 99\n 7f 50\ncopy b.radius 1f..3f to 5f\n");
  expect_numbers(over, "b.radius", "6f", {2}, 1e-9);
}

}  // namespace
}  // namespace betwixt
