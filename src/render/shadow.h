// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The shadow of the most important light: a depth map seen from it.
#pragma once

#include "render/batches.h"
#include "render/lighting.h"

namespace betwixt {

class Shadow {
 public:
  static constexpr int map_size = 1024;
  static Result<Shadow> create();
  // Draws the map of what `casters` keep from `light`.
  void draw(const std::vector<const Thing*>& casters, const Lighting::One& light);
  GLuint map() const { return target_.depth.id(); }
  const Mat4& clip() const { return clip_; }  // eye space to the map's clip space
  double texel() const { return texel_; }     // the width of a texel: metres (suns), or metres a metre away (lamps)
  bool perspective() const { return perspective_; }

 private:
  gl::Target target_;
  gl::Program meshes_, balls_, veils_;
  gl::Buffer instances_;
  Mat4 clip_;
  double texel_ = 0;
  bool perspective_ = false;
};

}  // namespace betwixt
