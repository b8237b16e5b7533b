// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The light that a sky sends from each direction, without that of its sun.
//
// All numbers that become pixels are made with +, -, *, / and square roots, so that they have the same bits on every
// processor.
#pragma once

#include <optional>

#include "betwixt/math.h"
#include "betwixt/setting.h"

namespace betwixt {

// The light of a sky that comes from nearly one direction. It casts shadows.
struct SkySun {
  Vec3 toward;      // unit length
  Vec3 color;       // linear light, as that of a sun: a surface of colour a that faces it shows a·c
  double size = 0;  // the radius of its disc one metre away
};
// The same sky without its turn and its strength, which SkyAround adds.
class SkyModel {
 public:
  explicit SkyModel(const Sky&);
  std::optional<SkySun> sun() const;
  Vec3 radiance(Vec3 along) const;  // `along`: from the eye, unit length

 private:
  // Of a clear day.
  struct Day {
    Vec3 sun;  // towards it; it may be below the horizon
    Vec3 zenith, horizon, glow, light;
  };
  static Day day_at(double hour);
  static Vec3 day_radiance(const Day&, Vec3 along);

  Sky sky_;
  Day day_;
};

}  // namespace betwixt
