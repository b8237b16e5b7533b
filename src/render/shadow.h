// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The shadow of the most important light: a depth map seen from it. What it must show finely are the
// casters that are large in the picture, unless all fit; it is drawn anew only where those are others, what casts it or
// the light is.
#pragma once

#include "render/batches.h"
#include "render/lighting.h"

namespace betwixt {

class Shadow {
 public:
  static constexpr int map_size = 1024;
  static Result<Shadow> create();
  // Makes the map of what all casters among the things keep from `light`; false: there are none.
  bool update(Things&, const Lighting::One& light);
  GLuint map() const { return target_.depth.id(); }
  const Mat4& clip() const { return clip_; }  // eye space to the map's clip space
  double texel() const { return texel_; }     // the width of a texel: metres (suns), or metres a metre away (lamps)
  bool perspective() const { return perspective_; }

 private:
  // What the map was drawn for.
  struct Made {
    std::uint64_t casters = 0;
    bool sun = false;
    Vec3 place;  // of a lamp; of a sun the direction towards it
    double range = 0;
    Vec3 anchor;
    friend bool operator==(const Made&, const Made&) = default;
  };
  std::vector<std::uint32_t> subject(const Things&, Vec3 anchor) const;
  void look(const Things&, const Lighting::One&, Vec3 anchor);
  void draw(Things&, const Lighting::One&);
  void draw_some(Things&, bool veils);

  gl::Target target_;
  gl::Program meshes_, balls_, veils_;
  Instances instances_;
  std::optional<Made> made_;
  std::vector<std::uint32_t> casters_, by_size_;
  std::vector<std::uint32_t> fine_;  // those that the map shows finely
  Vec3 origin_;    // in the world; what is drawn is placed relative to it
  Mat4 map_clip_;  // from there to the map's clip space
  Mat4 clip_;
  double texel_ = 0;
  bool perspective_ = false;
};

}  // namespace betwixt
