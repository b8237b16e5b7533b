// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The sky of a picture: a light from all around, how it is turned, and how strong it is.
#pragma once

#include "render/columns.h"
#include "render/sky_light.h"
#include "render/view.h"

namespace betwixt {

class SkyAround {
 public:
  SkyAround() = default;  // no sky
  // That of the script. A film with light from nowhere gets a studio that turns with the camera; one with lamps and
  // finishes gets a dim one, so that metals have something to mirror.
  SkyAround(const Scenery&, const View&, bool has_finishes);
  explicit operator bool() const { return light_ != nullptr; }
  const std::shared_ptr<const SkyLight>& light() const { return light_; }
  bool is_default() const { return own_; }           // the renderer's own, for light from nowhere
  bool seen_behind() const { return seen_behind_; }  // whether it is the background
  double cosine() const { return cosine_; }          // of its turn
  double sine() const { return sine_; }
  double share() const { return share_; }  // factor of its light, with the exposure
  std::optional<SkySun> sun() const;       // without the exposure

  // The sun's disc as the eye sees it: much darker than it is, which would dazzle, and blind in pictures with bloom.
  struct Disc {
    Vec3 toward, color;
    double size = 0;  // the radius one metre away; 0: there is none
  };
  Disc disc() const;
  Vec3 disc_seen(const Disc&, Vec3 along) const;

  // Directions in the world.
  Vec3 seen(Vec3 along) const { return share_ * light_->seen(to_sky(along)); }
  SkyLight::Direction sample(double which, double across, double down) const;
  double density(Vec3 along) const { return light_->density(to_sky(along)); }

 private:
  Vec3 to_sky(Vec3 d) const { return {cosine_ * d.x - sine_ * d.z, d.y, sine_ * d.x + cosine_ * d.z}; }
  Vec3 to_world(Vec3 d) const { return {cosine_ * d.x + sine_ * d.z, d.y, cosine_ * d.z - sine_ * d.x}; }

  std::shared_ptr<const SkyLight> light_;
  double cosine_ = 1, sine_ = 0, strength_ = 1, share_ = 1;
  bool seen_behind_ = false, own_ = false;  // own_: the renderer's
  bool with_lamps_ = false;                 // whether the script has lights
};

}  // namespace betwixt
