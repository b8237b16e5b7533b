// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes of plain bodies, made from numbers alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "betwixt/math.h"
#include "betwixt/mesh.h"

namespace betwixt {

// A measure or a point that can be reckoned with: squares and their products still fit into f32's neighbours in f64.
inline bool sane(double d) { return std::abs(d) < 1e18; }
inline bool sane(Vec3 p) { return sane(p.x) && sane(p.y) && sane(p.z); }
inline bool sane(const std::vector<Vec3>& points) {
  return std::all_of(points.begin(), points.end(), [](Vec3 p) { return sane(p); });
}

// About the origin, radius 1, height 1 along y, sides 1; `around` and `up`: how many faces. At least 3 and 2.
Mesh sphere_mesh(int around, int up);
Mesh box_mesh();
Mesh cylinder_mesh(int around);
Mesh cone_mesh(int around);  // the tip at y = 1/2
Mesh plane_mesh();           // 1 by 1 at z = 0, facing +z
Mesh disc_mesh(int around);  // at z = 0, facing +z

// The ring lies in the plane y = 0.
Mesh torus_mesh(double radius, double tube, int around, int across);
// A round tube along the points, joints and ends round.
Mesh tube_mesh(const std::vector<Vec3>& points, double diameter, int around);
// All of them in one; without parts and places of textures.
Mesh joined(std::vector<Mesh>);
// A hairline: edges and no triangles.
Mesh line_mesh(const std::vector<Vec3>& points);
// A ball at every point, each like `ball`, scaled.
Mesh balls_mesh(const std::vector<Vec3>& points, double diameter, const Mesh& ball);

}  // namespace betwixt
