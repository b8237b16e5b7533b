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

}  // namespace
}  // namespace betwixt
