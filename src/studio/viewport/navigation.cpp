// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/viewport/navigation.h"

#include <algorithm>
#include <cmath>

namespace betwixt::studio {
namespace {

constexpr double nearest_pole = 89.9 * pi / 180;
constexpr double margin = 1.15;  // around the framed box

Vec3 forward(const Camera& c) { return -normalize(transform_vector(c.world, {0, 0, 1})); }
Camera at(Camera c, Vec3 eye, Vec3 towards) {
  c.world = look_at(eye, eye + towards);
  return c;
}
Camera moved(Camera c, Vec3 by) {
  c.world = translation(by) * c.world;
  return c;
}

}  // namespace

Camera orbited(const Camera& c, Vec3 about, double around, double up) {
  const double elevation = std::asin(std::clamp(forward(c).y, -1.0, 1.0));
  const double to = std::clamp(elevation + up, std::min(elevation, -nearest_pole), std::max(elevation, nearest_pole));
  const Vec3 right = normalize(transform_vector(c.world, {1, 0, 0}));
  const Quat turn = axis_angle({0, 1, 0}, around) * axis_angle(right, to - elevation);
  Camera out = c;
  out.world = translation(about) * rotation(turn) * translation(-about) * c.world;
  // Keeps the camera upright, except where it looks straight up or down and has no upright direction.
  const Vec3 eye = translation_of(out.world), towards = forward(out);
  return std::abs(towards.y) < std::sin(nearest_pole) + 1e-9 ? at(out, eye, towards) : out;
}

Camera panned(const Camera& c, double aspect, double dx, double dy, double depth) {
  const Projection p(c, aspect);
  const double h = p.height(depth);
  return moved(c, -dx * h * aspect * p.right() + dy * h * p.up());
}

Camera zoomed(const Camera& c, Vec3 place, double factor) {
  const Vec3 eye = translation_of(c.world);
  if (!c.orthographic) return moved(c, (1 - factor) * (place - eye));
  Camera out = c;
  out.height *= factor;
  const Vec3 ahead = forward(c), across = place - eye - dot(place - eye, ahead) * ahead;
  return moved(out, (1 - factor) * across);
}

Camera looking_along(const Camera& c, Vec3 direction, Vec3 place, double distance) {
  return at(c, place - distance * direction, direction);
}

Camera framed(const Camera& c, const Box& box, double aspect) {
  const double radius = std::max(length(box.half()), 1e-3) * margin;
  const Vec3 towards = forward(c);
  Camera out = c;
  double distance = 3 * radius;
  if (c.orthographic) {
    out.height = 2 * radius / std::min(1.0, aspect);
    // Stay behind the objects in front, so that they remain visible.
    distance = std::max(distance, dot(box.middle() - translation_of(c.world), towards));
  } else {
    const double wide = std::tan(std::clamp(c.fov, 1e-3, 3.0) / 2);
    distance = radius / std::sin(std::atan(std::min(wide, wide / aspect)));
  }
  out.world = moved(c, box.middle() - distance * towards - translation_of(c.world)).world;
  return out;
}

Camera with_perspective(const Camera& c, bool perspective, double aspect, double depth) {
  if (c.orthographic != perspective) return c;
  Camera out = c;
  out.orthographic = !perspective;
  if (!perspective) {
    out.height = Projection(c, aspect).height(depth);
    return out;
  }
  if (!(out.fov > 0.01 && out.fov < 2.5)) out.fov = 0.9;
  // At this distance, objects at `depth` keep their size.
  const double far = c.height * aspect / 2 / std::tan(out.fov / 2);
  return moved(out, (depth - far) * forward(c));
}

Camera widened(const Camera& c, double part_of_width, double part_of_height) {
  Camera out = c;
  out.height = c.height / std::max(part_of_height, 1e-3);
  out.fov = 2 * std::atan(std::tan(std::clamp(c.fov, 1e-5, 3.0) / 2) / std::max(part_of_width, 1e-3));
  out.shift_x *= part_of_width, out.shift_y *= part_of_height;
  return out;
}

}  // namespace betwixt::studio
