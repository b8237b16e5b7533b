// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures that are composed to one: groups that are drawn by themselves, and the pictures of two cameras.
//
// Room: scene
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "betwixt/math.h"
#include "betwixt/object.h"

namespace betwixt {

enum class LayerBlend : std::uint8_t { normal, screen, multiply, add, overlay };
// In the order of LayerBlend.
inline constexpr std::array<std::string_view, 5> layer_blend_names{"normal", "screen", "multiply", "add", "overlay"};

// A group whose objects make a picture of their own, which is composed as a whole, in linear light.
struct Layer {
  ObjectId object;
  std::int32_t within = -1;         // the layer whose picture it is a part of; -1: the frame's
  bool is_mask = false;             // it is not seen itself
  std::vector<std::int32_t> masks;  // the layers that say where it is seen; if empty, it is seen everywhere
  double opacity = 1;
  LayerBlend blend = LayerBlend::normal;
  Vec3 place;       // in the world: lengths are those of things that are as far away
  double blur = 0;  // metres, of the deviation of a Gaussian
  double glow = 0, glow_size = 0.25;
  Vec3 shadow;  // how far to the right and up in the picture, and how soft, metres; all 0: it drops none
  Vec3 shadow_color;
  double shadow_opacity = 0.5;
};

// How the picture of one camera goes over into that of the next.
enum class ChangeKind : std::uint8_t { dissolve, left, right, up, down, iris };
// In the order of ChangeKind. A wipe to the left moves its edge to the left.
inline constexpr std::array<std::string_view, 6> change_names{"dissolve", "left", "right", "up", "down", "iris"};

}  // namespace betwixt
