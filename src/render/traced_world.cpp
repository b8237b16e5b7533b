// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/traced_world.h"

#include "render/forms.h"

namespace betwixt::traced {
namespace {

constexpr double far_away = 1e15;      // metres; squares of f32 stay finite
constexpr std::uint64_t kept_for = 2;  // pictures
constexpr std::uint64_t hairlines_first = std::uint64_t{1} << 63;
constexpr double hairline_reach = 0.7;  // half the width in pixels

// The inverse transpose up to its length: the cross products of the columns.
std::array<Vec3, 3> normal_matrix_of(const Mat4& m) {
  const Vec3 x = column(m, 0), y = column(m, 1), z = column(m, 2);
  return {cross(y, z), cross(z, x), cross(x, y)};
}

// Rays go through the inverse, so a flat object gets an invisible thickness. Returns nullopt for a line.
std::optional<Mat4> with_inverse(const Mat4& m) {
  if (inverse(m)) return m;
  // All cross products are along the one direction in which it has no extent.
  const std::array<Vec3, 3> all = normal_matrix_of(m);
  const Vec3 most = *std::max_element(all.begin(), all.end(), [](Vec3 a, Vec3 b) { return dot(a, a) < dot(b, b); });
  const double size = std::max({length(column(m, 0)), length(column(m, 1)), length(column(m, 2))});
  const Vec3 lost = normalize(most, {0, 0, 0});
  const Vec3 pressed = normalize({dot(all[0], lost), dot(all[1], lost), dot(all[2], lost)}, {0, 0, 0});
  Mat4 thick = m;
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < 3; ++i) thick(i, c) += 1e-5 * size * lost[i] * pressed[c];
  return inverse(thick) ? std::optional(thick) : std::nullopt;
}

bool indices_fit(const std::vector<std::uint32_t>& indices, std::size_t count) {
  return std::all_of(indices.begin(), indices.end(), [count](std::uint32_t i) { return i < count; });
}

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
  q.ray.mask = mask;
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

void set_flags(RTCScene scene) {
  rtcSetSceneFlags(scene, static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
}

template <class T>
T* new_buffer(RTCGeometry g, RTCBufferType type, RTCFormat format, std::size_t count) {
  return static_cast<T*>(rtcSetNewGeometryBuffer(g, type, 0, format, sizeof(T), count));
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

void World::need_scene(MeshScene& s) const {
  if (s.scene != nullptr) return;
  RTCDevice device = device_.get();
  GeometryHandle g;
  if (s.mesh == nullptr) {
    g.reset(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT));
    auto* ball = new_buffer<std::array<float, 4>>(g.get(), RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 1);
    if (ball != nullptr) *ball = {0, 0, 0, 1};
  } else {
    for (std::uint32_t p = 0; p < s.parts.size(); ++p) {
      const auto first = s.mesh->triangles.begin() + s.parts[p].first;
      const std::uint32_t whole = s.parts[p].count / 3;
      s.corners.insert(s.corners.end(), first, first + 3 * static_cast<std::ptrdiff_t>(whole));
      s.part_of.insert(s.part_of.end(), whole, p);
    }
    g.reset(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
    const auto& positions = s.mesh->positions;
    using Three = std::array<float, 3>;
    auto* vertices = new_buffer<Three>(g.get(), RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, positions.size());
    if (vertices != nullptr) std::copy(positions.begin(), positions.end(), vertices);
    auto* corners =
        new_buffer<std::array<std::uint32_t, 3>>(g.get(), RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, s.part_of.size());
    if (corners != nullptr) std::copy(s.corners.begin(), s.corners.end(), corners->data());
  }
  rtcCommitGeometry(g.get());
  s.scene.reset(rtcNewScene(device));
  set_flags(s.scene.get());
  rtcAttachGeometry(s.scene.get(), g.get());
  rtcCommitScene(s.scene.get());
}

std::optional<World::TracedObject> World::object_of(const Columns& c, std::uint32_t i, const View& view,
                                                    unsigned& mask) {
  const Evaluation::Look& l = c.looks[i];
  if (!l.visible || l.shape == Evaluation::Look::none || !finite(c.worlds[i]) || !finite(l.color) ||
      !std::isfinite(l.transparency) || !std::isfinite(l.shininess) || !std::isfinite(l.blend) || l.transparency >= 1)
    return {};
  const Shape& shape = *c.shape(l.shape);
  const Shape* const toward = l.toward != Evaluation::Look::none && l.blend != 0 ? c.shape(l.toward).get() : nullptr;
  const auto realised = [&](const Detail& d) {
    return toward != nullptr ? realise_blend(shape, *toward, l.blend, d) : realise(shape, d);
  };
  TracedObject b;
  if (l.texture != Evaluation::Look::none) b.texture = c.texture(l.texture);
  Mat4 world = c.worlds[i];
  for (int k = 0; k < 3; ++k) world(k, 3) -= view.eye[k];
  const bool ball =
      shape.kind == Kind::sphere && toward == nullptr && b.texture == nullptr && l.gradients == Evaluation::Look::none;
  const bool detailed = has_details(shape, toward);
  Geometry g = ball ? Geometry{nullptr, scaling({shape.radius, shape.radius, shape.radius})}
                    : realised(detailed ? Detail{24, true} : Detail{});
  std::shared_ptr<MeshScene> object = mesh_scene(g.mesh);
  const Bounds bounds = bounds_of(object->box, world * g.local);
  const double radius = bounds.radius(), away = length(bounds.center);
  if (!(radius > 0 && radius < far_away && away < far_away) || (!ball && g.mesh->positions.empty())) return {};
  if (detailed && !ball) {
    const double scale = view.sx * view.width * radius;
    g = realised(Detail::for_pixels(view.orthographic ? scale : scale / std::max(away - 0.5 * radius, 0.1 * radius)));
    object = mesh_scene(g.mesh);
  }
  const std::optional<Mat4> place = with_inverse(world * g.local);
  b.hairline = !ball && object->parts.empty();
  if (!place && !b.hairline) return {};
  b.place = b.hairline ? world * g.local : *place;
  b.normal_matrix = normal_matrix_of(b.place);
  const double longest = std::max({length(b.normal_matrix[0]), length(b.normal_matrix[1]), length(b.normal_matrix[2])});
  for (Vec3& v : b.normal_matrix) v = (determinant(b.place) < 0 ? -1 : 1) / longest * v;
  b.color = {std::clamp(l.color.x, 0.0, 1e4), std::clamp(l.color.y, 0.0, 1e4), std::clamp(l.color.z, 0.0, 1e4)};
  b.opacity = 1 - std::clamp(l.transparency, 0.0, 1.0), b.shine = std::clamp(l.shininess, 0.0, 1.0);
  if (l.finish != Evaluation::Look::none) b.finish = c.finish(l.finish), finishes_ = true;
  b.to_object = g.local;
  bool see_through = false;
  if (l.gradients != Evaluation::Look::none) {
    const Gradients& all = *c.gradients(l.gradients);
    const Box box = gradient_box(shape, toward, l.blend);
    for (const auto& [from, to] : {std::pair(&all.fill, &b.fill), std::pair(&all.stroke, &b.stroke)})
      if (from->kind != GradientKind::none)
        *to = std::make_shared<const TracedObject::Graded>(
            TracedObject::Graded{GradientColors(*from), placed_gradient(*from, box, g.local)});
    see_through = all.see_through();
  }
  b.material = l.material, b.line = row_of(shape.kind).line;
  b.blur = 0.1 * coplanar_tolerance * (away + radius);
  const bool holes = b.texture != nullptr ? has_holes(b.texture) : object->has_holes;
  mask = camera_rays;
  if (l.casts && !b.hairline) mask |= ambient_rays;
  if (l.casts && !b.hairline && b.material != Material::glow && b.opacity > 0.5)
    mask |= b.opacity < 1 || holes || see_through || (b.finish && b.finish->transmission > 0) ? translucent_shadow_rays
                                                                                              : shadow_rays;
  if (!b.hairline) need_scene(*object);
  b.solid = std::move(object);
  return b;
}

GeometryHandle World::instance(const TracedObject& b) const {
  GeometryHandle g(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_INSTANCE));
  rtcSetGeometryInstancedScene(g.get(), b.solid->scene.get());
  std::array<float, 12> columns;
  for (int i = 0; i < 12; ++i) columns[static_cast<std::size_t>(i)] = static_cast<float>(b.place(i % 3, i / 3));
  rtcSetGeometryTransform(g.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
  return g;
}

// Ribbons that face the eye, as wide everywhere as a line in the picture.
GeometryHandle World::hairlines(const TracedObject& b, const View& view) const {
  const Mesh& mesh = *b.solid->mesh;
  if (mesh.edges.size() < 2 || !indices_fit(mesh.edges, mesh.positions.size())) return {};
  const std::size_t ends = mesh.edges.size() / 2 * 2;
  GeometryHandle g(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_FLAT_LINEAR_CURVE));
  auto* vertices = new_buffer<std::array<float, 4>>(g.get(), RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, ends);
  auto* starts = new_buffer<std::uint32_t>(g.get(), RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, ends / 2);
  if (vertices == nullptr || starts == nullptr) return {};
  const double pixel = 2 / (view.sx * view.width);  // at depth 1, or anywhere if orthographic
  for (std::size_t k = 0; k < ends; ++k) {
    const Vec3 p = transform_point(b.place, wide(mesh.positions[mesh.edges[k]]));
    const double reach = hairline_reach * pixel * (view.orthographic ? 1 : std::abs(view.depth(p)));
    vertices[k] = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z),
                   static_cast<float>(reach)};
    if (k % 2 == 0) starts[k / 2] = static_cast<std::uint32_t>(k);
  }
  return g;
}

