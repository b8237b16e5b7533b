// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/ray_camera.h"

#include "render/blends.h"

namespace betwixt::traced {
namespace {

// Returns a point of the disc of radius 1. Squares around the middle become circles, so that points that are spread
// evenly over the square are so over the disc (Shirley and Chiu).
Vec3 on_disc(double x, double y) {
  const double a = 2 * x - 1, b = 2 * y - 1;
  if (a == 0 && b == 0) return {};
  const bool flat = std::abs(a) > std::abs(b);
  const auto [sine, cosine] = sine_cosine(pi / 4 * (flat ? b / a : a / b));
  return flat ? Vec3{a * cosine, a * sine, 0} : Vec3{b * sine, b * cosine, 0};
}

}  // namespace

RayCamera::RayCamera(std::span<const View> views, std::span<const Camera> cameras, bool moves)
    : orthographic_(views.front().orthographic), blurs_(moves || views.size() > 1) {
  for (std::size_t k = 0; k < views.size(); ++k) {
    Pose p{views[k], views[k].eye - views.front().eye};
    if (!orthographic_ && cameras[k].aperture > 0 && cameras[k].focus > 0)
      p.lens = cameras[k].aperture / 2, p.focus = cameras[k].focus, blurs_ = lens_ = true;
    poses_.push_back(p);
  }
}

RayCamera::Line RayCamera::line(const Pose& p, const RayChoice& c, Vec3 on_lens) const {
  const View& v = p.view;
  const Vec3 there = (2 * c.across - 1 - v.shift_x) / v.sx * v.right + (1 - 2 * c.down - v.shift_y) / v.sy * v.up;
  if (orthographic_) return {p.eye + there, -v.backward};
  if (!(p.lens > 0)) return {p.eye, there - v.backward};
  const Vec3 off = p.lens * (on_lens.x * v.right + on_lens.y * v.up);
  return {p.eye + off, there - v.backward - 1 / p.focus * off};
}

Ray RayCamera::ray(const RayChoice& c) const {
  const Vec3 lens = lens_ ? on_disc(c.lens_x, c.lens_y) : Vec3{};
  const double time = std::min(static_cast<double>(static_cast<float>(c.time)), 0x1.fffffep-1);
  const TimeStep step(time, poses_.size());
  Line l = line(poses_[step.first], c, lens);
  if (step.share > 0) {
    const Line next = line(poses_[step.first + 1], c, lens);
    l = {mix(l.from, next.from, step.share), mix(l.along, next.along, step.share)};
  }
  return {l.from, orthographic_ && poses_.size() == 1 ? l.along : unit(l.along), time};
}

}  // namespace betwixt::traced
