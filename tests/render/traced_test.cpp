// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the style `traced` (path tracing) with closed forms and with `shaded`. A picture must depend on the frame
// alone.
#include "render/traced.h"

#include <algorithm>
#include <set>

#include "betwixt/language.h"
#include "betwixt/program.h"
#include "render/pixel_sampler.h"
#include "render/traced_scenes.h"

namespace betwixt {
namespace {

using namespace traced_scenes;

// The furnace test: in uniform light an object that reflects all light is invisible, with any roughness and among any
// other such objects.
TEST(Traced, WhiteThingsAreNotSeenInWhiteLight) {
  for (const Material material : {Material::matte, Material::plastic})
    for (const double shine : {0.0, 0.5, 1.0}) {
      Frame f = everywhere({0.6, 0.6, 0.6});
      f.background = Vec3{0.6, 0.6, 0.6};
      for (int i = 0; i < 5; ++i) {
        f.items.push_back(item(sphere(1.2), translation({i - 2.0, i % 2 - 0.5, 0.3 * i}), {1, 1, 1}, material));
        f.items.push_back(
            item(shape(i % 2 ? Kind::box : Kind::torus), translation({2.0 - i, 0, 1}), {1, 1, 1}, material));
      }
      for (Item& i : f.items) i.shininess = shine;
      const Picture p = draw(f, with(32, 18, 64));
      EXPECT_NEAR(mean(p), 0.6, 0.006) << shine;
      for (int x = 0; x < 32; ++x) EXPECT_NEAR(light(p, x, 9), 0.6, 0.04) << x << " " << shine;
    }
}

TEST(Traced, GreyThingsGiveTheirShareBack) {
  Frame f = everywhere({0.6, 0.6, 0.6});
  f.items.push_back(item(sphere(20), translation({0, 0, -30}), {0.5, 0.25, 1}, Material::matte));
  const Picture p = draw(f, with(8, 8, 16));
  EXPECT_EQ(pixel(p, 4, 4), (Pixel{encoded_byte(0.3), encoded_byte(0.15), encoded_byte(0.6), 255}));
}

// A wall gets half of its light from above and half from below.
TEST(Traced, WallsGetLightFromAboveAndBelow) {
  Frame f = everywhere({0, 0, 0});
  f.surroundings.ambient.reset();
  f.surroundings.ground = Vec3{1, 1, 1};  // which is not met: the wall stands below it
  f.items.push_back(item(square(), translation({0, -20, 0}) * scaling({30, 30, 1}), {1, 1, 1}, Material::matte));
  f.camera.world = translation({0, -20, 10});
  const double sky = 0.215, ground = 0.3;
  EXPECT_NEAR(pixel(draw(f, with(8, 8, 256)), 4, 4).g, encoded_byte((sky + ground) / 2), 2);
}

// In a hollow ball with a lamp at its centre every point of the wall gets the same light: L = a (E + L), so
// L = a E / (1 - a). No light comes in from outside.
TEST(Traced, LightGoesRoundInAHollowBall) {
  const double a = 0.6, range = 10, radius = 3, window = 1 - radius * radius / (range * range);
  for (const bool mesh : {false, true}) {
    Frame f = everywhere({1, 1, 1});
    f.lights = {lamp({0, 0, 0}, range)};
    f.lights[0].color = {0.5, 0.5, 0.5};
    f.camera = {};
    f.camera.world = translation({1, 0.5, 0});
    f.items.push_back(
        item(mesh ? shape(Kind::sphere) : sphere(), scaling({radius, radius, radius}), {a, a, a}, Material::matte));
    if (mesh) {
      auto white = std::make_shared<Picture>(Picture{1, 1, {255, 255, 255, 255}});
      f.items.back().texture = white;
    }
    const double direct = 0.8 * 0.5 * window * window;
    const Picture p = draw(f, with(16, 9, 64));
    EXPECT_NEAR(mean(p), a * direct / (1 - a), 0.01 * a * direct / (1 - a)) << mesh;
  }
}

// The same with a wall that glows.
TEST(Traced, WhatGlowsGivesLight) {
  Frame f = everywhere({0, 0, 0});
  f.items.push_back(item(sphere(30), Mat4{}, {0.7, 0.35, 0.2}));
  f.items.push_back(item(sphere(3), Mat4{}, {0.8, 0.8, 0.8}, Material::matte));
  f.camera.world = translation({0, 0, 9});
  const Picture p = draw(f, with(16, 16, 16));
  EXPECT_EQ(pixel(p, 8, 8), (Pixel{encoded_byte(0.56), encoded_byte(0.28), encoded_byte(0.16), 255}));
  EXPECT_EQ(pixel(p, 0, 0), (Pixel{encoded_byte(0.7), encoded_byte(0.35), encoded_byte(0.2), 255}));
}

TEST(Traced, ALampLightsAWallAsItsDistanceSays) {
  Frame f = everywhere({0, 0, 0});
  const Vec3 at{1, 2, 4};
  f.lights = {lamp(at, 12)};
  f.items.push_back(item(square(), scaling({20, 20, 1}), {0.6, 0.6, 0.6}, Material::matte));
  const Picture p = draw(f, with(40, 40, 4));
  for (int y = 2; y < 40; y += 5)
    for (int x = 2; x < 40; x += 5) {
      const Vec3 there{(x + 0.5) / 4 - 5, 5 - (y + 0.5) / 4, 0}, to = at - there;
      const double d2 = dot(to, to), window = std::max(1 - d2 / 144, 0.0);
      EXPECT_NEAR(pixel(p, x, y).r, encoded_byte(0.6 * 0.8 * window * window * to.z / std::sqrt(d2)), 1) << x << y;
    }
}

// A lamp 4 m above the wall, and a square of 2 m halfway between: the shadow has 4 m.
TEST(Traced, ShadowsEndWhereLinesOfSightDo) {
  Frame f = everywhere({0, 0, 0});
  f.lights = {lamp({0, 0, 4}, 40)};
  f.items.push_back(item(square(), scaling({20, 20, 1}), {1, 1, 1}, Material::matte));
  f.items.push_back(item(square(), translation({0, 0, 2}) * scaling({2, 2, 1}), {0, 0, 0}, Material::matte));
  f.camera.world = translation({0, 0, 1});  // below the square
  const Picture p = draw(f, with(100, 100, 4));
  for (const int k : {0, 28, 29, 70, 71, 99}) EXPECT_GT(pixel(p, k, 50).r, 150) << k;
  for (const int k : {31, 50, 68}) EXPECT_EQ(pixel(p, k, 50).r, 0) << k;
  EXPECT_EQ(pixel(p, 31, 31).r, 0);
  EXPECT_GT(pixel(p, 28, 31).r, 150);
  // Of a lamp a twentieth of its range wide, here 2 m, half as high above the edge as that is above the wall: the
  // shadow's edge is as wide as the lamp. In its middle half of the lamp is seen.
  f.lights[0].casting = Casting::soft;
  const Picture soft = draw(f, with(100, 100, 64));
  const double open = light(p, 20, 50);
  EXPECT_EQ(pixel(soft, 42, 50).r, 0);
  EXPECT_NEAR(light(soft, 30, 50) / open, 0.5, 0.06);
  EXPECT_NEAR(light(soft, 12, 50) / light(p, 12, 50), 1, 0.02);
}

TEST(Traced, WhatIsThinCastsAThinShadow) {
  Frame f = everywhere({0, 0, 0});
  f.lights = {lamp({0, 0, 4}, 40)};
  f.items.push_back(item(square(), scaling({20, 20, 1}), {1, 1, 1}, Material::matte));
  f.items.push_back(item(square(), translation({0, 0, 2}) * scaling({2, 2, 1}), {0, 0, 0}, Material::matte));
  f.camera.world = translation({0, 0, 1});
  const auto shadow = [&](double transparency, bool casts) {
    f.items[1].transparency = transparency, f.items[1].casts = casts;
    return light(draw(f, with(10, 10, 4)), 5, 5);
  };
  const double open = shadow(0, false);
  EXPECT_GT(open, 0.7);
  EXPECT_EQ(shadow(0, true), 0);
  EXPECT_NEAR(shadow(0.2, true), 0.4 * open, 0.01);
  EXPECT_NEAR(shadow(0.6, true), open, 1e-9);
}

// Each drawing covers those before it, also in the same plane: c = a c1 + (1 - a) c0.
TEST(Traced, LayersLieInTheOrderInWhichTheyAreDrawn) {
  Frame f = frame();
  f.surroundings.flat = true;
  const auto put = [&](Vec3 color, double z, double transparency) {
    f.items.push_back(item(square(), translation({0, 0, z}) * scaling({20, 20, 1}), color));
    f.items.back().transparency = transparency;
  };
  put({1, 0, 0}, 0, 0), put({0, 1, 0}, 0, 0.5), put({0, 0, 1}, 0, 0.75);
  EXPECT_EQ(pixel(draw(f, with(5, 5, 1)), 2, 2),
            (Pixel{encoded_byte(0.375), encoded_byte(0.375), encoded_byte(0.25), 255}));
  put({1, 1, 1}, -1, 0);  // behind them all
  EXPECT_EQ(pixel(draw(f, with(5, 5, 1)), 2, 2).r, encoded_byte(0.375));
  put({1, 1, 1}, 1, 0.5);
  EXPECT_EQ(pixel(draw(f, with(5, 5, 1)), 2, 2).b, encoded_byte(0.5 + 0.125));
}

// Also if they are so close that the planes coincide in f32.
TEST(Traced, EachLayerIsSeenOnce) {
  Frame f = frame();
  f.surroundings.flat = true;
  for (int i = 0; i < 40; ++i) {
    f.items.push_back(item(square(), translation({0, 0, 1e-5 * (i * 7 % 40)}) * scaling({20, 20, 1}), {1, 1, 1}));
    f.items.back().transparency = 0.95;
  }
  EXPECT_NEAR(light(draw(f, with(5, 5, 1)), 2, 2), 1 - std::pow(0.95, 40), 0.01);
}

TEST(Traced, SaysWhatShadedSays) {
  const auto ratio = [](const Frame& f) { return psnr(draw(f, {96, 54, 16, "shaded"}), draw(f, with(96, 54, 64))); };
  Frame f = apart();
  EXPECT_GT(ratio(f), 35);
  f.surroundings.fog = {{0.5, 0.6, 0.7}, 15, 30};
  EXPECT_GT(ratio(f), 35) << "fog";
  f.surroundings.fog.reset(), f.surroundings.sky = true, f.surroundings.exposure = 0.5;
  EXPECT_GT(ratio(f), 35) << "sky";
  f.surroundings.flat = true, f.surroundings.sky = false, f.background = Vec3{0.1, 0.2, 0.3};
  EXPECT_GT(ratio(f), 35) << "flat";
  // The floor fades into the sky.
  Frame wide;
  wide.camera.world = look_at({0, 2, 0}, {0, 1.6, -10});
  wide.surroundings.sky = true, wide.surroundings.ground = Vec3{0.7, 0.7, 0.6},
  wide.surroundings.ambient = Vec3{0.2, 0.2, 0.2};
  EXPECT_GT(ratio(wide), 40) << "horizon";
  wide.surroundings.fog = {{0.5, 0.6, 0.7}, 15, 30};
  EXPECT_GT(ratio(wide), 40) << "a horizon in fog";
  // A shadow on the floor, of an object that reflects no light.
  Frame g = apart();
  for (Item& i : g.items) i.color = {0, 0, 0}, i.material = Material::matte;
  g.surroundings.ground = Vec3{0.6, 0.55, 0.5}, g.surroundings.ambient = Vec3{0, 0, 0};
  g.camera.world = look_at({2, 6, 14}, {0, 0, 0});
  g.lights[0].casting = Casting::on;
  for (Item& i : g.items) i.world = translation({0, 3, 0}) * i.world;
  EXPECT_GT(ratio(g), 35) << "shadow";
}

TEST(Traced, PicturesOnThingsLieAsInShaded) {
  auto picture =
      std::make_shared<Picture>(Picture{2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 0}});
  Frame f = frame();
  f.items.push_back(item(square(), scaling({8, 8, 1}), {1, 1, 1}));
  f.items[0].texture = picture;
  const Picture a = draw(f, {40, 40, 16, "shaded"}), b = draw(f, with(40, 40, 16));
  EXPECT_GT(psnr(a, b), 35);
  EXPECT_GT(pixel(b, 8, 8).r, 200);
  EXPECT_NEAR(pixel(b, 28, 28).b, pixel(b, 28, 28).g, 1);
}

TEST(Traced, HairlinesAreAsWideAsInShaded) {
  auto s = std::make_shared<Shape>();
  s->kind = Kind::polyline;
  s->points = std::vector<Vec3>{{-4, -3, 0}, {4, 3, 0}, {4, -3, 2}};
  for (const bool orthographic : {true, false}) {
    Frame f = frame();
    f.camera.orthographic = orthographic;
    f.items.push_back(item(s, Mat4{}, {1, 1, 1}));
    EXPECT_NEAR(mean(draw(f, with(64, 64, 64))) / mean(draw(f, {64, 64, 16, "shaded"})), 1, 0.1) << orthographic;
  }
}

// Light above white is kept, and empty parts are transparent.
TEST(Traced, LightStaysAsBrightAsItIs) {
  Frame f = everywhere({2, 2, 2});
  f.surroundings.clear = true, f.background = Vec3{};
  f.items.push_back(item(square(), translation({-2, 0, 0}) * scaling({4, 20, 1}), {1, 1, 1}, Material::matte));
  f.items.push_back(item(square(), translation({2, 0, 0}) * scaling({4, 20, 1}), {1, 1, 1}));
  f.items[1].transparency = 0.75;
  RenderOptions options = with(10, 10, 4);  // a pixel is a metre
  LinearPicture p;
  EXPECT_EQ(renderer(options)->render(f, p).error().code, ErrorCode::range);
  EXPECT_EQ(pixel(draw(f, options), 9, 5), (Pixel{0, 0, 0, 255}));
  options.linear = options.unclamped = true;
  ASSERT_TRUE(renderer(options)->render(f, p));
  const auto at = [&](std::size_t x) { return std::array{p.rgba[200 + 4 * x], p.rgba[203 + 4 * x]}; };
  EXPECT_EQ(at(3), (std::array{2.0F, 1.0F}));
  EXPECT_EQ(at(6), (std::array{0.25F, 0.25F}));
  EXPECT_EQ(at(9), (std::array{0.0F, 0.0F}));
  options.unclamped = false;
  ASSERT_TRUE(renderer(options)->render(f, p));
  EXPECT_LT(p.rgba[200 + 4 * 3], 1);
  EXPECT_EQ(pixel(draw(f, options), 6, 5).a, 64);
}

TEST(Traced, ArithmeticIsLeftAsItWas) {
  volatile double tiny = 1e-310;
  draw(some_of_all(), with(8, 8, 1));
  EXPECT_GT(tiny * 0.5, 0);
}

TEST(Traced, TakesAnyNumberOfSamples) {
  for (const int n : {1, 2, 3, 7, 100, 4096}) EXPECT_NEAR(mean(draw(everywhere({0, 0, 0}), with(1, 1, n))), 0, 1e-9);
  for (const int n : {-1, -4, 4097}) {
    const auto r = make_renderer(with(8, 8, n));
    ASSERT_FALSE(r);
    EXPECT_EQ(r.error().code, ErrorCode::range);
    EXPECT_EQ(r.error().hint, "1 to 4096");
  }
}

TEST(Traced, WhatCannotBeDrawnIsLeftOut) {
  const double nan = std::nan(""), huge = std::numeric_limits<double>::infinity();
  Frame f = everywhere({0.5, 0.5, 0.5});
  f.items.push_back(item(square(), translation({2, 2, 0}), {1, 1, 1}));
  const RenderOptions options = with(20, 20, 4);
  const Picture expected = draw(f, options);
  Mat4 bad;
  bad(1, 2) = nan;
  for (const Mat4& m : {bad, translation({huge, 0, 0}), translation({0, 0, 1e300}), scaling({0, 0, 0}),
                        scaling({0, 1, 0}), scaling({1e-200, 1e-200, 1e-200}), scaling({1e20, 1e20, 1e20})}) {
    f.items.push_back(item(sphere(), m, {1, 1, 1}, Material::matte));
    f.items.push_back(item(shape(Kind::box), m, {1, 1, 1}, Material::metal));
  }
  f.items.push_back(item(sphere(), Mat4{}, {nan, 1, 1}));
  f.items.push_back(item(nullptr, Mat4{}, {1, 1, 1}));
  f.items.push_back(item(std::make_shared<Shape>(), Mat4{}, {1, 1, 1}));
  EXPECT_EQ(draw(f, options).rgba, expected.rgba);
  f.camera.world(0, 3) = nan;
  EXPECT_EQ(pixel(draw(f, options), 14, 5).r, 0);
}

TEST(Traced, WhatIsPressedFlatIsSeen) {
  Frame f = everywhere({0.5, 0.5, 0.5});
  f.items.push_back(item(sphere(3), scaling({1, 1, 0}), {1, 1, 1}));
  f.items.push_back(item(
      shape(Kind::box), translation({0, 4, 0}) * rotation(axis_angle({1, 0, 0}, 0.5)) * scaling({1, 0, 1}), {1, 1, 1}));
  const Picture p = draw(f, with(20, 20, 4));
  EXPECT_EQ(pixel(p, 10, 10).r, 255);
  EXPECT_EQ(pixel(p, 10, 17).r, 0);
  EXPECT_GT(mean(p), pi * 9 / 100);
}

// A scene looks the same far from the world's origin.
TEST(Traced, PlaceIsNoMatter) {
  const Frame f = some_of_all();
  Frame far = f;
  const Vec3 by{3e6, 0, -2e6};
  far.camera.world = translation(by) * far.camera.world;
  for (Item& i : far.items) i.world = translation(by) * i.world;
  for (Light& l : far.lights) l.position = l.position + by;
  EXPECT_GT(psnr(draw(f, with(48, 27, 4)), draw(far, with(48, 27, 4))), 45);
}

// Of 2^k samples, every elementary box of area 2^-k contains exactly one.
TEST(PixelSampler, EachBoxHoldsOneSample) {
  for (const std::uint32_t count : {1U, 2U, 16U, 64U, 256U})
    for (int question = 0; question < 3; ++question)
      for (std::uint32_t columns = 1; columns <= count; columns *= 2) {
        std::set<std::pair<int, int>> boxes;
        for (std::uint32_t s = 0; s < count; ++s) {
          traced::PixelSampler dice(77, s, count);
          for (int k = 0; k < question; ++k) dice.next_2d();
          const auto [x, y] = dice.next_2d();
          boxes.emplace(static_cast<int>(x * columns), static_cast<int>(y * (count / columns)));
        }
        EXPECT_EQ(boxes.size(), count) << columns << " " << question;
      }
}

TEST(PixelSampler, QuestionsAndPixelsKnowNothingOfEachOther) {
  constexpr std::uint32_t count = 64, pixels = 200;
  double together = 0, beside = 0;
  for (std::uint32_t pixel = 0; pixel < pixels; ++pixel)
    for (std::uint32_t s = 0; s < count; ++s) {
      traced::PixelSampler dice(pixel, s, count), next(pixel + 1, s, count);
      const double a = dice.next_1d() - 0.5, b = dice.next_1d() - 0.5, c = next.next_1d() - 0.5;
      together += a * b * 12 / (count * pixels), beside += a * c * 12 / (count * pixels);
    }
  EXPECT_NEAR(together, 0, 0.03);
  EXPECT_NEAR(beside, 0, 0.03);
}

}  // namespace
}  // namespace betwixt
