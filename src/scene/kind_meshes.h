// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes of shapes in object space. Only src/scene/kinds.cpp includes this, for its rows.
#pragma once

#include <algorithm>
#include <cmath>

#include "scene/flat_shapes.h"
#include "scene/kind_extents.h"
#include "scene/kinds.h"
#include "scene/primitives.h"
#include "scene/strokes.h"

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
