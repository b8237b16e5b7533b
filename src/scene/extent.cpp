// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/extent.h"

#include <algorithm>

#include "base/utf8.h"

namespace betwixt {
namespace {

Extent about(Vec3 half) { return {-half, half}; }

Extent around(const std::vector<Vec3>& points, double margin) {
  if (points.empty()) return {};
  Extent e{points[0], points[0]};
  for (Vec3 p : points)
    for (int i = 0; i < 3; ++i) e.low[i] = std::min(e.low[i], p[i]), e.high[i] = std::max(e.high[i], p[i]);
  const Vec3 m{margin, margin, margin};
  return {e.low - m, e.high + m};
}

// Width and lines of a text, letters taken as 0.6 em wide.
Extent estimate(const Shape& s) {
  double widest = 0, letters = 0, lines = 1;
  for (const char c : *s.text) {
    if (c == '\n')
      ++lines, letters = 0;
    else if (begins_character(c))
      widest = std::max(widest, ++letters);
  }
  if (widest == 0) return {};
  const double em = s.size.y;
  return {{-0.3 * widest * em, (-0.25 - 1.2 * (lines - 1)) * em, -s.depth / 2},
          {0.3 * widest * em, 0.8 * em, s.depth / 2}};
}

}  // namespace

Extent extent(const Shape& s) {
  const double r = s.radius;
  switch (s.kind) {
    case Kind::sphere:
      return about({r, r, r});
    case Kind::disc:
      return about({r, r, 0});
    case Kind::box:
      return about(0.5 * s.size);
    case Kind::plane:
      return about({s.size.x / 2, s.size.y / 2, 0});
    case Kind::cylinder:
    case Kind::cone:
      return about({r, s.height / 2, r});
    case Kind::torus:
      return about({r + s.tube, s.tube, r + s.tube});
    case Kind::polygon:
      return around(*s.points, 0);
    case Kind::polyline:
    case Kind::points:
      return around(*s.points, s.width / 2);
    case Kind::text:
      return estimate(s);
    case Kind::mesh: {
      if (!s.mesh || s.mesh->positions.empty()) return {};
      const auto box = s.mesh->box();
      return {{box.low[0], box.low[1], box.low[2]}, {box.high[0], box.high[1], box.high[2]}};
    }
    default:
      return {};
  }
}

}  // namespace betwixt
