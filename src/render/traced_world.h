// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The objects of a picture in eye space, for Embree. A mesh is one scene, made once; every object with it is an
// instance. What moves while the shutter is open has several states, and rays have times.
#pragma once

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "exchange/geometry.h"
#include "render/exposure.h"
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
  double time;       // from 0, when the shutter opens, to 1, when it closes; a float
};

// Where a time is between states that are evenly spread over the exposure, the first one at 0, the last one at 1.
struct TimeStep {
  TimeStep(double time, std::size_t states) {
    if (states < 2) return;
    const double at = time * static_cast<double>(states - 1);
    first = std::min(static_cast<std::size_t>(at), states - 2);
    share = at - static_cast<double>(first);
  }
  std::size_t nearest() const { return share < 0.5 ? first : first + 1; }
  std::size_t first = 0;
  double share = 0;  // of the way to the next state
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
  Vec3 smooth;         // the normal before a picture or a pattern has bent it; none if none has
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
  double time = 0;        // that of the ray
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
  // Takes over the things of an exposure. `view`: that of the first camera. Errors: machine.
  Status set(const std::vector<Course>&, const View&);

  std::optional<Hit> nearest(const Ray&, unsigned mask) const;
  // Returns what the eye sees behind `last`, or first. Of surfaces in one plane the one drawn last comes first, as if
  // each were drawn over the earlier ones.
  std::optional<Hit> next_layer(const Ray&, const std::optional<Hit>& last) const;
  // Returns the share of light that comes through, over this distance. `passing`: the share that comes straight through
  // a surface with a finish that lets light through; by default none.
  using Passing = Vec3 (*)(const SurfacePoint&, Vec3 toward);
  Vec3 transmittance(const Ray&, double distance, Passing passing = nullptr) const;
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
  struct Graded {
    GradientColors colors;
    PlacedGradient placed;
  };
  // A state of an object. Whatever it points to is kept while the picture is drawn.
  struct TracedObject {
    const MeshScene* solid = nullptr;
    Mat4 place;                         // mesh space to eye space
    std::array<Vec3, 3> normal_matrix;  // the same for normals, column by column
    Vec3 color;
    double opacity = 1, shine = 0;
    Material material = Material::plastic;
    const Picture* texture = nullptr;
    const Finish* finish = nullptr;
    const Graded *fill = nullptr, *stroke = nullptr;  // its gradients; null if it has none
    Mat4 to_object;                                   // mesh space to object space
    double blur = 0;                                  // the uncertainty of its position in f32, metres
    bool line = false, hairline = false;
    unsigned mask = 0;  // of the rays that meet it
    // Between two states, if the corners of its triangles move: the mesh of the next one, and how near that is.
    const MeshScene *last = nullptr, *next = nullptr;
    double share = 0;

    Vec3 position(std::uint32_t corner) const { return between(&Mesh::positions, corner); }
    Vec3 normal(std::uint32_t corner) const { return between(&Mesh::normals, corner); }

   private:
    Vec3 between(std::vector<std::array<float, 3>> Mesh::*all, std::uint32_t corner) const {
      if (next == nullptr) return wide((*solid->mesh.*all)[corner]);
      return (1 - share) * wide((*last->mesh.*all)[corner]) + share * wide((*next->mesh.*all)[corner]);
    }
  };
  // One state, or several from the opening of the shutter to its closing.
  struct ObjectStates {
    std::vector<TracedObject> all;
    std::uint32_t order = 0;  // of creation
    TracedObject at(double time) const;
  };

  explicit World(DeviceHandle device) : device_(std::move(device)) {}
  std::shared_ptr<MeshScene> mesh_scene(const std::shared_ptr<const Mesh>&);
  bool has_holes(const std::shared_ptr<const Picture>&);
  static void list_triangles(MeshScene&);
  void need_scene(MeshScene&) const;
  GeometryHandle triangles(std::span<const MeshScene* const> states) const;
  // How large an object is in the picture, in pixels; 0 if it is not there.
  double pixels_of(const Content&, const View&);
  std::optional<TracedObject> object_of(const Content&, const View&, double pixels);
  void add_gradients(const Content&, const Mat4& local, TracedObject&);
  void add(const Course&, std::uint32_t place, const View&);
  // Adds an object with these states from one time of the exposure to another.
  void attach(std::vector<TracedObject>, std::uint32_t order, unsigned id, float from, float to, const View&);
  static bool mixable(const std::vector<TracedObject>&);
  SceneHandle scene_of(const GeometryHandle&) const;
  GeometryHandle instance(std::span<const TracedObject>) const;
  GeometryHandle hairlines(std::span<const TracedObject>, const View&) const;
  SurfacePoint surface_point(const TracedObject&, const Ray&, const Hit&) const;
  SurfacePoint triangle_point(const TracedObject&, const Hit&, bool back) const;
  void add_finish(const TracedObject&, const Hit&, SurfacePoint&) const;
  static void add_gradient(const TracedObject&, const MeshPart&, Vec3 in_mesh, SurfacePoint&);
  std::optional<Hit> highest(const Ray&, double plane, std::uint64_t below) const;

  DeviceHandle device_;
  SceneHandle all_;
  std::unordered_map<const Mesh*, std::shared_ptr<MeshScene>> mesh_scenes_;
  std::unordered_map<const Picture*, TextureUse> textures_;
  std::vector<ObjectStates> objects_;              // a place for each drawable, and more for what changes in steps
  std::vector<std::shared_ptr<const void>> kept_;  // what states point to
  bool finishes_ = false;                          // whether some have finishes
  double pixel_ = 0;                               // the width of a pixel, metres a metre away, or metres
  bool pixel_grows_ = true;
  bool thin_ = false;  // whether some of them let light through
  std::uint64_t picture_ = 0;
};

}  // namespace betwixt::traced
