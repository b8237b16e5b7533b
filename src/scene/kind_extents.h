// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Extents of shapes in object space. Only src/scene/kinds.cpp includes this, for its rows.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/utf8.h"
#include "scene/line.h"
#include "scene/outline.h"
#include "scene/strokes.h"

namespace betwixt {

inline Extent centred_on_origin(Vec3 half) { return {-half, half}; }

inline Extent around_points(const std::vector<Vec3>& points, double margin) {
  if (points.empty()) return {};
  Extent e;
  for (const Vec3 p : points) e.add(p);
  const Vec3 m{margin, margin, margin};
  return {e.low - m, e.high + m};
}

inline Extent of_ball(const Shape& s) { return centred_on_origin({s.radius, s.radius, s.radius}); }
inline Extent of_box(const Shape& s) { return centred_on_origin(0.5 * s.size); }
inline Extent of_plane(const Shape& s) { return centred_on_origin({s.size.x / 2, s.size.y / 2, 0}); }
inline Extent of_disc(const Shape& s) {
  return by_contours(s) ? drawn_extent(disc_contours(s), s) : centred_on_origin({s.radius, s.radius, 0});
}
inline Extent of_round(const Shape& s) {
  return centred_on_origin({s.radius, s.height / 2, s.radius});
}  // cylinder, cone
inline Extent of_ring(const Shape& s) { return centred_on_origin({s.radius + s.tube, s.tube, s.radius + s.tube}); }
// Returns the lines as drawn, with trim and dashes; closed ones end where they begin.
inline std::vector<std::vector<Vec3>> drawn_lines(const Shape& s) {
  std::vector<std::vector<Vec3>> all;
  for (const Line& line : lines_of(s))
    for (DrawnPart& part : stretches(line.points, line.closed, dashes_of(s))) {
      if (part.closed && part.points.size() > 1) part.points.push_back(part.points.front());
      all.push_back(std::move(part.points));
    }
  return all;
}
inline Extent of_line(const Shape& s) {
  Extent e;
  for (const auto& part : drawn_lines(s)) e.add(around_points(part, s.width / 2));
  return e;
}
inline Extent whole_line(const Shape& s) { return around_points(line_of(s).points, s.width / 2); }
inline Extent of_points(const Shape& s) { return around_points(*s.points, s.width / 2); }
inline Extent of_mesh(const Shape& s) { return s.mesh && !s.mesh->positions.empty() ? s.mesh->box() : Extent{}; }

// Returns width and height of a text, with letters 0.6 em wide. A line that wraps is taken to be three quarters full.
inline Extent of_text(const Shape& s) {
  if (s.formula) return drawn_extent(set_formula(s).contours, s);
  const double em = s.size.y, wrap = s.letters.wrap > 0 && em > 0 ? s.letters.wrap / em : 0;
  double widest = 0, letters = 0, lines = 0;
  const auto end_line = [&] {
    const double width = 0.6 * letters;
    lines += wrap > 0 && width > wrap ? std::ceil(width / (0.75 * wrap)) : 1;
    widest = std::max(widest, wrap > 0 ? std::min(width, wrap) : width);
    letters = 0;
  };
  for (const char c : *s.text) {
    if (c == '\n')
      end_line();
    else if (begins_character(c))
      ++letters;
  }
  end_line();
  if (widest == 0) return {};
  const double width = widest * em, edge = pen_of(s).width / 2;
  const double left = s.letters.align == Align::left ? 0 : s.letters.align == Align::right ? -width : -width / 2;
  const double y = first_baseline(s.letters.anchor, lines);
  return {{left - edge, (y - 0.25 - line_spacing * (lines - 1)) * em - edge, -s.depth / 2},
          {left + width + edge, (y + 0.8) * em + edge, s.depth / 2}};
}

template <Contours (*contours)(const Shape&)>
inline Extent of_contours(const Shape& s) {
  return drawn_extent(contours(s), s);
}

// Round shapes reach less far than the corners of their boxes.
inline double ball_reach(const Shape& s, Vec3 r) { return s.radius * length(r); }
inline double disc_reach(const Shape& s, Vec3 r) {
  if (!s.filled && !dashes_of(s).whole()) {
    const Vec3 half = of_disc(s).half();
    return std::abs(half.x * r.x) + std::abs(half.y * r.y) + std::abs(half.z * r.z);
  }
  return (s.radius + pen_of(s).width / 2) * std::hypot(r.x, r.y) + std::abs(s.depth / 2 * r.z);
}
inline double cylinder_reach(const Shape& s, Vec3 r) {
  return s.radius * std::hypot(r.x, r.z) + std::abs(s.height / 2 * r.y);
}
inline double ring_reach(const Shape& s, Vec3 r) { return s.radius * std::hypot(r.x, r.z) + s.tube * length(r); }

}  // namespace betwixt
