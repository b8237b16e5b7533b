// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/scenes.h"

namespace betwixt {
namespace {

using namespace scenes;

TEST(RenderLight, ARangeEndsTheLight) {
  // The lamp is at height 1 above a wall, range 2: it reaches as far as sqrt(3) to the side.
  Frame f = frame();
  f.lights.push_back(lamp({0, 0, 1}, 2));
  f.items.push_back(item(square(), scaling({50, 50, 1}), {1, 1, 1}, Material::matte));
  const Picture p = draw(f);
  const Pixel beyond = pixel(p, 95, 50);
  EXPECT_GT(pixel(p, 50, 50).r, beyond.r + 60);
  EXPECT_GT(pixel(p, 60, 50).r, beyond.r);
  EXPECT_EQ(pixel(p, 70, 50), beyond);  // 2 m from the middle
  EXPECT_EQ(pixel(p, 95, 95), beyond);
}

TEST(RenderLight, BrightnessFollowsTheFormula) {
  // Straight above the middle of the wall at d: 0.8 · color · (1 - (d / range)²)², plus the ambient light that an unlit
  // wall shows.
  Frame f = frame();
  f.items.push_back(item(square(), scaling({50, 50, 1}), {0.5, 0.5, 0.5}, Material::matte));
  f.lights = {lamp({0, 0, -3}, 50)};  // behind the wall
  const double ambient = decoded(pixel(draw(f), 50, 50).g / 255.0);
  for (const double d : {1.0, 4.0, 6.0}) {
    f.lights = {lamp({0.05, -0.05, d}, 8)};  // above the middle of pixel (50, 50)
    const double w = 1 - d * d / 64;
    EXPECT_NEAR(decoded(pixel(draw(f), 50, 50).g / 255.0), ambient + 0.8 * 0.5 * w * w, 0.006) << d;
  }
}

TEST(RenderLight, ShadowIsDarkerThanLightAndWhereItMustBe) {
  // A ball of radius 1 hangs 3 m over the floor; the sun stands straight above.
  Frame f;
  f.background = Vec3{};
  f.camera.world = translation({0, 20, 0}) * rotation(axis_angle({1, 0, 0}, -pi / 2));
  f.camera.orthographic = true, f.camera.height = 10;
  Light sun;
  sun.sun = true, sun.direction = normalize(Vec3{1, -1, 0});  // the shadow falls 3 m to the right
  f.lights.push_back(sun);
  f.items.push_back(
      item(square(), rotation(axis_angle({1, 0, 0}, -pi / 2)) * scaling({20, 20, 1}), {1, 1, 1}, Material::matte));
  f.items.push_back(item(sphere(1), translation({0, 3, 0}), {1, 1, 1}, Material::matte));
  const Picture p = draw(f);
  const Pixel lit = pixel(p, 20, 50), shadow = pixel(p, 80, 50);
  EXPECT_GT(lit.r, shadow.r + 50);
  EXPECT_EQ(pixel(p, 80, 20).r, lit.r);
  EXPECT_EQ(pixel(p, 20, 20).r, lit.r);
}

TEST(RenderLight, GlassAndGlowCastNoShadow) {
  Frame f;
  f.camera.world = translation({0, 20, 0}) * rotation(axis_angle({1, 0, 0}, -pi / 2));
  f.camera.orthographic = true, f.camera.height = 10;
  Light sun;
  sun.sun = true, sun.direction = normalize(Vec3{1, -1, 0});
  f.lights.push_back(sun);
  f.items.push_back(
      item(square(), rotation(axis_angle({1, 0, 0}, -pi / 2)) * scaling({20, 20, 1}), {1, 1, 1}, Material::matte));
  f.items.push_back(item(sphere(1), translation({0, 3, 0}), {1, 1, 1}, Material::glow));
  const Picture p = draw(f);
  EXPECT_EQ(pixel(p, 80, 50), pixel(p, 20, 20));
}

TEST(RenderLight, WithoutLightsThereAreSome) {
  Frame f = frame();
  f.items.push_back(item(sphere(3), Mat4{}, {0.8, 0.2, 0.2}, Material::plastic));
  const Picture p = draw(f);
  EXPECT_GT(pixel(p, 42, 35).r, pixel(p, 60, 75).r + 40);  // the key light comes from the upper left
  EXPECT_GT(pixel(p, 60, 75).r, 30);
}

// A wall that shows the light from everywhere, so much of it.
Pixel wall(Vec3 light) {
  Frame f = frame();
  f.lights = {lamp({0, 0, 50}, 1)};  // reaches nothing
  f.items.push_back(item(square(), scaling({50, 50, 1}), {1, 1, 1}, Material::matte));
  f.surroundings.ambient = light;
  return pixel(draw(f), 50, 50);
}

TEST(RenderLight, HighlightsRollOff) {
  for (int i = 0; i <= 16; ++i) {  // as it is up to 0.8
    const double x = 0.05 * i;
    const Pixel p = wall({x, 0.5 * x, 0.25 * x});
    EXPECT_NEAR(p.r, encoded_byte(x), 1) << x;
    EXPECT_NEAR(p.g, encoded_byte(0.5 * x), 1) << x;
    EXPECT_NEAR(p.b, encoded_byte(0.25 * x), 1) << x;
  }
  // From there on a hyperbola that begins as steep as the identity, and ends at 1.
  int before = 0;
  for (const double x : {0.8, 0.9, 1.0, 1.2, 1.5, 2.0, 3.0}) {
    const Pixel p = wall({x, x, x});
    EXPECT_NEAR(p.g, encoded_byte(1 - 0.04 / (x - 0.6)), 1) << x;
    EXPECT_GT(p.g, before) << x;
    EXPECT_LT(p.g, 255) << x;
    before = p.g;
  }
  // What is overbright goes over into white, and keeps its hue on the way.
  const Pixel bright = wall({2, 0.2, 0.2}), brighter = wall({8, 0.8, 0.8});
  EXPECT_EQ(bright.g, bright.b);
  EXPECT_GT(bright.r, bright.g + 80);
  EXPECT_GT(brighter.g, bright.g + 40);
}

TEST(RenderLight, WhatHasItsColorByItselfDoesNotRollOff) {
  for (const double x : {0.9, 1.0}) {
    Frame f = frame();
    f.items.push_back(item(square(), scaling({4, 4, 1}), {x, x, x}));
    f.background = Vec3{x, x, x};
    const Picture p = draw(f);
    EXPECT_EQ(pixel(p, 50, 50).r, encoded_byte(x));
    EXPECT_EQ(pixel(p, 5, 5).r, encoded_byte(x));
    f.items[0].material = Material::plastic, f.surroundings.flat = true;
    EXPECT_EQ(pixel(draw(f), 50, 50).r, encoded_byte(x));
  }
}

}  // namespace
}  // namespace betwixt
