// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/canvas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/stages.h"
#include "render/encoding.h"
#include "render/view.h"
#include "scene/pixel_filter.h"

namespace betwixt {
namespace {

const char* const gradient_fragment = R"(
in vec2 at;
uniform vec3 top, bottom;
uniform float bends;
out vec4 color;
void main() {
  vec3 c = mix(top, bottom, mix(at.y, smoothstep(0.0, 1.0, at.y), bends));
#ifdef ENCODED
  c = encoded(c);
#endif
  color = vec4(c, 1.0);
}
)";

const char* const average_fragment = R"(
uniform sampler2D samples;
out vec4 color;
void main() {
  ivec2 first = SIDE * ivec2(gl_FragCoord.xy) + FIRST, last = textureSize(samples, 0) - 1;
  vec4 sum = vec4(0.0);
  for (int y = 0; y < TAPS; ++y)
    for (int x = 0; x < TAPS; ++x)
      sum += weights[x] * weights[y] * texelFetch(samples, clamp(first + ivec2(x, y), ivec2(0), last), 0);
  color = max(sum, 0.0);
}
)";

// Returns GLSL with the filter's weights for the samples around a pixel, `side` of them per pixel. Their sum is 1.
std::string weights_of(const PixelFilter& filter, int side) {
  const auto offset = [&](int k) { return (k + 0.5) / side - 0.5; };
  int first = 0;
  while (offset(first - 1) > -filter.radius) --first;
  std::vector<double> weights;
  double sum = 0;
  for (int k = first; offset(k) < filter.radius; ++k) sum += weights.emplace_back(filter.weight(offset(k)));
  std::string list;
  for (const double w : weights) list += fmt::format("{}{:.9f}", list.empty() ? "" : ", ", w / sum);
  return fmt::format(
      "#define SIDE {}\n#define FIRST {}\n#define TAPS {}\nconst float weights[TAPS] = float[TAPS]({});\n", side, first,
      weights.size(), list);
}

// The same sums as the graphics interface's own, whose program no driver stores between runs: it would be compiled
// again for each first picture, which takes longer than everything else together. Marks are for
// EdgeSmoother.
const char* const resolve_fragment = R"(
uniform highp sampler2DMS samples;
out vec4 color;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 a = texelFetch(samples, at, 0), b = texelFetch(samples, at, 1), c = texelFetch(samples, at, 2),
       d = texelFetch(samples, at, 3);
  color = 0.25 * (a + b + c + d);
#ifdef MARKS
  const vec4 weights = vec4(0.35, 0.5, 0.15, 0.25);
  vec4 light = min(vec4(dot(a, weights), dot(b, weights), dot(c, weights), dot(d, weights)), 60000.0);
  float low = min(min(light.x, light.y), min(light.z, light.w)), high = max(max(light.x, light.y), max(light.z, light.w));
  vec4 bright = step(0.5 * (low + high), light), off = abs(light - mix(vec4(low), vec4(high), bright));
  if (max(max(off.x, off.y), max(off.z, off.w)) > 0.3 * (high - low)) bright = vec4(1.0);
  if (high - low <= 0.03 * (high - 0.25 * color.a) + 0.002) bright = vec4(0.0);
#ifdef LINEAR
  color = mix(max(color, 0.0), -max(color, 1e-7), greaterThan(bright, vec4(0.5)));
#else
  color.a = dot(bright, vec4(1.0, 2.0, 4.0, 8.0)) / 255.0;
#endif
#endif
}
)";

// The picture's first row is what is shown on top. A linear one has its opacity multiplied in, as graphics that are
// laid over others have it; an opacity is at least so much that light without it can be as bright (to_shown).
const char* const show_fragment = R"(
uniform sampler2D picture;
out vec4 color;
vec3 curve(vec3 c) { return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c)); }
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 c = texelFetch(picture, ivec2(at.x, textureSize(picture, 0).y - 1 - at.y), 0);
#ifdef LINEAR
  c = clamp(abs(c), 0.0, 1.0);  // the signs are marks
  float opacity = max(max(c.r, c.g), max(c.b, c.a));
  color = vec4(curve(c.rgb / max(opacity, 1e-6)) * opacity, opacity);
#else
  color = vec4(curve(c.rgb), 1.0);
#endif
}
)";

void set_color(GLint where, Vec3 c) {
  glUniform3f(where, static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z));
}

}  // namespace

const char* const encoded_function = R"(
vec3 encoded(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  vec3 r2 = sqrt(c), r4 = sqrt(r2), r8 = sqrt(r4);
  vec3 curve = 0.662002687 * r2 + 0.684122060 * r4 - 0.323583601 * r8 - 0.0225411470 * c;
  return mix(12.92 * c, curve, step(0.0031308, c));
}
)";

