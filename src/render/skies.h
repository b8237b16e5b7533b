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
  bool visible = true;
};
std::optional<SkySun> sun_of(const Sky&);
// `along`: from the eye, unit length. The strength of the sky is included.
Vec3 sky_radiance(const Sky&, Vec3 along);

}  // namespace betwixt
