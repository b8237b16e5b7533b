// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/skies.h"

#include <algorithm>
#include <cmath>

#include "render/blends.h"

namespace betwixt {
namespace {

// ---- a studio

struct Softbox {
  Vec3 toward;           // its middle
  double width, height;  // half of them, one metre away
  double soft;           // how much of that is its edge
  Vec3 light;
};
constexpr Softbox softboxes[] = {
    {{-0.62, 0.72, 0.55}, 0.62, 0.42, 0.25, {3.0, 2.9, 2.72}},   // key
    {{0.92, 0.22, 0.42}, 0.42, 0.70, 0.5, {0.62, 0.69, 0.80}},   // fill
    {{0.45, 0.42, -0.86}, 0.28, 0.62, 0.3, {2.1, 2.18, 2.34}},   // rim
    {{-0.75, 0.15, -0.70}, 0.20, 0.55, 0.4, {1.0, 1.0, 1.04}},   // second rim
    {{0.10, 0.42, 1.0}, 1.40, 0.95, 0.92, {0.96, 0.945, 0.93}},  // a large card in front: flat faces mirror its edge
    {{0.10, 1.0, -0.15}, 0.50, 0.50, 0.6, {0.75, 0.75, 0.75}},   // from above
};

double within(double at, double half, double soft) { return 1 - smoothstep(half * (1 - soft), half, std::abs(at)); }

Vec3 studio_radiance(Vec3 d) {
  Vec3 light = mix({0.05, 0.048, 0.046}, {0.15, 0.156, 0.168}, smoothstep(-0.35, 0.9, d.y));
  for (const Softbox& box : softboxes) {
    const Vec3 n = normalize(box.toward);
    const double deep = dot(d, n);
    if (deep <= 0.05) continue;
    const Vec3 across = normalize(cross(std::abs(n.y) > 0.95 ? Vec3{0, 0, 1} : Vec3{0, 1, 0}, n)),
               over = cross(n, across);
    const double share =
        within(dot(d, across) / deep, box.width, box.soft) * within(dot(d, over) / deep, box.height, box.soft);
    light = light + 0.9 * share * box.light;
  }
  return light;
}

// ---- a picture of the whole sky

// Returns the angle of (x y) as a share of a turn, -0.5 to 0.5, within 2e-7.
double turn_of(double y, double x) {
  const double ax = std::abs(x), ay = std::abs(y), big = std::max(ax, ay);
  if (!(big > 0)) return 0;
  const double q = std::min(ax, ay) / big, s = q * q;
  double a =
      q * (0.99997726 + s * (-0.33262347 + s * (0.19354346 + s * (-0.11643287 + s * (0.05265332 - s * 0.01172120)))));
  if (ay > ax) a = pi / 2 - a;
  if (x < 0) a = pi - a;
  return (y < 0 ? -a : a) / (2 * pi);
}

Vec3 picture_radiance(const LinearPicture& p, Vec3 d) {
  const auto area = static_cast<std::size_t>(std::max(p.width, 0)) * static_cast<std::size_t>(std::max(p.height, 0));
  if (area == 0 || p.rgba.size() < 4 * area) return {};
  const double across = turn_of(d.z, d.x) + 0.5, down = 0.5 - 2 * turn_of(d.y, std::sqrt(std::max(1 - d.y * d.y, 0.0)));
  const double x = across * p.width - 0.5, y = std::clamp(down * p.height - 0.5, 0.0, p.height - 1.0);
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(y);
  Vec3 sum;
  for (int k = 0; k < 4; ++k) {
    const int i = x0 + k % 2, j = y0 + k / 2;
    const double share = (1 - std::abs(x - i)) * (1 - std::abs(y - j));
    const auto at = static_cast<std::size_t>(std::min(j, p.height - 1)) * static_cast<std::size_t>(p.width) +
                    static_cast<std::size_t>((i + p.width) % p.width);
    const float* const c = &p.rgba[4 * at];
    sum = sum + share * Vec3{static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])};
  }
  return sum;
}

}  // namespace

SkyModel::Day SkyModel::day_at(double hour) {
  constexpr double highest = 1.05;  // radians
  const double along = pi * (std::clamp(hour, 0.0, 24.0) - 6) / 12;
  const auto [up, across] = sine_cosine(along);
  const auto [lift, flat] = sine_cosine(highest);
  Day s;
  s.sun = normalize(Vec3{across, up * lift, up * flat * 0.6}, {0, 1, 0});
  const double high = s.sun.y;
  const double day = smoothstep(-0.2, 0.27, high);      // how much of the full light there is
  const double low = 1 - smoothstep(0.02, 0.42, high);  // how red the light is
  // A low sun gives a surface that faces it about five times as much light as the sky gives the ground, as formulas of
  // daylight say from 6 to 10 degrees.
  // Above, a clear sky is xy = (0.25 0.255) (CIE): bluer ones made gold green.
  s.zenith = mix({0.012, 0.018, 0.045}, mix({0.165, 0.245, 0.465}, {0.095, 0.14, 0.29}, low), day);
  s.horizon = mix({0.03, 0.035, 0.06}, mix({0.62, 0.73, 0.86}, {0.58, 0.36, 0.22}, low), day);
  s.glow = day * mix({0.45, 0.42, 0.36}, {1.4, 0.62, 0.18}, low);
  s.light = smoothstep(-0.04, 0.19, high) * mix({1.08, 0.95, 0.76}, {2.0, 0.98, 0.38}, low);
  return s;
}

Vec3 SkyModel::day_radiance(const Day& s, Vec3 d) {
  const Vec3 ground{0.16, 0.15, 0.135};
  const double up = std::max(d.y, 0.0), near = 1 - up, haze = near * near * near * near;
  const double toward = std::max(dot(d, s.sun), 0.0), t2 = toward * toward, t4 = t2 * t2, t8 = t4 * t4,
               t64 = t8 * t8 * t8 * t8 * t8 * t8 * t8 * t8;
  Vec3 sky = mix(s.zenith, s.horizon, haze + 0.25 * near * (1 - haze));
  sky = sky + (0.25 * t4 * (0.35 + 0.65 * haze) + 0.8 * t64) * s.glow;
  return mix(sky, mix({1, 1, 1}, s.horizon, 0.5) * ground, smoothstep(0.0, -0.05, d.y));
}

SkyModel::SkyModel(const Sky& sky) : sky_(sky) {
  constexpr double at_sunset = 17.5;  // six and a half degrees
  if (sky.kind == Sky::day || sky.kind == Sky::sunset) day_ = day_at(sky.kind == Sky::sunset ? at_sunset : sky.hour);
}

std::optional<SkySun> SkyModel::sun() const {
  if (sky_.kind == Sky::studio) return SkySun{normalize(softboxes[0].toward), {0.72, 0.695, 0.65}, 0.16};
  if (!(day_.light.x > 0) || day_.sun.y <= 0) return std::nullopt;
  return SkySun{day_.sun, day_.light, 0.0175};
}

Vec3 SkyModel::radiance(Vec3 d) const {
  switch (sky_.kind) {
    case Sky::studio:
      return studio_radiance(d);
    case Sky::day:
    case Sky::sunset:
      return day_radiance(day_, d);
    case Sky::overcast:
      return mix((1 + 2 * std::max(d.y, 0.0)) / 3 * Vec3{0.86, 0.89, 0.94}, {0.19, 0.185, 0.175},
                 smoothstep(0.0, -0.08, d.y));
    case Sky::picture:
      return sky_.light ? picture_radiance(*sky_.light, d) : Vec3{};
    case Sky::none:
      break;
  }
  return {};
}

}  // namespace betwixt
