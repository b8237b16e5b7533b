// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/scenes.h"

namespace betwixt {
namespace {

using namespace scenes;

// shows: G11
TEST(RenderWireframe, EdgesAndWhatTheyHide) {
  // Behind a square of 6 m is one of 3 m: its edge shows in `wireframe`, and not in `hidden-line`.
  Frame f = frame();
  f.items.push_back(item(square(), scaling({6, 6, 1}), {1, 1, 1}));
  f.items.push_back(item(square(), translation({0, 0, -1}) * scaling({3, 3, 1}), {1, 1, 1}));
  const auto brightest = [](const Picture& p, int from, int to) {
    int most = 0;
    for (int x = from; x < to; ++x) most = std::max(most, pixel(p, x, 47).r);
    return most;
  };
  const Picture all = draw(f, {100, 100, 4, "wireframe"}), some = draw(f, {100, 100, 4, "hidden-line"});
  EXPECT_GT(brightest(all, 17, 24), 180);
  EXPECT_GT(brightest(some, 17, 24), 180);
  EXPECT_GT(brightest(all, 32, 39), 180);
  EXPECT_EQ(brightest(some, 32, 39), 0);
  EXPECT_EQ(brightest(all, 40, 50), 0);
}

}  // namespace
}  // namespace betwixt
