// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/traced_world.h"

#include "render/embree_buffers.h"

namespace betwixt::traced {
namespace {

constexpr std::uint64_t kept_for = 2;  // pictures
constexpr std::uint64_t hairlines_first = std::uint64_t{1} << 63;

std::vector<MeshPart> usable_parts(const Mesh& mesh) {
  const auto all = static_cast<std::uint32_t>(mesh.triangles.size());
  if (all < 3 || !indices_fit(mesh.triangles, mesh.positions.size())) return {};
  if (mesh.parts.empty()) return {{.first = 0, .count = all, .texture = nullptr}};
  std::vector<MeshPart> parts;
  for (MeshPart p : mesh.parts) {
    p.first = std::min(p.first, all), p.count = std::min(p.count, all - p.first);
    if (p.count > 0) parts.push_back(std::move(p));
  }
  return parts;
}

RTCRayHit ray_query(const Ray& r, unsigned mask, double from, double to) {
  RTCRayHit q{};
  q.ray.org_x = static_cast<float>(r.from.x), q.ray.org_y = static_cast<float>(r.from.y);
  q.ray.org_z = static_cast<float>(r.from.z), q.ray.tnear = static_cast<float>(from);
  q.ray.dir_x = static_cast<float>(r.along.x), q.ray.dir_y = static_cast<float>(r.along.y);
  q.ray.dir_z = static_cast<float>(r.along.z), q.ray.tfar = static_cast<float>(to);
  q.ray.mask = mask, q.ray.time = static_cast<float>(r.time);
  q.hit.geomID = q.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  return q;
}

Hit hit_of(const RTCHit& hit, float distance) {
  const bool instance = hit.instID[0] != RTC_INVALID_GEOMETRY_ID;
  return {instance ? hit.instID[0] : hit.geomID, hit.primID, distance, hit.u, hit.v, {hit.Ng_x, hit.Ng_y, hit.Ng_z}};
}

// Returns the distance up to which surfaces are in one plane with that one.
float end_of(double plane) { return static_cast<float>(plane * (1 + coplanar_tolerance)); }

// In a part of a ray, finds the surface with the highest rank below a given one. It reports no hit to Embree, so that
// the search continues.
struct Highest : RTCIntersectContext {
  const World* world = nullptr;
  std::uint64_t below = 0, rank = 0;
  std::optional<Hit> found;
};
void keep_highest(const RTCFilterFunctionNArguments* a) {
  if (a->valid[0] == 0) return;
  a->valid[0] = 0;
  auto& search = *static_cast<Highest*>(a->context);
  const Hit m = hit_of(rtcGetHitFromHitN(a->hit, a->N, 0), RTCRayN_tfar(a->ray, a->N, 0));
  const std::uint64_t rank = search.world->rank(m);
  if (rank >= search.below || (search.found && rank <= search.rank)) return;
  search.found = m, search.rank = rank;
}

}  // namespace

Result<World> World::create() {
  // With one building thread the result is the same each time. Without the fused products of processors beyond AVX it
  // is the same on all of them, and takes no more time.
  DeviceHandle device(rtcNewDevice("threads=1,max_isa=avx,ignore_config_files=1"));
  if (!device) return fail(ErrorCode::machine, "ray tracing is not available: Embree does not start");
  return World(std::move(device));
}

std::shared_ptr<World::MeshScene> World::mesh_scene(const std::shared_ptr<const Mesh>& mesh) {
  std::shared_ptr<MeshScene>& place = mesh_scenes_[mesh.get()];
  if (place == nullptr) {
    place = std::make_shared<MeshScene>();
    place->mesh = mesh;
    if (mesh != nullptr) {
      place->box = mesh->box();
      place->parts = usable_parts(*mesh);
      for (const MeshPart& p : place->parts) place->has_holes |= p.texture != nullptr && has_holes(p.texture);
    } else {
      place->box = {{-1, -1, -1}, {1, 1, 1}};
    }
  }
  place->used = picture_;
  return place;
}

bool World::has_holes(const std::shared_ptr<const Picture>& picture) {
  TextureUse& use = textures_[picture.get()];
  if (use.picture == nullptr) {
    use.picture = picture;
    for (std::size_t i = 3; i < picture->rgba.size() && !use.has_holes; i += 4) use.has_holes = picture->rgba[i] != 255;
  }
  use.used = picture_;
  return use.has_holes;
}

void World::list_triangles(MeshScene& s) {
  if (s.mesh == nullptr || !s.corners.empty()) return;
  for (std::uint32_t p = 0; p < s.parts.size(); ++p) {
    const auto first = s.mesh->triangles.begin() + s.parts[p].first;
    const std::uint32_t whole = s.parts[p].count / 3;
    s.corners.insert(s.corners.end(), first, first + 3 * static_cast<std::ptrdiff_t>(whole));
    s.part_of.insert(s.part_of.end(), whole, p);
  }
}

// The triangles of a mesh whose corners move from state to state.
GeometryHandle World::triangles(std::span<const MeshScene* const> states) const {
  GeometryHandle g(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
  const MeshScene& first = *states.front();
  rtcSetGeometryTimeStepCount(g.get(), static_cast<unsigned>(states.size()));
  for (unsigned k = 0; k < states.size(); ++k) {
    const auto& positions = states[k]->mesh->positions;
    auto* vertices =
        new_buffer<std::array<float, 3>>(g.get(), RTC_BUFFER_TYPE_VERTEX, k, RTC_FORMAT_FLOAT3, positions.size());
    if (vertices != nullptr) std::copy(positions.begin(), positions.end(), vertices);
  }
  auto* corners = new_buffer<std::array<std::uint32_t, 3>>(g.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                           first.part_of.size());
  if (corners != nullptr) std::copy(first.corners.begin(), first.corners.end(), corners->data());
  return g;
}

SceneHandle World::scene_of(const GeometryHandle& g) const {
  rtcCommitGeometry(g.get());
  SceneHandle scene(rtcNewScene(device_.get()));
  set_flags(scene.get());
  rtcAttachGeometry(scene.get(), g.get());
  rtcCommitScene(scene.get());
  return scene;
}

void World::need_scene(MeshScene& s) const {
  if (s.scene != nullptr) return;
  if (s.mesh != nullptr) {
    const MeshScene* const only = &s;
    s.scene = scene_of(triangles({&only, 1}));
    return;
  }
  const GeometryHandle g(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_SPHERE_POINT));
  auto* ball = new_buffer<std::array<float, 4>>(g.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 1);
  if (ball != nullptr) *ball = {0, 0, 0, 1};
  s.scene = scene_of(g);
}

Status World::set(const std::vector<Course>& things, const View& view) {
  ++picture_;
  objects_.clear(), kept_.clear();
  objects_.resize(things.size());
  thin_ = finishes_ = false;
  pixel_ = 2 / (view.sx * view.width), pixel_grows_ = !view.orthographic;
  all_.reset(rtcNewScene(device_.get()));
  set_flags(all_.get());
  for (std::uint32_t i = 0; i < things.size(); ++i) add(things[i], i, view);
  rtcCommitScene(all_.get());
  std::erase_if(mesh_scenes_, [&](const auto& s) { return s.second->used + kept_for <= picture_; });
  std::erase_if(textures_, [&](const auto& s) { return s.second.used + kept_for <= picture_; });
  switch (rtcGetDeviceError(device_.get())) {
    case RTC_ERROR_NONE:
      return Nothing{};
    case RTC_ERROR_OUT_OF_MEMORY:
      return fail(ErrorCode::machine, "there is not enough memory to trace rays in this scene");
    default:
      return fail(ErrorCode::machine, "ray tracing failed in Embree");
  }
}

std::optional<Hit> World::nearest(const Ray& r, unsigned mask) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit q = ray_query(r, mask, 0, INFINITY);
  rtcIntersect1(all_.get(), &context, &q);
  if (q.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return hit_of(q.hit, q.ray.tfar);
}

std::uint64_t World::rank(const Hit& m) const {
  const ObjectStates& o = objects_[m.object];
  const TracedObject& b = o.all.front();
  return std::uint64_t{o.order} << 32 | (b.line ? 0 : m.triangle) | (b.hairline ? hairlines_first : 0);
}

std::optional<Hit> World::highest(const Ray& r, double plane, std::uint64_t below) const {
  Highest search;
  rtcInitIntersectContext(&search);
  search.filter = keep_highest;
  search.world = this, search.below = below;
  RTCRayHit q = ray_query(r, camera_rays, plane, static_cast<double>(end_of(plane)));
  rtcIntersect1(all_.get(), &search, &q);
  if (search.found) search.found->plane = plane;
  return search.found;
}

std::optional<Hit> World::next_layer(const Ray& r, const std::optional<Hit>& last) const {
  double from = 0;
  if (last) {
    if (auto beneath = highest(r, last->plane, rank(*last))) return beneath;
    from = static_cast<double>(std::nextafter(end_of(last->plane), INFINITY));
  }
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit q = ray_query(r, camera_rays, from, INFINITY);
  rtcIntersect1(all_.get(), &context, &q);
  if (q.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  Hit first = hit_of(q.hit, q.ray.tfar);
  first.plane = first.distance;
  const std::optional<Hit> top = highest(r, first.plane, ~std::uint64_t{0});
  return top && rank(*top) > rank(first) ? top : first;
}

Vec3 World::transmittance(const Ray& r, double distance, Passing passing) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay solid = ray_query(r, shadow_rays, 0, distance).ray;
  rtcOccluded1(all_.get(), &context, &solid);
  if (!(solid.tfar >= 0)) return {};
  Vec3 through{1, 1, 1};
  double from = 0;
  for (int k = 0; thin_ && k < 64 && largest(through) > 0; ++k) {
    RTCRayHit q = ray_query(r, translucent_shadow_rays, from, distance);
    rtcIntersect1(all_.get(), &context, &q);
    if (q.hit.geomID == RTC_INVALID_GEOMETRY_ID) break;
    const Hit m = hit_of(q.hit, q.ray.tfar);
    // An object that fades out and lets half of the light through casts no shadow.
    const SurfacePoint p = surface_point(r, m);
    const double solidity = std::clamp(2 * p.opacity - 1, 0.0, 1.0);
    const bool passes = passing != nullptr && p.finish != nullptr && p.finish->transmission > 0;
    through = through * ((1 - solidity) * Vec3{1, 1, 1} + (passes ? solidity * passing(p, -r.along) : Vec3{}));
    from = m.distance * (1 + 2 * coplanar_tolerance) + 1e-30;
  }
  return through;
}

}  // namespace betwixt::traced
