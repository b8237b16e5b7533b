// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/things.h"

#include <algorithm>

#include "base/stages.h"
#include "exchange/geometry.h"

namespace betwixt {
namespace {

constexpr double largest = 1e15;  // metres; squares of f32 stay finite
// Pixels across, for surfaces and for lines.
constexpr double coarse_below[] = {28, 150}, fine_above[] = {220, 800};

bool usable(const Item& item) {
  return item.shape != nullptr && finite(item.world) && finite(item.color) && std::isfinite(item.transparency) &&
         std::isfinite(item.shininess) && std::isfinite(item.blend) && item.transparency < 1;
}

Geometry geometry_of(const Item& item, int detail) {
  const bool between = item.toward != nullptr && item.blend != 0;
  return between ? realise_blend(*item.shape, *item.toward, item.blend, detail) : realise(*item.shape, detail);
}

Bounds bounds_of(const Box& box, const Mat4& m) {
  const Vec3 half = box.half();
  Bounds b{transform_point(m, box.middle()), {}};
  for (int i = 0; i < 3; ++i)
    b.half[i] = std::abs(m(i, 0)) * half.x + std::abs(m(i, 1)) * half.y + std::abs(m(i, 2)) * half.z;
  return b;
}

bool has_holes(const Item& item, const StoredMesh& mesh, Store& store) {
  if (item.texture != nullptr) return store.texture(item.texture).see_through;
  return std::any_of(mesh.parts.begin(), mesh.parts.end(),
                     [&](const MeshPart& p) { return p.texture != nullptr && store.texture(p.texture).see_through; });
}

// Whether balls.h can draw it: a plain solid sphere, not flat, well before the eye.
bool is_ball(const Thing& t, const View& view, double determinant) {
  const Item& item = *t.item;
  const double size = t.bounds.radius();
  return item.shape->kind == Kind::sphere && item.blend == 0 && item.texture == nullptr && !t.transparent &&
         std::abs(determinant) > 1e-4 * size * size * size && (view.orthographic || t.depth > 2 * size || !t.visible);
}

void make_ball(Thing& t, const Mat4& world, double pixels, Store& store) {
  const double r = t.item->shape->radius;
  t.ball = true;
  t.local = t.coarse_local = world * scaling({r, r, r});
  t.coarse = &store.disc(1);  // round enough for shadows
  t.mesh = &store.disc(pixels < 40 ? 0 : pixels < 300 ? 1 : 2);
}

}  // namespace

std::vector<Thing> gather(const Frame& frame, int width, int height, Store& store, Purpose purpose, View& view) {
  const InStage stage(Stage::gather);
  bool good = false;
  view = make_view(frame.camera, width, height, good);
  if (!good) return {};
  const auto fewer = static_cast<std::size_t>(purpose);
  std::vector<Thing> things;
  things.reserve(frame.items.size());
  double nearest = largest, farthest = 0;
  for (const Item& item : frame.items) {
    if (!usable(item)) continue;
    Mat4 world = item.world;
    for (int i = 0; i < 3; ++i) world(i, 3) -= view.eye[i];
    const Geometry coarse = geometry_of(item, 0);
    if (coarse.mesh == nullptr || coarse.mesh->positions.empty()) continue;
    Thing t;
    t.item = &item;
    t.coarse = t.mesh = &store.mesh(coarse.mesh);
    t.coarse_local = t.local = world * coarse.local;
    t.bounds = bounds_of(t.mesh->box, t.local);
    if (!(t.bounds.radius() > 0 && t.bounds.radius() < largest && length(t.bounds.center) < largest)) continue;
    t.depth = view.depth(t.bounds.center);
    t.visible = view.sees(t.bounds);
    const double d = determinant(t.local);
    t.mirrored = d < 0;
    t.closed = t.mesh->mesh->closed && d != 0;
    t.transparent = item.transparency > 0 || has_holes(item, *t.mesh, store);
    const double pixels = view.pixels(t.bounds);
    if (purpose == Purpose::surfaces && is_ball(t, view, determinant(world) * std::pow(item.shape->radius, 3))) {
      make_ball(t, world, pixels, store);
    } else if (t.visible && pixels >= coarse_below[fewer]) {
      const Geometry better = geometry_of(item, pixels < fine_above[fewer] ? 1 : 2);
      t.mesh = &store.mesh(better.mesh);
      t.local = world * better.local;
    }
    if (t.visible) {
      nearest = std::min(nearest, t.depth - view.reach(t.bounds));
      farthest = std::max(farthest, t.depth + view.reach(t.bounds));
    }
    things.push_back(t);
  }
  view.fit(nearest, farthest);
  return things;
}

}  // namespace betwixt
