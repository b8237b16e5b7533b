// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The camera's view. All drawing is in *eye space*: the axes of the world, with the camera at the origin. Positions are
// made relative in f64, so scenes far from the world's origin do not jitter in f32.
#pragma once

#include <array>

#include "betwixt/frame.h"

namespace betwixt {

// A box along the axes of eye space.
struct Bounds {
  Vec3 center, half;
  double radius() const { return length(half); }
};

// Returns the bounds of a box that a matrix moves.
Bounds bounds_of(const Box&, const Mat4&);

// The radius of contact shading, as a part of the picture's height.
inline constexpr double contact_reach = 0.2;

struct View {
  Vec3 eye;                  // world
  Vec3 right, up, backward;  // world, the camera's x, y and z
  bool orthographic = false;
  double sx = 1, sy = 1;            // camera x/y to clip space, at depth 1 (perspective) or at any depth (orthographic)
  double near = 0.1, far = 100;     // metres before the eye; chosen by fit()
  int width = 1, height = 1;        // pixels of the picture
  std::array<Vec3, 4> side;         // inward normals of the frustum's side planes; of unit length
  double wide = 0, tall = 0;        // half the size of an orthographic picture
  double shift_x = 0, shift_y = 0;  // lens shift right and up, in halves of the picture

  double depth(Vec3 p) const { return -dot(p, backward); }
  // Returns half the extent of a box along the line of sight.
  double reach(const Bounds&) const;
  bool sees(const Bounds&) const;      // may be true for objects outside, but is never false for one in the picture
  double pixels(const Bounds&) const;  // approximate width in the picture
  void fit(double nearest, double farthest);
  Mat4 clip() const;  // eye space to clip space, upside down (see Canvas)
};

// Returns the view; sets `good` to whether the camera's numbers are valid.
View make_view(const Camera&, int width, int height, bool& good);

std::array<float, 16> to_float(const Mat4&);

}  // namespace betwixt
