// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Batches: objects that one call draws. They share mesh, texture and facing, with an instance each.
#pragma once

#include <span>

#include "render/gradients.h"
#include "render/things.h"

namespace betwixt {

struct Batch {
  StoredMesh* mesh = nullptr;
  const StoredTexture* texture = nullptr;  // that of the objects, in place of the mesh's
  const Finish* finish = nullptr;          // null if they have none
  const Gradients* gradients = nullptr;    // the same
  bool mirrored = false, closed = false, ball = false, line = false;
  std::size_t first = 0, count = 0;  // instances
  friend bool operator==(const Batch&, const Batch&) = default;
};

struct Batches {
  std::vector<Batch> batches;
  std::vector<std::uint32_t> order;  // the object of each instance
};

// Returns the gradient that colours a part of a batch, or null.
inline const Gradient* gradient_of(const Batch& b, const StoredPart& part) {
  return gradient_of(b.gradients, part.tinted, part.stroke);
}
// Sets the uniforms of a gradient in the current program. `at`: the places of uniforms by name.
template <class At>
void set_gradient(const Gradient& g, const Thing& t, const At& at) {
  const GradientUniforms u = uniforms_of(g, placed_gradient(g, t.gradient_box, t.to_object));
  glUniform4fv(at("gradient_x"), 1, u.x.data());
  glUniform4fv(at("gradient_y"), 1, u.y.data());
  glUniform4fv(at("grading"), 1, u.grading.data());
  glUniform4fv(at("stop_light"), most_stops, u.stop_light.front().data());
  glUniform1fv(at("stop_at"), most_stops, u.stop_at.data());
}
// Sets the colour of a part: that of its own, which a gradient of a stroke replaces.
template <class At>
void set_part_color(const StoredPart& part, const Gradient* gradient, const At& at) {
  const bool replaced = gradient != nullptr && part.stroke;
  const auto shown = [&](std::size_t i) { return replaced ? 1.F : part.color[i]; };
  glUniform4f(at("part_color"), shown(0), shown(1), shown(2), part.tinted ? 1.F : 0.F);
}

// Returns the batches of these objects, the nearest first, so that hidden surfaces are rarely shaded; equally near ones
// in their own order.
Batches batches_of(const Things&, std::span<const std::uint32_t>);
// Returns one batch for each, the farthest first.
Batches sorted_singles(const Things&, std::span<const std::uint32_t>);

// Instances in graphics memory, in drawing order. Instances at unchanged positions are not sent again.
class Instances {
 public:
  void set(const Things&, const std::vector<std::uint32_t>& order);
  void set(std::vector<Instance> all);
  // Binds the program's inputs to the instance `first`; the mesh's vertex array must be bound.
  void bind(std::size_t first) const;

 private:
  void send(std::size_t first, std::size_t end) const;
  gl::Buffer buffer_ = gl::new_buffer();
  std::vector<Instance> sent_;
  std::vector<std::uint32_t> order_, place_;  // the object of each instance, and the inverse
};

// After begin(), drawing changes each sample once, also where an object crosses itself. Uses the stencil.
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
  int mark_ = most;  // of the samples that have been changed
};

// Draws all triangles of a batch with the current program; of `closed` meshes the outside only.
void draw_triangles(const Batch&, const Instances&, bool upside_down);
// Sets the winding of front faces; in pictures that are drawn upside down it is reversed.
void set_facing(bool mirrored, bool upside_down);

// The inputs of a vertex shader: a vertex of the mesh, and the instance.
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
