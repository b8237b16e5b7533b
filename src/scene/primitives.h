// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes of primitive bodies, from numbers alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "betwixt/math.h"
#include "betwixt/mesh.h"

namespace betwixt {

// Returns whether a measure or a coordinate is small enough for computations with squares and their products.
inline bool sane(double d) { return std::abs(d) < 1e18; }
inline bool sane(Vec3 p) { return sane(p.x) && sane(p.y) && sane(p.z); }
inline bool sane(const std::vector<Vec3>& points) {
  return std::all_of(points.begin(), points.end(), [](Vec3 p) { return sane(p); });
}

// About the origin, radius 1, height 1 along y, sides 1. `around` and `up` are numbers of faces, at least 3 and 2.
Mesh sphere_mesh(int around, int up);
Mesh box_mesh();
// A box with round edges: `radius` > 0 is at most the smallest half. An edge has twice `steps` faces across.
Mesh round_box_mesh(Vec3 half, double radius, int steps);
Mesh cylinder_mesh(int around);
Mesh cone_mesh(int around);  // the tip at y = 1/2
Mesh plane_mesh();           // 1 by 1 at z = 0, facing +z
Mesh disc_mesh(int around);  // at z = 0, facing +z

// The ring is in the plane y = 0.
Mesh torus_mesh(double radius, double tube, int around, int across);
// A round tube along the points, with round joints and ends.
Mesh tube_mesh(const std::vector<Vec3>& points, double diameter, int around);
// Returns one mesh of all; without parts and texture coordinates.
Mesh joined(std::vector<Mesh>);
// A hairline: edges and no triangles.
Mesh line_mesh(const std::vector<Vec3>& points);
// Returns a scaled copy of `ball` at every point.
Mesh balls_mesh(const std::vector<Vec3>& points, double diameter, const Mesh& ball);

}  // namespace betwixt
