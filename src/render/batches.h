// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Things that are drawn by one call: the same mesh, texture and facing, one instance each.
#pragma once

#include <span>

#include "render/things.h"

namespace betwixt {

struct Batch {
  StoredMesh* mesh = nullptr;
  const StoredTexture* texture = nullptr;  // the things' own
  bool mirrored = false, closed = false, ball = false, line = false;
  std::size_t first = 0, count = 0;  // instances
  friend bool operator==(const Batch&, const Batch&) = default;
};

struct Batches {
  std::vector<Batch> batches;
  std::vector<std::uint32_t> order;  // the thing of each instance
};

// Of the things of these numbers. The nearest first, so that what is hidden is seldom shaded; equally near ones in
// their own order.
Batches batches_of(const Things&, std::span<const std::uint32_t>);
// Farthest first, each a batch of its own.
Batches sorted_singles(const Things&, std::span<const std::uint32_t>);

// Instances in graphics memory, in the order in which they are drawn. What stays where it was is not sent again.
class Instances {
 public:
  void set(const Things&, const std::vector<std::uint32_t>& order);
  void set(std::vector<Instance> all);
  // Points the program's inputs at the first-th instance; the mesh's vertex array is bound.
  void bind(std::size_t first) const;

 private:
  void send(std::size_t first, std::size_t end) const;
  gl::Buffer buffer_ = gl::new_buffer();
  std::vector<Instance> sent_;
  std::vector<std::uint32_t> order_, place_;  // the thing of each instance, and the other way round
};

// What is drawn from begin() on changes each sample once, also where it crosses itself. Takes the stencil for itself.
class Once {
 public:
  Once() = default;
  Once(const Once&) = delete;
  Once& operator=(const Once&) = delete;
  ~Once() { end(); }
  void begin();
  static void end();

 private:
  static constexpr int most = 255;
  int mark_ = most;  // of the samples that have changed
};

// Draws all triangles of a batch with the program that is set; `closed` ones from outside only.
void draw_triangles(const Batch&, const Instances&, bool upside_down);
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
