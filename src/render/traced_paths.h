// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What light goes along a ray. What lights send, and what surfaces make of it, is as in the style `shaded`; the light
// from everywhere is that of a dome, one colour from above and one from below, and comes as far as nothing is in its
// way. What is in its way sends its own light on instead.
#pragma once

#include "render/lighting.h"
#include "render/scattered.h"
#include "render/traced_world.h"

namespace betwixt::traced {

// What the eye sees along a ray: what is lit, and what has its colour by itself. `share`: how much of it is lit; of
// that the highlights roll off. `clear`: how much of it is nothing.
struct Sight {
  Vec3 lit, plain;
  double share = 0, clear = 0;
};

// What is brighter than can be shown rolls off, and goes over into white.
Vec3 rolled(Vec3);

class Paths {
 public:
  Paths(const World&, const View&, const Scenery&);
  // Through a place of the picture, from 0 to 1 from its left and top.
  Sight seen(double across, double down, Scattered&) const;

 private:
  // How a surface is reached: by a look at it, from the eye or mirrored, or in search of light for another one.
  enum class Way : std::uint8_t { look, mirrored_by_metal, mirrored, light };
  struct Surface;

  Ray through(double across, double down) const;
  void see_behind(double down, Vec3 along, double left, Sight&) const;
  Vec3 outside(Vec3 along, Way) const;
  Vec3 sky(double up, double below) const;
  double floor_distance(const Ray&) const;  // infinite where it is not met
  Spot floor_spot(const Ray&, double distance) const;
  double unblocked(const Spot&, const Lighting::One&, Scattered&) const;
  Vec3 from_lights(const Surface&, Scattered&) const;
  Vec3 gathered(const Surface&, int depth, Scattered&) const;
  Vec3 lit(const Surface&, int depth, Scattered&) const;
  // Against the ray, from the first thing that it does not go through.
  Vec3 arriving(Ray, Way, int depth, Scattered&) const;
  Surface surface(const Spot&, Vec3 toward, Way) const;

  const World& world_;
  const View& view_;
  const Surroundings& around_;
  const Lighting lighting_;
  Vec3 top_, bottom_;  // of the background
  bool bends_ = true;
};

}  // namespace betwixt::traced
