// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Shapes between two shapes.
#include <fmt/format.h>

#include <algorithm>

#include "exchange/geometry.h"
#include "exchange/outline_morph.h"
#include "scene/kinds.h"
#include "scene/topology.h"

namespace betwixt {
namespace {

// ---- shapes of one kind: by their measures

bool same_but_measures(const Shape& a, const Shape& b) {
  if (a.kind != b.kind || has_outline(a) || row_of(a.kind).fill == Fill::file) return false;
  if (a.kind == Kind::polyline && (a.width > 0) != (b.width > 0)) return false;
  return a.points->size() == b.points->size();
}

Shape between(const Shape& a, const Shape& b, double s) {
  Shape shape = a;
  shape.size = lerp(a.size, b.size, s);
  for (const auto m : shape_measures) shape.*m = std::max(0.0, lerp(a.*m, b.*m, s));
  std::vector<Vec3> points(std::min(a.points->size(), b.points->size()));
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = lerp((*a.points)[i], (*b.points)[i], s);
  shape.points = std::move(points);
  return shape;
}

// ---- meshes: vertex by vertex

// The geometry in object space.
struct Baked {
  const Mesh& mesh;
  Vec3 stretch;
  explicit Baked(const Geometry& g) : mesh(*g.mesh), stretch{g.local(0, 0), g.local(1, 1), g.local(2, 2)} {}
  Vec3 position(std::size_t i) const { return stretch * widen(mesh.positions[i]); }
  Vec3 normal(std::size_t i) const {
    const Vec3 n = widen(mesh.normals[i]);
    return normalize(Vec3{n.x / stretch.x, n.y / stretch.y, n.z / stretch.z}, n);
  }
};

Mesh between(const Geometry& a, const Geometry& b, double s) {
  const Baked from(a), to(b);
  Mesh mesh = *a.mesh;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    mesh.positions[i] = narrow(lerp(from.position(i), to.position(i), s));
    mesh.normals[i] = narrow(normalize(lerp(from.normal(i), to.normal(i), s), from.normal(i)));
  }
  if (to.mesh.uvs.size() == mesh.uvs.size())
    for (std::size_t i = 0; i < mesh.uvs.size(); ++i)
      for (std::size_t k = 0; k < 2; ++k)
        mesh.uvs[i][k] = static_cast<float>(lerp(mesh.uvs[i][k], to.mesh.uvs[i][k], s));
  if (to.mesh.parts.size() == mesh.parts.size())
    for (std::size_t i = 0; i < mesh.parts.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        mesh.parts[i].color[k] =
            std::max(0.0F, static_cast<float>(lerp(mesh.parts[i].color[k], to.mesh.parts[i].color[k], s)));
  mesh.closed = mesh.closed && to.mesh.closed && s >= 0 && s <= 1;
  return mesh;
}

// Why the meshes cannot be blended vertex by vertex; empty where they can.
std::string obstacle(const Shape& a, const Shape& b, const Mesh& from, const Mesh& to) {
  if (from.positions.size() != to.positions.size())
    return a.kind == b.kind && row_of(a.kind).fill != Fill::file
               ? fmt::format("{} points against {}", a.points->size(), b.points->size())
               : fmt::format("{} vertices against {}", from.positions.size(), to.positions.size());
  if (from.triangles != to.triangles)
    return a.kind == b.kind ? "as many vertices, but other triangles between them"
                            : fmt::format("{} and {} have nothing in common", a_kind(a.kind), a_kind(b.kind));
  return {};
}

}  // namespace

Geometry realise_blend(const Shape& a, const Shape& b, double s, const Detail& detail) {
  if (s == 0 || a == b || !std::isfinite(s)) return realise(a, detail);
  if (s == 1) return realise(b, detail);
  if (has_outline(a) && has_outline(b)) {
    if (s <= 0 || s >= 1) return realise(s < 1 ? a : b, detail);
    return {std::make_shared<const Mesh>(outline_between(a, b, s)), {}};
  }
  if (same_but_measures(a, b)) return realise(between(a, b, s), detail);
  const Geometry from = realise(a), to = realise(b);  // all of their vertices
  if (!obstacle(a, b, *from.mesh, *to.mesh).empty()) return realise(s < 1 ? a : b, detail);
  return {std::make_shared<const Mesh>(between(from, to, s)), {}};
}

bool can_blend(const Shape& a, const Shape& b, std::string* why) {
  if ((has_outline(a) && has_outline(b)) || same_but_measures(a, b)) return true;
  const Geometry from = realise(a), to = realise(b);
  const std::string reason = obstacle(a, b, *from.mesh, *to.mesh);
  if (why != nullptr) *why = reason;
  return reason.empty();
}

}  // namespace betwixt
