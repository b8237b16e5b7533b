// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares the surroundings with closed forms: backgrounds, drawings, ambient light, fog, the ground, the sky.
#include "render/scenes.h"

namespace betwixt {
namespace {

using namespace scenes;

const RenderOptions square_picture{100, 100, 4, "shaded"};

void expect_near(const Pixel& is, Vec3 linear, int within = 1) {
  EXPECT_NEAR(is.r, encoded_byte(linear.x), within);
  EXPECT_NEAR(is.g, encoded_byte(linear.y), within);
  EXPECT_NEAR(is.b, encoded_byte(linear.z), within);
}

Item matte(const Mat4& world, Vec3 color) { return item(square(), world, color, Material::matte); }

// A camera with a right angle of view, at `from`, that looks at `to`.
Frame looking(Vec3 from, Vec3 to) {
  Frame f;
  f.camera.world = look_at(from, to);
  f.camera.fov = pi / 2;
  f.background = Vec3{0, 0, 0};
  return f;
}

// Where a square picture of that camera shows a point.
std::pair<int, int> shown(const Frame& f, Vec3 p) {
  const Vec3 off = p - translation_of(f.camera.world);
  const auto along = [&](int axis) { return dot(off, column(f.camera.world, axis)); };
  const double x = along(0) / -along(2), y = along(1) / -along(2);
  return {static_cast<int>(50 + 50 * x), static_cast<int>(50 - 50 * y)};
}
Pixel at(const Picture& p, std::pair<int, int> place) { return pixel(p, place.first, place.second); }

TEST(RenderSetting, BackgroundsGoFromTopToBottomInLinearLight) {
  for (const char* style : {"shaded", "wireframe"}) {
    Frame f = frame();
    f.background = Vec3{1, 0, 0.25}, f.surroundings.below = Vec3{0, 0, 1};
    const Picture p = draw(f, {100, 100, 1, style});
    for (const int y : {0, 20, 50, 99}) {
      const double u = (y + 0.5) / 100;
      expect_near(pixel(p, 50, y), {1 - u, 0, 0.25 + 0.75 * u});
    }
  }
}

TEST(RenderSetting, DrawingsHaveTheirColorsExactly) {
  Frame f = frame();
  f.surroundings.flat = true;
  f.lights = {lamp({3, 3, 3}, 20)};
  const Material materials[] = {Material::plastic, Material::matte, Material::metal, Material::glow};
  for (int i = 0; i < 100; ++i) {  // each fills a pixel of ten
    const Vec3 place{-4.5 + i % 10, 4.5 - i / 10, 0.01 * i};
    const Vec3 color{decoded(2 * i / 255.0), decoded((255 - i) / 255.0), decoded((i * 37 % 256) / 255.0)};
    f.items.push_back(item(i % 2 ? sphere(0.5) : square(), translation(place), color, materials[i % 4]));
    f.items.back().shininess = i % 3 / 2.0;
  }
  const Picture p = draw(f);
  for (int i = 0; i < 100; ++i)
    EXPECT_EQ(pixel(p, 5 + 10 * (i % 10), 5 + 10 * (i / 10)), (Pixel{2 * i, 255 - i, i * 37 % 256, 255})) << i;
}

TEST(RenderSetting, LightFromEverywhereShowsColorsAsFarAsItIsWhite) {
  Frame f = frame();
  f.lights = {lamp({0, 0, 50}, 1)};  // reaches nothing
  f.items.push_back(matte(scaling({50, 50, 1}), {0.8, 0.5, 1}));
  f.surroundings.ambient = Vec3{0.5, 0.25, 0.125};
  expect_near(pixel(draw(f), 50, 50), {0.4, 0.125, 0.125});
  f.surroundings.exposure = -1;
  expect_near(pixel(draw(f), 50, 50), {0.2, 0.0625, 0.0625});
  f.surroundings.ambient = Vec3{};
  expect_near(pixel(draw(f), 50, 50), {});
}

// A stop is twice the light: what a sun of half the strength shows one stop brighter.
TEST(RenderSetting, ExposureIsInStops) {
  const auto picture = [](double strength, double stops) {
    Frame f = frame();
    Light sun;
    sun.sun = true, sun.direction = normalize(Vec3{-1, -1, -1}), sun.color = strength * Vec3{0.4, 0.3, 0.2};
    f.lights = {sun};
    f.items.push_back(matte(scaling({50, 50, 1}), {0.7, 0.7, 0.7}));
    f.surroundings.ambient = Vec3{}, f.surroundings.exposure = stops;
    return draw(f).rgba;
  };
  EXPECT_EQ(picture(0.5, 1), picture(1, 0));
  EXPECT_EQ(picture(2, -2), picture(0.5, 0));
  EXPECT_NE(picture(1, 1), picture(1, 0));
}

TEST(RenderSetting, FogGrowsWithTheDistance) {
  Frame f = frame();  // 10 m away
  f.items.push_back(item(square(), scaling({50, 50, 1}), {1, 0, 0}));
  f.surroundings.fog = {{0, 0, 1}, 4, 12};
  expect_near(pixel(draw(f), 50, 50), {0.25, 0, 0.75});
  f.surroundings.fog = {{0, 0, 1}, 10.5, 12};
  expect_near(pixel(draw(f), 50, 50), {1, 0, 0});
  f.surroundings.fog = {{0, 0, 1}, 1, 9};
  expect_near(pixel(draw(f), 50, 50), {0, 0, 1});
  f.items[0].transparency = 0.5;  // over black
  expect_near(pixel(draw(f), 50, 50), {0, 0, 0.5});

  Frame wide = looking({0, 0, 10}, {});  // by the distance, not by the depth
  wide.items.push_back(item(square(), scaling({50, 50, 1}), {1, 0, 0}));
  wide.surroundings.fog = {{0, 0, 1}, 10, 20};
  const Picture p = draw(wide);
  const double x = 10 * (90.5 - 50) / 50, y = 10 * (10.5 - 50) / 50, u = std::sqrt(100 + x * x + y * y) / 10 - 1;
  expect_near(pixel(p, 90, 10), {1 - u, 0, u});
}

// A floor under a sun that stands upright, and a ball above it.
Frame floor_with_ball() {
  Frame f = looking({0, 6, 12}, {});
  f.surroundings.ground = Vec3{0.5, 0.25, 0.125}, f.surroundings.ambient = Vec3{0.2, 0.2, 0.2};
  f.background = Vec3{0, 0, 1};
  Light sun;
  sun.sun = true, sun.direction = {0, -1, 0};
  f.lights = {sun};
  f.items.push_back(item(sphere(1), translation({0, 3, 0}), {1, 1, 1}, Material::plastic));
  return f;
}

TEST(RenderSetting, TheFloorIsLitAndShadowed) {
  const Frame f = floor_with_ball();
  const Picture p = draw(f);
  for (const Vec3 lit : {Vec3{3, 0, 0}, {-4, 0, 2}, {0, 0, 5}})  // 0.8 of the sun's light, and 0.2 from everywhere
    expect_near(at(p, shown(f, lit)), {0.5, 0.25, 0.125}, 2);
  for (const Vec3 dark : {Vec3{0, 0, 0}, {0.5, 0, 0.4}, {-0.6, 0, 0}}) {
    const Pixel shade = at(p, shown(f, dark));
    EXPECT_NEAR(shade.r, encoded_byte(0.1), 3);
    EXPECT_NEAR(shade.g, encoded_byte(0.05), 3);
  }
  EXPECT_GT(at(p, shown(f, {0, 3, 0})).b, 100) << "the ball stands before it";
}

TEST(RenderSetting, TheFloorFadesIntoTheBackground) {
  Frame f = looking({0, 1, 0}, {0, 1, -1});
  f.background = Vec3{0, 0, 1}, f.surroundings.ground = Vec3{0.5, 0.5, 0.5};
  const Picture p = draw(f);
  for (int y = 0; y < 50; ++y) EXPECT_EQ(pixel(p, 50, y), (Pixel{0, 0, 255, 255})) << y;
  for (int y = 51; y < 100; ++y) {
    EXPECT_GE(pixel(p, 50, y).r, pixel(p, 50, y - 1).r) << y;
    EXPECT_LE(pixel(p, 50, y).b, pixel(p, 50, y - 1).b) << y;
  }
  EXPECT_NEAR(pixel(p, 50, 99).r, pixel(p, 50, 99).b, 20);
}

TEST(RenderSetting, TheFloorHidesWhatIsBelowIt) {
  Frame f = looking({0, 4, 8}, {});
  f.surroundings.ground = Vec3{0, 0.5, 0};
  f.items.push_back(item(sphere(1), translation({0, -2, 0}), {1, 0, 0}));
  const Picture p = draw(f);
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x) EXPECT_LT(pixel(p, x, y).r, 5);
  f.items[0].world = translation({0, 1.2, 0});
  EXPECT_EQ(at(draw(f), shown(f, {0, 1.2, 0})), (Pixel{255, 0, 0, 255}));
  // From below there is none.
  Frame below = looking({0, -2, 8}, {0, -2, 0});
  below.surroundings.ground = Vec3{0, 0.5, 0};
  below.items.push_back(item(sphere(1), translation({0, 1, 0}), {1, 0, 0}));
  EXPECT_EQ(at(draw(below), shown(below, {0, 1, 0})), (Pixel{255, 0, 0, 255}));
  EXPECT_EQ(pixel(draw(below), 10, 10), (Pixel{0, 0, 0, 255}));
}

TEST(RenderSetting, AnOrthographicCameraSeesTheFloorToo) {
  Frame f = frame();
  f.camera.world = look_at({0, 10, 0}, {0, 0, -0.001});
  f.surroundings.ground = Vec3{0.5, 0, 0}, f.surroundings.flat = true;
  expect_near(pixel(draw(f), 50, 50), {0.5, 0, 0}, 2);
}

TEST(RenderSetting, TheSkyIsBlueAboveAndPaleAtTheHorizon) {
  Frame f = looking({0, 1, 0}, {0, 1, -1});
  f.background = Vec3{1, 0, 0}, f.surroundings.sky = true;
  const Picture p = draw(f);
  const Pixel high = pixel(p, 50, 0), low = pixel(p, 50, 48);
  EXPECT_GT(high.b, high.r + 60);
  EXPECT_GT(low.r, high.r + 60);
  for (int y = 1; y < 50; ++y) EXPECT_GE(pixel(p, 50, y).r, pixel(p, 50, y - 1).r) << y;
  f.surroundings.exposure = -1;
  const Picture darker = draw(f);
  EXPECT_NEAR(decoded(pixel(darker, 50, 20).g / 255.0), decoded(pixel(p, 50, 20).g / 255.0) / 2, 0.01);
}

// The sky as metals show it: seven tenths of the way to grey of the same luminance.
Vec3 paler(Vec3 c) {
  const double grey = dot(c, {0.2126, 0.7152, 0.0722});
  return c + 0.7 * (Vec3{grey, grey, grey} - c);
}

// A mirror of nine tenths that lies below a camera, and the camera turned to where the mirror shows what it does.
TEST(RenderSetting, MetalMirrorsTheSky) {
  Frame down = looking({0, 2, 2}, {0, 0, 0}), up = looking({0, 2, 2}, {0, 4, 0});
  for (Frame* f : {&down, &up}) f->surroundings.sky = true, f->lights = {lamp({0, 50, 0}, 1)};
  down.items.push_back(item(square(), look_at({}, {0, -1, 0}) * scaling({9, 9, 1}), {0.9, 0.9, 0.9}, Material::metal));
  down.items[0].shininess = 1;
  const Pixel mirrored = pixel(draw(down), 50, 50), sky = pixel(draw(up), 50, 50);
  expect_near(mirrored, 0.9 * paler({decoded(sky.r / 255.0), decoded(sky.g / 255.0), decoded(sky.b / 255.0)}), 3);
  EXPECT_GT(mirrored.b, mirrored.r + 15);
}

// What light comes to in linear sRGB where each of three primaries is mirrored by itself, from the primaries' places in
// the CIE's diagram and the white D65.
Mat4 to_xyz(const std::array<Vec3, 3>& primaries) {
  const auto bright = [](Vec3 c) { return Vec3{c.x / c.y, 1, (1 - c.x - c.y) / c.y}; };
  Mat4 m;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) m(i, k) = bright(primaries[static_cast<std::size_t>(k)])[i];
  const Vec3 share = transform_vector(*inverse(m), bright({0.3127, 0.3290, 0}));
  return m * scaling(share);
}
Vec3 mirrored_in_wide_primaries(Vec3 light, Vec3 metal) {
  const Mat4 srgb = to_xyz({Vec3{0.64, 0.33, 0}, {0.30, 0.60, 0}, {0.15, 0.06, 0}});
  const Mat4 wide = to_xyz({Vec3{0.708, 0.292, 0}, {0.170, 0.797, 0}, {0.131, 0.046, 0}});
  const Mat4 there = *inverse(wide) * srgb;
  const Vec3 a = transform_vector(there, light), b = transform_vector(there, metal);
  return transform_vector(*inverse(there), {a.x * b.x, a.y * b.y, a.z * b.z});
}

