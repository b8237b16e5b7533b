// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What rays meet: the things of a picture in eye space, as Embree has them. A mesh is one scene, made once, and every
// thing that looks like it is an instance of that.
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

// Rays of what sort meet a thing, as bits.
enum Sort : unsigned {
  looks = 1,        // of the eye, and mirrored
  gathers = 2,      // that look for light from everywhere
  shadows = 4,      // towards a light, where no light comes through the thing
  thin_shadows = 8  // the same, where some does
};

struct Ray {
  Vec3 from, along;  // unit length
};

// Where a ray meets a thing.
struct Meeting {
  unsigned body = 0, triangle = 0;
  double distance = 0, u = 0, v = 0;
  Vec3 across;       // as Embree has it: in mesh space, of any length
  double plane = 0;  // of layers: how far away the first one is that lies in one plane with it
};

// What is there.
struct Spot {
  Vec3 at;
  Vec3 start, beyond;  // where rays begin that leave it and that go through it: clear of the thing itself
  Vec3 normal, face;   // of the smooth surface and of the triangle, both to the side the ray came from; unit length
  Vec3 color;
  double opacity = 1, shine = 0;
  Material material = Material::plastic;
  bool hairline = false;  // it shows its own colour, fog or not
};

// What lies so close behind each other, as a part of the distance, lies in one plane; and as much f32 is off.
inline constexpr double one_plane = 4e-6;

inline Vec3 unit(Vec3 v) {
  const double square = dot(v, v);
  return square > 0 ? 1 / std::sqrt(square) * v : Vec3{0, 0, 1};
}
inline double largest(Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

class World {
 public:
  static Result<World> create();
  // Takes over the first `count` things, which are all or none. Errors: machine.
  Status set(const Columns&, std::size_t count, const View&);

  std::optional<Meeting> nearest(const Ray&, unsigned sorts) const;
  // What the eye sees behind `last`, or at first: of what lies in one plane that is drawn last comes first, as if each
  // had been drawn upon the ones before.
  std::optional<Meeting> next_layer(const Ray&, const std::optional<Meeting>& last) const;
  // How much of the light comes through, over such a distance.
  double unblocked(const Ray&, double distance) const;
  Spot spot(const Ray&, const Meeting&) const;
  // Of what lies in one plane, the higher is drawn later. A line that crosses itself has one rank there.
  std::uint64_t rank(const Meeting&) const;

 private:
  // A mesh, or the unit ball where there is none.
  struct Solid {
    std::shared_ptr<const Mesh> mesh;
    Box box;
    std::vector<MeshPart> parts;         // all within bounds
    std::vector<std::uint32_t> part_of;  // of a triangle
    std::vector<std::uint32_t> corners;  // three a triangle
    bool has_holes = false;
    SceneHandle scene;  // made when it is wanted
    std::uint64_t used = 0;
  };
  struct Cloth {
    std::shared_ptr<const Picture> picture;
    bool has_holes = false;
    std::uint64_t used = 0;
  };
  struct Body {
    std::shared_ptr<const Solid> solid;  // null: it is not there
    Mat4 place;                          // mesh space to eye space
    std::array<Vec3, 3> turn;            // the same for normals, column by column
    Vec3 color;
    double opacity = 1, shine = 0;
    Material material = Material::plastic;
    std::shared_ptr<const Picture> texture;
    double blur = 0;  // how exactly f32 knows where it is, metres
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
  bool thin_ = false;         // some light comes through some of them
  std::uint64_t picture_ = 0;
};

}  // namespace betwixt::traced
