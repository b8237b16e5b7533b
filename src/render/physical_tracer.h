// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The light that surfaces with finishes send to the eye, by tracing paths. Lights and the sky are sampled at each
// point, and so is the surface; the balance of both (multiple importance sampling) keeps the noise low.
#pragma once

#include "render/lighting.h"
#include "render/pixel_sampler.h"
#include "render/sky_around.h"
#include "render/traced_world.h"

namespace betwixt::traced {

class PathTracer;

// How a surface scatters light, as seen from one direction. Values are reflectances times the cosine of the angle of
// incidence, times pi: a white dull surface has the cosine.
class Scattering {
 public:
  Scattering(const SurfacePoint&, Vec3 toward, double least_roughness);
  Vec3 value(Vec3 along) const;      // of light from a direction above the surface
  double density(Vec3 along) const;  // with which sample() chooses it, per steradian
  struct Sample {
    Vec3 along;
    Vec3 weight;  // of the light from there
    double density = 0;
    bool through = false;   // whether it leaves on the other side
    bool straight = false;  // and goes on as it came
  };
  Sample sample(PixelSampler&) const;
  Vec3 albedo() const;
  // Whether light that comes through goes on as it came, and its share.
  bool straightens() const { return thin_ && smooth_pane_; }
  Vec3 straight() const { return straightens() ? passing(nv_) : Vec3{}; }
  const Vec3& normal() const { return n_; }

 private:
  Vec3 value_of_lobes(Vec3 along) const;
  double density_of_lobes(Vec3 along) const;
  double slant(double vh) const;
  Vec3 reflectance(double vh) const;  // of a facet, by its cosine of the angle of sight
  double reflects(double vh) const;
  Vec3 passing(double vh) const;  // the share of light that a facet lets through
  Sample through(Vec3 facet, double chance) const;
  double unhindered(double nl) const;
  Sample hindered(Vec3 facet, double chance) const;
  Vec3 n_, smooth_, toward_;
  double nv_ = 1, alpha_ = 1, f90_ = 1, coat_ = 0, coat_alpha_ = 1, coat_left_ = 1, sheen_alpha_ = 1, transmission_ = 0;
  double ior_ = 1.5;
  Vec3 f0_, diffuse_, once_, repeated_{1, 1, 1}, sheen_, left_, tint_;
  bool thin_ = false, leaves_ = false, bent_ = false, smooth_pane_ = false;
  double to_facets_ = 0, to_diffuse_ = 0, to_coat_ = 0;  // how often each is chosen
};

class PhysicalTracer {
 public:
  PhysicalTracer(const PathTracer& tracer, const World&, const Lighting&, const SkyAround&);
  // Returns the light that the surface sends towards the eye. `away`: the distance from it; `down`: the place in the
  // picture, from 0 at its top to 1.
  Vec3 radiance(SurfacePoint, Vec3 toward, double away, double down, PixelSampler&) const;
  // Returns the light from the sky or the dome.
  Vec3 surroundings(Vec3 along) const;

 private:
  Vec3 from_lights(const SurfacePoint&, const Scattering&, bool all, PixelSampler&) const;
  Vec3 from_light(const SurfacePoint&, const Scattering&, std::size_t light, PixelSampler&) const;
  Vec3 from_sky(const SurfacePoint&, const Scattering&, PixelSampler&) const;
  // Returns the light of visible lamps and suns along a ray up to a distance. `density`: with which the ray was chosen.
  Vec3 of_lamps(const Ray&, double distance, double density) const;

  const PathTracer& tracer_;
  const World& world_;
  const Lighting& lighting_;
  const SkyAround& sky_;
};

}  // namespace betwixt::traced
