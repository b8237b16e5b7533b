// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Things that are drawn by one call: the same mesh, texture and facing, one instance each.
#pragma once

#include <span>

#include "render/things.h"

namespace betwixt {

// What goes to the graphics interface for each thing.
struct Instance {
  std::array<float, 12> rows;   // mesh space to eye space, row by row
  std::array<float, 9> normal;  // the same for normals, column by column; of about unit size
  std::array<float, 4> color;   // linear light and opacity
  std::array<float, 2> look;    // shininess, Material
};

struct Batch {
  StoredMesh* mesh = nullptr;
  std::shared_ptr<const Picture> texture;  // the items' own
  bool mirrored = false, closed = false, ball = false;
  std::size_t first = 0, count = 0;  // instances
};

struct Batches {
  std::vector<Batch> batches;
  std::vector<Instance> instances;
};

// The nearest first, so that what is hidden is seldom shaded; equally near ones in their own order.
Batches batches_of(std::span<const Thing* const>, bool coarse);
// Farthest first, each a batch of its own.
Batches sorted_singles(std::span<const Thing* const>);

// Sends the instances into `buffer`, whose memory is used again.
void send_instances(const gl::Buffer& buffer, const std::vector<Instance>&);
// Points the program's inputs at the first-th instance; the mesh's vertex array is bound.
void bind_instances(const gl::Buffer&, std::size_t first);
// Draws all triangles of a batch with the program that is set; `closed` ones from outside only.
void draw_triangles(const Batch&, const gl::Buffer& instances, bool upside_down);
// Which way round triangles are seen from outside; in pictures that are drawn upside down it is the other way.
void set_facing(bool mirrored, bool upside_down);

// What a vertex shader is given: a mesh's vertex and the instance it belongs to.
inline constexpr const char* vertex_inputs = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec4 row_x;
layout(location = 4) in vec4 row_y;
layout(location = 5) in vec4 row_z;
layout(location = 6) in vec3 normal_x;
layout(location = 7) in vec3 normal_y;
layout(location = 8) in vec3 normal_z;
layout(location = 9) in vec4 color;
layout(location = 10) in vec2 look;
)";

}  // namespace betwixt
