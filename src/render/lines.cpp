// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/lines.h"

namespace betwixt {
namespace {

constexpr float line_width = 1.4F;  // pixels of the picture

// Each corner of a line's rectangle knows both ends. They are cut at the near plane and divided here, so that
// everything after is in pixels.
const char* const line_vertex = R"(
layout(location = 0) in vec3 start;
layout(location = 1) in vec3 end;
layout(location = 2) in vec2 corner;  // 0 start or 1 end, and which side: -1 or 1
layout(location = 3) in vec4 row_x;
layout(location = 4) in vec4 row_y;
layout(location = 5) in vec4 row_z;
layout(location = 9) in vec4 color;
uniform mat4 clip;
uniform vec2 half_size;  // of the picture, in pixels
uniform float reach;     // from the middle of a line to where it has faded
out float off;
flat out vec4 paint;
vec4 project(vec3 p) {
  vec4 q = vec4(p, 1.0);
  return clip * vec4(dot(row_x, q), dot(row_y, q), dot(row_z, q), 1.0);
}
void main() {
  paint = color;
  off = corner.y * reach;
  vec4 a = project(start), b = project(end);
  float da = a.z + a.w, db = b.z + b.w;  // before the near plane
  if (da < 0.0 && db < 0.0) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    return;
  }
  if (da < 0.0) a = mix(a, b, da / (da - db));
  if (db < 0.0) b = mix(b, a, db / (db - da));
  a.xyz /= a.w;
  b.xyz /= b.w;
  vec2 along = (b.xy - a.xy) * half_size;
  float size = length(along);
  along = size > 1e-6 ? along / size : vec2(1.0, 0.0);
  vec3 p = corner.x < 0.5 ? a.xyz : b.xyz;
  vec2 shift = vec2(-along.y, along.x) * corner.y * reach + along * (corner.x - 0.5) * 0.5;
  gl_Position = vec4(p.xy + shift / half_size, p.z, 1.0);
}
)";

const char* const line_fragment = R"(
in float off;
flat in vec4 paint;
uniform float reach;
#ifdef LAYER
uniform vec2 between;  // how much a line covers where it is drawn now
#endif
out vec4 color;
void main() {
  float cover = clamp(reach - abs(off), 0.0, 1.0);
#ifdef LAYER
  if (cover <= between.x || cover > between.y) discard;
#endif
  cover *= paint.a;
  color = vec4(min(paint.rgb, 1.0) * cover, cover);
}
)";

}  // namespace

Result<Lines> Lines::create() {
  auto program = gl::new_program(line_vertex, line_fragment);
  if (!program) return program.error();
  Lines l;
  l.program_ = *std::move(program);
  return l;
}

void Lines::set(const View& view, int side) { set(program_, view, side); }

void Lines::set(const gl::Program& program, const View& view, int side) {
  const auto s = static_cast<float>(side);
  glUseProgram(program.id());
  glUniformMatrix4fv(gl::uniform(program, "clip"), 1, GL_FALSE, to_float(view.clip()).data());
  glUniform2f(gl::uniform(program, "half_size"), 0.5F * s * static_cast<float>(view.width),
              0.5F * s * static_cast<float>(view.height));
  glUniform1f(gl::uniform(program, "reach"), 0.5F * s * line_width + 0.5F);
}

void Lines::draw(const Batch& batch, const Instances& instances) const {
  glUseProgram(program_.id());
  draw_edges(batch, instances);
}

void Lines::draw_edges(const Batch& batch, const Instances& instances) {
  Store::need_edges(*batch.mesh);
  if (batch.mesh->edge_count == 0) return;
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glBindVertexArray(batch.mesh->edges.id());
  instances.bind(batch.first);
  glDrawElementsInstanced(GL_TRIANGLES, batch.mesh->edge_count, GL_UNSIGNED_INT, nullptr,
                          static_cast<GLsizei>(batch.count));
  glDepthMask(GL_TRUE);
}

// Where borders that fade overlap what covers more, that counts: a line is drawn layer by layer, what covers most
// first.
void Lines::draw_transparent(const Batches& batches, const Instances& instances, const View& view, int side) {
  if (layer_.id() == 0) {
    auto made = gl::new_program(line_vertex, line_fragment, "#define LAYER");
    if (!made) return;  // the same stages as those of all others
    layer_ = *std::move(made);
  }
  set(layer_, view, side);
  const GLint between = gl::uniform(layer_, "between");
  constexpr int layers = 4;
  Once once;
  for (const Batch& b : batches.batches) {
    once.begin();
    for (int k = layers; k-- > 0;) {
      glUniform2f(between, static_cast<float>(k) / layers, static_cast<float>(k + 1) / layers);
      draw_edges(b, instances);
    }
  }
}

}  // namespace betwixt
