// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The structs of the wire format, in the byte order of the machine. Included only by the files that write and read it.
#pragma once

#include <array>
#include <cstdint>

#include "betwixt/math.h"

namespace betwixt::wire {

// A header, then blocks, each preceded by its length.
enum class Holds : std::uint32_t {
  mesh = 1,
  picture = 2,
  error = 3,
  scene = 4,
  drawing = 5,
  linear_picture = 6,
  letters = 7,
  table = 8,
  colors = 9
};
struct Head {
  std::uint32_t holds = 0;
  std::uint32_t detail = 0;  // of an error: its code, and the permission that it needs in the second byte
};
inline constexpr std::uint32_t no_picture = ~std::uint32_t{0};
struct FlatMesh {
  std::uint32_t closed = 0, pictures = 0, rigged = 0, targets = 0;
};
struct FlatPart {
  std::uint32_t first = 0, count = 0;
  std::array<float, 3> color{};
  std::uint32_t picture = no_picture;
};
struct FlatDrawing {
  double width = 1;
  std::uint64_t sentences = 0;
};
struct FlatGradient {
  std::uint32_t kind = 0, spread = 0;
  double turn = 0, move[2]{}, size = 1;
};
struct FlatThing {
  std::uint32_t above = 0, flags = 0;  // one bit each
  double at[3]{}, color[3]{}, stroke[3]{}, stroke_width = 0, transparency = 0, trim_to = 1, dash[2]{};
  FlatGradient gradients[2];            // of the fill and of the stroke
  std::uint64_t points = 0, holes = 0;  // the numbers of points and holes that follow
};
enum : std::uint32_t { is_group = 1, is_filled = 2, is_stroked = 4, is_round = 8 };
struct FlatSize {
  std::int32_t width = 0, height = 0;
};
struct FlatColors {
  std::uint32_t takes = 0, cube = 0, size = 0;
  std::array<float, 3> least{}, most{};
};
struct FlatScene {
  std::uint64_t nodes = 0, meshes = 0, clips = 0, sentences = 0;
};
struct FlatNode {
  std::int32_t parent = -1, mesh = -1, camera = -1, light = -1;
  Vec3 position;
  Quat rotation;
  Vec3 scale;
};
struct FlatSurface {
  std::uint32_t material = 0, finished = 0;
  double shininess = 0, transparency = 0;
};
// A finish without patterns; as many pictures follow, each once.
struct FlatFinish {
  double numbers[17]{};
  Vec3 emission, sheen;
  std::uint32_t pictures = 0, which[5]{no_picture, no_picture, no_picture, no_picture, no_picture};
};
struct FlatLight {
  std::uint32_t sun = 0, padding = 0;
  Vec3 color;
  double intensity = 0, range = 0;
};
struct FlatTrack {
  std::uint32_t node = 0, path = 0, way = 0;
};

inline constexpr std::size_t longest_words = 4096;

}  // namespace betwixt::wire
