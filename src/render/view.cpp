// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/view.h"

#include <algorithm>

namespace betwixt {

std::array<float, 16> to_float(const Mat4& a) {
  std::array<float, 16> r;
  std::transform(a.m.begin(), a.m.end(), r.begin(), [](double x) { return static_cast<float>(x); });
  return r;
}

Bounds bounds_of(const Box& box, const Mat4& m) {
  const Vec3 half = box.half();
  Bounds b{transform_point(m, box.middle()), {}};
  for (int i = 0; i < 3; ++i)
    b.half[i] = std::abs(m(i, 0)) * half.x + std::abs(m(i, 1)) * half.y + std::abs(m(i, 2)) * half.z;
  return b;
}

View make_view(const Camera& camera, int width, int height, bool& good) {
  View v;
  v.width = width, v.height = height;
  v.orthographic = camera.orthographic;
  v.shift_x = camera.shift_x, v.shift_y = camera.shift_y;
  v.eye = translation_of(camera.world);
  // If the camera has a scaled parent, its matrix is made rigid.
  v.backward = normalize(transform_vector(camera.world, {0, 0, 1}), {0, 0, 1});
  v.right = normalize(cross(transform_vector(camera.world, {0, 1, 0}), v.backward), {1, 0, 0});
  v.up = cross(v.backward, v.right);
  const double aspect = static_cast<double>(width) / height;
  if (v.orthographic) {
    v.tall = std::max(camera.height, 1e-9) / 2, v.wide = v.tall * aspect;
    v.sy = 1 / v.tall, v.sx = 1 / v.wide;
  } else {
    v.sx = 1 / std::tan(std::clamp(camera.fov, 1e-5, pi - 1e-3) / 2), v.sy = v.sx * aspect;
    const double x = v.shift_x, y = v.shift_y;
    v.side = {normalize(v.sx * v.right - (1 + x) * v.backward), normalize(-v.sx * v.right - (1 - x) * v.backward),
              normalize(v.sy * v.up - (1 + y) * v.backward), normalize(-v.sy * v.up - (1 - y) * v.backward)};
  }
  good = finite(camera.world) && std::isfinite(v.sx) && std::isfinite(v.sy) && std::isfinite(v.shift_x) &&
         std::isfinite(v.shift_y) && finite(v.up);
  return v;
}

double View::reach(const Bounds& b) const {
  return std::abs(backward.x) * b.half.x + std::abs(backward.y) * b.half.y + std::abs(backward.z) * b.half.z;
}

bool View::sees(const Bounds& b) const {
  const double radius = b.radius();
  if (depth(b.center) + reach(b) <= 0) return false;
  if (orthographic)
    return std::abs(dot(b.center, right) + shift_x * wide) < wide + radius &&
           std::abs(dot(b.center, up) + shift_y * tall) < tall + radius;
  return std::all_of(side.begin(), side.end(), [&](Vec3 n) { return dot(b.center, n) > -radius; });
}

double View::pixels(const Bounds& b) const {
  const double scale = sx * width * b.radius();
  return orthographic ? scale : scale / std::max(depth(b.center) - 0.5 * b.radius(), 1e-3 * b.radius() + 1e-300);
}

void View::fit(double nearest, double farthest) {
  far = std::max(farthest, 1e-6) * 1.001;
  // Four decades leave the depth buffer a millimetre at ten metres in a scene of depth forty.
  near = orthographic ? std::max(nearest * 0.999, 0.0) : std::max(nearest * 0.999, far * 1e-4);
  if (near >= far) near = far * 0.5;
}

Mat4 View::clip() const {
  Mat4 turn;
  for (int c = 0; c < 3; ++c) turn(0, c) = right[c], turn(1, c) = up[c], turn(2, c) = backward[c];
  Mat4 p;
  p(0, 0) = sx, p(1, 1) = -sy;
  if (orthographic) {
    p(2, 2) = -2 / (far - near), p(2, 3) = -(far + near) / (far - near);
    p(0, 3) = shift_x, p(1, 3) = -shift_y;
  } else {
    p(2, 2) = -(far + near) / (far - near), p(2, 3) = -2 * far * near / (far - near);
    p(3, 2) = -1, p(3, 3) = 0;
    p(0, 2) = -shift_x, p(1, 2) = shift_y;
  }
  return p * turn;
}

}  // namespace betwixt