Status World::set(const Columns& c, std::size_t count, const View& view) {
  ++picture_;
  objects_.clear();
  objects_.resize(count);
  thin_ = finishes_ = false;
  pixel_ = 2 / (view.sx * view.width), pixel_grows_ = !view.orthographic;
  all_.reset(rtcNewScene(device_.get()));
  set_flags(all_.get());
  for (std::uint32_t i = 0; i < objects_.size(); ++i) {
    unsigned mask = 0;
    std::optional<TracedObject> object = object_of(c, i, view, mask);
    if (!object) continue;
    const GeometryHandle g = object->hairline ? hairlines(*object, view) : instance(*object);
    if (g == nullptr) continue;
    objects_[i] = *std::move(object);
    thin_ |= (mask & translucent_shadow_rays) != 0;
    rtcSetGeometryMask(g.get(), mask);
    rtcCommitGeometry(g.get());
    rtcAttachGeometryByID(all_.get(), g.get(), i);
  }
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
  const TracedObject& b = objects_[m.object];
  return std::uint64_t{m.object} << 32 | (b.line ? 0 : m.triangle) | (b.hairline ? hairlines_first : 0);
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

double World::transmittance(const Ray& r, double distance) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay solid = ray_query(r, shadow_rays, 0, distance).ray;
  rtcOccluded1(all_.get(), &context, &solid);
  if (!(solid.tfar >= 0)) return 0;
  double through = 1, from = 0;
  for (int k = 0; thin_ && k < 64 && through > 0; ++k) {
    RTCRayHit q = ray_query(r, translucent_shadow_rays, from, distance);
    rtcIntersect1(all_.get(), &context, &q);
    if (q.hit.geomID == RTC_INVALID_GEOMETRY_ID) break;
    const Hit m = hit_of(q.hit, q.ray.tfar);
    // An object that fades out and lets half of the light through casts no shadow.
    const TracedObject& b = objects_[m.object];
    // Light that glass bends is not followed to the lights; most of it comes through straight.
    const double clear = b.finish ? 0.9 * b.finish->transmission : 0;
    const double solidity = std::clamp(2 * surface_point(r, m).opacity - 1, 0.0, 1.0) * (1 - clear);
    through *= 1 - solidity;
    from = m.distance * (1 + 2 * coplanar_tolerance) + 1e-30;
  }
  return through;
}

}  // namespace betwixt::traced
