// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The drawing surface of a style: n×n samples a pixel in linear light with depth and stencil, and a background; and its
// conversion to a picture of sRGB bytes, or, if it is linear, of light in half floats.
#pragma once

#include <optional>

#include "betwixt/render.h"
#include "render/edges.h"
#include "render/gl.h"

namespace betwixt {

struct Backdrop {
  Vec3 top, bottom;   // linear light
  bool bends = true;  // with a soft beginning and end
};

// GLSL: vec3 encoded(vec3 linear), the sRGB curve within a quarter of a byte (0.1 above 0.02), without a power.
extern const char* const encoded_function;

class Canvas {
 public:
  static Result<Canvas> create(const RenderOptions&);
  int width() const { return width_; }
  int height() const { return height_; }
  int side() const { return side_; }  // factor of the pixels along a side

  bool linear() const { return linear_; }
  GLenum format() const { return linear_ ? GL_RGBA16F : GL_SRGB8_ALPHA8; }

  // Clears colour and depth, to the plain background if given; if `clear` and the canvas is linear, to transparent.
  void begin(const std::optional<Vec3>& background, bool clear) const;
  // If can_write_encoded(), programs write encoded colours after begin(), which saves the encoding of each sample, and
  // linear light after write_linear(), which can be blended. Otherwise they always write linear light.
  void write_linear() const;
  // Makes it the target of drawing.
  void bind() const;
  // Copies the drawing and its depth, one of the samples of each pixel; then makes this the target again.
  void copy_to(const gl::Target& of_same_size) const;
  // Copies the drawing, and its depth as above if it is wanted.
  void copy_color_to(GLuint framebuffer_of_same_size, bool and_depth) const;
  bool can_write_encoded() const { return can_write_encoded_; }
  // Fills empty pixels with the gradient.
  void draw_behind(const Backdrop&) const;
  // Averages the samples in linear light, by the pixel filter.
  void finish() const;
  // Draws the last finished picture, encoded, to the surface of the graphics system. Errors: machine.
  Status show();
  // Reads the last finished picture; one of four samples a pixel has smoother edges than they give.
  void read(Picture& out) const;
  void read(LinearPicture& out) const;  // of a linear canvas

 private:
  void bind_last() const;
  void write_encoded() const;

  int width_ = 0, height_ = 0, side_ = 0;
  bool linear_ = false, can_write_encoded_ = false;
  bool averages_ = false;     // `large_` is averaged to `pixels_`
  gl::Multisampled corners_;  // four samples a pixel of `large_`; absent for plain supersampling
  gl::Target large_;          // `side_` times the picture's size
  gl::Target pixels_;         // the picture; absent if `large_` is the picture
  gl::Program gradient_, average_;
  std::optional<EdgeSmoother> edges_;  // of four samples that `resolve_` averages
  gl::Program resolve_;                // absent if the graphics interface resolves `corners_`
  gl::Program show_;                   // made on first use
  GLint gradient_top_ = 0, gradient_bottom_ = 0, gradient_bends_ = 0;
};

}  // namespace betwixt
