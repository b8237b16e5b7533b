// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a style draws on: n×n samples a pixel in linear light with depth, behind everything the background, and the way
// from there to a picture of sRGB bytes.
#pragma once

#include <optional>

#include "betwixt/render.h"
#include "render/gl.h"

namespace betwixt {

struct Gradient {
  Vec3 top, bottom;  // linear light
};

class Canvas {
 public:
  static Result<Canvas> create(const RenderOptions&);
  int width() const { return width_; }
  int height() const { return height_; }
  int side() const { return side_; }  // samples along one side of a pixel
  const gl::Target& samples() const { return samples_; }

  // Clears colour and depth; a plain background is there from now on.
  void begin(const std::optional<Vec3>& background) const;
  // Fills what is still empty with the gradient, where the frame has no background of its own.
  void draw_behind(const std::optional<Vec3>& background, const Gradient&) const;
  // Averages the samples in linear light, encodes and reads them. `occlusion`: a texture that darkens, or 0.
  void finish(GLuint occlusion, Picture& out) const;

 private:
  int width_ = 0, height_ = 0, side_ = 0;
  gl::Target samples_, pixels_;
  gl::Program gradient_, resolve_;
  GLint gradient_top_ = 0, gradient_bottom_ = 0;
};

}  // namespace betwixt
