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

Vec3 wide(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

Bounds bounds_in(const Box& box, const Mat4& m) {
  const Vec3 half = box.half();
  Bounds b{transform_point(m, box.middle()), {}};
  for (int i = 0; i < 3; ++i)
    b.half[i] = std::abs(m(i, 0)) * half.x + std::abs(m(i, 1)) * half.y + std::abs(m(i, 2)) * half.z;
  return b;
}

// The inverse transpose up to its length: the cross products of the columns.
std::array<Vec3, 3> crossed(const Mat4& m) {
  const Vec3 x = column(m, 0), y = column(m, 1), z = column(m, 2);
  return {cross(y, z), cross(z, x), cross(x, y)};
}

// Rays go through the inverse, so a flat object gets an invisible thickness. Returns nullopt for a line.
std::optional<Mat4> with_inverse(const Mat4& m) {
  if (inverse(m)) return m;
  // All cross products are along the one direction in which it has no extent.
  const std::array<Vec3, 3> all = crossed(m);
  const Vec3 most = *std::max_element(all.begin(), all.end(), [](Vec3 a, Vec3 b) { return dot(a, a) < dot(b, b); });
  const double size = std::max({length(column(m, 0)), length(column(m, 1)), length(column(m, 2))});
  const Vec3 lost = normalize(most, {0, 0, 0});
  const Vec3 pressed = normalize({dot(all[0], lost), dot(all[1], lost), dot(all[2], lost)}, {0, 0, 0});
  Mat4 thick = m;
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < 3; ++i) thick(i, c) += 1e-5 * size * lost[i] * pressed[c];
  return inverse(thick) ? std::optional(thick) : std::nullopt;
}

double decoded(std::uint8_t byte) {
  static const std::array<double, 256> all = [] {
    std::array<double, 256> r{};
    for (std::size_t i = 0; i < r.size(); ++i) {
      const double s = static_cast<double>(i) / 255;
      r[i] = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    }
    return r;
  }();
  return all[byte];
}

struct Dye {
  Vec3 color{1, 1, 1};
  double opacity = 1;
};

