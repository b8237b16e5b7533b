// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Which lights shine on a frame.
//
// A light of colour c (intensity included) at distance d sends c·w² where w = 1 - (d / range)², and nothing beyond its
// range; a surface of colour a that faces it shows a·c·w². So intensity 1 lights well from close by up to about two
// thirds of the range (w² = 0.31), wherever the range ends, and nothing is ever cut off. A sun sends 0.8·c. A fifth of
// a white surface's brightness is left to the sky.
#pragma once

#include <array>
#include <vector>

#include "render/view.h"

namespace betwixt {

struct Lighting {
  static constexpr std::size_t most = 16, most_casting = 4;
  // What is behind everything, at the top of the picture and at its bottom, where a film says nothing.
  static constexpr Vec3 above{0.26, 0.28, 0.31}, beneath{0.12, 0.125, 0.13};
  struct One {
    bool sun = false;
    Vec3 place;  // eye space: where a lamp is, or the direction towards a sun
    Vec3 color;
    double range = 1;
    Vec3 world;  // a lamp's place in the world
    // How large it is, for the shadow's edge: a lamp's radius, of a sun that of its disc a metre away; 0: a point.
    double size = 0;
  };
  std::vector<One> lights;      // `most` at most; first those that cast shadows, then the most important ones
  std::size_t casting = 0;      // how many of them do, `most_casting` at most
  Vec3 sky, ground;             // ambient light from above and below
  Vec3 zenith, horizon, below;  // the sky, if it is seen
};

// `center`: what the picture is about, in eye space.
Lighting lighting_of(const std::vector<Light>&, const View&, Vec3 center, const Surroundings& = {});

}  // namespace betwixt
