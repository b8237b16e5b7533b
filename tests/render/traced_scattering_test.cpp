// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How the style `traced` scatters light at glass and at bumps: with the law of refraction, with sums over all
// directions, and in rooms where all is white.
#include <cmath>

#include "render/physical_scenes.h"
#include "render/physical_tracer.h"

namespace betwixt::traced {
namespace {

using namespace physical_scenes;

SurfacePoint point_of(const Finish& f, bool inside = false) {
  SurfacePoint p;
  p.normal = p.face = {0, 0, 1};
  p.color = {1, 1, 1}, p.finish = &f, p.roughness = f.roughness, p.metalness = f.metalness;
  p.solid = true, p.inside = inside;
  return p;
}

Finish glass(double roughness, double thickness = 1) {
  Finish f;
  f.transmission = 1, f.ior = 1.5, f.roughness = roughness, f.thickness = thickness;
  return f;
}

Vec3 at_angle(double sine) { return {sine, 0, std::sqrt(1 - sine * sine)}; }

// Where light goes that reaches a surface, as shares.
struct Shares {
  double reflected = 0, through = 0;
};
Shares shares_of(const SurfacePoint& p, Vec3 toward, std::uint32_t samples = 4096) {
  const Scattering s(p, toward, 0);
  Shares sum;
  for (std::uint32_t k = 0; k < samples; ++k) {
    PixelSampler sampler(7, k, samples);
    const Scattering::Sample next = s.sample(sampler);
    (next.through ? sum.through : sum.reflected) += next.weight.x / samples;
  }
  return sum;
}

// What value() says, summed over all directions on the side of `n`.
double sum_of_values(const Scattering& s, Vec3 n) {
  constexpr int rings = 400, around = 400;
  const Vec3 x = unit(cross(n, Vec3{0.1, 1, 0.2})), y = cross(n, x);
  double sum = 0;
  for (int j = 0; j < rings; ++j)
    for (int i = 0; i < around; ++i) {
      const double z = (j + 0.5) / rings, r = std::sqrt(1 - z * z), turn = 2 * pi * (i + 0.5) / around;
      sum += s.value(r * std::cos(turn) * x + r * std::sin(turn) * y + z * n).x;
    }
  return 2 * sum / (rings * around);
}

// Light on the same path is reflected alike from both sides, nearly as Fresnel's equations say. Where the law of
// refraction has no angle, all of it is.
TEST(Scattering, GlassReflectsAlikeFromBothSides) {
  const Finish f = glass(0);
  for (const double outside : {0.1, 0.4, 0.7, 0.9, 0.97}) {
    const double inside = outside / 1.5, c = std::sqrt(1 - outside * outside), d = std::sqrt(1 - inside * inside);
    const double across = (c - 1.5 * d) / (c + 1.5 * d), along = (1.5 * c - d) / (1.5 * c + d);
    const double exact = (across * across + along * along) / 2;
    const double from_outside = shares_of(point_of(f), at_angle(outside)).reflected,
                 from_inside = shares_of(point_of(f, true), at_angle(inside)).reflected;
    EXPECT_NEAR(from_outside, from_inside, 0.01) << outside;
    EXPECT_NEAR(from_inside, exact, 0.035) << outside;
  }
  for (const double inside : {0.7, 0.9, 0.99}) {
    const Shares all = shares_of(point_of(f, true), at_angle(inside));
    EXPECT_NEAR(all.reflected, 1, 0.01) << inside;
    EXPECT_NEAR(all.through, 0, 0.01) << inside;
  }
}

TEST(Scattering, GlassSwallowsNoLight) {
  for (const bool inside : {false, true})
    for (const double thickness : {0.0, 1.0})
      for (const double roughness : {0.0, 0.2, 0.5, 1.0})
        for (const double sine : {0.0, 0.5, 0.8, 0.99}) {
          const Finish f = glass(roughness, thickness);
          const Shares all = shares_of(point_of(f, inside), at_angle(sine));
          EXPECT_NEAR(all.reflected + all.through, 1, 0.01) << inside << thickness << ' ' << roughness << ' ' << sine;
        }
}

// Paths that are chosen by the density bring what a sum over all directions gives.
TEST(Scattering, ItsSamplesBringWhatItsValuesSay) {
  Finish metal;
  metal.metalness = 1;
  for (const double roughness : {0.3, 0.7})
    for (const double tilt : {0.0, 0.5, 0.8})
      for (Finish f : {glass(roughness), metal, Finish()}) {
        f.roughness = roughness;
        SurfacePoint p = point_of(f);
        p.color = {0.6, 0.6, 0.6};
        if (tilt > 0) p.smooth = p.normal, p.normal = at_angle(tilt);
        const Scattering s(p, at_angle(-0.3), 0);
        constexpr std::uint32_t samples = 16384;
        double sum = 0;
        for (std::uint32_t k = 0; k < samples; ++k) {
          PixelSampler sampler(3, k, samples);
          const Scattering::Sample next = s.sample(sampler);
          if (next.density > 0) sum += next.weight.x / samples;
        }
        EXPECT_NEAR(sum, sum_of_values(s, {0, 0, 1}), 0.01) << roughness << ' ' << tilt << ' ' << f.metalness;
      }
}

// However a picture of normals bends them, nothing of the light goes behind the surface or is lost there.
TEST(Scattering, BumpsOfWhiteMetalSwallowNoLight) {
  Finish f;
  f.metalness = 1;
  for (const double roughness : {0.2, 0.5})
    for (const double tilt : {-0.6, 0.3, 0.6, 0.9}) {
      f.roughness = roughness;
      SurfacePoint p = point_of(f);
      p.smooth = p.normal, p.normal = at_angle(tilt);
      const Scattering s(p, {0, 0, 1}, 0);
      EXPECT_NEAR(sum_of_values(s, {0, 0, 1}), 1, 0.02) << roughness << ' ' << tilt;
      EXPECT_EQ(sum_of_values(s, {0, 0, -1}), 0);
    }
}

// White walls, and things of glass before them: in light that is even everywhere, nothing is seen.
TEST(Scattering, GlassBeforeWhiteWallsIsNotSeenInEvenLight) {
  Finish dull;
  dull.roughness = 1, dull.specular = 0;
  Item wall = item(square(), translation({0, 0, -1.2}) * scaling({8, 8, 1}), {1, 1, 1}, Material::plastic);
  wall.finish = std::make_shared<const Finish>(dull);
  for (const double roughness : {0.0, 0.35}) {
    const LinearPicture ball =
        styled_light(frame_of({wall, finished(glass(roughness), {1, 1, 1}, 0.8)}, even_sky(0.5F)), "traced", 24, 256);
    EXPECT_NEAR(mean_of(ball, 0, 24).x, 0.5, 0.005) << roughness;
    EXPECT_NEAR(mean_of(ball, 9, 15).x, 0.5, 0.01) << roughness;
    Item pane = item(square(), scaling({1.5, 1.5, 1}), {1, 1, 1}, Material::plastic);
    pane.finish = std::make_shared<const Finish>(glass(roughness, 0));
    const LinearPicture flat = styled_light(frame_of({wall, pane}, even_sky(0.5F)), "traced", 24, 256);
    EXPECT_NEAR(mean_of(flat, 0, 24).x, 0.5, 0.005) << roughness;
  }
}

// A frosted pane blurs what is behind it: before the border of black and white it shows grey.
TEST(Scattering, FrostedPanesBlur) {
  const auto right_of_border = [](double roughness) {
    std::vector<Item> items;
    for (const int side : {-1, 1}) {
      items.push_back(item(square(), translation({4.0 * side, 0, -2}) * scaling({8, 8, 1}),
                           side < 0 ? Vec3{} : Vec3{0.8, 0.8, 0.8}, Material::glow));
    }
    Item pane = item(square(), scaling({3, 3, 1}), {1, 1, 1}, Material::plastic);
    pane.finish = std::make_shared<const Finish>(glass(roughness, 0));
    items.push_back(pane);
    return light_at(styled_light(frame_of(items, even_sky(0)), "traced", 24, 256), 13, 12).x;
  };
  EXPECT_NEAR(right_of_border(0), 0.96 * 0.8, 0.02);
  EXPECT_LT(right_of_border(0.5), 0.6);
  EXPECT_GT(right_of_border(0.5), 0.35);
}

}  // namespace
}  // namespace betwixt::traced
