// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The shadows of lights: for each that casts depth maps seen from it. One is enough where it shows all casters as
// finely as the picture does; else there are finer ones for what is seen from close by, and the last has all. What lies
// around a lamp takes one for each side. They are drawn anew only where what casts, the light, or what they must show
// is another.
#pragma once

#include "render/batches.h"
#include "render/lighting.h"

namespace betwixt {

class Shadows {
 public:
  static constexpr int map_size = 1024;
  static constexpr std::size_t most_maps = 16;  // of all lights together
  // What a map is to those who look it up.
  struct Map {
    Mat4 clip;         // eye space to the map's clip space
    double texel = 0;  // the width of a texel: metres (suns), or metres a metre away (lamps)
    bool perspective = false;
    // Of an edge in the map, which is a square of 1, so much of its depth before what it falls on, also of 1, is half
    // its penumbra; 0: it has none.
    double spread = 0;
    double top = 0;         // the least depth of what it was made for
    std::size_t light = 0;  // whose it is
  };

  static Result<Shadows> create();
  // The maps of what all casters among the things keep from each of the lights, light by light, and of each the finest
  // first: the first that a point lies in says what it gets. None where there are no casters. `floor`: y = 0 takes
  // shadows.
  std::span<const Map> update(Things&, std::span<const Lighting::One> casting, bool floor);
  GLuint texture() const { return layers_.id(); }  // an array, in that order

 private:
  using Numbers = std::vector<std::uint32_t>;
  // What a light's maps were drawn for.
  struct Made {
    std::uint64_t casters = 0;
    bool sun = false;
    Vec3 place;  // of a lamp; of a sun the direction towards it
    double range = 0, size = 0;
    Vec3 anchor;
    bool floor = false;
    std::size_t room = 0;  // for so many maps
    friend bool operator==(const Made&, const Made&) = default;
  };
  struct Part {
    Map map;
    Vec3 origin;        // in the world; what is drawn is placed relative to it
    Mat4 clip;          // from there to the map's clip space
    bool stale = true;  // its layer shows something else
  };
  struct One {
    std::optional<Made> made;
    std::vector<Numbers> levels;  // what each map must show, or, the last of a lamp, all of its sides
    std::vector<Part> parts;
    std::size_t first = 0;  // of its layers
  };
  Status make_layers(std::size_t count);
  void find_casters(Things&, Vec3 anchor);
  static bool casts_on_nothing(Things&, std::uint32_t thing, const Made&);
  Numbers without_backdrops(Things&, const Made&) const;
  std::vector<Numbers> levels(Things&, const Made&) const;
  Part part_of_sun(const Things&, const Made&, const Numbers&) const;
  void look(One&, const Things&) const;
  void draw(const Part&, std::size_t layer, Things&, const Made&);
  void draw_some(const Part&, Things&, bool veils);

  gl::Texture layers_;
  gl::Framebuffer framebuffer_;
  std::size_t count_ = 0;  // of layers
  gl::Program meshes_, balls_, veils_;
  Instances instances_;
  Numbers casters_;
  std::optional<std::pair<std::uint64_t, Vec3>> found_;  // for which casters, and which anchor, these are
  std::array<One, Lighting::most_casting> all_;
  std::array<Map, most_maps> maps_;
};

}  // namespace betwixt
