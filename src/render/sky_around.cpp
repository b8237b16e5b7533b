// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/sky_around.h"

#include <algorithm>
#include <cmath>

#include "render/blends.h"

namespace betwixt {

SkyAround::SkyAround(const Scenery& scenery, const View& view, bool has_finishes) {
  const Surroundings& around = scenery.surroundings;
  if (around.flat) return;
  Sky sky = around.environment;
  constexpr double beside_lamps = 0.45;  // as much light as the dome of other films with lamps gives
  with_lamps_ = !scenery.lights.empty();
  own_ = sky.kind == Sky::none && !around.sky && !around.ambient && (!with_lamps_ || has_finishes);
  if (own_) {
    sky.kind = Sky::studio, sky.strength = with_lamps_ ? beside_lamps : sky.strength;
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
  if (!light_ || !light_->sun() || (own_ && with_lamps_)) return std::nullopt;
  SkySun sun = *light_->sun();
  sun.toward = to_world(sun.toward), sun.color = strength_ * sun.color;
  if (own_) sun.size = 0;  // soft shadows take a multiple of the time, so a script asks for them with `sky studio`
  return sun;
}

SkyAround::Disc SkyAround::disc() const {
  constexpr double bright = 40;  // to a surface that faces it
  const std::optional<SkySun> it = seen_behind_ ? sun() : std::nullopt;
  if (!it || !(it->size > 0)) return {};
  return {it->toward, bright * share_ / std::max(strength_, 1e-12) * it->color, it->size};
}

// With a soft border, and not below the horizon.
Vec3 SkyAround::disc_seen(const Disc& disc, Vec3 along) const {
  if (!(disc.size > 0) || !(dot(along, disc.toward) > 0)) return {};
  const double off = length(cross(along, disc.toward)) / disc.size;
  return (1 - smoothstep(0.94, 1.06, off)) * smoothstep(-0.004, 0.004, along.y) * disc.color;
}

SkyLight::Direction SkyAround::sample(double which, double across, double down) const {
  SkyLight::Direction d = light_->sample(which, across, down);
  d.along = to_world(d.along);
  return d;
}

}  // namespace betwixt