TEST(RenderSetting, GoldUnderABlueSkyIsGold) {
  const Vec3 gold{1, decoded(215 / 255.0), 0};
  for (const double height : {0.5, 1.0, 2.0, 4.0}) {  // the mirror shows the sky at different heights
    Frame down = looking({0, height, 2}, {0, 0, 0}), up = looking({0, height, 2}, {0, 2 * height, 0});
    for (Frame* f : {&down, &up}) f->surroundings.sky = true, f->lights = {lamp({0, 50, 0}, 1)};
    down.items.push_back(item(square(), look_at({}, {0, -1, 0}) * scaling({9, 9, 1}), gold, Material::metal));
    down.items[0].shininess = 1;
    const Pixel seen = pixel(draw(down), 50, 50), sky = pixel(draw(up), 50, 50);
    const Vec3 light{decoded(sky.r / 255.0), decoded(sky.g / 255.0), decoded(sky.b / 255.0)};
    if (height > 1)
      expect_near(seen, mirrored_in_wide_primaries(paler(light), gold), 4);  // else it mirrors like glass, too
    EXPECT_GT(decoded(seen.r / 255.0), 0.9 * decoded(seen.g / 255.0)) << height;
    EXPECT_GT(seen.g, seen.b + 30) << height;
  }
}