// Interpolates between the four nearest pixels; the picture repeats.
Dye dye_at(const Picture& p, double u, double v) {
  const auto area = static_cast<std::size_t>(std::max(p.width, 0)) * static_cast<std::size_t>(std::max(p.height, 0));
  if (area == 0 || p.rgba.size() < 4 * area || !std::isfinite(u) || !std::isfinite(v)) return {};
  const double x = (u - std::floor(u)) * p.width - 0.5, y = (v - std::floor(v)) * p.height - 0.5;
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  Dye sum{{}, 0};
  for (int k = 0; k < 4; ++k) {
    const int i = x0 + k % 2, j = y0 + k / 2;
    const double share = (1 - std::abs(x - i)) * (1 - std::abs(y - j));
    const auto at = static_cast<std::size_t>((j + p.height) % p.height) * static_cast<std::size_t>(p.width) +
                    static_cast<std::size_t>((i + p.width) % p.width);
    const std::uint8_t* c = &p.rgba[4 * at];
    sum.color = sum.color + share * Vec3{decoded(c[0]), decoded(c[1]), decoded(c[2])};
    sum.opacity += share * c[3] / 255;
  }
  return sum;
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

RTCRayHit question(const Ray& r, unsigned sorts, double from, double to) {
  RTCRayHit q{};
  q.ray.org_x = static_cast<float>(r.from.x), q.ray.org_y = static_cast<float>(r.from.y);
  q.ray.org_z = static_cast<float>(r.from.z), q.ray.tnear = static_cast<float>(from);
  q.ray.dir_x = static_cast<float>(r.along.x), q.ray.dir_y = static_cast<float>(r.along.y);
  q.ray.dir_z = static_cast<float>(r.along.z), q.ray.tfar = static_cast<float>(to);
  q.ray.mask = sorts;
  q.hit.geomID = q.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  return q;
}

Meeting met(const RTCHit& hit, float distance) {
  const bool instance = hit.instID[0] != RTC_INVALID_GEOMETRY_ID;
  return {instance ? hit.instID[0] : hit.geomID, hit.primID, distance, hit.u, hit.v, {hit.Ng_x, hit.Ng_y, hit.Ng_z}};
}

// Returns the distance up to which surfaces are in one plane with that one.
float end_of(double plane) { return static_cast<float>(plane * (1 + one_plane)); }

// In a part of a ray, finds the surface with the highest rank below a given one. It reports no hit to Embree, so that
// the search continues.
struct Highest : RTCIntersectContext {
  const World* world = nullptr;
  std::uint64_t below = 0, rank = 0;
  std::optional<Meeting> found;
};
void look_at_meeting(const RTCFilterFunctionNArguments* a) {
  if (a->valid[0] == 0) return;
  a->valid[0] = 0;
  auto& search = *static_cast<Highest*>(a->context);
  const Meeting m = met(rtcGetHitFromHitN(a->hit, a->N, 0), RTCRayN_tfar(a->ray, a->N, 0));
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
  if (!device) return fail(ErrorCode::machine, "rays cannot be traced here: Embree does not start");
  return World(std::move(device));
}

std::shared_ptr<World::Solid> World::solid(const std::shared_ptr<const Mesh>& mesh) {
  std::shared_ptr<Solid>& place = solids_[mesh.get()];
  if (place == nullptr) {
    place = std::make_shared<Solid>();
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
  Cloth& cloth = cloths_[picture.get()];
  if (cloth.picture == nullptr) {
    cloth.picture = picture;
    for (std::size_t i = 3; i < picture->rgba.size() && !cloth.has_holes; i += 4)
      cloth.has_holes = picture->rgba[i] != 255;
  }
  cloth.used = picture_;
  return cloth.has_holes;
}

void World::need_scene(Solid& s) const {
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

std::optional<World::Body> World::body_of(const Columns& c, std::uint32_t i, const View& view, unsigned& sorts) {
  const Evaluation::Look& l = c.looks[i];
  if (!l.visible || l.shape == Evaluation::Look::none || !finite(c.worlds[i]) || !finite(l.color) ||
      !std::isfinite(l.transparency) || !std::isfinite(l.shininess) || !std::isfinite(l.blend) || l.transparency >= 1)
    return {};
  const Shape& shape = *c.shape(l.shape);
  const Shape* const toward = l.toward != Evaluation::Look::none && l.blend != 0 ? c.shape(l.toward).get() : nullptr;
  const auto realised = [&](const Detail& d) {
    return toward != nullptr ? realise_blend(shape, *toward, l.blend, d) : realise(shape, d);
  };
  Body b;
  if (l.texture != Evaluation::Look::none) b.texture = c.texture(l.texture);
  Mat4 world = c.worlds[i];
  for (int k = 0; k < 3; ++k) world(k, 3) -= view.eye[k];
  const bool ball = shape.kind == Kind::sphere && toward == nullptr && b.texture == nullptr;
  const bool detailed = has_details(shape, toward);
  Geometry g = ball ? Geometry{nullptr, scaling({shape.radius, shape.radius, shape.radius})}
                    : realised(detailed ? Detail{24, true} : Detail{});
  std::shared_ptr<Solid> body = solid(g.mesh);
  const Bounds bounds = bounds_in(body->box, world * g.local);
  const double radius = bounds.radius(), away = length(bounds.center);
  if (!(radius > 0 && radius < far_away && away < far_away) || (!ball && g.mesh->positions.empty())) return {};
  if (detailed && !ball) {
    const double scale = view.sx * view.width * radius;
    g = realised(Detail::for_pixels(view.orthographic ? scale : scale / std::max(away - 0.5 * radius, 0.1 * radius)));
    body = solid(g.mesh);
  }
  const std::optional<Mat4> place = with_inverse(world * g.local);
  b.hairline = !ball && body->parts.empty();
  if (!place && !b.hairline) return {};
  b.place = b.hairline ? world * g.local : *place;
  b.turn = crossed(b.place);
  const double longest = std::max({length(b.turn[0]), length(b.turn[1]), length(b.turn[2])});
  for (Vec3& v : b.turn) v = (determinant(b.place) < 0 ? -1 : 1) / longest * v;
  b.color = {std::clamp(l.color.x, 0.0, 1e4), std::clamp(l.color.y, 0.0, 1e4), std::clamp(l.color.z, 0.0, 1e4)};
  b.opacity = 1 - std::clamp(l.transparency, 0.0, 1.0), b.shine = std::clamp(l.shininess, 0.0, 1.0);
  b.material = l.material, b.line = row_of(shape.kind).line;
  b.blur = 0.1 * one_plane * (away + radius);
  const bool holes = b.texture != nullptr ? has_holes(b.texture) : body->has_holes;
  sorts = looks;
  if (l.casts && !b.hairline) sorts |= gathers;
  if (l.casts && !b.hairline && b.material != Material::glow && b.opacity > 0.5)
    sorts |= b.opacity < 1 || holes ? thin_shadows : shadows;
  if (!b.hairline) need_scene(*body);
  b.solid = std::move(body);
  return b;
}

GeometryHandle World::instance(const Body& b) const {
  GeometryHandle g(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_INSTANCE));
  rtcSetGeometryInstancedScene(g.get(), b.solid->scene.get());
  std::array<float, 12> columns;
  for (int i = 0; i < 12; ++i) columns[static_cast<std::size_t>(i)] = static_cast<float>(b.place(i % 3, i / 3));
  rtcSetGeometryTransform(g.get(), 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
  return g;
}

// Ribbons that face the eye, as wide everywhere as a line in the picture.
GeometryHandle World::hairlines(const Body& b, const View& view) const {
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
  bodies_.clear();
  bodies_.resize(count);
  thin_ = false;
  all_.reset(rtcNewScene(device_.get()));
  set_flags(all_.get());
  for (std::uint32_t i = 0; i < bodies_.size(); ++i) {
    unsigned sorts = 0;
    std::optional<Body> body = body_of(c, i, view, sorts);
    if (!body) continue;
    const GeometryHandle g = body->hairline ? hairlines(*body, view) : instance(*body);
    if (g == nullptr) continue;
    bodies_[i] = *std::move(body);
    thin_ |= (sorts & thin_shadows) != 0;
    rtcSetGeometryMask(g.get(), sorts);
    rtcCommitGeometry(g.get());
    rtcAttachGeometryByID(all_.get(), g.get(), i);
  }
  rtcCommitScene(all_.get());
  std::erase_if(solids_, [&](const auto& s) { return s.second->used + kept_for <= picture_; });
  std::erase_if(cloths_, [&](const auto& s) { return s.second.used + kept_for <= picture_; });
  switch (rtcGetDeviceError(device_.get())) {
    case RTC_ERROR_NONE:
      return Nothing{};
    case RTC_ERROR_OUT_OF_MEMORY:
      return fail(ErrorCode::machine, "there is not enough memory to trace rays among all that is there");
    default:
      return fail(ErrorCode::machine, "rays cannot be traced among what is there: Embree fails");
  }
}

std::optional<Meeting> World::nearest(const Ray& r, unsigned sorts) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit q = question(r, sorts, 0, INFINITY);
  rtcIntersect1(all_.get(), &context, &q);
  if (q.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return met(q.hit, q.ray.tfar);
}

std::uint64_t World::rank(const Meeting& m) const {
  const Body& b = bodies_[m.body];
  return std::uint64_t{m.body} << 32 | (b.line ? 0 : m.triangle) | (b.hairline ? hairlines_first : 0);
}

std::optional<Meeting> World::highest(const Ray& r, double plane, std::uint64_t below) const {
  Highest search;
  rtcInitIntersectContext(&search);
  search.filter = look_at_meeting;
  search.world = this, search.below = below;
  RTCRayHit q = question(r, looks, plane, static_cast<double>(end_of(plane)));
  rtcIntersect1(all_.get(), &search, &q);
  if (search.found) search.found->plane = plane;
  return search.found;
}

std::optional<Meeting> World::next_layer(const Ray& r, const std::optional<Meeting>& last) const {
  double from = 0;
  if (last) {
    if (auto beneath = highest(r, last->plane, rank(*last))) return beneath;
    from = static_cast<double>(std::nextafter(end_of(last->plane), INFINITY));
  }
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit q = question(r, looks, from, INFINITY);
  rtcIntersect1(all_.get(), &context, &q);
  if (q.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  Meeting first = met(q.hit, q.ray.tfar);
  first.plane = first.distance;
  const std::optional<Meeting> top = highest(r, first.plane, ~std::uint64_t{0});
  return top && rank(*top) > rank(first) ? top : first;
}

double World::unblocked(const Ray& r, double distance) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay solid = question(r, shadows, 0, distance).ray;
  rtcOccluded1(all_.get(), &context, &solid);
  if (!(solid.tfar >= 0)) return 0;
  double through = 1, from = 0;
  for (int k = 0; thin_ && k < 64 && through > 0; ++k) {
    RTCRayHit q = question(r, thin_shadows, from, distance);
    rtcIntersect1(all_.get(), &context, &q);
    if (q.hit.geomID == RTC_INVALID_GEOMETRY_ID) break;
    const Meeting m = met(q.hit, q.ray.tfar);
    // An object that fades out and lets half of the light through casts no shadow.
    const double solidity = std::clamp(2 * spot(r, m).opacity - 1, 0.0, 1.0);
    through *= 1 - solidity;
    from = m.distance * (1 + 2 * one_plane) + 1e-30;
  }
  return through;
}

// The surface on a triangle. If the triangle approximates a smooth surface, rays to lights start from that, so that
// facets do not shade each other.
Spot World::corner_spot(const Body& b, const Meeting& m, bool back) const {
  const Solid& solid = *b.solid;
  const Mesh& mesh = *solid.mesh;
  const std::uint32_t* corner = &solid.corners[3 * std::size_t{m.triangle}];
  const std::array<double, 3> share{1 - m.u - m.v, m.u, m.v};
  const bool normals = mesh.normals.size() == mesh.positions.size();
  Vec3 at, normal, u;
  for (std::size_t k = 0; k < 3; ++k) {
    at = at + share[k] * wide(mesh.positions[corner[k]]);
    normal = normal + share[k] * (normals ? wide(mesh.normals[corner[k]]) : m.across);
  }
  Vec3 smooth = at;
  for (std::size_t k = 0; k < 3 && normals && !back; ++k) {
    const Vec3 n = wide(mesh.normals[corner[k]]);
    smooth = smooth + share[k] * std::max(dot(wide(mesh.positions[corner[k]]) - at, n), 0.0) * n;
  }
  const MeshPart& part = solid.parts[solid.part_of[m.triangle]];
  Spot s;
  s.at = transform_point(b.place, at), s.start = transform_point(b.place, smooth);
  s.normal = normal;
  s.color = (part.tinted ? b.color : Vec3{1, 1, 1}) * wide(part.color);
  s.opacity = b.opacity;
  const Picture* const picture = b.texture != nullptr ? b.texture.get() : part.texture.get();
  if (picture == nullptr) return s;
  if (mesh.uvs.size() == mesh.positions.size())
    for (std::size_t k = 0; k < 3; ++k) u = u + share[k] * Vec3{mesh.uvs[corner[k]][0], mesh.uvs[corner[k]][1], 0};
  const Dye dye = dye_at(*picture, u.x, u.y);
  s.color = s.color * dye.color, s.opacity *= dye.opacity;
  return s;
}

Spot World::spot(const Ray& r, const Meeting& m) const {
  const Body& b = bodies_[m.body];
  const auto turned = [&](Vec3 v) { return unit(v.x * b.turn[0] + v.y * b.turn[1] + v.z * b.turn[2]); };
  Spot s;
  if (b.hairline) {
    s.at = s.start = r.from + m.distance * r.along;
    s.beyond = s.at + one_plane * (largest(s.at) + m.distance) * r.along;
    s.color = {std::min(b.color.x, 1.0), std::min(b.color.y, 1.0), std::min(b.color.z, 1.0)};
    s.normal = s.face = -r.along, s.opacity = b.opacity, s.material = Material::glow, s.hairline = true;
    return s;
  }
  const Vec3 face = turned(m.across);
  const bool back = dot(face, r.along) > 0;
  if (b.solid->mesh != nullptr) {
    s = corner_spot(b, m, back);
    s.normal = turned(s.normal);
  } else {
    s.at = s.start = transform_point(b.place, unit(m.across));
    s.normal = face, s.color = b.color, s.opacity = b.opacity;
  }
  s.face = back ? -face : face;
  if (back) s.normal = -s.normal;
  const Vec3 clear = (one_plane * largest(s.at) + b.blur) * s.face;
  s.start = s.start + clear, s.beyond = s.at - clear;
  s.shine = b.shine, s.material = b.material;
  return s;
}

}  // namespace betwixt::traced
