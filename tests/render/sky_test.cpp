// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Skies and their fog, in the styles that have light.
#include <gtest/gtest.h>

#include <cmath>

#include "render/physical_scenes.h"
#include "render/skies.h"

namespace betwixt {
namespace {

using namespace physical_scenes;

// The light of a low sun beside that of its sky, between the formulas of the IES for clear air and for very clear air.
TEST(Skies, LowSunsAreAsStrongAsTheirSkiesAre) {
  int met = 0;
  for (double hour = 16.8; hour < 17.6; hour += 0.05) {
    Sky sky;
    sky.kind = Sky::day, sky.hour = hour;
    const SkyModel model(sky);
    const double high = model.sun()->toward.y, degrees = std::asin(high) * 180 / pi;
    if (degrees < 6 || degrees > 10.5) continue;
    ++met;
    const auto luminance = [](Vec3 c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; };
    double falling = 0, weights = 0;
    for (int i = 0; i < 64; ++i)
      for (int k = 0; k < 96; ++k) {
        const double y = (i + 0.5) / 64, flat = std::sqrt(1 - y * y), turn = 2 * pi * (k + 0.5) / 96;
        falling += y * luminance(model.radiance({flat * std::cos(turn), y, flat * std::sin(turn)})), weights += y;
      }
    const double is = luminance(model.sun()->color) / (falling / weights);
    const auto formula = [&](double air) { return 127.5 * std::exp(-air / high) / (0.8 + 15.5 * std::sqrt(high)); };
    EXPECT_GT(is, 0.9 * formula(0.21)) << degrees;
    EXPECT_LT(is, 1.1 * formula(0.15)) << degrees;
  }
  EXPECT_GT(met, 3);
}

// A disc, two degrees wide, where the sun is.
TEST(Skies, TheSunIsSeenAsADisc) {
  Sky sky;
  sky.kind = Sky::sunset, sky.turn = 0.3;
  Frame f = frame_of({finished({}, {1, 1, 1}, 1e-3)}, sky);
  f.background.reset();
  const Vec3 sun = SkyModel(sky).sun()->toward;
  const auto [sine, cosine] = sine_cosine(sky.turn);
  const Vec3 toward{cosine * sun.x + sine * sun.z, sun.y, cosine * sun.z - sine * sun.x};
  f.camera.world = look_at({0, 2, 0}, Vec3{0, 2, 0} + toward), f.camera.fov = 8 * pi / 180;
  for (const std::string style : {"shaded", "traced"}) {
    const LinearPicture p = styled_light(f, style, 64, style == "traced" ? 16 : 4);
    EXPECT_GT(light_at(p, 32, 32).x, 20) << style;
    EXPECT_GT(light_at(p, 26, 32).x, 20) << style;  // 0.7 degrees from its middle
    EXPECT_LT(light_at(p, 20, 32).x, 3) << style;   // 1.4
    EXPECT_LT(light_at(p, 32, 20).x, 3) << style;
  }
}

// Fog is before the sky too: all of it at the horizon, and (1 - y)^8 of it where one looks up by y.
TEST(Skies, FogThinsTowardsTheZenith) {
  const Vec3 fog{0.1, 0.2, 0.6};
  Frame f = frame_of({finished({}, {0, 0, 0}, 1e-3)}, even_sky(0.5F));
  f.background.reset(), f.surroundings.fog = {fog, 5, 50};
  f.camera.fov = pi / 2;
  for (const std::string style : {"shaded", "traced"}) {
    const LinearPicture p = styled_light(f, style, 64, style == "traced" ? 4 : 0);
    for (const int row : {0, 8, 16, 24, 28, 31, 40}) {
      const double up = (32 - row - 0.5) / 32, y = std::max(up / std::sqrt(1 + up * up), 0.0);
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(light_at(p, 32, row)[i], 0.5 + std::pow(1 - y, 8) * (fog[i] - 0.5), 0.02) << style << ' ' << row;
    }
  }
}

// What a mirror shows is as foggy as the whole way to it is long.
TEST(Skies, FogIsOnMirroredThingsToo) {
  Finish mirror;
  mirror.metalness = 1, mirror.roughness = 0;
  Item plate = item(square(), scaling({8, 8, 1}), {1, 1, 1}, Material::plastic);
  plate.finish = std::make_shared<const Finish>(mirror);
  const Item wall = item(square(), translation({0, 0, 10}) * scaling({90, 90, 1}), {1, 0, 0}, Material::glow);
  Frame f = frame_of({plate, wall}, even_sky(0));
  f.surroundings.fog = {{0, 0, 1}, 0, 20};  // the wall is 4 + 10 metres away
  const Vec3 is = mean_of(styled_light(f, "traced", 16), 6, 10);
  EXPECT_NEAR(is.x, 0.3, 0.02);
  EXPECT_NEAR(is.z, 0.7, 0.02);
}

// What is mirrored is where it is in the sky: six faces, six colours.
TEST(Skies, SkiesLieAsTheirPictureSays) {
  auto picture = std::make_shared<LinearPicture>();
  picture->width = 64, picture->height = 32;
  picture->rgba.resize(static_cast<std::size_t>(4 * 64 * 32), 0);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x) {
      float* const c = &picture->rgba[static_cast<std::size_t>(4 * (y * 64 + x))];
      c[0] = y < 16 ? 1.0F : 0.0F;             // above
      c[1] = x >= 16 && x < 48 ? 1.0F : 0.0F;  // towards +x, the middle of the picture
      c[2] = x < 32 ? 1.0F : 0.0F;             // towards -z
    }
  Sky sky;
  sky.kind = Sky::picture, sky.light = picture;
  const auto is = [&](Vec3 d) { return SkyModel(sky).radiance(normalize(d)); };
  EXPECT_NEAR(is({0, 1, 0.01}).x, 1, 1e-6);
  EXPECT_NEAR(is({0, -1, 0.01}).x, 0, 1e-6);
  EXPECT_NEAR(is({1, 0.3, 0.2}).y, 1, 1e-6);
  EXPECT_NEAR(is({-1, 0.3, 0.2}).y, 0, 1e-6);
  EXPECT_NEAR(is({0.2, 0.3, -1}).z, 1, 1e-6);
  EXPECT_NEAR(is({0.2, 0.3, 1}).z, 0, 1e-6);
}

}  // namespace
}  // namespace betwixt
