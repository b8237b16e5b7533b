// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/lighting.h"

#include <algorithm>

namespace betwixt {
namespace {

// Key from the upper left, fill from the right, rim from behind. They turn with the camera, but only about the
// vertical, so that light always comes from above and shadows fall on the ground.
std::vector<Lighting::One> rig(const View& view) {
  Vec3 right = view.right;
  right.y = 0;
  right = normalize(right, {1, 0, 0});
  const Vec3 up{0, 1, 0}, toward_eye = cross(right, up);
  const auto sun = [&](double x, double y, double z, Vec3 color) {
    return Lighting::One{true, normalize(x * right + y * up + z * toward_eye), color, 1, {}, 0};
  };
  return {sun(-0.55, 0.95, 0.6, {0.86, 0.83, 0.78}), sun(0.9, 0.35, 0.55, {0.13, 0.15, 0.19}),
          sun(0.35, 0.6, -0.9, {0.3, 0.32, 0.36})};
}

// The radius of the disc of a sun with soft shadows (six degrees wide), and that of a lamp as a part of its range.
constexpr double sun_size = 0.0524, lamp_size = 0.025;

// With this share of a light and the sky's, a white surface that faces a lamp of intensity 1 is exactly white.
constexpr double gain = 0.8;

double importance(const Lighting::One& l, Vec3 center) {
  const double strength = l.color.x + l.color.y + l.color.z;
  if (l.sun) return strength;
  const double d = length(l.place - center) / l.range, w = std::max(1 - d * d, 0.0);
  return strength * w * w;
}

struct Candidate {
  Lighting::One one;
  Casting casting;
};

// Those with shadows come first.
void take(Lighting& r, std::vector<Candidate>& sorted) {
  if (sorted.size() > Lighting::most) sorted.resize(Lighting::most);
  for (std::size_t i = 0; i < sorted.size(); ++i)
    if (i > 0 && sorted[i].casting == Casting::strongest) sorted[i].casting = Casting::off;
  for (const bool casts : {true, false})
    for (const Candidate& c : sorted)
      if ((c.casting != Casting::off) == casts) r.lights.push_back(c.one), r.casting += casts;
  r.casting = std::min(r.casting, Lighting::most_casting);
}

// Adds what only lamps with an area or a cone have. The light of an area becomes less with the square of the distance.
void add_front(Lighting::One& one, const Light& l) {
  if (l.sun || !finite(l.direction) || !finite(l.across)) return;
  one.aim = normalize(l.direction, {0, -1, 0}), one.across = normalize(l.across, {1, 0, 0});
  if (std::isfinite(l.cone) && l.cone > 0)
    one.cone = std::min(l.cone, 3.1), one.cone_edge = l.cone_edge, one.picture = l.picture;
  if (l.shape == LightShape::point || !std::isfinite(l.width) || !std::isfinite(l.height)) return;
  one.shape = l.shape;
  one.half_width = std::clamp(l.width / 2, 1e-4, 1e6), one.half_height = std::clamp(l.height / 2, 1e-4, 1e6);
  const double area = (l.shape == LightShape::disc ? pi : 4) * one.half_width * one.half_height;
  const double bright_at = one.range / 4;
  one.color = pi * bright_at * bright_at / area * one.color;
  if (l.casting != Casting::off) one.size = std::sqrt(one.half_width * one.half_height);
}

// Returns the lights in use, or the default ones.
Lighting chosen(const std::vector<Light>& lights, const View& view, Vec3 center, const Surroundings& around,
                const std::optional<SkySun>& sun) {
  Lighting r;
  if (lights.empty() && around.environment.kind == Sky::none && !sun) {
    r.lights = rig(view), r.casting = 1;
    return r;
  }
  std::vector<Candidate> found;
  if (sun) found.push_back({{true, sun->toward, sun->color, 1, {}, sun->size}, Casting::soft});
  for (const Light& l : lights) {
    if (!finite(l.color) || !finite(l.position) || !finite(l.direction) || std::isnan(l.range)) continue;
    if (!l.sun && !(l.range > 0)) continue;
    const Vec3 color = gain * Vec3{std::max(l.color.x, 0.0), std::max(l.color.y, 0.0), std::max(l.color.z, 0.0)};
    const double range = std::clamp(l.range, 1e-9, 1e15);
    const double size = l.casting != Casting::soft ? 0 : l.sun ? sun_size : lamp_size * range;
    const Vec3 place = l.sun ? normalize(-l.direction, {0, 1, 0}) : l.position - view.eye;
    Lighting::One one{l.sun, place, color, range, l.position, size};
    add_front(one, l);
    found.push_back({one, l.casting});
  }
  std::stable_sort(found.begin(), found.end(), [center](const auto& a, const auto& b) {
    return importance(a.one, center) > importance(b.one, center);
  });
  take(r, found);
  return r;
}

// Sets ambient light, and scales all light by the exposure.
void surround(Lighting& r, const Surroundings& around) {
  r.sky = {0.2, 0.215, 0.24}, r.ground = {0.1, 0.09, 0.08};
  if (around.sky) r.sky = {0.2, 0.25, 0.33};
  if (around.ground) r.ground = 0.3 * *around.ground;
  if (around.ambient) r.sky = r.ground = *around.ambient;
  r.zenith = {0.12, 0.25, 0.54}, r.horizon = {0.6, 0.72, 0.84}, r.below = {0.16, 0.155, 0.15};
  const double share = std::exp2(around.exposure);
  for (Vec3* light : {&r.sky, &r.ground, &r.zenith, &r.horizon, &r.below}) *light = share * *light;
  for (Lighting::One& l : r.lights) l.color = share * l.color;
}

}  // namespace

Lighting lighting_of(const std::vector<Light>& lights, const View& view, Vec3 center, const Surroundings& around,
                     const std::optional<SkySun>& sun) {
  Lighting r = chosen(lights, view, center, around, sun);
  surround(r, around);
  if (around.flat) r.lights.clear(), r.casting = 0;
  return r;
}

}  // namespace betwixt
