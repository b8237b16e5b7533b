// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Surfaces with finishes, skies and lamps with areas, in the styles that have light.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "render/physical_scenes.h"
#include "render/sky_light.h"
#include "scene/materials.h"
#include "scene/patterns.h"

namespace betwixt {
namespace {

using namespace physical_scenes;

// A white wall before the camera, 16 pixels a metre in a picture of 64 by 64, without light.
Frame dull_wall() {
  Finish dull;
  dull.roughness = 1, dull.specular = 0;
  Item wall = item(square(), scaling({8, 8, 1}), {1, 1, 1}, Material::plastic);
  wall.finish = std::make_shared<const Finish>(dull);
  Frame f = frame_of({wall}, {});
  f.camera.orthographic = true, f.camera.height = 4;
  f.surroundings.ambient = Vec3{};
  return f;
}

// In light that is equal from everywhere, a body that swallows none shows that light, whatever its finish is.
TEST(Physical, WhiteBodiesAreNotSeenInEvenLight) {
  for (const std::string style : {"shaded", "traced"})
    for (const double metalness : {0.0, 1.0})
      for (const double roughness : {0.0, 0.3, 0.6, 1.0}) {
        Finish f;
        f.metalness = metalness, f.roughness = roughness;
        const LinearPicture p =
            styled_light(frame_of({finished(f, {1, 1, 1})}, even_sky(0.5F)), style, 32, style == "traced" ? 256 : 0);
        const Vec3 is = mean_of(p, 12, 20);
        for (int i = 0; i < 3; ++i)
          EXPECT_NEAR(is[i], 0.5, style == "traced" ? 0.01 : 0.005) << style << ' ' << metalness << ' ' << roughness;
      }
}

// A picture of normals that lean all alike, and a sky of which one half is bright. Of a bright half, a dull surface
// whose normal is at the angle a to its middle gets (1 + cos a) / 2. It is so in the first picture of a renderer too.
TEST(Physical, NormalsOfPicturesLeanAsTheySay) {
  const auto half_sky = [](bool upper) {
    auto picture = std::make_shared<LinearPicture>();
    picture->width = 64, picture->height = 32;
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 64; ++x)
        for (int k = 0; k < 4; ++k) picture->rgba.push_back((upper ? y < 16 : x >= 16 && x < 48) ? 1.F : 0.F);
    Sky sky;
    sky.kind = Sky::picture, sky.light = picture;
    return sky;
  };
  const auto light = [&](const std::string& style, int red, int green, bool upper, double width) {
    auto leaning = std::make_shared<Picture>();
    leaning->width = leaning->height = 1;
    leaning->rgba = {static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green), 218, 255};
    Finish dull;
    dull.roughness = 1, dull.specular = 0, dull.normals = leaning;
    Item wall = item(square(), scaling({width, 8, 1}), {1, 1, 1}, Material::plastic);
    wall.finish = std::make_shared<const Finish>(dull);
    return mean_of(styled_light(frame_of({wall}, half_sky(upper)), style, 32, style == "traced" ? 64 : 4), 12, 20).x;
  };
  for (const std::string style : {"shaded", "traced"}) {
    // Some of the light that a leaning normal faces comes from behind the wall: traced, it does not arrive.
    const double off = style == "traced" ? 0.1 : 0.03;
    EXPECT_NEAR(light(style, 128, 218, true, 8), 0.854, off) << style;
    EXPECT_NEAR(light(style, 128, 38, true, 8), 0.146, off) << style;
    EXPECT_NEAR(light(style, 218, 128, false, 8), 0.854, off) << style;   // the bright half is that about x
    EXPECT_NEAR(light(style, 218, 128, false, -8), 0.146, off) << style;  // a mirrored picture leans the other way
  }
}

// Dull bodies give their share back.
TEST(Physical, DullBodiesShowTheirColor) {
  Finish f;
  f.roughness = 1, f.specular = 0;
  for (const std::string style : {"shaded", "traced"}) {
    const Vec3 is = mean_of(
        styled_light(frame_of({finished(f, {0.8, 0.4, 0.1})}, even_sky(0.5F)), style, 32, style == "traced" ? 256 : 0),
        14, 18);
    EXPECT_NEAR(is.x, 0.4, 0.006) << style;
    EXPECT_NEAR(is.y, 0.2, 0.004) << style;
    EXPECT_NEAR(is.z, 0.05, 0.002) << style;
  }
}

