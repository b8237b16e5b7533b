// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The light along a ray. Lights and surfaces are as in the style `shaded`. Ambient light is that of a dome, one colour
// from above and one from below; an object in its way blocks it, and sends its own light on instead.
#pragma once

#include "render/lighting.h"
#include "render/scattered.h"
#include "render/traced_world.h"

namespace betwixt::traced {

// The light that the eye sees along a ray: lit surfaces and unlit colours. `share`: how much of it is lit, whose
// highlights roll off. `clear`: how much of it is transparent.
struct Sight {
  Vec3 lit, plain;
  double share = 0, clear = 0;
};

// Rolls off light that is too bright for the screen, towards white.
Vec3 rolled(Vec3);

class Paths {
 public:
  Paths(const World&, const View&, const Scenery&);
  // Returns the light at a place of the picture, from 0 to 1 from its left and top.
  Sight seen(double across, double down, Scattered&) const;

 private:
  // The kind of the ray that reaches a surface: from the eye, reflected, or for the ambient light of another surface.
  enum class Way : std::uint8_t { look, mirrored_by_metal, mirrored, light };
  struct Surface;

  Ray through(double across, double down) const;
  void see_behind(double down, Vec3 along, double left, Sight&) const;
  Vec3 outside(Vec3 along, Way) const;
  Vec3 sky(double up, double below) const;
  double floor_distance(const Ray&) const;  // infinity if the ray misses it
  Spot floor_spot(const Ray&, double distance) const;
  double unblocked(const Spot&, const Lighting::One&, Scattered&) const;
  Vec3 from_lights(const Surface&, Scattered&) const;
  Vec3 gathered(const Surface&, int depth, Scattered&) const;
  Vec3 lit(const Surface&, int depth, Scattered&) const;
  // Returns the light that arrives against the ray, from the first opaque object.
  Vec3 arriving(Ray, Way, int depth, Scattered&) const;
  Surface surface(const Spot&, Vec3 toward, Way) const;

  const World& world_;
  const View& view_;
  const Surroundings& around_;
  const Lighting lighting_;
  Vec3 top_, bottom_;  // the background
  bool bends_ = true;
};

}  // namespace betwixt::traced
