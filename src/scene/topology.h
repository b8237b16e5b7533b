// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The topology of a mesh: the corners that its triangles share. Corners at the same position count as one.
#pragma once

#include <cstdint>
#include <vector>

#include "betwixt/math.h"
#include "betwixt/mesh.h"

namespace betwixt {

inline Vec3 widen(const std::array<float, 3>& p) { return {p[0], p[1], p[2]}; }
inline std::array<float, 3> narrow(Vec3 p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

// Returns, for each vertex, the first one at the same position.
std::vector<std::uint32_t> weld(const std::vector<std::array<float, 3>>& positions);

// Returns the edges for wireframe: borders, and those where the surface bends by more than half a degree.
std::vector<std::uint32_t> crease_edges(const Mesh&);
// Return the normal of each triangle, and whether the edge between two is such an edge: for callers who know which
// triangles are neighbours.
std::vector<Vec3> face_normals(const Mesh&);
bool creased(Vec3 normal, Vec3 other);

// Returns whether every edge is used once in each direction, and every connected part encloses a positive volume.
bool is_closed(const Mesh&);

// Returns the volume inside the triangles; negative if they face inward.
double signed_volume(const Mesh&);

// Sets normals, and splits vertices where the surface bends by more than `crease` radians. Removes triangles without
// area, from `parts` too. `from`: the original index of each vertex.

void make_normals(Mesh&, double crease, std::vector<std::uint32_t>* from = nullptr);

}  // namespace betwixt
