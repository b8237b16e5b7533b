// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/physical_tracer.h"

#include "render/path_tracer.h"
#include "render/traced_sampling.h"
#include "scene/materials.h"

namespace betwixt::traced {
namespace {

constexpr int most_bounces = 16, bounces_before_chance = 3;
// Paths that reach a light by way of a second surface are limited to this, or single ones would be white dots.
constexpr double brightest_indirect = 4;

double fifth(double x) { return x * x * x * x * x; }

// The shares of light from all around that a rough surface reflects, by the cosine of the angle of sight and the
// roughness: for a reflectance of 0 at all angles but grazing ones, and what a reflectance adds. Worked out once.
class ReflectedShares {
 public:
  ReflectedShares() {
    for (std::size_t j = 0; j < side; ++j)
      for (std::size_t i = 0; i < side; ++i)
        at_[j * side + i] =
            worked_out(std::max(static_cast<double>(i), 0.05) / (side - 1), static_cast<double>(j) / (side - 1));
  }
  std::array<double, 2> at(double nv, double roughness) const {
    const double x = std::clamp(nv, 0.0, 1.0) * (side - 1), y = std::clamp(roughness, 0.0, 1.0) * (side - 1);
    const auto i = static_cast<std::size_t>(x), j = static_cast<std::size_t>(y);
    const std::size_t i1 = std::min(i + 1, side - 1), j1 = std::min(j + 1, side - 1);
    const double a = x - static_cast<double>(i), b = y - static_cast<double>(j);
    std::array<double, 2> r{};
    for (std::size_t k = 0; k < 2; ++k)
      r[k] = (1 - b) * ((1 - a) * at_[j * side + i][k] + a * at_[j * side + i1][k]) +
             b * ((1 - a) * at_[j1 * side + i][k] + a * at_[j1 * side + i1][k]);
    return r;
  }

