// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/path_tracer.h"

#include "render/blends.h"
#include "render/traced_sampling.h"

namespace betwixt::traced {
namespace {

constexpr int max_layers = 64;  // of transparent surfaces
constexpr int max_bounces = 24, bounces_before_roulette = 3;

// Reflects directions that would enter the object.
Vec3 kept_outside(Vec3 face, Vec3 along) {
  const double into = std::min(dot(along, face), 0.0);
  return along - 2 * into * face;
}

// Returns the light after a reflection by metal: multiplied in the wide primaries of BT.2020, as in `shaded`.
Vec3 metal_reflection(Vec3 light, Vec3 share) {
  const auto times = [](const std::array<Vec3, 3>& rows, Vec3 v) {
    return Vec3{dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)};
  };
  constexpr std::array<Vec3, 3> wide{{{0.6274, 0.3293, 0.0433}, {0.0691, 0.9195, 0.0113}, {0.0164, 0.0880, 0.8956}}};
  constexpr std::array<Vec3, 3> narrow{
      {{1.6605, -0.5876, -0.0728}, {-0.1246, 1.1329, -0.0083}, {-0.0182, -0.1006, 1.1187}}};
  const Vec3 left = times(narrow, times(wide, light) * times(wide, share));
  return {std::max(left.x, 0.0), std::max(left.y, 0.0), std::max(left.z, 0.0)};
}

}  // namespace

// Khronos' neutral tone mapping without its toe.
Vec3 tone_mapped(Vec3 c) {
  constexpr double start = 0.8, room = 1 - start;
  const double peak = largest(c), over = peak - start;
  if (!(over > 0)) return c;
  const double shown = start + room * over / (room + over);
  return mix(shown / peak * c, {shown, shown, shown}, 1 - 1 / (0.15 * (peak - shown) + 1));
}

// A surface point as seen from a direction.
struct PathTracer::Surface {
  SurfacePoint point;
  Vec3 toward;  // towards the viewer
  RayKind kind = RayKind::camera;
  bool unlit = false, metal = false;
  double roughness = 0, cos_view = 0;
  Vec3 diffuse_albedo;      // diffuse reflectance
  Vec3 normal_reflectance;  // specular reflectance at normal incidence
  Vec3 fresnel;             // specular reflectance in this direction
  double coverage = 1;      // opacity
};

PathTracer::PathTracer(const World& world, const View& view, const Scenery& scenery)
    : world_(world),
      view_(view),
      around_(scenery.surroundings),
      sky_(scenery, view, world.has_finishes()),
      disc_(sky_.disc()),
      lighting_(lighting_of(scenery.lights, view, {}, around_, sky_.sun())),
      top_(scenery.background.value_or(Lighting::above)),
      bottom_(scenery.background ? around_.below.value_or(top_) : Lighting::beneath),
      bends_(!scenery.background) {
  const auto has_front = [](const Lighting::One& l) { return l.shape != LightShape::point || l.cone > 0; };
  if (!around_.flat &&
      (sky_ || world.has_finishes() || std::any_of(lighting_.lights.begin(), lighting_.lights.end(), has_front)))
    physical_.emplace(*this, world_, lighting_, sky_);
}

Vec3 PathTracer::sky_radiance(double up, double below) const {
  const double over = 1 - std::clamp(up, 0.0, 1.0);
  return mix(mix(lighting_.zenith, lighting_.horizon, over * over), lighting_.below, below);
}

double PathTracer::fog_at(double distance) const {
  if (!around_.fog) return 0;
  return std::clamp((distance - around_.fog->from) / (around_.fog->to - around_.fog->from), 0.0, 1.0);
}

// The less, the higher one looks.
double PathTracer::haze(Vec3 along) const {
  if (!around_.fog || !(around_.sky || (sky_ && sky_.seen_behind()))) return 0;
  const double low = 1 - std::clamp(along.y, 0.0, 1.0), low2 = low * low;
  return low2 * low2 * low2 * low2;
}

