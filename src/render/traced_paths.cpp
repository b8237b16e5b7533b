// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/traced_paths.h"

namespace betwixt::traced {
namespace {

constexpr int most_layers = 64;  // of transparent surfaces
constexpr int most_bounces = 24, sure_bounces = 3;

Vec3 mix(Vec3 a, Vec3 b, double s) { return (1 - s) * a + s * b; }
double smoothstep(double from, double to, double x) {
  const double s = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

// Converts a vector from coordinates about a direction to the world.
Vec3 about(Vec3 axis, Vec3 v) {
  const Vec3 x = unit(cross(std::abs(axis.y) < 0.9 ? Vec3{0, 1, 0} : Vec3{1, 0, 0}, axis));
  return v.x * x + v.y * cross(axis, x) + v.z * axis;
}
Vec3 round(double radius, double turn, double z) {
  const auto [sine, cosine] = sine_cosine(2 * pi * turn);
  return {radius * cosine, radius * sine, z};
}
// Reflects directions that would enter the object.
Vec3 off(Vec3 face, Vec3 along) {
  const double into = std::min(dot(along, face), 0.0);
  return along - 2 * into * face;
}

// Samples a direction with the density of ambient light (cosine-weighted).
Vec3 fallen(Vec3 normal, const std::array<double, 2>& dice) {
  return about(normal, round(std::sqrt(dice[0]), dice[1], std::sqrt(1 - dice[0])));
}

// Samples a reflection by one of the visible microfacets of a rough surface (GGX): on the sphere to which the surface
// is scaled, these are a cap about the direction of sight.
Vec3 mirrored(Vec3 normal, Vec3 toward, double alpha, const std::array<double, 2>& dice) {
  const Vec3 x = about(normal, {1, 0, 0}), y = about(normal, {0, 1, 0});
  const Vec3 sight = unit({alpha * dot(toward, x), alpha * dot(toward, y), std::max(dot(toward, normal), 1e-4)});
  const double z = (1 - dice[0]) * (1 + sight.z) - sight.z;
  const Vec3 facet = round(std::sqrt(std::max(1 - z * z, 0.0)), dice[1], z) + sight;
  const Vec3 h = about(normal, unit({alpha * facet.x, alpha * facet.y, std::max(facet.z, 1e-9)}));
  return unit(2 * dot(toward, h) * h - toward);
}

// Returns the light after a reflection by metal: multiplied in the wide primaries of BT.2020, as in `shaded`.
Vec3 tinted(Vec3 light, Vec3 share) {
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
Vec3 rolled(Vec3 c) {
  constexpr double start = 0.8, room = 1 - start;
  const double peak = largest(c), over = peak - start;
  if (!(over > 0)) return c;
  const double shown = start + room * over / (room + over);
  return mix(shown / peak * c, {shown, shown, shown}, 1 - 1 / (0.15 * (peak - shown) + 1));
}

// A surface point as seen from a direction.
struct Paths::Surface {
  Spot spot;
  Vec3 toward;  // towards the viewer
  Way way = Way::look;
  bool glows = false, metal = false;
  double roughness = 0, facing = 0;
  Vec3 body;          // diffuse reflectance
  Vec3 upright;       // specular reflectance at normal incidence
  Vec3 mirrors;       // specular reflectance in this direction
  double covers = 1;  // opacity
};

Paths::Paths(const World& world, const View& view, const Scenery& scenery)
    : world_(world),
      view_(view),
      around_(scenery.surroundings),
      lighting_(lighting_of(scenery.lights, view, {}, around_)),
      top_(scenery.background.value_or(Lighting::above)),
      bottom_(scenery.background ? around_.below.value_or(top_) : Lighting::beneath),
      bends_(!scenery.background) {}

Ray Paths::through(double across, double down) const {
  const Vec3 there =
      (2 * across - 1 - view_.shift_x) / view_.sx * view_.right + (1 - 2 * down - view_.shift_y) / view_.sy * view_.up;
  return view_.orthographic ? Ray{there, -view_.backward} : Ray{{}, unit(there - view_.backward)};
}

Vec3 Paths::sky(double up, double below) const {
  const double over = 1 - std::clamp(up, 0.0, 1.0);
  return mix(mix(lighting_.zenith, lighting_.horizon, over * over), lighting_.below, below);
}

// The background. An orthographic picture shows the sky as if it were in perspective.
void Paths::see_behind(double down, Vec3 along, double left, Sight& sight) const {
  if (around_.clear) {
    sight.clear = left;
  } else if (around_.sky) {
    const Vec3 d = view_.orthographic ? unit((0.5 - down) * view_.up - view_.backward) : along;
    sight.lit = sight.lit + left * sky(d.y, smoothstep(0, 1, -4 * d.y));
    sight.share = std::min(sight.share + left, 1.0);
  } else {
    sight.plain = sight.plain + left * mix(top_, bottom_, bends_ ? smoothstep(0, 1, down) : down);
  }
}

Vec3 Paths::outside(Vec3 along, Way way) const {
  if (way == Way::mirrored_by_metal && around_.sky) return sky(along.y, smoothstep(0.02, -0.02, along.y));
  const Vec3 dome = mix(lighting_.ground, lighting_.sky, std::clamp(0.5 + along.y / 0.35, 0.0, 1.0));
  return (way == Way::mirrored_by_metal ? 3 : 1) * dome;
}

double Paths::floor_distance(const Ray& r) const {
  const double above = r.from.y + view_.eye.y;
  return around_.ground && above > 0 && r.along.y < 0 ? above / -r.along.y : INFINITY;
}

Spot Paths::floor_spot(const Ray& r, double distance) const {
  Spot s;
  s.at = r.from + distance * r.along;
  s.at.y = -view_.eye.y;
  s.normal = s.face = {0, 1, 0};
  s.start = s.at + one_plane * (largest(s.at) + std::abs(view_.eye.y)) * s.face;
  s.color = *around_.ground, s.material = Material::matte;
  return s;
}

Paths::Surface Paths::surface(const Spot& spot, Vec3 toward, Way way) const {
  Surface s;
  s.spot = spot, s.toward = toward, s.way = way;
  s.glows = around_.flat || spot.material == Material::glow;
  s.covers = spot.opacity;
  if (s.glows) return s;
  s.metal = spot.material == Material::metal;
  const bool glossy = spot.material != Material::matte;
  s.roughness = 0.8 + spot.shine * (0.08 - 0.8);
  s.facing = dot(spot.normal, toward);
  s.body = s.metal ? Vec3{} : spot.opacity * spot.color;
  const double dull = glossy ? 0.045 * std::min(1.0, 0.25 + spot.shine) : 0;
  s.upright = s.metal ? spot.color : Vec3{dull, dull, dull};
  const double edge = 1 - std::clamp(s.facing, 0.0, 1.0), rim = edge * edge * edge * edge * edge;
  const double most = glossy ? spot.shine * spot.shine : 0;
  for (int i = 0; i < 3; ++i) s.mirrors[i] = s.upright[i] + std::max(most - s.upright[i], 0.0) * rim;
  s.covers += (1 - spot.opacity) * std::min(largest(s.mirrors), 1.0);
  return s;
}

// Lamps are discs that face the surface.
double Paths::unblocked(const Spot& spot, const Lighting::One& light, Scattered& dice) const {
  Vec3 to = light.sun ? light.place : light.place - spot.start;
  if (light.size > 0) {
    const auto [area, turn] = dice.two();
    to = to + about(unit(to), round(light.size * std::sqrt(area), turn, 0));
  }
  const double distance = light.sun ? INFINITY : std::sqrt(dot(to, to)) * (1 - one_plane);
  return world_.unblocked({spot.start, unit(to)}, distance);
}

Vec3 Paths::from_lights(const Surface& s, Scattered& dice) const {
  // A highlight of a light source is visible, but is no lamp for other surfaces: that would make fireflies.
  const double roughness = s.way == Way::light ? std::max(s.roughness, 0.5) : s.roughness;
  const double a2 = roughness * roughness * roughness * roughness;
  Vec3 diffuse, specular;
  for (std::size_t i = 0; i < lighting_.lights.size(); ++i) {
    const Lighting::One& light = lighting_.lights[i];
    const Vec3 to = light.sun ? light.place : light.place - s.spot.at;
    const double d2 = std::max(dot(to, to), 1e-30);
    const Vec3 l = 1 / std::sqrt(d2) * to;
    const double slant = dot(s.spot.normal, l);
    const double window = light.sun ? 1 : std::max(1 - d2 / (light.range * light.range), 0.0);
    double strength = std::max(slant, 0.0) * window * window;
    if (strength > 0 && i < lighting_.casting) strength *= unblocked(s.spot, light, dice);
    if (!(strength > 0)) continue;
    const double nh = slant + s.facing, hh = 2 + 2 * dot(l, s.toward);
    const double peak = hh / std::max(nh * nh * (a2 - 1) + hh, 1e-6);
    diffuse = diffuse + strength * light.color;
    specular = specular + strength * peak * peak * light.color;
  }
  return s.body * diffuse + a2 / (1 + 2 * roughness) * (specular * s.upright);
}

// Returns the reflected light that does not come from lights. Samples either the reflection or the diffuse part, as
// often as it contributes. A surface never returns more than it receives.
Vec3 Paths::gathered(const Surface& s, int depth, Scattered& dice) const {
  const double mirrors = std::min(largest(s.mirrors), 1.0), enters = (1 - mirrors) * largest(s.body);
  const double weight = mirrors + enters;
  if (!(weight > 0) || depth >= most_bounces) return {};
  // Russian roulette: the longer the path and the less it carries, the rarer it continues.
  const double goes_on = depth < sure_bounces ? 1 : std::min(weight, 0.95);
  if (goes_on < 1 && dice.one() >= goes_on) return {};
  double share = mirrors / weight;
  if (depth == 0 && mirrors > 0 && enters > 0) share = std::max(share, 0.25 * s.spot.shine);
  const bool mirror = share > 0 && dice.one() < share;
  const auto where = dice.two();
  const Vec3 along =
      mirror ? mirrored(s.spot.normal, s.toward, s.roughness * s.roughness, where) : fallen(s.spot.normal, where);
  const Way way = s.way == Way::light || !mirror ? Way::light : s.metal ? Way::mirrored_by_metal : Way::mirrored;
  const Vec3 light = arriving({s.spot.start, off(s.spot.face, along)}, way, depth + 1, dice);
  if (!mirror) return (1 - mirrors) / ((1 - share) * goes_on) * (s.body * light);
  return 1 / (share * goes_on) * (s.metal ? tinted(light, s.mirrors) : s.mirrors * light);
}

Vec3 Paths::lit(const Surface& s, int depth, Scattered& dice) const {
  return from_lights(s, dice) + gathered(s, depth, dice);
}

Vec3 Paths::arriving(Ray r, Way way, int depth, Scattered& dice) const {
  for (int layer = 0; layer < most_layers; ++layer) {
    const std::optional<Meeting> met = world_.nearest(r, way == Way::light ? gathers : looks);
    const double floor = floor_distance(r);
    if (!met && floor == INFINITY) return outside(r.along, way);
    const bool on_floor = !met || floor < met->distance;
    const Surface s = surface(on_floor ? floor_spot(r, floor) : world_.spot(r, *met), -r.along, way);
    if (s.covers >= 1 || dice.one() < s.covers) return s.glows ? s.spot.color : 1 / s.covers * lit(s, depth, dice);
    r.from = s.spot.beyond;
  }
  return {};
}

Sight Paths::seen(double across, double down, Scattered& dice) const {
  const Ray r = through(across, down);
  const double floor = floor_distance(r);
  Sight sight;
  double left = 1;
  const auto add = [&](const Surface& s, double distance, double cover) {
    const double foggy =
        around_.fog ? std::clamp((distance - around_.fog->from) / (around_.fog->to - around_.fog->from), 0.0, 1.0) : 0;
    const double fogged = s.spot.hairline ? 0 : foggy, clear = left * cover * (1 - fogged);
    if (s.glows) {
      sight.plain = sight.plain + clear * s.covers * s.spot.color;
    } else {
      sight.lit = sight.lit + clear * lit(s, 0, dice);
      sight.share = std::min(sight.share + cover * (1 - fogged), 1.0);  // highlights on glass count like those on walls
    }
    if (fogged > 0) sight.plain = sight.plain + left * cover * fogged * s.covers * around_.fog->color;
    left *= 1 - cover * s.covers;
  };
  std::optional<Meeting> met;
  for (int layer = 0; layer < most_layers && left > 1e-3; ++layer) {
    met = world_.next_layer(r, met);
    if (!met || met->distance * (1 - one_plane) > floor) break;
    add(surface(world_.spot(r, *met), -r.along, Way::look), met->distance, 1);
  }
  if (!(left > 1e-3)) return sight;
  // Towards the horizon the floor fades into the background.
  if (floor < INFINITY) {
    const double drop = r.along.y * r.along.y;
    add(surface(floor_spot(r, floor), -r.along, Way::look), floor, drop / (drop + 1e-3));
  }
  see_behind(down, r.along, left, sight);
  return sight;
}

}  // namespace betwixt::traced
