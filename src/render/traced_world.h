// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The objects of a picture in eye space, for Embree. A mesh is one scene, made once; every object with it is an
// instance.
#pragma once

#include <embree3/rtcore.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "exchange/geometry.h"
#include "render/columns.h"
#include "render/view.h"

namespace betwixt::traced {

struct Release {
  void operator()(RTCDevice d) const { rtcReleaseDevice(d); }
  void operator()(RTCScene s) const { rtcReleaseScene(s); }
  void operator()(RTCGeometry g) const { rtcReleaseGeometry(g); }
};
using DeviceHandle = std::unique_ptr<RTCDeviceTy, Release>;
using SceneHandle = std::unique_ptr<RTCSceneTy, Release>;
using GeometryHandle = std::unique_ptr<RTCGeometryTy, Release>;

// Kinds of rays that meet an object, as bits.
enum Sort : unsigned {
  looks = 1,        // from the eye, and reflected
  gathers = 2,      // for ambient light
  shadows = 4,      // towards a light, if the object is opaque
  thin_shadows = 8  // the same, if some light comes through
};

struct Ray {
  Vec3 from, along;  // unit length
};

// The intersection of a ray with an object.
struct Meeting {
  unsigned body = 0, triangle = 0;
  double distance = 0, u = 0, v = 0;
  Vec3 across;       // Embree's normal: in mesh space, of any length
  double plane = 0;  // of layers: the distance of the first one in the same plane
};

// The surface at an intersection.
struct Spot {
  Vec3 at;
  Vec3 start, beyond;  // origins of rays that leave it and that pass through it, clear of the object itself
  Vec3 normal, face;   // of the smooth surface and of the triangle, both towards the ray's origin; unit length
  Vec3 color;
  double opacity = 1, shine = 0;
  Material material = Material::plastic;
  bool hairline = false;  // shows its own colour, fog or not
};

// Surfaces that are closer to each other than this part of the distance are in one plane; f32 is off by as much.
inline constexpr double one_plane = 4e-6;

inline Vec3 unit(Vec3 v) {
  const double square = dot(v, v);
  return square > 0 ? 1 / std::sqrt(square) * v : Vec3{0, 0, 1};
}
inline double largest(Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

class World {
 public:
  static Result<World> create();
  // Takes over the first `count` objects: either all or none of them. Errors: machine.
  Status set(const Columns&, std::size_t count, const View&);

  std::optional<Meeting> nearest(const Ray&, unsigned sorts) const;
  // Returns what the eye sees behind `last`, or first. Of surfaces in one plane the one drawn last comes first, as if
  // each were drawn over the earlier ones.
  std::optional<Meeting> next_layer(const Ray&, const std::optional<Meeting>& last) const;
  // Returns the share of light that comes through, over this distance.
  double unblocked(const Ray&, double distance) const;
  Spot spot(const Ray&, const Meeting&) const;
  // Of surfaces in one plane, the one with the higher rank is drawn later. A line that crosses itself has one rank
  // there.
  std::uint64_t rank(const Meeting&) const;

 private:
  // A mesh, or the unit ball if it has none.
  struct Solid {
    std::shared_ptr<const Mesh> mesh;
    Box box;
    std::vector<MeshPart> parts;         // all within bounds
    std::vector<std::uint32_t> part_of;  // of a triangle
    std::vector<std::uint32_t> corners;  // three a triangle
    bool has_holes = false;
    SceneHandle scene;  // made on first use
    std::uint64_t used = 0;
  };
  struct Cloth {
    std::shared_ptr<const Picture> picture;
    bool has_holes = false;
    std::uint64_t used = 0;
  };
  struct Body {
    std::shared_ptr<const Solid> solid;  // null if it is not there
    Mat4 place;                          // mesh space to eye space
    std::array<Vec3, 3> turn;            // the same for normals, column by column
    Vec3 color;
    double opacity = 1, shine = 0;
    Material material = Material::plastic;
    std::shared_ptr<const Picture> texture;
    double blur = 0;  // the uncertainty of its position in f32, metres
    bool line = false, hairline = false;
  };

  explicit World(DeviceHandle device) : device_(std::move(device)) {}
  std::shared_ptr<Solid> solid(const std::shared_ptr<const Mesh>&);
  bool has_holes(const std::shared_ptr<const Picture>&);
  void need_scene(Solid&) const;
  std::optional<Body> body_of(const Columns&, std::uint32_t, const View&, unsigned& sorts);
  GeometryHandle instance(const Body&) const;
  GeometryHandle hairlines(const Body&, const View&) const;
  Spot corner_spot(const Body&, const Meeting&, bool back) const;
  std::optional<Meeting> highest(const Ray&, double plane, std::uint64_t below) const;

  DeviceHandle device_;
  SceneHandle all_;
  std::unordered_map<const Mesh*, std::shared_ptr<Solid>> solids_;
  std::unordered_map<const Picture*, Cloth> cloths_;
  std::vector<Body> bodies_;  // a place for each drawable
  bool thin_ = false;         // whether some of them let light through
  std::uint64_t picture_ = 0;
};

}  // namespace betwixt::traced
