// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What can be told of a mesh from which corners its triangles share. Corners at the same position count as one.
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

// For each vertex the first one at the same position.
std::vector<std::uint32_t> weld(const std::vector<std::array<float, 3>>& positions);

// The edges worth drawing as wireframe: borders, and those where the surface bends (by more than half a degree).
std::vector<std::uint32_t> crease_edges(const Mesh&);
// Which these are, for who knows the neighbours of each triangle already.
std::vector<Vec3> face_normals(const Mesh&);
bool creased(Vec3 normal, Vec3 other);

// Every edge is used once each way, and every connected part encloses a positive volume.
bool is_closed(const Mesh&);

// Volume enclosed by the triangles; negative when they face inward.
double signed_volume(const Mesh&);

// Sets normals, splitting vertices where the surface bends by more than `crease` radians. Triangles without area are
// dropped together with what they had in `parts`. `from`: which vertex each has been.
void make_normals(Mesh&, double crease, std::vector<std::uint32_t>* from = nullptr);

}  // namespace betwixt