// The light of a rectangle on a small surface that is parallel to it, opposite its middle: the closed form of books on
// radiative transfer.
double share_of_rectangle(double half_width, double half_height, double distance) {
  const double x = half_width / distance, y = half_height / distance;
  const auto term = [](double a, double b) { return a / std::sqrt(1 + a * a) * std::atan(b / std::sqrt(1 + a * a)); };
  return 4 * (term(x, y) + term(y, x)) / (2 * pi);
}

TEST(Physical, AreasLightAsTheirShareOfTheSkyIs) {
  for (const std::string style : {"shaded", "traced"})
    for (const double width : {0.5, 2.0, 6.0}) {
      Finish dull;
      dull.roughness = 1, dull.specular = 0;
      Item wall = item(square(), scaling({0.2, 0.2, 1}), {1, 1, 1}, Material::plastic);
      wall.finish = std::make_shared<const Finish>(dull);
      Frame f = frame_of({wall}, {});
      f.camera.fov = 0.02;
      f.surroundings.ambient = Vec3{};
      Light l;
      l.shape = LightShape::rectangle, l.position = {0, 0, 2}, l.direction = {0, 0, -1}, l.width = width, l.height = 1,
      l.range = 8;
      l.casting = Casting::off;
      f.lights = {l};
      const double radiance = 0.8 * pi * 2 * 2 / width;  // as bright as a sun at a quarter of the range
      const double expected = radiance * share_of_rectangle(width / 2, 0.5, 2);
      const Vec3 is = mean_of(styled_light(f, style, 16, style == "traced" ? 256 : 0), 4, 12);
      EXPECT_NEAR(is.x / expected, 1, style == "traced" ? 0.02 : 0.06) << style << ' ' << width;
    }
}

TEST(Physical, ConesEndWhereTheyShould) {
  for (const std::string style : {"shaded", "traced"}) {
    Frame f = dull_wall();
    Light l;
    l.position = {0, 0, 2}, l.direction = {0, 0, -1}, l.cone = 2 * std::atan(0.5), l.cone_edge = 0,
    l.casting = Casting::off;
    f.lights = {l};
    const LinearPicture p = styled_light(f, style, 64);
    EXPECT_GT(light_at(p, 32, 32).x, 0.5) << style;
    EXPECT_GT(light_at(p, 32 + 14, 32).x, 0.3) << style;  // the cone's circle has a radius of 1 m: 16 pixels
    EXPECT_LT(light_at(p, 32 + 18, 32).x, 0.01) << style;
  }
}

// Left is red and the upper half is blue, seen from behind the lamp.
TEST(Physical, AConeProjectsItsPictureUpright) {
  auto slide = std::make_shared<Picture>(Picture{16, 16, std::vector<std::uint8_t>(16 * 16 * 4, 255)});
  for (std::size_t y = 0; y < 16; ++y)
    for (std::size_t x = 0; x < 16; ++x) {
      std::uint8_t* const c = &slide->rgba[4 * (16 * y + x)];
      c[0] = x < 8 ? 255 : 0, c[1] = 0, c[2] = y < 8 ? 255 : 0;
    }
  for (const std::string style : {"shaded", "traced"}) {
    Frame f = dull_wall();
    Light l;
    l.position = {0, 0, 2}, l.direction = {0, 0, -1}, l.across = {1, 0, 0};
    l.cone = 2 * std::atan(0.5), l.cone_edge = 0, l.casting = Casting::off, l.picture = slide;
    f.lights = {l};
    const LinearPicture p = styled_light(f, style, 64);
    const Vec3 upper_left = light_at(p, 26, 26), lower_right = light_at(p, 38, 38), lower_left = light_at(p, 26, 38);
    EXPECT_GT(upper_left.x, 0.3) << style;
    EXPECT_GT(upper_left.z, 0.3) << style;
    EXPECT_LT(lower_right.x + lower_right.z, 0.02) << style;
    EXPECT_GT(lower_left.x, 0.3) << style;
    EXPECT_LT(lower_left.z, 0.02) << style;
  }
}