// Hue in degrees.
double hue(const Pixel& p) {
  const double high = std::max({p.r, p.g, p.b}), low = std::min({p.r, p.g, p.b}), span = std::max(high - low, 1.0);
  const double sixth = p.r == high ? (p.g - p.b) / span : p.g == high ? 2 + (p.b - p.r) / span : 4 + (p.r - p.g) / span;
  return 60 * sixth;
}

// A ball of gold as in docs/look.md, in both styles.
TEST(RenderSetting, ABallOfGoldHasTheHueOfGoldAllOver) {
  for (const char* style : {"shaded", "traced"}) {
    Frame f = looking({0, 2.4, 4}, {0, 1, 0});
    f.surroundings.sky = true, f.surroundings.ground = Vec3{0.43, 0.37, 0.26};
    Light sun;
    sun.sun = true, sun.direction = normalize(Vec3{4, -6, -5});
    f.lights = {sun};
    f.items = {item(sphere(1), translation({0, 1, 0}), {1, decoded(215 / 255.0), 0}, Material::metal)};
    f.items[0].shininess = 0.85;
    const Picture p = draw(f, {200, 200, 16, style});
    int count = 0;
    for (int y = 0; y < 200; ++y)
      for (int x = 0; x < 200; ++x) {
        const Vec3 way = transform_vector(f.camera.world, {(x + 0.5 - 100) / 100, (99.5 - y) / 100, -1});
        const Vec3 off = Vec3{0, 1, 0} - translation_of(f.camera.world);
        const double along = dot(off, normalize(way)), miss = std::sqrt(dot(off, off) - along * along);
        const Pixel is = pixel(p, x, y);
        if (miss > 0.9 || is.r > 230) continue;  // not at the rim, which mirrors everything, nor in the highlight
        ++count;
        EXPECT_GE(hue(is), 38) << style << ' ' << x << ' ' << y;
        EXPECT_LE(hue(is), 55) << style << ' ' << x << ' ' << y;
      }
    EXPECT_GT(count, 1000);
  }
}

