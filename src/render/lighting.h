// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The lights of a frame.
//
// A light of colour c (intensity included) at distance d sends c·w², w = 1 - (d / range)², and nothing beyond its
// range; a surface of colour a that faces it shows a·c·w². So intensity 1 lights well from close by up to about two
// thirds of the range (w² = 0.31), whatever the range, and nothing is cut off. A sun sends 0.8·c. A fifth of a white
// surface's brightness is left to the sky.
#pragma once

#include <array>
#include <vector>

#include "render/skies.h"
#include "render/view.h"

namespace betwixt {

struct Lighting {
  static constexpr std::size_t most = 16, most_casting = 4;
  // The default background, at the top of the picture and at its bottom.
  static constexpr Vec3 above{0.26, 0.28, 0.31}, beneath{0.12, 0.125, 0.13};
  struct One {
    bool sun = false;
    Vec3 place;  // eye space: the position of a lamp, or the direction towards a sun
    Vec3 color;
    double range = 1;
    Vec3 world;  // a lamp's position in the world
    // Its size, for soft edges of shadows: a lamp's radius, or the radius of a sun's disc one metre away; 0: a point.
    double size = 0;
    // Of lamps with an area or a cone.
    LightShape shape = LightShape::point;
    Vec3 aim{0, -1, 0}, across{1, 0, 0};  // where it shines to, and the direction of its width
    double half_width = 0, half_height = 0, cone = 0, cone_edge = 0;
    std::shared_ptr<const Picture> picture = {};  // that a cone projects; null if it has none
  };
  std::vector<One> lights;      // at most `most`; first those that cast shadows, then the strongest
  std::size_t casting = 0;      // how many of them cast shadows, at most `most_casting`
  Vec3 sky, ground;             // ambient light from above and below
  Vec3 zenith, horizon, below;  // the sky, if it is visible
};

// Returns what metals mirror of the sky: less saturated than it is seen, since gold under pure blue would be olive.
inline Vec3 in_metal(Vec3 sky) {
  const double gray = 0.2126 * sky.x + 0.7152 * sky.y + 0.0722 * sky.z;
  return 0.3 * sky + 0.7 * gray * Vec3{1, 1, 1};
}

// `center`: the middle of the scene, in eye space.
// `sun`: that of the sky.
Lighting lighting_of(const std::vector<Light>&, const View&, Vec3 center, const Surroundings& = {},
                     const std::optional<SkySun>& sun = {});

}  // namespace betwixt