// A film with a lamp and without a sky: metals mirror a dim studio, and are not black beside the lamp's highlight.
TEST(Physical, MetalIsNotBlackBesideALamp) {
  Finish f;
  f.metalness = 1, f.roughness = 0.2;
  Vec3 mean[2];
  for (const bool traced : {false, true}) {
    Frame frame = frame_of({finished(f, {1, 0.71, 0.29})}, {});
    Light lamp;
    lamp.position = {4, 8, 6}, lamp.range = 40;
    frame.background = std::nullopt;
    frame.lights = {lamp};
    const LinearPicture p = styled_light(frame, traced ? "traced" : "shaded", 64);
    double dark = 0, all = 0;
    for (int y = 14; y < 50; ++y)
      for (int x = 14; x < 50; ++x) {
        const Vec3 c = light_at(p, x, y);
        mean[traced ? 1 : 0] = mean[traced ? 1 : 0] + 1.0 / (36 * 36) * c;
        ++all, dark += c.x < 0.02 ? 1 : 0;
      }
    EXPECT_LT(dark, 0.02 * all) << traced;
  }
  for (const Vec3& m : mean) {
    EXPECT_GT(m.x, 0.1);
    EXPECT_GT(m.x, 1.3 * m.y);
    EXPECT_GT(m.y, 1.8 * m.z);
  }
  EXPECT_NEAR(mean[0].x, mean[1].x, 0.12 * mean[1].x);
}

// The text of the patterns is compiled twice, as C++ and as GLSL: both styles must show the same colours.
TEST(Physical, PatternsAreTheSameInBothLanguages) {
  for (const MaterialRow& row : materials()) {
    if (row.finish.pattern == Pattern::none) continue;
    Finish f = row.finish;
    f.metalness = 0, f.roughness = 1, f.specular = 0, f.pattern_bumps = 0, f.clearcoat = 0, f.sheen = {};
    Item wall = item(square(), scaling({2, 2, 1}), row.color, Material::plastic);
    wall.finish = std::make_shared<const Finish>(f);
    Frame frame = frame_of({wall}, even_sky(1));
    frame.camera.orthographic = true, frame.camera.height = 0.4;
    const LinearPicture a = styled_light(frame, "shaded", 24, 16), b = styled_light(frame, "traced", 24, 64);
    double off = 0, sum = 0;
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 24; ++x)
        for (int i = 0; i < 3; ++i)
          off += std::abs(light_at(a, x, y)[i] - light_at(b, x, y)[i]), sum += light_at(b, x, y)[i];
    EXPECT_LT(off / sum, 0.12) << row.word;
  }
}

// Squares of half a metre: moved by one of them, the two colours change places.
TEST(Physical, PatternsCanBeMoved) {
  for (const char* style : {"shaded", "traced"}) {
    const auto drawn = [&](double move) {
      Finish f;
      f.roughness = 1, f.specular = 0, f.pattern = Pattern::checker, f.second = {0.05, 0.05, 0.05}, f.move_x = move;
      Item wall = item(square(), scaling({2, 2, 1}), {0.8, 0.8, 0.8}, Material::plastic);
      wall.finish = std::make_shared<const Finish>(f);
      Frame frame = frame_of({wall}, even_sky(1));
      frame.camera.orthographic = true, frame.camera.height = 0.8;
      return styled_light(frame, style, 16, 16);
    };
    const LinearPicture a = drawn(0), b = drawn(1), c = drawn(0.5);
    for (int y : {2, 13})
      for (int x : {2, 13}) {
        EXPECT_NEAR(light_at(a, x, y).x, light_at(b, x, y).x, 0.05) << style;
        EXPECT_NEAR(light_at(a, x, y).x + light_at(c, x, y).x, 0.85, 0.1) << style;
      }
  }
}

