// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/sky_around.h"

#include <cmath>

namespace betwixt {

SkyAround::SkyAround(const Scenery& scenery, const View& view) {
  const Surroundings& around = scenery.surroundings;
  if (around.flat) return;
  Sky sky = around.environment;
  own_ = sky.kind == Sky::none && scenery.lights.empty() && !around.sky && !around.ambient;
  if (own_) {
    sky.kind = Sky::studio;
    const Vec3 right = normalize(Vec3{view.right.x, 0, view.right.z}, {1, 0, 0});
    cosine_ = right.x, sine_ = -right.z;
  } else {
    const auto [sine, cosine] = sine_cosine(sky.turn);
    cosine_ = cosine, sine_ = sine;
  }
  strength_ = sky.strength, share_ = std::exp2(around.exposure) * sky.strength;
  // The lamps of a studio light the objects, but they are not seen.
  seen_behind_ = sky.kind != Sky::studio && !around.clear && !scenery.background;
  sky.turn = 0, sky.strength = 1;
  light_ = sky_light_of(sky, around.ground);
}

std::optional<SkySun> SkyAround::sun() const {
  if (!light_ || !light_->sun()) return std::nullopt;
  SkySun sun = *light_->sun();
  sun.toward = to_world(sun.toward), sun.color = strength_ * sun.color;
  if (own_) sun.size = 0;  // soft shadows take a multiple of the time, so a script asks for them with `sky studio`
  return sun;
}

SkyLight::Direction SkyAround::sample(double which, double across, double down) const {
  SkyLight::Direction d = light_->sample(which, across, down);
  d.along = to_world(d.along);
  return d;
}

}  // namespace betwixt
