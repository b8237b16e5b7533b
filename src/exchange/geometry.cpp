// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/geometry.h"

#include <algorithm>
#include <functional>
#include <mutex>
#include <unordered_map>

#include "exchange/outlines.h"
#include "exchange/shapes.h"
#include "scene/primitives.h"

namespace betwixt {
namespace {

std::size_t mixed(std::size_t h, std::size_t with) { return (h ^ with) * 0x9e3779b97f4a7c15ULL + (h >> 29); }
std::size_t mixed(std::size_t h, double with) { return mixed(h, std::hash<double>{}(with)); }
std::size_t mixed(std::size_t h, Vec3 with) { return mixed(mixed(mixed(h, with.x), with.y), with.z); }

// What a mesh is made from: a shape with all that does not matter for the mesh at rest.
struct Key {
  Shape shape;
  int detail = 1;
  friend bool operator==(const Key&, const Key&) = default;
};
struct KeyHash {
  std::size_t operator()(const Key& k) const {
    const Shape& s = k.shape;
    std::size_t h = mixed(static_cast<std::size_t>(s.kind), static_cast<std::size_t>(k.detail));
    h = mixed(h, s.size);
    for (const double d : {s.radius, s.height, s.tube, s.width, s.depth}) h = mixed(h, d);
    for (const Vec3 p : *s.points) h = mixed(h, p);
    return mixed(mixed(h, std::hash<std::string>{}(*s.text)), std::hash<std::string>{}(*s.font));
  }
};

// Meshes that somebody holds. Forgets the others whenever it has doubled.
class Held {
 public:
  template <class Make>
  std::shared_ptr<const Mesh> get(const Key& key, Make make) {
    {
      const std::lock_guard lock(mutex_);
      if (const auto i = meshes_.find(key); i != meshes_.end())
        if (auto mesh = i->second.lock()) return mesh;
    }
    auto made = std::make_shared<const Mesh>(make());  // outside the lock: it may take long
    const std::lock_guard lock(mutex_);
    auto& place = meshes_[key];
    if (auto mesh = place.lock()) return mesh;  // another thread was faster
    place = made;
    if (meshes_.size() > limit_) {
      std::erase_if(meshes_, [](const auto& m) { return m.second.expired(); });
      limit_ = std::max<std::size_t>(64, 2 * meshes_.size());
    }
    return made;
  }

 private:
  std::mutex mutex_;
  std::unordered_map<Key, std::weak_ptr<const Mesh>, KeyHash> meshes_;
  std::size_t limit_ = 64;
};

bool sane(double d) { return std::abs(d) < 1e18; }  // squares and their products still fit into f32's neighbours in f64
bool sane(Vec3 p) { return sane(p.x) && sane(p.y) && sane(p.z); }

// A scaling that can be undone: what is flat is given a thickness nobody sees, so that normals keep a direction.
std::optional<Mat4> stretch(Vec3 s) {
  const double most = std::max({std::abs(s.x), std::abs(s.y), std::abs(s.z)});
  if (!sane(s) || !(most > 0)) return {};
  for (int i = 0; i < 3; ++i) s[i] = std::max(std::abs(s[i]), 1e-5 * most);
  return scaling(s);
}

Vec3 measures(const Shape& s) {
  switch (s.kind) {
    case Kind::sphere:
      return {s.radius, s.radius, s.radius};
    case Kind::box:
      return s.size;
    case Kind::plane:
      return {s.size.x, s.size.y, std::max(s.size.x, s.size.y)};
    case Kind::disc:
      return {s.radius, s.radius, s.radius};
    default:
      return {s.radius, s.height, s.radius};  // cylinder, cone
  }
}

// The shape without what does not matter for its unit mesh, or for a mesh made as needed.
Key key_of(const Shape& s, int detail) {
  Key key;
  Shape& k = key.shape;
  k.kind = s.kind;
  key.detail = s.kind == Kind::box || s.kind == Kind::plane || s.kind == Kind::polygon ? 1 : detail;
  switch (s.kind) {
    case Kind::torus:
      k.radius = s.radius, k.tube = s.tube;
      break;
    case Kind::polyline:
    case Kind::points:
      k.width = s.width, k.points = s.points;
      break;
    case Kind::polygon:
      k.points = s.points;
      break;
    case Kind::text:
      k.text = s.text, k.font = s.font, k.size.y = s.size.y, k.depth = s.depth;
      break;
    default:
      break;
  }
  return key;
}

Mesh balls(const Shape& s, int detail) {
  // Fewer triangles for each where there are many: together they may be millions.
  if (s.points->size() > 20000) return balls_mesh(*s.points, s.width, sphere_mesh(4, 2));
  return balls_mesh(*s.points, s.width, sphere_mesh(8 << detail, 4 << detail));
}

Mesh made(const Shape& s, int detail) {
  const int around = 24 << detail;
  const bool in_reach = std::all_of(s.points->begin(), s.points->end(), [](Vec3 p) { return sane(p); });
  switch (s.kind) {
    case Kind::sphere:
      return sphere_mesh(around, around / 2);
    case Kind::box:
      return box_mesh();
    case Kind::cylinder:
      return cylinder_mesh(around);
    case Kind::cone:
      return cone_mesh(around);
    case Kind::plane:
      return plane_mesh();
    case Kind::disc:
      return disc_mesh(around);
    case Kind::torus:
      if (!(s.tube > 0) || !(s.radius >= 0) || !sane(s.tube) || !sane(s.radius)) return {};
      return torus_mesh(s.radius, s.tube, around, around / 2);
    case Kind::polyline:
      if (!in_reach || !sane(s.width) || s.points->empty()) return {};
      return s.width > 0 ? tube_mesh(*s.points, s.width, 8 + 4 * detail) : line_mesh(*s.points);
    case Kind::points:
      return in_reach && sane(s.width) && s.width > 0 ? balls(s, detail) : Mesh{};
    case Kind::polygon:
    case Kind::text:
      return fill(outline_of(s), s.depth);
    default:
      return {};
  }
}

}  // namespace

Outline outline_of(const Shape& s) {
  if (s.kind == Kind::polygon) {
    if (s.points->size() < 3 || !std::all_of(s.points->begin(), s.points->end(), [](Vec3 p) { return sane(p); }))
      return {};
    return {{*s.points}, {Letter{}}};
  }
  if (s.kind != Kind::text || !sane(s.size.y) || !(s.size.y > 0) || !sane(s.depth)) return {};
  Outline outline = text_outline(*s.text, *s.font);
  for (auto& contour : outline.contours)
    for (auto& p : contour) p = s.size.y * p;
  return outline;
}

Geometry realise(const Shape& shape, int detail) {
  static const auto empty = std::make_shared<const Mesh>();
  static Held held;
  if (shape.kind == Kind::mesh) return {shape.mesh ? shape.mesh : empty, {}};
  if (shape.kind == Kind::group || shape.kind == Kind::light || shape.kind == Kind::camera) return {empty, {}};
  Geometry g;
  switch (shape.kind) {
    case Kind::sphere:
    case Kind::box:
    case Kind::cylinder:
    case Kind::cone:
    case Kind::plane:
    case Kind::disc: {
      const auto local = stretch(measures(shape));
      if (!local) return {empty, {}};
      g.local = *local;
      break;
    }
    default:
      break;
  }
  const Key key = key_of(shape, std::clamp(detail, 0, 2));
  g.mesh = held.get(key, [&] { return made(key.shape, key.detail); });
  return g;
}

}  // namespace betwixt