// From afar, joints are as wide as from nearby, and pixels differ no more than the parts of the wall that they cover.
TEST(Physical, PatternsWithJointsShowTheirMeanFromAfar) {
  for (const std::string word : {"bricks", "tiles", "parquet"}) {
    const auto row =
        std::find_if(materials().begin(), materials().end(), [&](const auto& r) { return r.word == word; });
    ASSERT_NE(row, materials().end()) << word;
    const auto at = [&](double x, double y, double width) {
      return pattern_at(row->finish, row->color, {x, y, 0.3}, {0, 0, 1}, width);
    };
    for (const double width : {0.01, 0.03, 0.06}) {
      double mean = 0, fine_mean = 0, off = 0, spread = 0;
      constexpr int pixels = 24, parts = 12;
      std::vector<double> coarse, fine;
      for (int k = 0; k < pixels * pixels; ++k) {
        const double x = (k % pixels) * width * 1.37, y = (k / pixels) * width * 1.37;
        coarse.push_back(at(x, y, width).height), fine.push_back(0);
        for (int i = 0; i < parts * parts; ++i) {
          const double dx = (i % parts + 0.5) / parts - 0.5, dy = (i / parts + 0.5) / parts - 0.5;
          fine.back() += at(x + dx * width, y + dy * width, width / parts).height / (parts * parts);
        }
        mean += coarse.back() / (pixels * pixels), fine_mean += fine.back() / (pixels * pixels);
      }
      for (std::size_t k = 0; k < fine.size(); ++k)
        off += std::pow(coarse[k] - fine[k], 2), spread += std::pow(fine[k] - fine_mean, 2);
      EXPECT_NEAR(mean, fine_mean, 0.06) << word << width;
      EXPECT_LT(off, 0.35 * spread + 0.002 * pixels * pixels) << word << width;
    }
  }
}

// Bumps are as deep in both styles, whatever the size of the object is.
TEST(Physical, BumpsOfLargeThinBoxesAreAsDeepInBothStyles) {
  for (const std::string word : {"bricks", "fabric"}) {
    const auto row =
        std::find_if(materials().begin(), materials().end(), [&](const auto& r) { return r.word == word; });
    Finish f = row->finish;
    f.second = row->color, f.sheen = {};
    auto box = std::make_shared<Shape>();
    box->kind = Kind::box, box->size = {16, 7, 0.4};
    Item wall = item(box, {}, row->color, Material::plastic);
    wall.finish = std::make_shared<const Finish>(f);
    Frame frame = frame_of({wall}, even_sky(0.02F));
    frame.camera.orthographic = true, frame.camera.height = word == "bricks" ? 0.6 : 0.1;
    Light sun;
    sun.sun = true, sun.direction = normalize(Vec3{1, -1, -1}), sun.casting = Casting::off;
    frame.lights = {sun};
    const auto contrast = [&](const std::string& style) {
      const LinearPicture p = styled_light(frame, style, 48, style == "traced" ? 64 : 16);
      double sum = 0, squares = 0;
      for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 48; ++x) sum += light_at(p, x, y).x, squares += std::pow(light_at(p, x, y).x, 2);
      const double mean = sum / (48 * 48);
      return std::sqrt(squares / (48 * 48) - mean * mean) / mean;
    };
    const double shaded = contrast("shaded");
    EXPECT_GT(shaded, 0.1) << word;
    EXPECT_NEAR(contrast("traced") / shaded, 1, 0.2) << word;
  }
}