 private:
  static constexpr std::size_t side = 32;
  static std::array<double, 2> worked_out(double nv, double roughness) {
    constexpr int count = 256;
    const double a = std::max(roughness * roughness, 0.002), a2 = a * a;
    const Vec3 v{std::sqrt(1 - nv * nv), 0, nv};
    std::array<double, 2> sum{};
    for (int i = 0; i < count; ++i) {
      double reversed = 0, step = 0.5;
      for (int bits = i; bits > 0; bits /= 2, step /= 2) reversed += step * (bits % 2);
      const double u = (i + 0.5) / count, c = std::sqrt((1 - u) / (1 + (a2 - 1) * u));
      const Vec3 h = cylindrical(std::sqrt(std::max(1 - c * c, 0.0)), reversed, c);
      const double vh = dot(v, h), nl = 2 * vh * h.z - v.z;
      if (!(nl > 0) || !(vh > 0)) continue;
      const double seen = 2 * nl / (nl * std::sqrt(nv * nv * (1 - a2) + a2) + nv * std::sqrt(nl * nl * (1 - a2) + a2));
      const double share = seen * nv * vh / (h.z * nv), rim = fifth(1 - vh);
      sum[0] += (1 - rim) * share, sum[1] += rim * share;
    }
    return {sum[0] / count, sum[1] / count};
  }
  std::array<std::array<double, 2>, side * side> at_{};
};
std::array<double, 2> reflected_shares(double nv, double roughness) {
  static const ReflectedShares shares;
  return shares.at(nv, roughness);
}

// The distribution of microfacets times pi, and the light that they do not hide from each other over four cosines.
double facets(double nh, double a) {
  const double k = nh * nh * (a * a - 1) + 1;
  return a * a / std::max(k * k, 1e-30);
}
double unhidden(double nl, double nv, double a) {
  const double a2 = a * a;
  return 0.5 / std::max(nl * std::sqrt(nv * nv * (1 - a2) + a2) + nv * std::sqrt(nl * nl * (1 - a2) + a2), 1e-30);
}
// The density of a reflection by one of the facets that are visible.
double density_of(double nh, double nv, double a) {
  const double shown = 2 * nv / (nv + std::sqrt(nv * nv * (1 - a * a) + a * a));
  return shown * facets(nh, a) / (4 * pi * std::max(nv, 1e-9));
}
double balance(double own, double other) { return own / (own + other); }

}  // namespace

Scattering::Scattering(const SurfacePoint& p, Vec3 toward, double least_roughness) : n_(p.normal), toward_(toward) {
  const Finish plain = finish_of(p.material, p.shine);
  const Finish& f = p.finish != nullptr ? *p.finish : plain;
  const double metal = p.finish != nullptr ? p.metalness : plain.metalness;
  const double roughness =
      std::clamp(std::max(p.finish != nullptr ? p.roughness : plain.roughness, least_roughness), 0.03, 1.0);
  nv_ = std::clamp(dot(n_, toward), 1e-4, 1.0), alpha_ = roughness * roughness;
  const double edge = (f.ior - 1) / (f.ior + 1), dull = (f.transmission > 0 ? edge * edge : 0.04) * f.specular;
  f0_ = (1 - metal) * Vec3{dull, dull, dull} + metal * p.color;
  f90_ = (1 - metal) * std::min(f.specular, 1.0) + metal;
  const auto shares = reflected_shares(nv_, roughness);
  const double single = shares[0] + shares[1];
  Vec3 again;
  for (int i = 0; i < 3; ++i) {
    once_[i] = f0_[i] * shares[0] + f90_ * shares[1];
    repeated_[i] = 1 + f0_[i] * (1 / std::max(single, 1e-3) - 1);
    again[i] = once_[i] * (repeated_[i] - 1);
  }
  transmission_ = f.transmission * (1 - metal), ior_ = f.ior, thin_ = !(f.thickness > 0) || !p.solid,
  leaves_ = p.inside && !thin_;
  const Vec3 left{1 - once_.x - again.x, 1 - once_.y - again.y, 1 - once_.z - again.z};
  diffuse_ = (1 - metal) * (1 - transmission_) * p.opacity * (left * p.color);
  // Light goes through both sides of a body, and through a thin wall once.
  const Vec3 c{std::max(p.color.x, 0.0), std::max(p.color.y, 0.0), std::max(p.color.z, 0.0)};
  tint_ = left * (thin_ ? c : Vec3{std::sqrt(c.x), std::sqrt(c.y), std::sqrt(c.z)});
  coat_ = f.clearcoat, coat_alpha_ = std::max(f.clearcoat_roughness, std::max(least_roughness, 0.03));
  coat_alpha_ *= coat_alpha_;
  coat_left_ = 1 - coat_ * (0.04 + 0.96 * fifth(1 - nv_));
  sheen_ = f.sheen, sheen_alpha_ = std::max(f.sheen_roughness * f.sheen_roughness, 0.01);
  const double most_sheen = largest(sheen_) * (0.16 + 0.4 * (1 - nv_) * (1 - nv_));
  coat_left_ *= 1 - most_sheen;
  const double mirror = std::min(largest(once_) + largest(again), 1.0), diffuse = largest(diffuse_) + most_sheen;
  const double through = transmission_ * (1 - mirror), coat = coat_ > 0 ? std::max(1 - coat_left_, 0.05) : 0;
  const double sum = std::max(mirror + diffuse + through + coat, 1e-9);
  to_mirror_ = mirror / sum, to_diffuse_ = diffuse / sum, to_through_ = through / sum, to_coat_ = coat / sum;
}

Vec3 Scattering::albedo() const {
  Vec3 all = diffuse_ + once_ * repeated_ + transmission_ * tint_;
  for (int i = 0; i < 3; ++i) all[i] = std::clamp(all[i], 0.0, 1.0);
  return all;
}

Vec3 Scattering::value(Vec3 l) const {
  const double nl = dot(n_, l);
  if (!(nl > 0)) return {};
  const Vec3 h = unit(l + toward_);
  const double nh = std::clamp(dot(n_, h), 0.0, 1.0), vh = std::clamp(dot(toward_, h), 0.0, 1.0), rim = fifth(1 - vh);
  const double shine = facets(nh, alpha_) * unhidden(nl, nv_, alpha_);
  Vec3 sum = diffuse_;
  for (int i = 0; i < 3; ++i) sum[i] += shine * (f0_[i] + std::max(f90_ - f0_[i], 0.0) * rim) * repeated_[i];
  sum = coat_left_ * sum;
  if (coat_ > 0) {
    const double c = coat_ * facets(nh, coat_alpha_) * unhidden(nl, nv_, coat_alpha_) * (0.04 + 0.96 * rim);
    sum = sum + Vec3{c, c, c};
  }
  if (largest(sheen_) > 0) {
    // Charlie's sheen with its power as one of a few squares, since powers have other bits on other processors.
    const double sine2 = std::max(1 - nh * nh, 0.0078), inv = 1 / sheen_alpha_;
    double power = 1, base = std::sqrt(sine2), left = std::min(inv, 64.0);
    for (; left >= 1; left -= 1) power *= base;
    power *= 1 - left + left * base;
    sum = sum + (2 + inv) * power * 0.5 / (4 * (nl + nv_ - nl * nv_)) * sheen_;
  }
  return nl * sum;
}

double Scattering::density(Vec3 l) const {
  const double nl = dot(n_, l);
  if (!(nl > 0)) return 0;
  const double nh = std::clamp(dot(n_, unit(l + toward_)), 0.0, 1.0);
  return to_diffuse_ * nl / pi + to_mirror_ * density_of(nh, nv_, alpha_) +
         (to_coat_ > 0 ? to_coat_ * density_of(nh, nv_, coat_alpha_) : 0);
}

Scattering::Sample Scattering::sample_through(PixelSampler& sampler) const {
  const Vec3 h = sample_visible_facet(n_, toward_, alpha_, sampler.next_2d());
  Sample s{-toward_, 1 / to_through_ * (transmission_ * tint_), 0, true};
  if (thin_) return s;
  const double eta = leaves_ ? ior_ : 1 / ior_, c = dot(toward_, h), k = 1 - eta * eta * (1 - c * c);
  if (k < 0) {  // all of it is reflected inside
    s.along = mirrored_at(h, toward_), s.through = false;
    return s;
  }
  s.along = unit((eta * c - std::sqrt(k)) * h - eta * toward_);
  return s;
}

Scattering::Sample Scattering::sample(PixelSampler& sampler) const {
  const double choice = sampler.next_1d();
  if (choice < to_through_) return sample_through(sampler);
  const auto random = sampler.next_2d();
  const double rest = choice - to_through_;
  Sample s;
  if (rest < to_diffuse_)
    s.along = sample_cosine_hemisphere(n_, random);
  else {
    const Vec3 h = sample_visible_facet(n_, toward_, rest < to_diffuse_ + to_mirror_ ? alpha_ : coat_alpha_, random);
    s.along = mirrored_at(h, toward_);
  }
  s.density = density(s.along);
  if (s.density > 0) s.weight = 1 / (pi * s.density) * value(s.along);
  return s;
}

PhysicalTracer::PhysicalTracer(const PathTracer& tracer, const World& world, const Lighting& lighting,
                               const SkyAround& sky)
    : tracer_(tracer), world_(world), lighting_(lighting), sky_(sky) {}

Vec3 PhysicalTracer::surroundings(Vec3 along) const {
  if (sky_) return sky_.seen(along);
  const double up = std::clamp(0.5 + along.y / 2, 0.0, 1.0);
  return (1 - up) * lighting_.ground + up * lighting_.sky;
}

namespace {

Vec3 axis_y(const Lighting::One& l) { return cross(l.aim, l.across); }
double area_of(const Lighting::One& l) { return (l.shape == LightShape::disc ? pi : 4) * l.half_width * l.half_height; }
bool is_area(const Lighting::One& l) { return l.shape != LightShape::point; }
// A sun with a size is a disc in the sky, of this light.
bool is_disc(const Lighting::One& l) { return l.sun && l.size > 0; }
double steradians(const Lighting::One& l) { return pi * l.size * l.size; }
double cone_of(const Lighting::One& l, Vec3 from_lamp) {
  if (!(l.cone > 0)) return 1;
  const double outer = sine_cosine(l.cone / 2).cosine,
               inner = sine_cosine(l.cone / 2 * (1 - std::clamp(l.cone_edge, 0.001, 1.0))).cosine;
  const double s = std::clamp((dot(l.aim, from_lamp) - outer) / std::max(inner - outer, 1e-6), 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

// The colour that a lamp with a picture sends in a direction.
Vec3 projected_color(const Lighting::One& l, Vec3 from_lamp) {
  if (!l.picture || !(l.cone > 0)) return l.color;
  const auto [sine, cosine] = sine_cosine(l.cone / 2);
  const double deep = dot(from_lamp, l.aim), wide = 2 * deep * sine / std::max(cosine, 1e-6);
  if (!(wide > 0)) return {};
  return l.color *
         picture_color(*l.picture, 0.5 + dot(from_lamp, l.across) / wide, 0.5 + dot(from_lamp, axis_y(l)) / wide);
}

}  // namespace

Vec3 PhysicalTracer::from_light(const SurfacePoint& p, const Scattering& s, std::size_t i,
                                PixelSampler& sampler) const {
  const Lighting::One& l = lighting_.lights[i];
  const bool casts = i < lighting_.casting;
  const auto random = sampler.next_2d();
  Vec3 to = l.sun ? l.place : l.place - p.start;
  double strength = 1;
  if (is_area(l)) {
    Vec3 on{2 * random[0] - 1, 2 * random[1] - 1, 0};
    if (l.shape == LightShape::disc) on = cylindrical(std::sqrt(random[0]), random[1], 0);
    to = to + on.x * l.half_width * l.across + on.y * l.half_height * axis_y(l);
    const double d2 = std::max(dot(to, to), 1e-12), facing = -dot(l.aim, to) / std::sqrt(d2);
    if (!(facing > 0)) return {};
    const double density = d2 / (facing * area_of(l));
    strength = 1 / (pi * density) * balance(density, s.density(unit(to)));
  } else if (is_disc(l)) {
    to = to + from_frame(unit(to), cylindrical(l.size * std::sqrt(random[0]), random[1], 0));
    strength = balance(1 / steradians(l), s.density(unit(to)));
  } else if (!l.sun) {
    if (l.size > 0) to = to + from_frame(unit(to), cylindrical(l.size * std::sqrt(random[0]), random[1], 0));
    const double window = std::max(1 - dot(to, to) / (l.range * l.range), 0.0);
    strength = window * window * cone_of(l, unit(-to));
  }
  const Vec3 along = unit(to);
  const Vec3 value = strength > 0 ? strength * s.value(along) : Vec3{};
  if (!(largest(value) > 0)) return {};
  const double distance = l.sun ? INFINITY : std::sqrt(dot(to, to)) * (1 - coplanar_tolerance);
  return (casts ? world_.transmittance({p.start, along}, distance) : 1) * (value * projected_color(l, -along));
}

Vec3 PhysicalTracer::from_lights(const SurfacePoint& p, const Scattering& s, bool all, PixelSampler& sampler) const {
  const std::size_t count = lighting_.lights.size();
  if (count == 0) return {};
  Vec3 sum;
  if (all) {
    for (std::size_t i = 0; i < count; ++i) sum = sum + from_light(p, s, i, sampler);
    return sum;
  }
  const auto one = std::min(static_cast<std::size_t>(sampler.next_1d() * static_cast<double>(count)), count - 1);
  return static_cast<double>(count) * from_light(p, s, one, sampler);
}

Vec3 PhysicalTracer::from_sky(const SurfacePoint& p, const Scattering& s, PixelSampler& sampler) const {
  if (!sky_) return {};
  const auto [first, second] = sampler.next_2d();
  const SkyLight::Direction d = sky_.sample(first, second, sampler.next_1d());
  if (!(d.density > 0)) return {};
  const Vec3 value = s.value(d.along);
  if (!(largest(value) > 0)) return {};
  if (tracer_.meets_floor({p.start, d.along})) return {};
  const double seen = world_.transmittance({p.start, d.along}, INFINITY);
  return seen * balance(d.density, s.density(d.along)) / (pi * d.density) * (value * sky_.seen(d.along));
}

Vec3 PhysicalTracer::of_lamps(const Ray& r, double distance, double density) const {
  Vec3 sum;
  for (const Lighting::One& l : lighting_.lights) {
    if (is_disc(l)) {
      if (distance < INFINITY) continue;
      const Vec3 axis = unit(l.place);
      const double c = dot(r.along, axis), off2 = 1 - c * c;
      if (c > 0 && off2 < l.size * l.size * c * c)
        sum = sum + (density > 0 ? balance(density, 1 / steradians(l)) : 1) / (l.size * l.size) * l.color;
    } else if (is_area(l)) {
      const double facing = -dot(l.aim, r.along);
      if (!(facing > 1e-6)) continue;
      const double t = dot(l.aim, l.place - r.from) / dot(l.aim, r.along);
      if (!(t > 0) || t > distance) continue;
      const Vec3 off = r.from + t * r.along - l.place;
      const double x = dot(off, l.across) / l.half_width, y = dot(off, axis_y(l)) / l.half_height;
      if (l.shape == LightShape::disc ? x * x + y * y > 1 : std::abs(x) > 1 || std::abs(y) > 1) continue;
      sum = sum + (density > 0 ? balance(density, t * t / (facing * area_of(l))) : 1) * l.color;
    }
  }
  return sum;
}

Vec3 PhysicalTracer::radiance(SurfacePoint p, Vec3 toward, PixelSampler& sampler) const {
  Vec3 sum, carried{1, 1, 1};
  double least_roughness = 0;
  const auto add = [&](Vec3 light, int depth) {
    Vec3 part = carried * light;
    if (const double most = largest(part); depth > 0 && most > brightest_indirect)
      part = brightest_indirect / most * part;
    sum = sum + part;
  };
  for (int depth = 0; depth < most_bounces; ++depth) {
    if (p.material == Material::glow) {
      add(p.color, depth);
      break;
    }
    add(p.emission, depth);
    const Scattering s(p, toward, least_roughness);
    add(from_lights(p, s, depth == 0, sampler) + from_sky(p, s, sampler), depth);
    const Scattering::Sample next = s.sample(sampler);
    if (!(largest(next.weight) > 0)) break;
    carried = carried * next.weight;
    const double most = largest(carried);
    if (depth >= bounces_before_chance) {
      const double goes_on = std::min(most, 0.95);
      if (sampler.next_1d() >= goes_on) break;
      carried = 1 / goes_on * carried;
    }
    Vec3 along = next.along;
    const double into = dot(along, p.face);
    if (!next.through && into < 0) along = along - 2 * into * p.face;
    Ray r{next.through ? p.beyond : p.start, along};
    if (next.density > 0 && next.density < 20) least_roughness = std::max(least_roughness, 0.2);
    double density = next.density;
    // Straight through what is transparent, to the next surface.
    std::optional<SurfacePoint> met;
    for (int layer = 0; layer < 64; ++layer) {
      const std::optional<Hit> hit = world_.nearest(r, camera_rays);
      const double floor = tracer_.floor_distance(r), distance = std::min(hit ? hit->distance : INFINITY, floor);
      if (const Vec3 lamps = of_lamps(r, distance, density); largest(lamps) > 0) add(lamps, depth + 1);
      if (distance == INFINITY) {
        const double share = sky_ && density > 0 ? balance(density, sky_.density(r.along)) : 1;
        add(share * surroundings(r.along), depth + 1);
        break;
      }
      SurfacePoint at = hit && hit->distance <= floor ? world_.surface_point(r, *hit) : tracer_.floor_point(r, floor);
      if (at.opacity >= 1 || sampler.next_1d() < at.opacity) {
        at.opacity = 1;
        met = at;
        break;
      }
      r.from = at.beyond;
    }
    if (!met) break;
    p = *met, toward = -r.along;
  }
  return sum;
}

}  // namespace betwixt::traced
