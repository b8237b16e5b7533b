// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Shapes between two shapes.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "exchange/geometry.h"
#include "exchange/held_meshes.h"
#include "exchange/outline_morph.h"
#include "scene/kinds.h"
#include "scene/shape_blend.h"
#include "scene/strokes.h"

namespace betwixt {
namespace {

// ---- shapes of one kind: interpolates their measures

bool same_but_measures(const Shape& a, const Shape& b) {
  return !by_contours(a) && !by_contours(b) && row_of(a.kind).fill != Fill::file && one_topology(a, b);
}

Shape between(const Shape& a, const Shape& b, double s) {
  return sum_of(std::array{ShapeShare{&a, 1 - s}, ShapeShare{&b, s}});
}

// ---- meshes: vertex by vertex

// The input of a blend.
struct BlendKey {
  Shape from, to;
  double blend = 0;
  friend bool operator==(const BlendKey&, const BlendKey&) = default;
};
struct BlendHash {
  std::size_t operator()(const BlendKey& k) const { return mixed(mixed(hash_of(k.from), hash_of(k.to)), k.blend); }
};

// Returns the geometry's share in object space.
MeshShare share(const Geometry& g, double weight) {
  return {g.mesh.get(), weight, {g.local(0, 0), g.local(1, 1), g.local(2, 2)}};
}

// Returns why the meshes cannot be blended vertex by vertex, or "" if they can.
std::string obstacle(const Shape& a, const Shape& b, const Mesh& from, const Mesh& to) {
  if (from.positions.size() != to.positions.size())
    return a.kind == b.kind && row_of(a.kind).fill != Fill::file
               ? fmt::format("{} points and {} points", a.points->size(), b.points->size())
               : fmt::format("{} vertices and {} vertices", from.positions.size(), to.positions.size());
  if (from.triangles != to.triangles)
    return a.kind == b.kind ? "the same number of vertices, but different triangles"
                            : fmt::format("{} and {} have nothing in common", a_kind(a.kind), a_kind(b.kind));
  return {};
}

}  // namespace

Geometry realise_blend(const Shape& a, const Shape& b, double s, const Detail& detail) {
  static HeldMeshes<BlendKey, BlendHash> held;
  if (s == 0 || a == b || !std::isfinite(s)) return realise(a, detail);
  if (s == 1) return realise(b, detail);
  if (same_but_measures(a, b)) return realise(between(a, b, s), detail);
  if (has_outline(a) && has_outline(b)) {
    if (s <= 0 || s >= 1) return realise(s < 1 ? a : b, detail);
    return {held.get({a, b, s}, [&] { return outline_between(a, b, s); }), {}};
  }
  const Geometry from = realise(a), to = realise(b);  // at full detail, with all vertices
  if (!obstacle(a, b, *from.mesh, *to.mesh).empty()) return realise(s < 1 ? a : b, detail);
  return {held.get({a, b, s}, [&] { return sum_of(std::array{share(from, 1 - s), share(to, s)}); }), {}};
}

bool can_blend(const Shape& a, const Shape& b, std::string* why) {
  if ((has_outline(a) && has_outline(b)) || same_but_measures(a, b)) return true;
  const Geometry from = realise(a), to = realise(b);
  const std::string reason = obstacle(a, b, *from.mesh, *to.mesh);
  if (why != nullptr) *why = reason;
  return reason.empty();
}

}  // namespace betwixt
