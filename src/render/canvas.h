// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a style draws on: n×n samples a pixel in linear light with depth and stencil, behind everything the background,
// and the way from there to a picture: of sRGB bytes, or where it is deep of light, in half floats.
#pragma once

#include <optional>

#include "betwixt/render.h"
#include "render/gl.h"

namespace betwixt {

struct Gradient {
  Vec3 top, bottom;   // linear light
  bool bends = true;  // it begins and ends softly
};

// GLSL: vec3 encoded(vec3 linear), the sRGB curve within a quarter of a byte (0.1 above 0.02), without a power.
extern const char* const encoded_function;

class Canvas {
 public:
  static Result<Canvas> create(const RenderOptions&);
  int width() const { return width_; }
  int height() const { return height_; }
  int side() const { return side_; }  // how many times as many pixels are drawn along a side

  bool deep() const { return deep_; }
  GLenum format() const { return deep_ ? GL_RGBA16F : GL_SRGB8_ALPHA8; }

  // Clears colour and depth; a plain background is there from now on, or where the canvas is deep nothing, if `clear`.
  void begin(const std::optional<Vec3>& background, bool clear) const;
  // Where can_write_encoded(), programs write encoded colours after begin(), which saves encoding each sample, and
  // after write_linear() linear light, which can be blended. Elsewhere always linear light.
  void write_linear() const;
  // What is drawn goes there.
  void bind() const;
  // Copies what was drawn so far, with its depth, one sample where there are several to average; then binds this again.
  void copy_to(const gl::Target& of_same_size) const;
  bool can_write_encoded() const { return can_write_encoded_; }
  // Fills what is still empty with the gradient.
  void draw_behind(const Gradient&) const;
  // Averages the samples in linear light.
  void finish() const;
  // Draws the picture that was finished last, encoded, to what the graphics themselves show. Errors: machine.
  Status show();
  // Reads the picture that was finished last.
  void read(Picture& out) const;
  void read(DeepPicture& out) const;  // of a deep one

 private:
  void bind_last() const;
  void write_encoded() const;

  int width_ = 0, height_ = 0, side_ = 0;
  bool deep_ = false, can_write_encoded_ = false;
  gl::Multisampled corners_;  // four samples a pixel of `large_`; not there for plain supersampling
  gl::Target large_;          // `side_` times the picture's size
  gl::Target pixels_;         // the picture's size; not there where `large_` is that
  gl::Program gradient_, average_;
  gl::Program show_;  // made when it is wanted
  GLint gradient_top_ = 0, gradient_bottom_ = 0, gradient_bends_ = 0;
};

}  // namespace betwixt
