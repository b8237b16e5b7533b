// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares shadow maps with traced shadows, in scenes of 1 mm to 10 km: nothing that is lit is dark (acne), what is in
// the shade is dark as far as the foot of what casts it (gaps), and no light leaks in beside what reaches into another.
#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "render/scenes.h"

namespace betwixt {
namespace {

using namespace scenes;

constexpr int width = 400, height = 225;

std::shared_ptr<const Shape> shape_of(Kind kind, Vec3 size, double radius = 1, double high = 1) {
  auto shape = std::make_shared<Shape>();
  shape->kind = kind, shape->size = size, shape->radius = radius, shape->height = high;
  return shape;
}

// A tube along y from -0.5 to 0.5 with smooth normals and flat ends, of so many sides.
std::shared_ptr<const Shape> tube(int sides, float radius) {
  auto mesh = std::make_shared<Mesh>();
  const auto put = [&](double turn, float y, bool end) {
    const auto c = static_cast<float>(std::cos(turn)), s = static_cast<float>(std::sin(turn));
    mesh->positions.push_back({radius * c, y, radius * s});
    mesh->normals.push_back(end ? std::array<float, 3>{0, y < 0 ? -1.F : 1.F, 0} : std::array<float, 3>{c, 0, s});
    mesh->uvs.push_back({0, 0});
    return static_cast<std::uint32_t>(mesh->positions.size() - 1);
  };
  const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh->triangles.insert(mesh->triangles.end(), {a, b, c});
  };
  for (int k = 0; k < sides; ++k) {
    const double from = 2 * pi * k / sides, to = 2 * pi * (k + 1) / sides;
    const auto a = put(from, -0.5F, false), b = put(to, -0.5F, false), c = put(to, 0.5F, false),
               d = put(from, 0.5F, false);
    face(a, d, c), face(a, c, b);
    if (k + 1 == sides) continue;
    const auto e = put(0, -0.5F, true), f = put(from, -0.5F, true), g = put(to, -0.5F, true);
    const auto h = put(0, 0.5F, true), i = put(from, 0.5F, true), j = put(to, 0.5F, true);
    if (k > 0) face(e, f, g), face(h, j, i);
  }
  mesh->closed = true;
  auto shape = std::make_shared<Shape>();
  shape->kind = Kind::mesh, shape->mesh = mesh;
  return shape;
}

// A ball, a box, a thin post, and a body with an arm that reaches a little into it, on a floor.
Frame standing(double unit, const Light& light, bool close) {
  Frame f;
  f.camera.world = close ? look_at(unit * Vec3{0.9, 1, 2}, unit * Vec3{0.4, 0.88, 0.3})
                         : look_at(unit * Vec3{0.5, 1.8, 6}, unit * Vec3{0.2, 0.6, 0});
  f.camera.fov = close ? 0.25 : 0.9;
  f.background = Vec3{}, f.surroundings.ambient = Vec3{}, f.surroundings.ground = Vec3{0.02, 0.02, 0.02};
  f.surroundings.exposure = 5.5;
  const auto put = [&](std::shared_ptr<const Shape> shape, const Mat4& world) {
    f.items.push_back(item(std::move(shape), scaling({unit, unit, unit}) * world, {0.02, 0.02, 0.02}, Material::matte));
  };
  const auto turned = [](Vec3 axis, double degrees) { return rotation(axis_angle(axis, degrees * pi / 180)); };
  put(sphere(0.5), translation({-1.2, 0.5, 0.6}));
  put(shape_of(Kind::box, {0.9, 0.9, 0.9}), translation({1.8, 0.45, 0}) * turned({0, 1, 0}, 25));
  put(shape_of(Kind::cylinder, {1, 1, 1}, 0.025, 1.2), translation({-2.2, 0.6, -0.4}));
  put(shape_of(Kind::cylinder, {1, 1, 1}, 0.3, 1.2), translation({0.3, 0.6, 0}));
  put(tube(20, 0.09F), translation({0.3, 0.75, 0.36}) * turned({0, 0, 1}, 25) * scaling({1, 0.8, 1}));
  // Two sides of it are nearly parallel to the suns.
  put(shape_of(Kind::box, {0.5, 0.5, 0.5}), translation({-0.3, 0.25, 1.6}) * turned({0, 1, 0}, 59));
  f.lights = {light};
  return f;
}

Light sun(double degrees, Casting casting) {
  Light l;
  const double up = degrees * pi / 180, aside = -0.5;
  l.sun = true, l.casting = casting;
  l.direction = -Vec3{std::cos(up) * std::sin(aside), std::sin(up), std::cos(up) * std::cos(aside)};
  return l;
}
Light lamp_at(double unit, Casting casting) {
  Light l = lamp(unit * Vec3{-2, 4, 5}, 20 * unit);
  l.casting = casting;
  return l;
}

// The share of the light that each pixel shows; less than 0 where there is hardly any.
std::vector<double> shares(const Picture& with, const Picture& without) {
  std::vector<double> r;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double all = decoded(pixel(without, x, y).g / 255.0);
      r.push_back(all > 0.02 ? decoded(pixel(with, x, y).g / 255.0) / all : -1);
    }
  return r;
}

