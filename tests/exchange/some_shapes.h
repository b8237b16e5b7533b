// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Short functions that make shapes and measure them.
#pragma once

#include <gtest/gtest.h>

#include "exchange/fonts.h"
#include "exchange/geometry.h"
#include "scene/topology.h"

namespace betwixt {

using Corners = std::vector<Vec3>;

inline Shape shape(Kind kind) {
  Shape s;
  s.kind = kind;
  return s;
}
inline Shape polygon(Corners points) {
  Shape s = shape(Kind::polygon);
  s.points = std::move(points);
  return s;
}
inline Shape text(std::string words, double depth = 0) {
  Shape s = shape(Kind::text);
  s.text = std::move(words);
  s.font = std::string("DejaVu Sans");
  s.depth = depth;
  return s;
}

// Returns the area of the triangles, counted as seen from +z.
inline double front(const Mesh& m) {
  double sum = 0;
  for (std::size_t i = 0; i < m.triangles.size(); i += 3) {
    const Vec3 a = widen(m.positions[m.triangles[i]]), b = widen(m.positions[m.triangles[i + 1]]),
               c = widen(m.positions[m.triangles[i + 2]]);
    sum += std::max(0.0, cross(b - a, c - a).z / 2);
  }
  return sum;
}

// Returns the contours of one letter of a text.
inline std::vector<Contour> letter(const std::string& words, std::size_t i) {
  const Outline o = text_outline(words, "DejaVu Sans");
  const auto at = [&](std::size_t n) { return o.contours.begin() + static_cast<std::ptrdiff_t>(n); };
  return {at(o.letters[i].first), i + 1 < o.letters.size() ? at(o.letters[i + 1].first) : o.contours.end()};
}

}  // namespace betwixt
