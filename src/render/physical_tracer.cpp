// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/physical_tracer.h"

#include "render/path_tracer.h"
#include "render/traced_sampling.h"

namespace betwixt::traced {
namespace {

constexpr int most_bounces = 64, bounces_before_chance = 3;
// Paths that reach a light by way of a second surface are limited to this, or single ones would be white dots.
constexpr double brightest_indirect = 10;

double balance(double own, double other) { return own / (own + other); }

Vec3 through_panes(const SurfacePoint& p, Vec3 toward) { return Scattering(p, toward, 0).straight(); }
// Small lights are not found by paths that glass bends: as if most of their light came through straight.
Vec3 through_glass(const SurfacePoint& p, Vec3 toward) {
  const Scattering s(p, toward, 0);
  const double most = 0.9 * p.finish->transmission;
  return s.straightens() ? s.straight() : Vec3{most, most, most};
}

}  // namespace

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
  const Vec3 light = value * projected_color(l, -along);
  return casts ? world_.transmittance({p.start, along, p.time}, distance, through_glass) * light : light;
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
  if (tracer_.meets_floor({p.start, d.along, p.time})) return {};
  const Vec3 seen = world_.transmittance({p.start, d.along, p.time}, INFINITY, through_panes);
  return balance(d.density, s.density(d.along)) / (pi * d.density) * (seen * value * sky_.seen(d.along));
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

Vec3 PhysicalTracer::radiance(SurfacePoint p, Vec3 toward, double away, double down, PixelSampler& sampler) const {
  Vec3 sum, carried{1, 1, 1};
  double least_roughness = 0, density = 0;
  bool scattered = false, bends = false;  // whether a surface has reflected the path, and glass has bent it since then
  bool mirrored = true, straight = true;  // the path so far: sharply, so that fog is seen; only through glass
  const auto add = [&](Vec3 light, int depth) {
    Vec3 part = carried * light;
    if (const double most = largest(part); depth > 0 && most > brightest_indirect)
      part = brightest_indirect / most * part;
    sum = sum + part;
  };
  const auto add_fog = [&](double share, int depth) {
    add(share * tracer_.fog_color(), depth);
    carried = (1 - share) * carried;
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
    if (next.through != (into < 0)) along = along - 2 * into * p.face;
    Ray r{next.through ? p.beyond : p.start, along, p.time};
    const bool rough = next.density > 0 && next.density < 20;
    mirrored = mirrored && !rough, straight = straight && next.through;
    const bool backdrop = straight && tracer_.has_backdrop();
    if (rough) least_roughness = std::max(least_roughness, 0.2);
    if (!next.straight) density = next.density, bends = next.through;
    scattered = scattered || !next.through;
    // Straight through what is transparent, to the next surface.
    std::optional<SurfacePoint> met;
    for (int layer = 0; layer < 64; ++layer) {
      const std::optional<Hit> hit = world_.nearest(r, camera_rays);
      const double floor = tracer_.floor_distance(r), distance = std::min(hit ? hit->distance : INFINITY, floor);
      if (distance == INFINITY && backdrop) {
        add(tracer_.backdrop(r.along, down), depth);
        break;
      }
      const bool hidden = backdrop || (scattered && bends);  // or seen as if straight through the glass
      if (const Vec3 lamps = hidden ? Vec3{} : of_lamps(r, distance, density); largest(lamps) > 0) add(lamps, depth);
      if (distance == INFINITY) {
        if (const double hazy = mirrored ? tracer_.haze(r.along) : 0; hazy > 0) add_fog(hazy, depth);
        const double share = sky_ && density > 0 ? balance(density, sky_.density(r.along)) : 1;
        add(share * surroundings(r.along), depth);
        break;
      }
      if (const double before = tracer_.fog_at(away), after = tracer_.fog_at(away + distance);
          mirrored && after > before)
        add_fog((after - before) / (1 - before), depth);
      away += distance;
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
