// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/gradient_place.h"

#include <algorithm>
#include <cmath>

#include "exchange/geometry.h"
#include "scene/kinds.h"

namespace betwixt {
namespace {

// The whole shape, filled.
Shape plain_shape(const Shape& s) {
  Shape whole = s;
  whole.filled = true, whole.stroke = Vec3{-1, -1, -1}, whole.stroke_graded = false;
  whole.dash = whole.gap = whole.trim_from = 0, whole.trim_to = 1;
  whole.letters.typed = Letters().typed;
  return whole;
}

}  // namespace

Box gradient_box(const Shape& s, const Shape* toward, double blend) {
  const Shape whole = plain_shape(s);
  Box out;
  if (const KindRow& row = row_of(s.kind); toward == nullptr && row.contours) {  // a line there and back has no area
    for (const auto& contour : row.contours(whole))
      for (const Vec3 p : contour) out.add(p);
    return out.empty() ? Box{{}, {}} : out;
  }
  const Geometry g = toward != nullptr ? realise_blend(whole, plain_shape(*toward), blend) : realise(whole);
  const Box box = g.mesh->box();
  // `local` only scales.
  out.add(transform_point(g.local, box.low)), out.add(transform_point(g.local, box.high));
  return out;
}

GradientPlane plane_of(const Gradient& g, const Box& box) {
  constexpr double thin = 1e-9;
  const double width = std::max(box.high.x - box.low.x, 0.0), height = std::max(box.high.y - box.low.y, 0.0);
  const double least = std::max(thin * std::max(width, height), 1e-12);
  const double x = (box.low.x + box.high.x) / 2 + g.move_x * width,
               y = (box.low.y + box.high.y) / 2 + g.move_y * height;
  const auto [sine, cosine] = sine_cosine(g.turn);
  // A row that is 0 at the middle.
  const auto row = [&](double a, double b) { return std::array<double, 3>{a, b, -a * x - b * y}; };
  if (g.kind == GradientKind::linear) {
    const double whole = g.size * std::max(width * std::abs(cosine) + height * std::abs(sine), least);
    GradientPlane p{row(cosine / whole, sine / whole), {}};
    p.x[2] += 0.5;
    return p;
  }
  const bool circle = g.kind == GradientKind::circular;
  const double across = circle ? std::max(width, height) : width, up = circle ? across : height;
  if (circle || g.kind == GradientKind::radial)
    return {row(2 / (g.size * std::max(across, least)), 0), row(0, 2 / (g.size * std::max(up, least)))};
  const double unit = 2 / std::max({width, height, least});
  return {row(unit * cosine, unit * sine), row(-unit * sine, unit * cosine)};
}

}  // namespace betwixt
