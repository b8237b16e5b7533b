// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/picture_screen.h"

namespace betwixt {
namespace {

// The picture's first row is what is shown on top. Its colours are straight; the surface wants them multiplied.
const char* const copy_fragment = R"(
uniform sampler2D picture;
out vec4 color;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 c = texelFetch(picture, ivec2(at.x, textureSize(picture, 0).y - 1 - at.y), 0);
  color = vec4(c.rgb * c.a, c.a);
}
)";

}  // namespace

PictureScreen::~PictureScreen() {
  if (!context_) return;
  const gl::Current current(*context_);
  program_ = {}, texture_ = {};
}

Status PictureScreen::show(const Picture& picture) {
  if (!context_) {
    auto context = gl::Context::create();
    if (!context) return context.error();
    context_.emplace(*std::move(context));
  }
  if (!context_->shows())
    return fail(ErrorCode::machine, "this renderer has no window", "use render() to get the picture");
  const gl::Current current(*context_);
  if (program_.id() == 0) {
    auto made = gl::new_program(gl::fill_vertex, copy_fragment);
    if (!made) return made.error();
    program_ = *std::move(made);
    gl::set_samplers(program_, {{"picture", 0}});
  }
  if (width_ != picture.width || height_ != picture.height)
    texture_ = gl::new_texture(GL_RGBA8, picture.width, picture.height, GL_NEAREST), width_ = picture.width,
    height_ = picture.height;
  gl::use_texture(0, texture_.id());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, width_, height_);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glUseProgram(program_.id());
  gl::fill();
  return Nothing{};
}

}  // namespace betwixt
