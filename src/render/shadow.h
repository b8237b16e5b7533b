// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The shadows of lights: for each that casts a depth map seen from it. What a map must show finely are the
// casters that are large in the picture, unless all fit; it is drawn anew only where those are others, what casts it or
// the light is.
#pragma once

#include "render/batches.h"
#include "render/lighting.h"

namespace betwixt {

class Shadows {
 public:
  static constexpr int map_size = 1024;
  // What a light's map is to those who look it up.
  struct Map {
    Mat4 clip;         // eye space to the map's clip space
    double texel = 0;  // the width of a texel: metres (suns), or metres a metre away (lamps)
    bool perspective = false;
    // Of an edge in the map, which is a square of 1, so much of its depth before what it falls on, also of 1, is half
    // its penumbra; 0: it has none.
    double spread = 0;
    double top = 0;  // the least depth of what is shown finely
  };

  static Result<Shadows> create();
  // The maps of what all casters among the things keep from each of the lights; none where there are no casters.
  std::span<const Map> update(Things&, std::span<const Lighting::One> casting);
  GLuint texture() const { return layers_.id(); }  // an array, in that order

 private:
  // What a map was drawn for.
  struct Made {
    std::uint64_t casters = 0;
    bool sun = false;
    Vec3 place;  // of a lamp; of a sun the direction towards it
    double range = 0, size = 0;
    Vec3 anchor;
    friend bool operator==(const Made&, const Made&) = default;
  };
  struct One {
    Map map;
    std::optional<Made> made;
    std::vector<std::uint32_t> fine;  // those that the map shows finely
    Vec3 origin;                      // in the world; what is drawn is placed relative to it
    Mat4 clip;                        // from there to the map's clip space
  };
  Status make_layers(std::size_t count);
  void find_casters(const Things&, Vec3 anchor);
  std::vector<std::uint32_t> subject(const Things&, Vec3 anchor) const;
  void look(One&, const Things&, const Lighting::One&) const;
  void draw(One&, std::size_t layer, Things&, const Lighting::One&);
  void draw_some(const One&, Things&, bool veils);

  gl::Texture layers_;
  gl::Framebuffer framebuffer_;
  std::size_t count_ = 0;  // of layers
  gl::Program meshes_, balls_, veils_;
  Instances instances_;
  std::vector<std::uint32_t> casters_, by_size_;
  std::optional<std::pair<std::uint64_t, Vec3>> found_;  // for which casters, and which anchor, these are
  std::array<One, Lighting::most_casting> all_;
  std::array<Map, Lighting::most_casting> maps_;
};

}  // namespace betwixt
