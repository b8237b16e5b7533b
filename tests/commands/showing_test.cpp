// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests what is visible at which time, and through which camera.
#include "support/loaded_film.h"

namespace betwixt {
namespace {

// shows: G28 G69
TEST(Showing, LookThroughShowHide) {
  const LoadedFilm s(
      "create a camera position=(1 0 0)\ncreate b camera position=(2 0 0)\nat 5f look through b\nat 9f look through a\n"
      "create ball sphere\nat 5f hide ball\nat 9f show ball\ncreate gone sphere\nhide gone\n");
  EXPECT_EQ(s.frame("4f").camera.world(0, 3), 1);
  EXPECT_EQ(s.frame("5f").camera.world(0, 3), 2);
  EXPECT_EQ(s.frame("9f").camera.world(0, 3), 1);
  expect_numbers(s, "ball.display", "5f", {0});
  EXPECT_EQ(s.frame("6f").items.size(), 0u);
  EXPECT_EQ(s.frame("9f").items.size(), 1u);
}

}  // namespace
}  // namespace betwixt