// Pixels that are wrong where the traced picture is all lit, or all dark, two pixels around.
struct Wrong {
  int lit = 0, dark = 0, acne = 0, gaps = 0;
};
Wrong wrong(const std::vector<double>& is, const std::vector<double>& should) {
  Wrong r;
  for (int y = 2; y < height - 2; ++y)
    for (int x = 2; x < width - 2; ++x) {
      double low = 1, high = 0;
      for (int k = 0; k < 25; ++k) {
        const double s = should[static_cast<std::size_t>((y + k / 5 - 2) * width + x + k % 5 - 2)];
        low = std::min(low, s), high = std::max(high, s);
      }
      const double s = is[static_cast<std::size_t>(y * width + x)];
      if (low > 0.93) ++r.lit, r.acne += s < 0.7;
      if (low >= 0 && high < 0.07) ++r.dark, r.gaps += s > 0.3;
    }
  return r;
}

// Rows with light in the shade right beside the arm: in the second pixel of six or more that are dark in the traced
// picture.
int leaks(const std::vector<double>& is, const std::vector<double>& should) {
  int rows = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 1; x + 6 < width / 2; ++x) {
      const auto at = static_cast<std::size_t>(y * width + x);
      const auto shade = [&](std::size_t i) { return should[i] >= 0 && should[i] < 0.07; };
      if (shade(at - 1)) continue;
      int dark = 0;
      while (dark < 6 && shade(at + static_cast<std::size_t>(dark))) ++dark;
      rows += dark == 6 && is[at + 1] > 0.2;
    }
  return rows;
}

void compare(const char* what, bool close, const std::function<Light(double, Casting)>& light) {
  for (const Casting casting : {Casting::on, Casting::soft}) {
    const Frame one = standing(1, light(1, casting), close);
    Frame unshadowed = one;
    unshadowed.lights[0].casting = Casting::off;
    const RenderOptions options{width, height, 4, "shaded"};
    const Picture plain = draw(unshadowed, options);
    RenderOptions traced{width, height, 16, "traced"};
    traced.denoise = false;
    const std::vector<double> should = shares(draw(one, traced), plain);
    for (const double unit : {1e-3, 0.1, 1.0, 100.0, 1e4}) {
      const Frame f = standing(unit, light(unit, casting), close);
      const std::vector<double> is = shares(draw(f, options), plain);
      const std::string where = fmt::format("{} {}{}", what, unit, casting == Casting::soft ? " soft" : "");
      if (close) {
        EXPECT_LE(leaks(is, should), 3) << where;
        continue;
      }
      const Wrong w = wrong(is, should);
      EXPECT_GT(w.lit, 15000) << where;
      EXPECT_GT(w.dark, 100) << where;
      EXPECT_LE(w.acne, 3) << where << " of " << w.lit;
      EXPECT_LE(w.gaps, 3) << where << " of " << w.dark;
    }
  }
}

TEST(RenderShadowScale, SunsOfAnyHeight) {
  for (const double degrees : {10.0, 30.0, 60.0})
    for (const bool close : {false, true})
      compare(fmt::format("sun {}{}", degrees, close ? " close" : "").c_str(), close,
              [&](double, Casting c) { return sun(degrees, c); });
}
TEST(RenderShadowScale, Lamps) {
  for (const bool close : {false, true}) compare(close ? "lamp close" : "lamp", close, lamp_at);
}

}  // namespace
}  // namespace betwixt