// A mirror that stands on the floor shows at (0 0.5 0) what is at (0 0 2).
TEST(RenderSetting, MetalMirrorsTheFloor) {
  Frame f = looking({0, 1, 2}, {0, 0.5, 0});
  f.surroundings.ground = Vec3{0.6, 0.3, 0.1}, f.surroundings.ambient = Vec3{0.3, 0.3, 0.3};
  Light sun;
  sun.sun = true, sun.direction = {0, -1, 0}, sun.color = {0.6, 0.6, 0.6};
  f.lights = {sun};
  f.items.push_back(item(square(), scaling({4, 4, 1}), {0.9, 0.9, 0.9}, Material::metal));
  f.items[0].shininess = 1;
  const Vec3 lit = (0.3 + 0.8 * 0.6) * 0.9 * *f.surroundings.ground;
  expect_near(pixel(draw(f), 50, 50), lit, 4);
  f.items[0].material = Material::plastic;
  EXPECT_GT(std::abs(pixel(draw(f), 50, 50).b - encoded_byte(lit.z)), 40) << "plastic does not";
}

TEST(RenderSetting, WhatSurroundsIsComparedToo) {
  const auto keeping = renderer(square_picture);
  Frame f = floor_with_ball();
  Picture p;
  const auto check = [&](const char* what) {
    ASSERT_TRUE(keeping->render(f, p));
    EXPECT_EQ(p.rgba, draw(f, square_picture).rgba) << what;
  };
  check("at first");
  f.surroundings.ground = Vec3{0.1, 0.1, 0.1}, check("ground");
  f.surroundings.ground.reset(), check("no ground");
  f.surroundings.sky = true, check("sky");
  f.surroundings.sky = false, f.surroundings.below = Vec3{1, 1, 1}, check("below");
  f.surroundings.fog = {{1, 1, 1}, 1, 20}, check("fog");
  f.surroundings.ambient = Vec3{1, 0, 0}, check("ambient");
  f.surroundings.exposure = 1, check("exposure");
  f.surroundings.flat = true, check("flat");
}

}  // namespace
}  // namespace betwixt
