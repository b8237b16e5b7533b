// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/sky_light.h"

#include <algorithm>
#include <cmath>
#include <list>
#include <mutex>

namespace betwixt {
namespace {

// Returns the direction of a place on a face of the cube; s to the right and t down, -1 to 1.
Vec3 direction(int face, double s, double t) {
  switch (face) {
    case 0:
      return {1, -t, -s};
    case 1:
      return {-1, -t, s};
    case 2:
      return {s, 1, t};
    case 3:
      return {s, -1, -t};
    case 4:
      return {s, -t, 1};
    default:
      return {-s, -t, -1};
  }
}

struct CubePlace {
  int face = 0;
  double s = 0, t = 0;
};
CubePlace place_of(Vec3 d) {
  const double x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
  if (x >= y && x >= z) return d.x > 0 ? CubePlace{0, -d.z / x, -d.y / x} : CubePlace{1, d.z / x, -d.y / x};
  if (y >= z) return d.y > 0 ? CubePlace{2, d.x / y, d.z / y} : CubePlace{3, d.x / y, -d.z / y};
  return d.z > 0 ? CubePlace{4, d.x / z, -d.y / z} : CubePlace{5, -d.x / z, -d.y / z};
}

using SkyLevel = SkyLight::Level;

Vec3 pixel(const SkyLevel& l, int face, int x, int y) {
  const std::size_t at = 3 * (static_cast<std::size_t>(face * l.side + y) * static_cast<std::size_t>(l.side) +
                              static_cast<std::size_t>(x));
  return {static_cast<double>(l.rgb[at]), static_cast<double>(l.rgb[at + 1]), static_cast<double>(l.rgb[at + 2])};
}
void put(SkyLevel& l, int face, int x, int y, Vec3 c) {
  const std::size_t at = 3 * (static_cast<std::size_t>(face * l.side + y) * static_cast<std::size_t>(l.side) +
                              static_cast<std::size_t>(x));
  for (int i = 0; i < 3; ++i) l.rgb[at + static_cast<std::size_t>(i)] = static_cast<float>(c[i]);
}
SkyLevel level_of(int side) { return {side, std::vector<float>(static_cast<std::size_t>(18 * side * side))}; }

template <class F>
void each_pixel(const SkyLevel& l, F&& f) {
  for (int face = 0; face < 6; ++face)
    for (int y = 0; y < l.side; ++y)
      for (int x = 0; x < l.side; ++x) f(face, x, y, (2 * x + 1.0) / l.side - 1, (2 * y + 1.0) / l.side - 1);
}

// Interpolates within a face.
Vec3 looked_up(const SkyLevel& l, Vec3 d) {
  const CubePlace p = place_of(d);
  const double x = std::clamp((p.s + 1) / 2 * l.side - 0.5, 0.0, l.side - 1.0);
  const double y = std::clamp((p.t + 1) / 2 * l.side - 0.5, 0.0, l.side - 1.0);
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, l.side - 1), y1 = std::min(y0 + 1, l.side - 1);
  const double a = x - x0, b = y - y0;
  return (1 - b) * ((1 - a) * pixel(l, p.face, x0, y0) + a * pixel(l, p.face, x1, y0)) +
         b * ((1 - a) * pixel(l, p.face, x0, y1) + a * pixel(l, p.face, x1, y1));
}

SkyLevel half_of(const SkyLevel& l) {
  SkyLevel r = level_of(l.side / 2);
  each_pixel(r, [&](int face, int x, int y, double, double) {
    put(r, face, x, y,
        0.25 * (pixel(l, face, 2 * x, 2 * y) + pixel(l, face, 2 * x + 1, 2 * y) + pixel(l, face, 2 * x, 2 * y + 1) +
                pixel(l, face, 2 * x + 1, 2 * y + 1)));
  });
  return r;
}

// The directions that a rough surface mirrors where one looks straight at it, about the z axis; each with its weight
// and the level of detail at which it is looked up.
struct SkyLobe {
  Vec3 d;
  double weight;
  std::size_t level;
};
std::vector<SkyLobe> lobes_of(double roughness, std::size_t finest, std::size_t coarsest) {
  constexpr int count = 64;
  const double a = roughness * roughness, a2 = a * a;
  std::vector<SkyLobe> all;
  for (int i = 0; i < count; ++i) {
    double reversed = 0, step = 0.5;
    for (int bits = i; bits > 0; bits /= 2, step /= 2) reversed += step * (bits % 2);
    const double u = (i + 0.5) / count, c2 = (1 - u) / (1 + (a2 - 1) * u), c = std::sqrt(c2),
                 s = std::sqrt(std::max(1 - c2, 0.0));
    const auto [sine, cosine] = sine_cosine(2 * pi * reversed);
    const Vec3 h{s * cosine, s * sine, c};
    const Vec3 d = 2 * h.z * h - Vec3{0, 0, 1};
    if (!(d.z > 0)) continue;
    // The more of the sphere a direction stands for, the coarser it is looked up.
    const double k = c2 * (a2 - 1) + 1, density = a2 / (pi * k * k) / 4;
    const double stands_for = 1 / (count * density), texel = 4 * pi / (6.0 * SkyLight::side * SkyLight::side);
    std::size_t level = 0;
    for (double area = 2 * texel; area < stands_for && level < coarsest; area *= 4) ++level;
    all.push_back({d, d.z, std::max(level, finest)});
  }
  return all;
}

// The spherical harmonics up to the second degree, without their constants.
std::array<double, 9> harmonics(Vec3 d) {
  return {1, d.y, d.z, d.x, d.x * d.y, d.y * d.z, 3 * d.z * d.z - 1, d.x * d.z, d.x * d.x - d.y * d.y};
}

}  // namespace