TEST(Physical, AnyFinishGivesLightThatIsANumber) {
  std::mt19937 random(7);
  const auto share = [&] { return std::uniform_real_distribution<double>(0, 1)(random); };
  const auto extreme = [&] { return random() % 4 == 0 ? 0.0 : random() % 3 == 0 ? 1.0 : share(); };
  auto odd = std::make_shared<Picture>();
  odd->width = odd->height = 1, odd->rgba = {0, 0, 0, 0};
  for (int k = 0; k < 60; ++k) {
    Finish f;
    f.metalness = extreme(), f.roughness = extreme(), f.clearcoat = extreme(), f.clearcoat_roughness = extreme();
    f.sheen = random() % 2 ? Vec3{share(), share(), share()} : Vec3{}, f.sheen_roughness = extreme();
    f.transmission = random() % 2 ? extreme() : 0, f.ior = 1 + 3 * extreme(), f.thickness = random() % 2 ? share() : 0;
    f.emission = random() % 4 ? Vec3{} : Vec3{share(), 1e6, 0}, f.normal_strength = 20 * share() - 10;
    f.pattern = static_cast<Pattern>(random() % 17), f.pattern_bumps = share();
    f.tile_x = random() % 5 ? 1 + 5 * share() : 0, f.tile_y = random() % 5 ? 1 : -1e6, f.turn = 7 * share();
    if (random() % 2) f.normals = f.roughness_map = f.occlusion_map = odd;
    Sky sky;
    sky.kind = static_cast<Sky::Kind>(random() % 5), sky.hour = 24 * share();
    Item thing = finished(f, {share(), share(), 0});
    if (random() % 2) thing.shape = square();
    Frame frame = frame_of({thing}, sky);
    Light l;
    l.shape = static_cast<LightShape>(random() % 3), l.position = {0, 3 * share(), 3},
    l.direction = normalize(Vec3{0, -share(), -1}), l.width = random() % 3 ? share() : 0, l.height = share();
    l.cone = random() % 2 ? 3.2 * share() : 0;
    frame.lights = {l};
    for (const std::string style : {"shaded", "traced"}) {
      const LinearPicture p = styled_light(frame, style, 16, style == "traced" ? 4 : 4);
      for (const float c : p.rgba) ASSERT_TRUE(std::isfinite(c) && c >= 0) << style << ' ' << k;
    }
  }
}

// Glass that does not bend light shows the background, not the sky that lights the scene.
TEST(Physical, GlassShowsTheBackground) {
  Finish clear;
  clear.transmission = 1, clear.ior = 1, clear.specular = 0, clear.roughness = 0;
  for (const double thickness : {0.0, 1.0})
    for (const std::string style : {"shaded", "traced"}) {
      clear.thickness = thickness;
      Frame f = frame_of({finished(clear, {1, 1, 1})}, even_sky(3));
      f.background = Vec3{0.2, 0.6, 0.4};
      const Vec3 even = mean_of(styled_light(f, style), 12, 20);
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(even[i], (*f.background)[i], 0.02) << style << thickness;
      f.surroundings.below = Vec3{1, 0, 0};
      const Vec3 top = *f.background, graded = light_at(styled_light(f, style), 16, 12);
      const double down = 12.5 / 32;
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(graded[i], top[i] + down * ((*f.surroundings.below)[i] - top[i]), 0.03) << style << thickness;
    }
}

TEST(SkyLight, GivesWhatASumOverAllDirectionsGives) {
  for (const Sky::Kind kind : {Sky::studio, Sky::day, Sky::overcast, Sky::sunset}) {
    Sky sky;
    sky.kind = kind;
    const auto light = sky_light_of(sky, {});
    const SkyModel model(sky);
    for (const Vec3 n : {Vec3{0, 1, 0}, Vec3{0, -1, 0}, normalize(Vec3{1, 0.4, -0.3})}) {
      Vec3 sum;
      constexpr int rows = 120;
      for (int j = 0; j < rows; ++j)
        for (int i = 0; i < 2 * rows; ++i) {
          const double y = 1 - (2 * j + 1.0) / rows, r = std::sqrt(1 - y * y), turn = pi * (i + 0.5) / rows;
          const Vec3 d{r * std::cos(turn), y, r * std::sin(turn)};
          sum = sum + 4 * std::max(dot(d, n), 0.0) / (2 * rows * rows) * model.radiance(d);
        }
      const Vec3 is = light->irradiance(n);
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(is[k], sum[k], 0.06 * std::max({sum.x, sum.y, sum.z}) + 0.01) << sky_names[kind];
    }
  }
}

TEST(SkyLight, IsSampledWithTheDensityThatItSays) {
  Sky sky;
  sky.kind = Sky::studio;
  const auto light = sky_light_of(sky, {});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0, 1);
  double all = 0;  // of the sphere: the mean of 1 / density is its area
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const SkyLight::Direction d = light->sample(share(random), share(random), share(random));
    ASSERT_GT(d.density, 0);
    EXPECT_NEAR(d.density, light->density(d.along), 1e-6 * d.density);
    all += 1 / d.density / count;
  }
  EXPECT_NEAR(all, 4 * pi, 0.6);
}

}  // namespace
}  // namespace betwixt
