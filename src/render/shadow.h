// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Shadow maps. Each light with shadows has depth maps as seen from it. One is enough if it shows all casters as finely
// as the picture does; otherwise close objects have finer ones, and the last has everything. A lamp among objects has
// one for each side. Maps are drawn again only if the casters, the light, or the objects to show have changed.
#pragma once

#include "render/batches.h"
#include "render/lighting.h"

namespace betwixt {

class Shadows {
 public:
  static constexpr int map_size = 1024;
  static constexpr std::size_t most_maps = 16;  // of all lights together
  // The data for lookups in a map.
  struct Map {
    Mat4 clip;         // eye space to the map's clip space
    double texel = 0;  // the width of a texel: metres (suns), or metres a metre away (lamps)
    bool perspective = false;
    // Half the penumbra of an edge, for each unit of depth between the edge and the receiving point; the map is a
    // square of 1 with depths to 1. 0: no penumbra.
    double spread = 0;
    double top = 0;         // the least depth of the objects that it was made for
    std::size_t light = 0;  // the index of its light
  };

  static Result<Shadows> create();
  // Returns the maps of all casters for each of the lights, light by light, the finest first: the first that contains a
  // point determines its shadow. Returns none if there are no casters. `floor`: the plane y = 0 receives shadows.
  std::span<const Map> update(Things&, std::span<const Lighting::One> casting, bool floor);
  GLuint texture() const { return layers_.id(); }  // an array, in that order

 private:
  using Numbers = std::vector<std::uint32_t>;
  // The state for which a light's maps were drawn.
  struct Made {
    std::uint64_t casters = 0;
    bool sun = false;
    Vec3 place;  // of a lamp; for a sun the direction towards it
    double range = 0, size = 0;
    Vec3 anchor;
    bool floor = false;
    std::size_t room = 0;  // the most maps
    friend bool operator==(const Made&, const Made&) = default;
  };
  struct Part {
    Map map;
    Vec3 origin;        // in the world; everything drawn is relative to it
    Mat4 clip;          // from there to the map's clip space
    bool stale = true;  // its layer has another content
  };
  struct One {
    std::optional<Made> made;
    std::vector<Numbers> levels;  // the objects that each map must show; the last of a lamp, those of all its sides
    std::vector<Part> parts;
    std::size_t first = 0;  // its first layer
  };
  Status make_layers(std::size_t count);
  void find_casters(Things&, Vec3 anchor);
  static bool casts_on_nothing(Things&, std::uint32_t thing, const Made&);
  Numbers without_backdrops(Things&, const Made&) const;
  std::vector<Numbers> levels(Things&, const Made&) const;
  Part part_of_sun(const Things&, const Made&, const Numbers&) const;
  void look(One&, const Things&) const;
  void draw(const Part&, std::size_t layer, Things&, const Made&);
  void draw_some(const Part&, Things&, const Made&, bool veils);
  // Makes the program on first use. Returns null if the graphics driver refuses it.
  const gl::Program* need(gl::Program Shadows::*, const Part&, const Made&);

  gl::Texture layers_;
  gl::Framebuffer framebuffer_;
  std::size_t count_ = 0;  // of layers
  gl::Program meshes_, balls_, veils_;
  Instances instances_;
  Numbers casters_;
  std::optional<std::pair<std::uint64_t, Vec3>> found_;  // the casters and the anchor for which these are valid
  std::array<One, Lighting::most_casting> all_;
  std::array<Map, most_maps> maps_;
};

}  // namespace betwixt
