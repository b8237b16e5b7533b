// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/canvas.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/view.h"

namespace betwixt {
namespace {

const char* const gradient_fragment = R"(
in vec2 at;
uniform vec3 top, bottom;
out vec4 color;
void main() { color = vec4(mix(bottom, top, smoothstep(0.0, 1.0, at.y)), 0.0); }
)";

// Rows come from the top, so the picture is turned over here, where it costs nothing.
const char* const resolve_fragment = R"(
uniform sampler2D samples;
uniform sampler2D occlusion;
uniform int height;
in vec2 at;
out vec4 color;
vec3 encoded(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}
void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  pixel.y = height - 1 - pixel.y;
  vec4 sum = vec4(0.0);
  for (int y = 0; y < SIDE; ++y)
    for (int x = 0; x < SIDE; ++x) sum += texelFetch(samples, SIDE * pixel + ivec2(x, y), 0);
  sum *= 1.0 / float(SIDE * SIDE);
#ifdef OCCLUSION
  sum.rgb *= 1.0 - sum.a * (1.0 - texture(occlusion, vec2(at.x, 1.0 - at.y)).r);
#endif
  color = vec4(encoded(sum.rgb), 1.0);
}
)";

void set_color(GLint where, Vec3 c) {
  glUniform3f(where, static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z));
}

}  // namespace

Result<Canvas> Canvas::create(const RenderOptions& options) {
  Canvas c;
  c.width_ = options.width, c.height_ = options.height;
  while ((c.side_ + 1) * (c.side_ + 1) <= options.samples) ++c.side_;
  auto samples = gl::new_target(GL_SRGB8_ALPHA8, GL_DEPTH_COMPONENT24, c.width_ * c.side_, c.height_ * c.side_);
  if (!samples) return samples.error();
  auto pixels = gl::new_target(GL_RGBA8, 0, c.width_, c.height_);
  if (!pixels) return pixels.error();
  auto gradient = gl::new_program(gl::fill_vertex, gradient_fragment);
  if (!gradient) return gradient.error();
  auto resolve = gl::new_program(gl::fill_vertex, resolve_fragment, fmt::format("#define SIDE {}", c.side_));
  if (!resolve) return resolve.error();
  c.samples_ = *std::move(samples), c.pixels_ = *std::move(pixels);
  c.gradient_ = *std::move(gradient), c.resolve_ = *std::move(resolve);
  c.gradient_top_ = gl::uniform(c.gradient_, "top"), c.gradient_bottom_ = gl::uniform(c.gradient_, "bottom");
  gl::set_samplers(c.resolve_, {{"samples", 0}, {"occlusion", 1}});
  glUniform1i(gl::uniform(c.resolve_, "height"), c.height_);
  return c;
}

void Canvas::begin(const std::optional<Vec3>& background) const {
  samples_.bind();
  const Vec3 c = background && finite(*background) ? *background : Vec3{};
  glClearColor(static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z), 0);
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Canvas::draw_behind(const std::optional<Vec3>& background, const Gradient& gradient) const {
  if (background) return;
  glUseProgram(gradient_.id());
  set_color(gradient_top_, gradient.top);
  set_color(gradient_bottom_, gradient.bottom);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  gl::fill();
  glDepthMask(GL_TRUE);
}

void Canvas::finish(GLuint occlusion, Picture& out) const {
  pixels_.bind();
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glUseProgram(resolve_.id());
  gl::use_texture(1, occlusion);
  gl::use_texture(0, samples_.color.id());
  gl::fill();
  out.width = width_, out.height = height_;
  out.rgba.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 4);
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, out.rgba.data());
}

}  // namespace betwixt
