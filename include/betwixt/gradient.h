// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Gradients: colours that go over into each other across an object. They are mixed in linear light, multiplied by their
// opacities, so that a colour fades without a dark edge.
//
// Room: scene
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "betwixt/math.h"

namespace betwixt {

// Along a line, from a point outwards to an ellipse or to a circle, or around a point.
enum class GradientKind : std::uint8_t { none, linear, radial, circular, conic };
// What is before the first stop and after the last one: their colours; the gradient again; or again, backwards every
// other time.
enum class GradientSpread : std::uint8_t { pad, repeat, reflect };

// It lies on the box of the object in object space, seen along z; the box is that of the whole object, without its
// stroke. With a size of 1, a linear one goes through the middle of the box from the corner that is farthest back to
// the one that is farthest ahead; a radial one goes from the middle to an ellipse that touches the sides, a circular
// one to a circle that touches those that are farther apart; a conic one goes once around the middle, anticlockwise.
struct Gradient {
  struct Stop {
    double at = 0;       // 0 where the gradient begins to 1 where it ends
    Vec3 color;          // linear light
    double opacity = 1;  // 0 to 1
    friend bool operator==(const Stop&, const Stop&) = default;
  };
  GradientKind kind = GradientKind::none;
  GradientSpread spread = GradientSpread::pad;
  double turn = 0;  // radians: where a linear one goes to, and where a conic one begins; anticlockwise from x
  double move_x = 0, move_y = 0;  // in widths and heights of the box
  double size = 1;                // its length; of a conic one, the part of a turn
  std::vector<Stop> stops;        // two or more, in order
  friend bool operator==(const Gradient&, const Gradient&) = default;
};
inline constexpr std::size_t most_stops = 16;  // of a gradient

// Those of an object. A part of its mesh that is not the stroke and has the object's own colour has `fill` in its
// place.
struct Gradients {
  Gradient fill, stroke;  // the kind is `none` if there is none
  friend bool operator==(const Gradients&, const Gradients&) = default;
  // Returns whether one of them lets through what is behind it.
  bool see_through() const {
    for (const Gradient* g : {&fill, &stroke})
      for (const Gradient::Stop& s : g->stops)
        if (s.opacity < 1) return true;
    return false;
  }
};

}  // namespace betwixt
