// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The light along a ray. Lights and surfaces are as in the style `shaded`. Ambient light is that of a dome, one colour
// from above and one from below; an object in its way blocks it, and sends its own light on instead.
#pragma once

#include "render/lighting.h"
#include "render/physical_tracer.h"
#include "render/pixel_sampler.h"
#include "render/traced_world.h"

namespace betwixt::traced {

// The light that the eye sees along a ray: lit surfaces and unlit colours. `share`: how much of it is lit, whose
// highlights roll off. `clear`: how much of it is transparent.
struct CameraSample {
  Vec3 lit, plain;
  double share = 0, clear = 0;
  // What the denoiser knows of the lit surfaces: the light that they reflect of white light, their normal and place in
  // eye space, each times their part of the sample (`seen`). A sky counts as if it reflected all that it sends: a pixel
  // of a bright sky with a bit of a dark surface would be off scale.
  Vec3 albedo, normal, place;
  double seen = 0;
};

// Rolls off light that is too bright for the screen, towards white.
Vec3 tone_mapped(Vec3);

class PathTracer {
 public:
  PathTracer(const World&, const View&, const Scenery&);
  // Returns the light along a ray of the camera. `down`: where it is in the picture, from 0 to 1 from the top.
  CameraSample sample(const Ray&, double down, PixelSampler&) const;

  double floor_distance(const Ray&) const;  // infinity if the ray misses it
  SurfacePoint floor_point(const Ray&, double distance) const;
  bool meets_floor(const Ray& r) const { return floor_distance(r) < INFINITY; }
  double fog_at(double distance) const;  // from the eye: how much of what is there the fog hides
  double haze(Vec3 along) const;         // the same for the sky
  // The background of one colour or two, which what one sees through glass has as well, if it hides the sky.
  bool has_backdrop() const { return !around_.clear && !around_.sky && !(sky_ && sky_.seen_behind()); }
  Vec3 backdrop(Vec3 along, double down) const;
  Vec3 fog_color() const { return around_.fog->color; }

 private:
  // The kind of the ray that reaches a surface: from the eye, reflected, or for the ambient light of another surface.
  enum class RayKind : std::uint8_t { camera, reflected_by_metal, reflected, ambient };
  struct Surface;

  void add_background(double down, Vec3 along, double left, CameraSample&) const;
  Vec3 environment_radiance(Vec3 along, RayKind) const;
  Vec3 sky_radiance(double up, double below) const;
  Vec3 backdrop_at(double down) const;
  double visibility(const SurfacePoint&, const Lighting::One&, PixelSampler&) const;
  Vec3 direct_light(const Surface&, PixelSampler&) const;
  Vec3 indirect_light(const Surface&, int depth, PixelSampler&) const;
  Vec3 reflected_radiance(const Surface&, int depth, PixelSampler&) const;
  // The same as the eye sees it from a distance, at a place from 0 at the picture's top to 1.
  Vec3 seen_radiance(const Surface&, double distance, double down, PixelSampler&) const;
  // Returns the light that arrives against the ray, from the first opaque object.
  Vec3 incoming_radiance(Ray, RayKind, int depth, PixelSampler&) const;
  Surface surface_at(const SurfacePoint&, Vec3 toward, RayKind) const;
  static Vec3 albedo_of(const Surface&);

  const World& world_;
  const View& view_;
  const Surroundings& around_;
  const SkyAround sky_;
  const SkyAround::Disc disc_;
  const Lighting lighting_;
  std::optional<PhysicalTracer> physical_;  // for surfaces with finishes, and under skies
  Vec3 top_, bottom_;                       // the background
  bool bends_ = true;
};

}  // namespace betwixt::traced
