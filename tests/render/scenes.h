// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Small frames to render, and functions that measure pictures.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "betwixt/render.h"

namespace betwixt::scenes {

struct Pixel {
  int r = 0, g = 0, b = 0, a = 0;
  friend bool operator==(const Pixel&, const Pixel&) = default;
};
inline void PrintTo(const Pixel& p, std::ostream* out) { *out << p.r << ' ' << p.g << ' ' << p.b << ' ' << p.a; }

inline Pixel pixel(const Picture& p, int x, int y) {
  const auto* at =
      &p.rgba.at((static_cast<std::size_t>(y) * static_cast<std::size_t>(p.width) + static_cast<std::size_t>(x)) * 4);
  return {at[0], at[1], at[2], at[3]};
}

// The sRGB curve, from the standard.
inline double decoded(double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); }
inline int encoded_byte(double l) {
  return static_cast<int>(std::lround(255 * (l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055)));
}

// Returns a square of side 1 in the plane z = 0 that faces +z. It is closed only if `closed` is set.
inline std::shared_ptr<const Shape> square(bool closed = false) {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = {{-0.5F, -0.5F, 0}, {0.5F, -0.5F, 0}, {0.5F, 0.5F, 0}, {-0.5F, 0.5F, 0}};
  mesh->normals.assign(4, {0, 0, 1});
  mesh->uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  mesh->triangles = {0, 1, 2, 0, 2, 3};
  mesh->edges = {0, 1, 1, 2, 2, 3, 3, 0};
  mesh->closed = closed;
  auto shape = std::make_shared<Shape>();
  shape->kind = Kind::mesh;
  shape->mesh = mesh;
  return shape;
}

inline std::shared_ptr<const Shape> sphere(double radius = 1) {
  auto shape = std::make_shared<Shape>();
  shape->kind = Kind::sphere;
  shape->radius = radius;
  return shape;
}

inline Item item(std::shared_ptr<const Shape> shape, const Mat4& world, Vec3 color,
                 Material material = Material::glow) {
  Item i;
  i.world = world, i.shape = std::move(shape), i.color = color, i.material = material;
  return i;
}

// Returns a frame with a camera at `z` that looks along -z. The picture shows a height of 10 m at the origin.
inline Frame frame(double z = 10) {
  Frame f;
  f.camera.world = translation({0, 0, z});
  f.camera.orthographic = true;
  f.camera.height = 10;
  f.background = Vec3{0, 0, 0};
  return f;
}

inline std::unique_ptr<Renderer> renderer(RenderOptions options) {
  auto r = make_renderer(options);
  EXPECT_TRUE(r) << (r ? "" : r.error().message);
  return r ? *std::move(r) : nullptr;
}

inline Picture draw(const Frame& f, RenderOptions options = {100, 100, 4, "shaded"}) {
  Picture p;
  const auto r = renderer(options);
  const Status s = r->render(f, p);
  EXPECT_TRUE(s) << (s ? "" : s.error().message);
  return p;
}

// Returns the centre of the pixels brighter than `above`, in pixels from the top left corner.
inline std::pair<double, double> middle(const Picture& p, int above = 128) {
  double x = 0, y = 0, n = 0;
  for (int j = 0; j < p.height; ++j)
    for (int i = 0; i < p.width; ++i)
      if (pixel(p, i, j).r > above) x += i + 0.5, y += j + 0.5, ++n;
  return {x / n, y / n};
}

inline Light lamp(Vec3 position, double range) {
  Light l;
  l.position = position, l.range = range;
  return l;
}

}  // namespace betwixt::scenes
