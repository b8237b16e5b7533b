// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The light from all around as the styles need it: as a cube that is blurred for each roughness, as the light that
// falls on a surface for each of its directions, and as it is.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "render/skies.h"

namespace betwixt {

class SkyLight {
 public:
  SkyLight(const Sky&, const std::optional<Vec3>& ground);

  // The faces of a cube, in the order +x -x +y -y +z -z, rows from the top, three numbers a pixel. Level 0 is the sky
  // itself; level k is what a surface with roughness_of(k) mirrors. Levels are closer for smooth surfaces, of which one
  // sees the difference.
  static constexpr int side = 128, levels = 5;
  // The inverse of levels r (2 - r). What a surface of roughness 1 mirrors would be one more level: it is the
  // irradiance.
  static double roughness_of(int level);
  struct Level {
    int side = 0;
    std::vector<float> rgb;  // face by face
  };
  const std::array<Level, levels>& cube() const { return cube_; }
  // The light on a surface whose normal is n, divided by pi: the sum of these, multiplied by 1, y, z, x, xy, yz,
  // 3z² - 1, xz and x² - y².
  const std::array<Vec3, 9>& irradiance() const { return irradiance_; }
  Vec3 irradiance(Vec3 normal) const;
  // The light from a direction, with the floor below the horizon.
  Vec3 radiance(Vec3 along) const;
  // The sky without the floor.
  Vec3 seen(Vec3 along) const { return sky_.radiance(along); }
  const std::optional<SkySun>& sun() const { return sun_; }

  // A direction with the density with which sample() chooses it, per steradian: the brighter the more often.
  struct Direction {
    Vec3 along;
    double density = 0;
  };
  // The numbers are random, from 0 to 1.
  Direction sample(double which, double across, double down) const;
  double density(Vec3 along) const;

 private:
  // `halved`: the sky, with each side half of the one before.
  void sum_up(const std::vector<Level>& halved);
  void blur(const std::vector<Level>& halved);
  SkyModel sky_;
  std::optional<SkySun> sun_;
  Vec3 floor_;  // the light that it sends
  bool has_floor_ = false;
  std::array<Level, levels> cube_;
  std::array<Vec3, 9> irradiance_{};
  // Of the pixels of the cube with half of level 0's side: the sums of their light up to each, and that of all is 1.
  std::vector<double> sums_;
};

// Returns the environment of a sky, made once for all renderers; null without a sky. `ground`: the colour of the floor.
std::shared_ptr<const SkyLight> sky_light_of(const Sky&, const std::optional<Vec3>& ground);

}  // namespace betwixt