SkyLight::SkyLight(const Sky& sky, const std::optional<Vec3>& ground) : sky_(sky), sun_(sky_.sun()) {
  const auto halves = [this] {
    std::vector<Level> all{level_of(side)};
    each_pixel(all[0], [&](int face, int x, int y, double s, double t) {
      put(all[0], face, x, y, radiance(normalize(direction(face, s, t))));
    });
    while (all.back().side > 4) all.push_back(half_of(all.back()));
    return all;
  };
  std::vector<Level> halved = halves();
  sum_up(halved);
  if (ground) {
    // The floor shows its own light below the horizon, and so lights things from there.
    Vec3 light = irradiance({0, 1, 0});
    if (sun_) light = light + std::max(sun_->toward.y, 0.0) * sun_->color;
    floor_ = *ground * light, has_floor_ = true;
    halved = halves();
    sum_up(halved);
  }
  blur(halved);
}

Vec3 SkyLight::radiance(Vec3 along) const {
  if (!has_floor_ || along.y >= 0) return seen(along);
  const double share = std::min(-40 * along.y, 1.0);
  return (1 - share) * seen(along) + share * floor_;
}

Vec3 SkyLight::irradiance(Vec3 n) const {
  const std::array<double, 9> by = harmonics(n);
  Vec3 sum;
  for (std::size_t i = 0; i < 9; ++i) sum = sum + by[i] * irradiance_[i];
  return {std::max(sum.x, 0.0), std::max(sum.y, 0.0), std::max(sum.z, 0.0)};
}

void SkyLight::sum_up(const std::vector<Level>& halved) {
  sums_.clear();
  double sum = 0;
  each_pixel(halved[1], [&](int face, int x, int y, double s, double t) {
    const double away = 1 + s * s + t * t;
    const Vec3 c = pixel(halved[1], face, x, y);
    // A little for every direction, since the sky is not as coarse as these pixels.
    sums_.push_back(sum += (0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z + 1e-3) / (away * std::sqrt(away)));
  });
  for (double& to : sums_) to /= sum;
  // Spherical harmonics of the second degree, with the cosine of the angle of incidence.
  const SkyLevel& coarse = halved[2];
  std::array<Vec3, 9> sums{};
  double whole = 0;
  each_pixel(coarse, [&](int face, int x, int y, double s, double t) {
    const double away = 1 + s * s + t * t, share = 1 / (away * std::sqrt(away));
    const Vec3 d = normalize(direction(face, s, t)), light = share * pixel(coarse, face, x, y);
    const std::array<double, 9> by = harmonics(d);
    for (std::size_t i = 0; i < 9; ++i) sums[i] = sums[i] + by[i] * light;
    whole += share;
  });
  // Squares of the constants of the harmonics times 4 pi, and the shares that the cosine leaves: 1, 2/3 and 1/4.
  constexpr std::array<double, 9> constants{1, 2, 2, 2, 15.0 / 4, 15.0 / 4, 5.0 / 16, 15.0 / 4, 15.0 / 16};
  for (std::size_t i = 0; i < 9; ++i) irradiance_[i] = constants[i] / whole * sums[i];
}