Vec3 PathTracer::backdrop_at(double down) const { return mix(top_, bottom_, bends_ ? smoothstep(0, 1, down) : down); }

// Where the direction is in the picture, or the nearest place of it. `down`: that of the eye's ray, for orthographic
// pictures, in which a direction has no place.
Vec3 PathTracer::backdrop(Vec3 along, double down) const {
  if (view_.orthographic) return backdrop_at(down);
  const double ahead = -dot(along, view_.backward), up = dot(along, view_.up);
  const double at = 0.5 * (1 - view_.shift_y - view_.sy * up / std::max(ahead, 1e-6));
  return backdrop_at(std::clamp(at, 0.0, 1.0));
}

// The background. An orthographic picture shows the sky as if it were in perspective.
void PathTracer::add_background(double down, Vec3 along, double left, CameraSample& result) const {
  const auto add_sky = [&](Vec3 light, Vec3 d) {
    const double fogged = haze(d), clear = left * (1 - fogged);
    result.lit = result.lit + clear * light, result.albedo = result.albedo + clear * light;
    result.share = std::min(result.share + clear, 1.0);
    if (fogged > 0) result.plain = result.plain + left * fogged * around_.fog->color;
  };
  if (around_.clear) {
    result.clear = left;
  } else if (sky_ && sky_.seen_behind()) {
    const Vec3 d = view_.orthographic ? unit((0.5 - down) * view_.up - view_.backward) : along;
    add_sky(sky_.seen(d) + sky_.disc_seen(disc_, d), d);
  } else if (around_.sky) {
    const Vec3 d = view_.orthographic ? unit((0.5 - down) * view_.up - view_.backward) : along;
    add_sky(sky_radiance(d.y, smoothstep(0, 1, -4 * d.y)), d);
  } else {
    result.plain = result.plain + left * backdrop_at(down);
  }
}

Vec3 PathTracer::environment_radiance(Vec3 along, RayKind kind) const {
  if (kind == RayKind::reflected_by_metal && around_.sky)
    return in_metal(sky_radiance(along.y, smoothstep(0.02, -0.02, along.y)));
  const Vec3 dome = mix(lighting_.ground, lighting_.sky, std::clamp(0.5 + along.y / 0.35, 0.0, 1.0));
  return (kind == RayKind::reflected_by_metal ? 3 : 1) * dome;
}

double PathTracer::floor_distance(const Ray& r) const {
  const double above = r.from.y + view_.eye.y;
  return around_.ground && above > 0 && r.along.y < 0 ? above / -r.along.y : INFINITY;
}

SurfacePoint PathTracer::floor_point(const Ray& r, double distance) const {
  SurfacePoint s;
  s.at = r.from + distance * r.along;
  s.at.y = -view_.eye.y;
  s.normal = s.face = {0, 1, 0};
  s.start = s.at + coplanar_tolerance * (largest(s.at) + std::abs(view_.eye.y)) * s.face;
  s.color = *around_.ground, s.material = Material::matte, s.time = r.time;
  return s;
}

PathTracer::Surface PathTracer::surface_at(const SurfacePoint& point, Vec3 toward, RayKind kind) const {
  Surface s;
  s.point = point, s.toward = toward, s.kind = kind;
  s.unlit = around_.flat || point.material == Material::glow;
  s.coverage = point.opacity;
  if (s.unlit) return s;
  if (physical_) {
    const Scattering scattering(point, toward, 0);
    s.diffuse_albedo = scattering.albedo();
    return s;
  }
  s.metal = point.material == Material::metal;
  const bool glossy = point.material != Material::matte;
  s.roughness = 0.8 + point.shine * (0.08 - 0.8);
  s.cos_view = dot(point.normal, toward);
  s.diffuse_albedo = s.metal ? Vec3{} : point.opacity * point.color;
  const double dull = glossy ? 0.045 * std::min(1.0, 0.25 + point.shine) : 0;
  s.normal_reflectance = s.metal ? point.color : Vec3{dull, dull, dull};
  const double edge = 1 - std::clamp(s.cos_view, 0.0, 1.0), rim = edge * edge * edge * edge * edge;
  const double most = glossy ? point.shine * point.shine : 0;
  for (int i = 0; i < 3; ++i)
    s.fresnel[i] = s.normal_reflectance[i] + std::max(most - s.normal_reflectance[i], 0.0) * rim;
  s.coverage += (1 - point.opacity) * std::min(largest(s.fresnel), 1.0);
  return s;
}

