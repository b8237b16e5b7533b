// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/bodies.h"

#include <algorithm>
#include <cmath>

#include "scene/extent.h"

namespace betwixt {
namespace {

Clearance ball_from_box(const Body& ball, const Body& box) {
  const Vec3 d = ball.middle - box.middle;
  Vec3 at, near, normal;
  double least = -1e300;
  for (int i = 0; i < 3; ++i) {
    at[i] = dot(d, box.axes[static_cast<std::size_t>(i)]), near[i] = std::clamp(at[i], -box.half[i], box.half[i]);
    const double inside = std::abs(at[i]) - box.half[i];
    // A ball whose middle is in the plane of a flat box meets its edges only.
    if ((box.half[i] < 1e-9 && std::abs(at[i]) < 1e-9) || inside <= least) continue;
    least = inside, normal = (at[i] < 0 ? -1.0 : 1.0) * box.axes[static_cast<std::size_t>(i)];
  }
  const Vec3 out = at - near;
  const double wide = length(out);
  if (wide == 0) return {least - ball.radius, normal};
  Vec3 n;
  for (int i = 0; i < 3; ++i) n = n + (out[i] / wide) * box.axes[static_cast<std::size_t>(i)];
  return {wide - ball.radius, n};
}

// The separating axis with the widest gap. The sign of the result is exact; outside, the distance may be larger.
Clearance box_from_box(const Body& a, const Body& b) {
  const Vec3 d = a.middle - b.middle;
  Clearance widest{-1e300, {}};
  const auto look = [&](Vec3 axis) {
    const double l = length(axis);
    if (l < 1e-9) return;
    axis = (1 / l) * axis;
    double reach = 0;
    for (std::size_t i = 0; i < 3; ++i)
      reach += std::abs(dot(axis, a.axes[i])) * a.half[static_cast<int>(i)] +
               std::abs(dot(axis, b.axes[i])) * b.half[static_cast<int>(i)];
    const double at = dot(axis, d);
    if (reach < 1e-9 && std::abs(at) < 1e-9) return;  // both are flat, in one plane
    if (std::abs(at) - reach > widest.wide) widest = {std::abs(at) - reach, (at < 0 ? -1.0 : 1.0) * axis};
  };
  for (std::size_t i = 0; i < 3; ++i) look(a.axes[i]), look(b.axes[i]);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) look(cross(a.axes[i], b.axes[k]));
  return widest;
}

}  // namespace

Clearance gap_between(const Body& a, const Body& b) {
  if (a.radius > 0 && b.radius > 0) {
    const Vec3 d = a.middle - b.middle;
    const double l = length(d);
    return {l - a.radius - b.radius, l > 0 ? (1 / l) * d : Vec3{0, 1, 0}};
  }
  if (a.radius > 0) return ball_from_box(a, b);
  if (b.radius == 0) return box_from_box(a, b);
  Clearance g = ball_from_box(b, a);
  g.normal = -1.0 * g.normal;
  return g;
}

std::optional<Body> body_of(const Shape& s, const Mat4& world) {
  const Extent e = extent(s);
  if (e.empty()) return std::nullopt;
  Body b;
  b.middle = transform_point(world, e.middle()), b.half = e.half();
  Vec3 scale;
  for (int i = 0; i < 3; ++i) {
    const Vec3 column{world(0, i), world(1, i), world(2, i)};
    scale[i] = length(column);
    b.half[i] *= scale[i];
    b.axes[static_cast<std::size_t>(i)] =
        normalize(column, {i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0});
  }
  const bool round = s.kind == Kind::sphere || s.kind == Kind::disc || s.kind == Kind::ring;
  const bool even = std::abs(scale.x - scale.y) < 1e-9 * scale.x &&
                    (s.kind != Kind::sphere || std::abs(scale.x - scale.z) < 1e-9 * scale.x);
  if (round && even) b.radius = s.radius * scale.x;
  return finite(b.middle) && finite(b.half) ? std::optional(b) : std::nullopt;
}

bool same(const Body& a, const Body& b) {
  return a.middle == b.middle && a.half == b.half && a.axes == b.axes && a.radius == b.radius;
}

Body between(const Body& a, const Body& b, double share) {
  Body out = a;
  out.middle = a.middle + share * (b.middle - a.middle), out.half = a.half + share * (b.half - a.half);
  out.radius = a.radius + share * (b.radius - a.radius);
  for (std::size_t i = 0; i < 3; ++i) out.axes[i] = normalize(a.axes[i] + share * (b.axes[i] - a.axes[i]), a.axes[i]);
  return out;
}

}  // namespace betwixt