Result<Canvas> Canvas::create(const RenderOptions& options) {
  Canvas c;
  c.width_ = options.width, c.height_ = options.height;
  c.linear_ = options.linear;
  c.can_write_encoded_ = !c.linear_ && gl::has_extension("GL_EXT_sRGB_write_control");
  if (c.linear_ && !gl::has_extension("GL_EXT_color_buffer_float"))
    return fail(ErrorCode::machine, "these graphics have no pictures of light (GL_EXT_color_buffer_float)");
  const PixelFilter& filter = *find_pixel_filter(options.pixel_filter);
  const bool box = &filter == &pixel_filters().front();
  // The graphics can average four samples by themselves, but only as a box does.
  const bool multisampled = box && (options.samples == 4 || options.samples == 16);
  c.side_ = static_cast<int>(std::lround(std::sqrt(options.samples))) / (multisampled ? 2 : 1);
  c.averages_ = c.side_ > 1 || !box;
  const int width = c.width_ * c.side_, height = c.height_ * c.side_;
  if (multisampled) {
    auto corners = gl::new_multisampled(c.format(), GL_DEPTH24_STENCIL8, 4, width, height);
    if (!corners) return corners.error();
    c.corners_ = *std::move(corners);
  }
  if (c.corners_.samples.id() != 0) {
    auto resolve = gl::new_program(gl::fill_vertex, resolve_fragment,
                                   c.averages_ ? ""
                                   : c.linear_ ? "#define MARKS\n#define LINEAR"
                                               : "#define MARKS",
                                   "310 es");
    if (!resolve) return resolve.error();
    c.resolve_ = *std::move(resolve);
    gl::set_samplers(c.resolve_, {{"samples", 0}});
    if (!c.averages_) {
      c.bind();
      c.edges_.emplace(gl::sample_places(4));
    }
  }
  auto large = gl::new_target(c.format(), multisampled ? 0 : GL_DEPTH24_STENCIL8, width, height);
  if (!large) return large.error();
  c.large_ = *std::move(large);
  auto gradient = gl::new_program(gl::fill_vertex, std::string(encoded_function) + gradient_fragment,
                                  c.can_write_encoded_ ? "#define ENCODED" : "");
  if (!gradient) return gradient.error();
  c.gradient_ = *std::move(gradient);
  c.gradient_top_ = gl::uniform(c.gradient_, "top"), c.gradient_bottom_ = gl::uniform(c.gradient_, "bottom");
  c.gradient_bends_ = gl::uniform(c.gradient_, "bends");
  if (!c.averages_) return c;
  auto pixels = gl::new_target(c.format(), 0, c.width_, c.height_);
  if (!pixels) return pixels.error();
  c.pixels_ = *std::move(pixels);
  auto average = gl::new_program(gl::fill_vertex, weights_of(filter, c.side_) + average_fragment);
  if (!average) return average.error();
  c.average_ = *std::move(average);
  gl::set_samplers(c.average_, {{"samples", 0}});
  return c;
}

void Canvas::bind() const {
  large_.bind();
  if (corners_.framebuffer.id() != 0) glBindFramebuffer(GL_FRAMEBUFFER, corners_.framebuffer.id());
}

void Canvas::copy_to(const gl::Target& to) const {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.framebuffer.id());
  glBlitFramebuffer(0, 0, large_.width, large_.height, 0, 0, large_.width, large_.height,
                    GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  bind();
}

void Canvas::copy_color_to(GLuint framebuffer, bool and_depth) const {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  glBlitFramebuffer(0, 0, large_.width, large_.height, 0, 0, large_.width, large_.height,
                    GL_COLOR_BUFFER_BIT | (and_depth ? GL_DEPTH_BUFFER_BIT : 0U), GL_NEAREST);
  bind();
}

void Canvas::begin(const std::optional<Vec3>& background, bool clear) const {
  bind();
  write_encoded();
  Vec3 c = background && finite(*background) && !clear ? *background : Vec3{};
  if (can_write_encoded_) c = {encoded(c.x), encoded(c.y), encoded(c.z)};
  glClearColor(static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z), linear_ && clear ? 0 : 1);
  glDepthMask(GL_TRUE);
  // Clear the stencil too, so that whole words are cleared: for depth alone, software GL clears bits, sample by sample.
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void Canvas::draw_behind(const Backdrop& gradient) const {
  glUseProgram(gradient_.id());
  set_color(gradient_top_, gradient.top);
  set_color(gradient_bottom_, gradient.bottom);
  glUniform1f(gradient_bends_, gradient.bends ? 1 : 0);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  gl::fill();
  glDepthMask(GL_TRUE);
}

void Canvas::write_encoded() const {
  if (can_write_encoded_) glDisable(gl::framebuffer_srgb);
}

void Canvas::write_linear() const {
  if (can_write_encoded_) glEnable(gl::framebuffer_srgb);
}

void Canvas::finish() const {
  write_linear();
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  if (resolve_.id() != 0) {
    large_.bind();
    glUseProgram(resolve_.id());
    gl::use_samples(0, corners_.samples.id());
    gl::fill();
  } else if (corners_.framebuffer.id() != 0) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, corners_.framebuffer.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, large_.framebuffer.id());
    glBlitFramebuffer(0, 0, large_.width, large_.height, 0, 0, large_.width, large_.height, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
  }
  if (!averages_) return;
  pixels_.bind();
  glUseProgram(average_.id());
  gl::use_texture(0, large_.color.id());
  gl::fill();
}

Status Canvas::show() {
  if (show_.id() == 0) {
    auto made = gl::new_program(gl::fill_vertex, show_fragment, linear_ ? "#define LINEAR" : "");
    if (!made) return made.error();
    show_ = *std::move(made);
    gl::set_samplers(show_, {{"picture", 0}});
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, width_, height_);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glUseProgram(show_.id());
  gl::use_texture(0, (averages_ ? pixels_ : large_).color.id());
  gl::fill();
  return Nothing{};
}

void Canvas::bind_last() const { glBindFramebuffer(GL_FRAMEBUFFER, (averages_ ? pixels_ : large_).framebuffer.id()); }

void Canvas::read(Picture& out) const {
  if (StageTimes::listened()) glFinish();  // otherwise its time would be counted below
  const InStage stage(Stage::read_back);
  out.width = width_, out.height = height_;
  out.rgba.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 4);
  bind_last();
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, out.rgba.data());
  if (edges_) edges_->finish(out);
}

void Canvas::read(LinearPicture& out) const {
  if (StageTimes::listened()) glFinish();
  const InStage stage(Stage::read_back);
  out.width = width_, out.height = height_;
  out.rgba.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 4);
  bind_last();
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, out.rgba.data());
  if (edges_) edges_->finish(out);
}

}  // namespace betwixt