// Returns the share of white light from everywhere that the surface sends to the viewer, never quite none.
Vec3 PathTracer::albedo_of(const Surface& s) {
  const double rest = 1 - std::min(largest(s.fresnel), 1.0), least = 0.02 * s.coverage;
  Vec3 all = s.fresnel + rest * s.diffuse_albedo;
  for (int i = 0; i < 3; ++i) all[i] = std::max(all[i], least);
  return all;
}

// Lamps are discs that face the surface.
double PathTracer::visibility(const SurfacePoint& point, const Lighting::One& light, PixelSampler& sampler) const {
  Vec3 to = light.sun ? light.place : light.place - point.start;
  if (light.size > 0) {
    const auto [area, turn] = sampler.next_2d();
    to = to + from_frame(unit(to), cylindrical(light.size * std::sqrt(area), turn, 0));
  }
  const double distance = light.sun ? INFINITY : std::sqrt(dot(to, to)) * (1 - coplanar_tolerance);
  return world_.transmittance({point.start, unit(to), point.time}, distance).x;
}

Vec3 PathTracer::direct_light(const Surface& s, PixelSampler& sampler) const {
  // A highlight of a light source is visible, but is no lamp for other surfaces: that would make fireflies.
  const double roughness = s.kind == RayKind::ambient ? std::max(s.roughness, 0.5) : s.roughness;
  const double a2 = roughness * roughness * roughness * roughness;
  Vec3 diffuse, specular;
  for (std::size_t i = 0; i < lighting_.lights.size(); ++i) {
    const Lighting::One& light = lighting_.lights[i];
    const Vec3 to = light.sun ? light.place : light.place - s.point.at;
    const double d2 = std::max(dot(to, to), 1e-30);
    const Vec3 l = 1 / std::sqrt(d2) * to;
    const double slant = dot(s.point.normal, l);
    const double window = light.sun ? 1 : std::max(1 - d2 / (light.range * light.range), 0.0);
    double strength = std::max(slant, 0.0) * window * window;
    if (strength > 0 && i < lighting_.casting) strength *= visibility(s.point, light, sampler);
    if (!(strength > 0)) continue;
    const double nh = slant + s.cos_view, hh = 2 + 2 * dot(l, s.toward);
    const double peak = hh / std::max(nh * nh * (a2 - 1) + hh, 1e-6);
    diffuse = diffuse + strength * light.color;
    specular = specular + strength * peak * peak * light.color;
  }
  return s.diffuse_albedo * diffuse + a2 / (1 + 2 * roughness) * (specular * s.normal_reflectance);
}

// Returns the reflected light that does not come from lights. Samples either the reflection or the diffuse part, as
// often as it contributes. A surface never returns more than it receives.
Vec3 PathTracer::indirect_light(const Surface& s, int depth, PixelSampler& sampler) const {
  const double specular = std::min(largest(s.fresnel), 1.0), diffuse = (1 - specular) * largest(s.diffuse_albedo);
  const double throughput = specular + diffuse;
  if (!(throughput > 0) || depth >= max_bounces) return {};
  // Russian roulette: the longer the path and the less it carries, the rarer it continues.
  const double survival_probability = depth < bounces_before_roulette ? 1 : std::min(throughput, 0.95);
  if (survival_probability < 1 && sampler.next_1d() >= survival_probability) return {};
  double specular_probability = specular / throughput;
  if (depth == 0 && specular > 0 && diffuse > 0)
    specular_probability = std::max(specular_probability, 0.25 * s.point.shine);
  const bool is_specular = specular_probability > 0 && sampler.next_1d() < specular_probability;
  const auto random = sampler.next_2d();
  const Vec3 along =
      is_specular
          ? mirrored_at(sample_visible_facet(s.point.normal, s.toward, s.roughness * s.roughness, random), s.toward)
          : sample_cosine_hemisphere(s.point.normal, random);
  const RayKind kind = s.kind == RayKind::ambient || !is_specular ? RayKind::ambient
                       : s.metal                                  ? RayKind::reflected_by_metal
                                                                  : RayKind::reflected;
  const Ray next{s.point.start, kept_outside(s.point.face, along), s.point.time};
  const Vec3 light = incoming_radiance(next, kind, depth + 1, sampler);
  if (!is_specular)
    return (1 - specular) / ((1 - specular_probability) * survival_probability) * (s.diffuse_albedo * light);
  return 1 / (specular_probability * survival_probability) *
         (s.metal ? metal_reflection(light, s.fresnel) : s.fresnel * light);
}

