// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/shape_blend.h"

#include <algorithm>

#include "scene/kinds.h"
#include "scene/topology.h"

namespace betwixt {

bool one_topology(const Shape& a, const Shape& b) {
  if (a.kind != b.kind || a.kind == Kind::text) return false;
  if (a.mesh != nullptr && b.mesh != nullptr && a.mesh != b.mesh)
    return a.mesh->positions.size() == b.mesh->positions.size() && a.mesh->triangles == b.mesh->triangles;
  if (a.kind == Kind::polyline && (a.width > 0) != (b.width > 0)) return false;
  return (a.mesh == nullptr) == (b.mesh == nullptr) && a.points->size() == b.points->size() &&
         a.holes->size() == b.holes->size();
}

Mesh sum_of(std::span<const MeshShare> shares) {
  const auto over = [&](auto of) {
    Vec3 sum{0, 0, 0};
    for (const MeshShare& share : shares) sum = sum + share.weight * of(share);
    return sum;
  };
  const auto normal = [](const MeshShare& s, std::size_t i) {
    const Vec3 n = widen(s.mesh->normals[i]);
    return normalize(Vec3{n.x / s.stretch.x, n.y / s.stretch.y, n.z / s.stretch.z}, n);
  };
  Mesh mesh = *shares[0].mesh;
  bool uvs = true, parts = true;
  for (const MeshShare& s : shares) {
    uvs = uvs && s.mesh->uvs.size() == mesh.uvs.size(), parts = parts && s.mesh->parts.size() == mesh.parts.size();
    mesh.closed = mesh.closed && s.mesh->closed && s.weight >= 0;  // an extrapolation may turn it inside out
  }
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    mesh.positions[i] = narrow(over([&](const MeshShare& s) { return s.stretch * widen(s.mesh->positions[i]); }));
    mesh.normals[i] = narrow(normalize(over([&](const MeshShare& s) { return normal(s, i); }), normal(shares[0], i)));
  }
  for (std::size_t i = 0; uvs && i < mesh.uvs.size(); ++i) {
    const Vec3 uv = over([&](const MeshShare& s) { return Vec3{s.mesh->uvs[i][0], s.mesh->uvs[i][1], 0}; });
    mesh.uvs[i] = {static_cast<float>(uv.x), static_cast<float>(uv.y)};
  }
  for (std::size_t i = 0; parts && i < mesh.parts.size(); ++i) {
    const auto color = narrow(over([&](const MeshShare& s) { return widen(s.mesh->parts[i].color); }));
    for (std::size_t k = 0; k < 3; ++k) mesh.parts[i].color[k] = std::max(0.0F, color[k]);
  }
  return mesh;
}

Shape sum_of(std::span<const ShapeShare> shares) {
  Shape shape = *shares[0].shape;
  std::vector<Vec3> points(shape.points->size()), holes(shape.holes->size());
  shape.size = {0, 0, 0};
  for (const auto m : shape_measures) shape.*m = 0;
  std::vector<MeshShare> meshes;
  bool one_mesh = true;
  for (const auto& [of, weight] : shares) {
    shape.size = shape.size + weight * of->size;
    for (const auto m : shape_measures) shape.*m += weight * (of->*m);
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = points[i] + weight * (*of->points)[i];
    for (std::size_t i = 0; i < holes.size(); ++i) holes[i] = holes[i] + weight * (*of->holes)[i];
    if (of->mesh) meshes.push_back({of->mesh.get(), weight, {1, 1, 1}});
    one_mesh = one_mesh && of->mesh == shape.mesh;
  }
  for (const auto m : shape_measures) shape.*m = std::max(0.0, shape.*m);
  if (!points.empty()) shape.points = std::move(points);
  if (!holes.empty()) shape.holes = std::move(holes);
  if (!one_mesh) shape.mesh = std::make_shared<const Mesh>(sum_of(std::span<const MeshShare>(meshes)));
  return shape;
}

}  // namespace betwixt