double SkyLight::roughness_of(int level) { return 1 - std::sqrt(1 - static_cast<double>(level) / levels); }

void SkyLight::blur(const std::vector<Level>& halved) {
  cube_[0] = halved[0];
  for (int k = 1; k < levels; ++k) {
    SkyLevel level = level_of(side >> k);
    const auto lobes = lobes_of(roughness_of(k), static_cast<std::size_t>(std::max(k - 1, 0)), halved.size() - 1);
    each_pixel(level, [&](int face, int x, int y, double s, double t) {
      const Vec3 n = normalize(direction(face, s, t));
      const Vec3 across = normalize(cross(std::abs(n.y) < 0.9 ? Vec3{0, 1, 0} : Vec3{1, 0, 0}, n)),
                 over = cross(n, across);
      Vec3 sum;
      double weight = 0;
      for (const SkyLobe& lobe : lobes) {
        const Vec3 d = lobe.d.x * across + lobe.d.y * over + lobe.d.z * n;
        sum = sum + lobe.weight * looked_up(halved[lobe.level], d), weight += lobe.weight;
      }
      put(level, face, x, y, 1 / weight * sum);
    });
    cube_[static_cast<std::size_t>(k)] = std::move(level);
  }
}

SkyLight::Direction SkyLight::sample(double which, double across, double down) const {
  constexpr int n = side / 2;
  const auto found = std::upper_bound(sums_.begin(), sums_.end(), which);
  const auto k =
      static_cast<std::size_t>(std::min(found - sums_.begin(), static_cast<std::ptrdiff_t>(sums_.size()) - 1));
  const auto face = static_cast<int>(k) / (n * n), y = static_cast<int>(k) / n % n, x = static_cast<int>(k) % n;
  const Vec3 d = normalize(direction(face, 2 * (x + across) / n - 1, 2 * (y + down) / n - 1));
  return {d, density(d)};
}

double SkyLight::density(Vec3 d) const {
  constexpr int n = side / 2;
  const CubePlace p = place_of(d);
  const int x = std::clamp(static_cast<int>((p.s + 1) / 2 * n), 0, n - 1),
            y = std::clamp(static_cast<int>((p.t + 1) / 2 * n), 0, n - 1);
  const auto k = static_cast<std::size_t>((p.face * n + y) * n + x);
  const double share = sums_[k] - (k > 0 ? sums_[k - 1] : 0), away = 1 + p.s * p.s + p.t * p.t;
  return share * n * n / 4 * away * std::sqrt(away);
}

std::shared_ptr<const SkyLight> sky_light_of(const Sky& sky, const std::optional<Vec3>& ground) {
  if (sky.kind == Sky::none || (sky.kind == Sky::picture && !sky.light)) return nullptr;
  struct Known {
    Sky sky;
    std::optional<Vec3> ground;
    std::shared_ptr<const SkyLight> made;
  };
  constexpr std::size_t most = 8;
  static std::mutex mutex;
  static std::list<Known> all;
  const std::lock_guard lock(mutex);
  for (auto at = all.begin(); at != all.end(); ++at)
    if (at->sky == sky && at->ground == ground) {
      all.splice(all.begin(), all, at);
      return all.front().made;
    }
  all.push_front({sky, ground, std::make_shared<const SkyLight>(sky, ground)});
  if (all.size() > most) all.pop_back();
  return all.front().made;
}

}  // namespace betwixt
