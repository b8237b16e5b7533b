// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The style `shaded` where objects overlap: shadows in shadows, and glass behind what stands in front of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/physical_scenes.h"

namespace betwixt {
namespace {

using namespace physical_scenes;

// A floor from above, 100 pixels a metre; x of the world is right, z is down. Of two plates under a soft sun, the low
// one shades x < 0.5, and the high one z > 0. Neither is above the part of the floor that is looked at.
struct Plates {
  bool low = false, high = false;
};
std::vector<std::vector<double>> light_under(Plates plates) {
  Frame f;
  f.camera.world = translation({0.5, 20, 0}) * rotation(axis_angle({1, 0, 0}, -pi / 2));
  f.camera.orthographic = true, f.camera.height = 1;
  f.background = Vec3{}, f.surroundings.ambient = Vec3{};
  const Mat4 lying = rotation(axis_angle({1, 0, 0}, -pi / 2));
  const auto put = [&](Vec3 middle, double x, double y, bool there) {
    f.items.push_back(
        item(square(), translation(middle) * lying * scaling({x, y, 1}), {0.5, 0.5, 0.5}, Material::matte));
    f.items.back().casts = there;
  };
  put({0, 0, 0}, 60, 60, false);
  put({-4, 0.5, 0}, 8, 16, plates.low);
  put({-5, 4, 4}, 6, 8, plates.high);
  Light sun;
  sun.sun = true, sun.direction = normalize(Vec3{1, -1, 0}), sun.casting = Casting::soft;
  f.lights = {sun};
  const Picture p = draw(f, {100, 100, 4, "shaded"});
  std::vector<std::vector<double>> rows(100);
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x) rows[static_cast<std::size_t>(y)].push_back(decoded(pixel(p, x, y).g / 255.0));
  return rows;
}

TEST(RenderOverlap, ShadowsOfOneLampAreAsDarkAsTheDarkerOfThem) {
  const auto lit = light_under({}), low = light_under({.low = true}), high = light_under({.high = true}),
             both = light_under({.low = true, .high = true});
  double lighter = 0, darker = 0;
  for (std::size_t y = 10; y < 48; ++y)  // z < 0: the high plate hides nothing of the low one from the sun
    for (std::size_t x = 10; x < 95; ++x) {
      // A map of both plates is coarser than one of the low plate, so edges may lie beside each other by two pixels.
      double most = 0, least = 1;
      for (std::size_t beside = x - 2; beside <= x + 2; ++beside) {
        const double by_low = low[y][beside] / lit[y][beside], by_high = high[y][beside] / lit[y][beside];
        most = std::max(most, std::min(by_low, by_high));
        least = std::min(least, std::max(by_low + by_high - 1, 0.0));  // no part of the sun's disc is hidden twice
      }
      lighter = std::max(lighter, both[y][x] / lit[y][x] - most),
      darker = std::max(darker, least - both[y][x] / lit[y][x]);
    }
  EXPECT_LT(lighter, 0.06);
  EXPECT_LT(darker, 0.03);
}

// A block of glass that stands askew before nothing, and a glowing bar: red if it is in front, green if behind.
Frame block_and_bar(bool glass, double z, Vec3 color) {
  Finish clear;
  clear.transmission = 1, clear.ior = 1.5, clear.roughness = 0, clear.thickness = 1;
  auto box = std::make_shared<Shape>();
  box->kind = Kind::box, box->size = {1.4, 1.4, 0.8};
  Item block = item(box, rotation(axis_angle({0, 1, 0}, 0.6)), {1, 1, 1}, Material::plastic);
  block.finish = std::make_shared<const Finish>(clear);
  Frame f = frame_of({item(square(), translation({0, 0, z}) * scaling({0.12, 1, 1}), color)}, even_sky(0));
  if (glass) f.items.push_back(block);
  return f;
}

TEST(RenderOverlap, GlassDoesNotShowWhatStandsBeforeIt) {
  for (const int samples : {1, 4}) {
    const auto light = [&](bool glass, double z, Vec3 color) {
      return styled_light(block_and_bar(glass, z, color), "shaded", 96, samples);
    };
    const LinearPicture alone = light(false, 1.2, {1, 0, 0}), with = light(true, 1.2, {1, 0, 0});
    double most = 0;
    for (int y = 0; y < 96; ++y)
      for (int x = 1; x < 95; ++x)
        if (light_at(alone, x - 1, y).x + light_at(alone, x, y).x + light_at(alone, x + 1, y).x == 0)
          most = std::max(most, light_at(with, x, y).x);
    EXPECT_LT(most, 0.1) << samples;
    // What is behind is seen through it, and in another place.
    const LinearPicture behind = light(false, -1.5, {0, 1, 0}), bent = light(true, -1.5, {0, 1, 0});
    double moved = 0, seen = 0;
    for (int x = 0; x < 96; ++x)
      if (light_at(behind, x, 48).y == 0) moved += light_at(bent, x, 48).y, seen += light_at(with, x, 48).y;
    EXPECT_GT(moved, 2) << samples;
    EXPECT_LT(seen, 0.1) << samples;
  }
}

// A block of glass that faces us, before an even background: its side walls are seen through its front, since they
// mirror the sky inside.
TEST(RenderOverlap, BlocksOfGlassHaveWallsBeforeAnEvenBackground) {
  Frame f = block_and_bar(true, 100, {});
  f.items.erase(f.items.begin());
  f.items[0].world = Mat4{};
  f.surroundings.environment = even_sky(1), f.background = Vec3{0.2, 0.2, 0.2};
  const LinearPicture p = styled_light(f, "shaded", 128);
  int last = 64;  // of the block, in the middle row
  while (last < 127 && light_at(p, last + 1, 64).x > 0.21) ++last;
  ASSERT_LT(last, 120);
  EXPECT_GT(light_at(p, last - 2, 64).x, light_at(p, 64, 64).x + 0.1);
  EXPECT_NEAR(light_at(p, 80, 64).x, light_at(p, 64, 64).x, 0.02);
}

}  // namespace
}  // namespace betwixt
