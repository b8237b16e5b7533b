// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The objects of a picture in eye space, for Embree. A mesh is one scene, made once; every object with it is an
// instance.
#pragma once

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "exchange/geometry.h"
#include "render/columns.h"
#include "render/gradients.h"
#include "render/view.h"

namespace betwixt::traced {

struct RtcRelease {
  void operator()(RTCDevice d) const { rtcReleaseDevice(d); }
  void operator()(RTCScene s) const { rtcReleaseScene(s); }
  void operator()(RTCGeometry g) const { rtcReleaseGeometry(g); }
};
using DeviceHandle = std::unique_ptr<RTCDeviceTy, RtcRelease>;
using SceneHandle = std::unique_ptr<RTCSceneTy, RtcRelease>;
using GeometryHandle = std::unique_ptr<RTCGeometryTy, RtcRelease>;

// Kinds of rays that meet an object, as bits.
enum RayMask : unsigned {
  camera_rays = 1,             // from the eye, and reflected
  ambient_rays = 2,            // for ambient light
  shadow_rays = 4,             // towards a light, if the object is opaque
  translucent_shadow_rays = 8  // the same, if some light comes through
};

struct Ray {
  Vec3 from, along;  // unit length
};

// The intersection of a ray with an object.
struct Hit {
  unsigned object = 0, triangle = 0;
  double distance = 0, u = 0, v = 0;
  Vec3 across;       // Embree's normal: in mesh space, of any length
  double plane = 0;  // of layers: the distance of the first one in the same plane
};

inline Vec3 wide(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

// The surface at an intersection.
struct SurfacePoint {
  Vec3 at;
  Vec3 start, beyond;  // origins of rays that leave it and that pass through it, clear of the object itself
  Vec3 normal, face;   // of the smooth surface and of the triangle, both towards the ray's origin; unit length
  Vec3 color;
  double opacity = 1, shine = 0;
  Material material = Material::plastic;
  // Of a surface with a finish: what its pictures and its pattern make of it here.
  const Finish* finish = nullptr;
  double roughness = 0, metalness = 0;
  Vec3 emission;
  bool solid = false;     // whether it encloses a body
  bool inside = false;    // whether the ray came from within it
  bool hairline = false;  // shows its own colour, fog or not
};

// Surfaces that are closer to each other than this part of the distance are in one plane; f32 is off by as much.
inline constexpr double coplanar_tolerance = 4e-6;

inline Vec3 unit(Vec3 v) {
  const double square = dot(v, v);
  return square > 0 ? 1 / std::sqrt(square) * v : Vec3{0, 0, 1};
}
inline double largest(Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// Returns the linear colour of a picture, which repeats; (0 0) is its top left.
Vec3 picture_color(const Picture&, double u, double v);

class World {
 public:
  static Result<World> create();
  // Takes over the first `count` objects: either all or none of them. Errors: machine.
  Status set(const Columns&, std::size_t count, const View&);

  std::optional<Hit> nearest(const Ray&, unsigned mask) const;
  // Returns what the eye sees behind `last`, or first. Of surfaces in one plane the one drawn last comes first, as if
  // each were drawn over the earlier ones.
  std::optional<Hit> next_layer(const Ray&, const std::optional<Hit>& last) const;
  // Returns the share of light that comes through, over this distance.
  double transmittance(const Ray&, double distance) const;
  SurfacePoint surface_point(const Ray&, const Hit&) const;
  // Of surfaces in one plane, the one with the higher rank is drawn later. A line that crosses itself has one rank
  // there.
  std::uint64_t rank(const Hit&) const;
  bool has_finishes() const { return finishes_; }

 private:
  // A mesh, or the unit ball if it has none.
  struct MeshScene {
    std::shared_ptr<const Mesh> mesh;
    Box box;
    std::vector<MeshPart> parts;         // all within bounds
    std::vector<std::uint32_t> part_of;  // of a triangle
    std::vector<std::uint32_t> corners;  // three a triangle
    bool has_holes = false;
    SceneHandle scene;  // made on first use
    std::uint64_t used = 0;
  };
  struct TextureUse {
    std::shared_ptr<const Picture> picture;
    bool has_holes = false;
    std::uint64_t used = 0;
  };
  struct TracedObject {
    std::shared_ptr<const MeshScene> solid;  // null if it is not there
    Mat4 place;                              // mesh space to eye space
    std::array<Vec3, 3> normal_matrix;       // the same for normals, column by column
    Vec3 color;
    double opacity = 1, shine = 0;
    Material material = Material::plastic;
    std::shared_ptr<const Picture> texture;
    std::shared_ptr<const Finish> finish;
    struct Graded {
      GradientColors colors;
      PlacedGradient placed;
    };
    std::shared_ptr<const Graded> fill, stroke;  // its gradients; null if it has none
    Mat4 to_object;                              // mesh space to object space
    double blur = 0;                             // the uncertainty of its position in f32, metres
    bool line = false, hairline = false;
  };

  explicit World(DeviceHandle device) : device_(std::move(device)) {}
  std::shared_ptr<MeshScene> mesh_scene(const std::shared_ptr<const Mesh>&);
  bool has_holes(const std::shared_ptr<const Picture>&);
  void need_scene(MeshScene&) const;
  std::optional<TracedObject> object_of(const Columns&, std::uint32_t, const View&, unsigned& mask);
  GeometryHandle instance(const TracedObject&) const;
  GeometryHandle hairlines(const TracedObject&, const View&) const;
  SurfacePoint triangle_point(const TracedObject&, const Hit&, bool back) const;
  void add_finish(const TracedObject&, const Hit&, SurfacePoint&) const;
  static void add_gradient(const TracedObject&, const MeshPart&, Vec3 in_mesh, SurfacePoint&);
  std::optional<Hit> highest(const Ray&, double plane, std::uint64_t below) const;

  DeviceHandle device_;
  SceneHandle all_;
  std::unordered_map<const Mesh*, std::shared_ptr<MeshScene>> mesh_scenes_;
  std::unordered_map<const Picture*, TextureUse> textures_;
  std::vector<TracedObject> objects_;  // a place for each drawable
  bool finishes_ = false;              // whether some have finishes
  double pixel_ = 0;                   // the width of a pixel, metres a metre away, or metres
  bool pixel_grows_ = true;
  bool thin_ = false;  // whether some of them let light through
  std::uint64_t picture_ = 0;
};

}  // namespace betwixt::traced
