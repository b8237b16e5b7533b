// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes of shapes in object space. Only src/scene/kinds.cpp includes this, for its rows.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/flat_shapes.h"
#include "scene/kind_extents.h"
#include "scene/kinds.h"
#include "scene/primitives.h"
#include "scene/strokes.h"
#include "scene/topology.h"

namespace betwixt {

inline Vec3 even_measures(const Shape& s) { return {s.radius, s.radius, s.radius}; }
inline Vec3 box_measures(const Shape& s) { return s.size; }
inline Vec3 plane_measures(const Shape& s) { return {s.size.x, s.size.y, std::max(s.size.x, s.size.y)}; }
inline Vec3 round_measures(const Shape& s) { return {s.radius, s.height, s.radius}; }

// Returns a radius relative to the largest measure from the centre.
inline double share_of(double radius, const Extent& all) {
  const Vec3 half = all.half();
  return radius / std::max({half.x, half.y, half.z, radius, 1e-300});
}

inline bool has_round_edges(const Shape& box) { return box.corner > 0; }
inline Mesh any_box_mesh(const Shape& s, const Detail& d) {
  if (!has_round_edges(s)) return box_mesh();
  const Vec3 half{std::abs(s.size.x) / 2, std::abs(s.size.y) / 2, std::abs(s.size.z) / 2};
  const double radius = std::min({s.corner, half.x, half.y, half.z});
  if (!sane(half) || !(radius > 0)) return {};
  const int around = d.even ? d.around / 2 : d.around_thin(radius / std::max({half.x, half.y, half.z}));
  return round_box_mesh(half, radius, std::max(1, around / 8));
}

inline Mesh ring_mesh(const Shape& s, const Detail& d) {
  if (!(s.tube > 0) || !(s.radius >= 0) || !sane(s.tube) || !sane(s.radius)) return {};
  const int across = d.even ? d.around / 2 : d.around_thin(s.tube / (s.radius + s.tube));
  return torus_mesh(s.radius, s.tube, d.around, across);
}
inline Mesh stroke_mesh(const Shape& s, const Detail& d) {
  if (!sane(s.width)) return {};
  const int around = d.even ? 8 + d.around / 48 * 4 : d.around_thin(share_of(s.width / 2, whole_line(s)));
  std::vector<Mesh> parts;
  for (const auto& part : drawn_lines(s))
    parts.push_back(s.width > 0 ? tube_mesh(part, s.width, around) : line_mesh(part));
  return joined(std::move(parts));
}
inline Mesh cloud_mesh(const Shape& s, const Detail& d) {
  if (!sane(*s.points) || !sane(s.width) || !(s.width > 0)) return {};
  // Fewer triangles for each if there are many: together they may be millions.
  if (s.points->size() > 20000) return balls_mesh(*s.points, s.width, sphere_mesh(4, 2));
  const int around = d.even ? d.around / 3 : d.around_thin(share_of(s.width / 2, of_points(s)));
  return balls_mesh(*s.points, s.width, sphere_mesh(around, around / 2));
}

// Discs if all points are at one z, balls if they are in space. Fewer triangles for each if there are many.
inline Mesh scatter_mesh(const Shape& s, const Detail& d) {
  const std::vector<Vec3>& all = *s.points;
  const bool flat = std::all_of(all.begin(), all.end(), [&](Vec3 p) { return p.z == all[0].z; });
  if (!flat) return cloud_mesh(s, d);
  if (!sane(all) || !sane(s.width) || !(s.width > 0)) return {};
  const int around = all.size() > 20000 ? 6
                     : d.even           ? d.around / 3
                                        : d.around_thin(share_of(s.width / 2, of_points(s)));
  return balls_mesh(all, s.width, disc_mesh(around));
}

inline Extent of_sane_points(const Shape& s) {
  Extent e;
  for (const Vec3 p : *s.points)
    if (sane(p)) e.add(p);
  return e;
}
// The points are those of a square grid, row after row. Where one is not finite, there is a hole.
inline Mesh surface_mesh(const Shape& s, const Detail&) {
  const std::vector<Vec3>& all = *s.points;
  const int n = static_cast<int>(std::lround(std::sqrt(static_cast<double>(all.size()))));
  if (n < 2 || static_cast<std::size_t>(n) * static_cast<std::size_t>(n) != all.size()) return {};
  const auto index = [n](int i, int j) { return static_cast<std::uint32_t>(j * n + i); };
  const auto there = [&](int i, int j) { return i >= 0 && j >= 0 && i < n && j < n && sane(all[index(i, j)]); };
  // Returns the way from the point before to the point after, as far as they are there.
  const auto way = [&](int i, int j, int di, int dj) {
    const bool before = there(i - di, j - dj), after = there(i + di, j + dj);
    return all[after ? index(i + di, j + dj) : index(i, j)] - all[before ? index(i - di, j - dj) : index(i, j)];
  };
  // Corners that are not there are where another one is, because the box of a mesh is that of all.
  const auto any = std::find_if(all.begin(), all.end(), [](Vec3 p) { return sane(p); });
  if (any == all.end()) return {};
  Mesh mesh;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const bool is = there(i, j);
      const Vec3 p = is ? all[index(i, j)] : *any;
      const Vec3 up = is ? normalize(cross(way(i, j, 1, 0), way(i, j, 0, 1)), {0, 0, 1}) : Vec3{0, 0, 1};
      mesh.positions.push_back(narrow(p)), mesh.normals.push_back(narrow(up));
      if (is && there(i + 1, j)) mesh.edges.insert(mesh.edges.end(), {index(i, j), index(i + 1, j)});
      if (is && there(i, j + 1)) mesh.edges.insert(mesh.edges.end(), {index(i, j), index(i, j + 1)});
      // The two triangles of a face, as far as their corners are there; cut along the diagonal that exists.
      if (i + 1 == n || j + 1 == n) continue;
      const bool other = !is || !there(i + 1, j + 1);
      const int corner[4][2] = {{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}};
      for (const auto& [a, b, c] : {std::array{0, 1, 2}, {0, 2, 3}}) {
        const int shift = other ? 1 : 0;
        std::uint32_t at[3];
        bool whole = true;
        for (int k = 0; k < 3; ++k) {
          const auto& [x, y] = corner[((k == 0 ? a : k == 1 ? b : c) + shift) % 4];
          at[k] = index(x, y), whole = whole && there(x, y);
        }
        if (whole) mesh.triangles.insert(mesh.triangles.end(), at, at + 3);
      }
    }
  return mesh;
}

// Returns the row of a line with a width.
constexpr KindRow a_line(KindRow row) {
  row.fill = Fill::surface, row.line = row.detailed = true;
  row.extent = of_line, row.mesh = stroke_mesh;
  return row;
}
// Returns the row of a flat shape, the area of its contours, which can have a depth.
template <auto contours>
constexpr KindRow flat(KindRow row) {
  row.fill = Fill::outline, row.deep = true;
  row.extent = of_contours<contours>, row.contours = contours;
  return row;
}

}  // namespace betwixt
