// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Shadows are fine where one looks.
#include "render/scenes.h"

namespace betwixt {
namespace {

using namespace scenes;

// A ball of 0.1 m on a plane of 1,000 m, from 1 m away; the sun stands at 45 degrees at the left.
Frame small_ball() {
  Frame f;
  f.camera.world = look_at({0, 0.8, 0.8}, {0.1, 0, 0});
  f.background = Vec3{};
  f.items.push_back(item(square(), look_at({}, {0, -1, 0}) * scaling({1000, 1000, 1}), {1, 1, 1}, Material::matte));
  f.items.push_back(item(sphere(0.1), translation({0, 0.1, 0}), {1, 0, 0}, Material::matte));
  Light sun;
  sun.sun = true, sun.direction = normalize(Vec3{1, -1, 0});
  f.lights = {sun};
  return f;
}

// Pixels of the middle row, right of the ball, that are neither lit nor dark.
int between(const Picture& p) {
  const int dark = pixel(p, p.width / 2, p.height / 2).g, lit = pixel(p, p.width - 2, p.height / 2).g;
  EXPECT_GT(lit, dark + 50);
  int n = 0;
  for (int x = p.width / 2; x < p.width; ++x) {
    const int g = pixel(p, x, p.height / 2).g;
    n += g > dark + (lit - dark) / 10 && g < lit - (lit - dark) / 10;
  }
  return n;
}

TEST(RenderShadow, ASmallBallBesideALargePlaneHasACrispOne) {
  const RenderOptions options{640, 360, 4, "shaded"};
  const Frame f = small_ball();
  const Picture alone = draw(f, options);
  EXPECT_LE(between(alone), 6);
  for (const Vec3 far : {Vec3{0, 0.1, 300}, {0, 0.1, 30}, {-50, 3, 90}}) {  // behind the camera, all of them
    Frame with = f;
    with.items.push_back(item(sphere(0.1), translation(far), {1, 0, 0}, Material::matte));
    EXPECT_EQ(draw(with, options).rgba, alone.rgba) << far.z;
  }
}

// The same renderer, from here and from there: what it keeps must not show.
TEST(RenderShadow, WhatIsFineFollowsTheCamera) {
  const RenderOptions options{320, 180, 4, "shaded"};
  const auto keeping = renderer(options);
  Frame f = small_ball();
  f.items.push_back(item(sphere(0.1), translation({200, 0.1, 0}), {0, 0, 1}, Material::matte));
  for (const double x : {0.0, 200.0, 0.1, 100.0, 200.1}) {
    f.camera.world = look_at({x, 0.8, 0.8}, {x + 0.1, 0, 0});
    Picture p;
    ASSERT_TRUE(keeping->render(f, p));
    EXPECT_EQ(p.rgba, draw(f, options).rgba) << x;
  }
}

}  // namespace
}  // namespace betwixt
