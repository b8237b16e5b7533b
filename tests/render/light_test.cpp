// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Colours: exact bytes, blending, light and shadow.
#include <thread>

#include "render/scenes.h"

namespace betwixt {
namespace {

using namespace scenes;

TEST(RenderColor, GlowAndBackgroundAreExact) {
  const auto r = renderer({16, 16, 4, "shaded"});
  for (int byte = 0; byte < 256; ++byte) {
    Frame f = frame();
    const double l = decoded(byte / 255.0);
    f.background = Vec3{l, decoded((255 - byte) / 255.0), 0};
    f.items.push_back(
        item(square(), translation({0, 5, 0}) * scaling({100, 10, 1}), {0, l, decoded((255 - byte) / 255.0)}));
    Picture p;
    ASSERT_TRUE(r->render(f, p));
    EXPECT_EQ(pixel(p, 8, 12), (Pixel{byte, 255 - byte, 0, 255}));
    EXPECT_EQ(pixel(p, 8, 3), (Pixel{0, byte, 255 - byte, 255}));
  }
}

TEST(RenderColor, MoreThanWhiteIsWhite) {
  Frame f = frame();
  f.items.push_back(item(square(), scaling({50, 50, 1}), {7, 1, 0}));
  EXPECT_EQ(pixel(draw(f), 50, 50), (Pixel{255, 255, 0, 255}));
}

TEST(RenderColor, HalfOfATransparentThingOverWhiteBlendsInLinearLight) {
  Frame f = frame();
  f.background = Vec3{1, 1, 1};
  f.items.push_back(item(square(), scaling({50, 50, 1}), {1, 0, 0.25}));
  f.items[0].transparency = 0.5;
  const Pixel p = pixel(draw(f), 50, 50);
  EXPECT_EQ(p.r, 255);
  EXPECT_NEAR(p.g, encoded_byte(0.5), 1);
  EXPECT_NEAR(p.b, encoded_byte(0.5 + 0.125), 1);
}

TEST(RenderColor, TransparentThingsAreSortedByDistance) {
  Frame f = frame();
  f.items.push_back(item(square(), translation({0, 0, 1}) * scaling({50, 50, 1}), {0, 1, 0}));  // nearer, and first
  f.items.push_back(item(square(), scaling({50, 50, 1}), {1, 0, 0}));
  for (Item& i : f.items) i.transparency = 0.5;
  const Pixel p = pixel(draw(f), 50, 50);
  EXPECT_NEAR(p.g, encoded_byte(0.5), 1);
  EXPECT_NEAR(p.r, encoded_byte(0.25), 1);
}

TEST(RenderColor, TexturesMultiplyAndStandUpright) {
  auto picture = std::make_shared<Picture>();
  picture->width = 1, picture->height = 2;
  picture->rgba = {255, 0, 0, 255, 0, 0, 255, 255};  // red above blue
  Frame f = frame();
  f.items.push_back(item(square(), scaling({8, 8, 1}), {1, 1, 1}));
  f.items[0].texture = picture;
  const Picture p = draw(f);
  const Pixel upper = pixel(p, 50, 29), lower = pixel(p, 50, 70);
  EXPECT_GT(upper.r, 250);
  EXPECT_LT(upper.b, 40);
  EXPECT_LT(lower.r, 40);
  EXPECT_GT(lower.b, 250);
}

Light lamp(Vec3 position, double range) {
  Light l;
  l.position = position, l.range = range;
  return l;
}

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

Frame busy() {
  Frame f;
  f.camera.world = translation({0, 3, 14}) * rotation(axis_angle({1, 0, 0}, -0.2));
  f.items.push_back(item(square(), rotation(axis_angle({1, 0, 0}, -pi / 2)) * scaling({20, 20, 1}), {0.6, 0.6, 0.6},
                         Material::plastic));
  for (int i = 0; i < 12; ++i) {
    f.items.push_back(item(sphere(0.7), translation({i - 6.0, 1.0 + i % 3, -1.0 * (i % 4)}), {0.1 * (i % 10), 0.5, 0.7},
                           Material::plastic));
    f.items.back().shininess = 0.5, f.items.back().transparency = i % 5 == 0 ? 0.5 : 0;
  }
  f.lights = {lamp({5, 9, 5}, 40), lamp({-5, 4, 5}, 20)};
  return f;
}

TEST(RenderSame, TheSameFrameTwiceIsTheSamePicture) {
  for (const Style& style : styles()) {
    const auto r = renderer({160, 90, 4, std::string(style.name)});
    Picture a, b, other;
    ASSERT_TRUE(r->render(busy(), a));
    ASSERT_TRUE(r->render(frame(), other));
    ASSERT_TRUE(r->render(busy(), b));
    EXPECT_EQ(a.rgba, b.rgba) << style.name;
    EXPECT_NE(a.rgba, other.rgba) << style.name;
  }
}

TEST(RenderSame, TwoThreadsDrawTheSamePictures) {
  const Picture expected = draw(busy(), {160, 90, 4, "shaded"});
  Picture got[2];
  std::vector<std::thread> threads;
  for (Picture& p : got)
    threads.emplace_back([&p] {
      for (int again = 0; again < 3; ++again) p = draw(busy(), {160, 90, 4, "shaded"});
    });
  for (std::thread& t : threads) t.join();
  EXPECT_EQ(got[0].rgba, expected.rgba);
  EXPECT_EQ(got[1].rgba, expected.rgba);
}

TEST(RenderSame, MeshesComeAndGo) {
  const auto r = renderer({32, 32, 1, "shaded"});
  Picture p;
  for (int i = 0; i < 40; ++i) {
    Frame f = frame();
    f.items.push_back(item(square(), scaling({9, 9, 1}), {1, 1, 1}));  // a new mesh each time
    ASSERT_TRUE(r->render(f, p));
    EXPECT_EQ(pixel(p, 16, 16).r, 255);
  }
}

TEST(RenderMany, AHundredThousandThings) {
  Frame f = frame();
  const auto ball = sphere(0.02), tile = square();
  for (int i = 0; i < 100000; ++i)
    f.items.push_back(item(i % 2 ? ball : tile,
                           translation({(i % 400) * 0.025 - 5, (i / 400) * 0.04 - 5, 0}) * scaling({.02, .02, .02}),
                           {1, 1, 1}));
  f.items.push_back(item(tile, translation({0, 0, 1}), {1, 1, 1}));
  EXPECT_EQ(pixel(draw(f, {100, 100, 1, "shaded"}), 50, 50).r, 255);
}

}  // namespace
}  // namespace betwixt
