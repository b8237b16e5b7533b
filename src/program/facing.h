// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Rotations of objects that face a direction.
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "betwixt/math.h"

namespace betwixt {

// The axis of an object that is its front.
inline constexpr std::array<std::string_view, 6> front_names{"x", "-x", "y", "-y", "z", "-z"};
enum class Front : std::uint8_t { x, minus_x, y, minus_y, z, minus_z };

// Returns the rotation that points the front along `direction`. Of the other two axes, y (or z if y is the front)
// points up as far as possible. With `flat`, z keeps pointing at the viewer, so an object that faces with x or y turns
// about z.
inline Quat facing(Vec3 direction, Front front, bool flat) {
  const int axis = static_cast<int>(front) / 2;
  flat = flat && axis != 2;
  const Vec3 along = (static_cast<int>(front) % 2 == 0 ? 1.0 : -1.0) * normalize(direction, {1, 0, 0});
  const int upright = flat || axis == 1 ? 2 : 1;
  Vec3 up = flat ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
  if (std::abs(dot(along, up)) > 1 - 1e-12) up = flat ? Vec3{0, 1, 0} : Vec3{0, 0, -dot(along, up)};
  const int third = 3 - axis - upright;
  Vec3 axes[3];
  axes[axis] = along;
  // The third axis is perpendicular to both. The order of the axes gives its sign.
  const bool cyclic = (upright + 1) % 3 == axis;
  axes[third] = normalize(cyclic ? cross(up, along) : cross(along, up));
  axes[upright] = cyclic ? cross(along, axes[third]) : cross(axes[third], along);
  Mat4 m;
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < 3; ++i) m(i, c) = axes[c][i];
  return from_matrix(m);
}

}  // namespace betwixt