Vec3 PathTracer::seen_radiance(const Surface& s, double distance, double down, PixelSampler& sampler) const {
  if (physical_) return physical_->radiance(s.point, s.toward, distance, down, sampler);
  return reflected_radiance(s, 0, sampler);
}

Vec3 PathTracer::reflected_radiance(const Surface& s, int depth, PixelSampler& sampler) const {
  return direct_light(s, sampler) + indirect_light(s, depth, sampler);
}

Vec3 PathTracer::incoming_radiance(Ray r, RayKind kind, int depth, PixelSampler& sampler) const {
  for (int layer = 0; layer < max_layers; ++layer) {
    const std::optional<Hit> hit = world_.nearest(r, kind == RayKind::ambient ? ambient_rays : camera_rays);
    const double floor = floor_distance(r);
    if (!hit && floor == INFINITY) return environment_radiance(r.along, kind);
    const bool on_floor = !hit || floor < hit->distance;
    const Surface s = surface_at(on_floor ? floor_point(r, floor) : world_.surface_point(r, *hit), -r.along, kind);
    if (s.coverage >= 1 || sampler.next_1d() < s.coverage)
      return s.unlit ? s.point.color : 1 / s.coverage * reflected_radiance(s, depth, sampler);
    r.from = s.point.beyond;
  }
  return {};
}

CameraSample PathTracer::sample(const Ray& r, double down, PixelSampler& sampler) const {
  const double floor = floor_distance(r);
  CameraSample result;
  double left = 1;
  const auto add = [&](const Surface& s, double distance, double cover) {
    const double fogged = s.point.hairline ? 0 : fog_at(distance), clear = left * cover * (1 - fogged);
    if (s.unlit) {
      result.plain = result.plain + clear * s.coverage * s.point.color;
    } else {
      result.lit = result.lit + clear * seen_radiance(s, distance, down, sampler);
      result.share =
          std::min(result.share + cover * (1 - fogged), 1.0);  // highlights on glass count like those on walls
      const double seen = clear * s.coverage;
      result.albedo = result.albedo + clear * albedo_of(s), result.seen += seen;
      result.normal = result.normal + seen * s.point.normal, result.place = result.place + seen * s.point.at;
    }
    if (fogged > 0) result.plain = result.plain + left * cover * fogged * s.coverage * around_.fog->color;
    left *= 1 - cover * s.coverage;
  };
  std::optional<Hit> hit;
  for (int layer = 0; layer < max_layers && left > 1e-3; ++layer) {
    hit = world_.next_layer(r, hit);
    if (!hit || hit->distance * (1 - coplanar_tolerance) > floor) break;
    add(surface_at(world_.surface_point(r, *hit), -r.along, RayKind::camera), hit->distance, 1);
  }
  if (!(left > 1e-3)) return result;
  // Towards the horizon the floor fades into the background.
  if (floor < INFINITY) {
    const double drop = r.along.y * r.along.y;
    add(surface_at(floor_point(r, floor), -r.along, RayKind::camera), floor, drop / (drop + 1e-3));
  }
  add_background(down, r.along, left, result);
  return result;
}

}  // namespace betwixt::traced
