// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The objects of a picture, each with one state or several.
#include "render/blends.h"
#include "render/content_geometry.h"
#include "render/embree_buffers.h"
#include "render/forms.h"
#include "render/traced_world.h"

namespace betwixt::traced {
namespace {

constexpr double far_away = 1e15;       // metres; squares of f32 stay finite
constexpr double hairline_reach = 0.7;  // half the width in pixels

// The inverse transpose up to its length: the cross products of the columns.
std::array<Vec3, 3> normal_matrix_of(const Mat4& m) {
  const Vec3 x = column(m, 0), y = column(m, 1), z = column(m, 2);
  return {cross(y, z), cross(z, x), cross(x, y)};
}

// The same, at most of length 1, with the direction of normals of what is mirrored.
std::array<Vec3, 3> normals_of(const Mat4& m) {
  std::array<Vec3, 3> all = normal_matrix_of(m);
  const double longest = std::max({length(all[0]), length(all[1]), length(all[2])});
  for (Vec3& v : all) v = (determinant(m) < 0 ? -1 : 1) / longest * v;
  return all;
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

bool is_ball(const Content& p) {
  return p.shape->kind == Kind::sphere && blend_target(p) == nullptr && p.texture == nullptr && p.gradients == nullptr;
}

Geometry realised(const Content& p, const Detail& d) {
  const double r = p.shape->radius;
  return is_ball(p) ? Geometry{nullptr, scaling({r, r, r})} : geometry_of(p, d);
}

Mat4 seen_from(const Vec3& eye, Mat4 world) {
  for (int k = 0; k < 3; ++k) world(k, 3) -= eye[k];
  return world;
}

bool is_there(const Content& p) {
  const Evaluation::Look& l = p.look;
  return l.visible && p.shape && finite(p.world) && finite(l.color) && std::isfinite(l.transparency) &&
         std::isfinite(l.shininess) && std::isfinite(l.blend) && l.transparency < 1;
}

bool same_parts(const std::vector<MeshPart>& a, const std::vector<MeshPart>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const MeshPart& x, const MeshPart& y) {
    return x.first == y.first && x.count == y.count && x.color == y.color && x.texture == y.texture &&
           x.tinted == y.tinted && x.stroke == y.stroke;
  });
}

// Returns whether two meshes differ in nothing but the places of their corners.
bool same_triangles(const Mesh& a, const Mesh& b) {
  return a.positions.size() == b.positions.size() && a.normals.size() == b.normals.size() &&
         a.uvs.size() == b.uvs.size() && a.triangles == b.triangles && a.edges == b.edges && a.closed == b.closed &&
         same_parts(a.parts, b.parts);
}

}  // namespace

double World::pixels_of(const Content& p, const View& view) {
  if (!is_there(p) || is_ball(p) || !has_details(*p.shape, blend_target(p))) return 0;
  const Geometry g = realised(p, {24, true});
  const Bounds bounds = bounds_of(mesh_scene(g.mesh)->box, seen_from(view.eye, p.world) * g.local);
  const double radius = bounds.radius(), away = length(bounds.center), scale = view.sx * view.width * radius;
  return view.orthographic ? scale : scale / std::max(away - 0.5 * radius, 0.1 * radius);
}

std::optional<World::TracedObject> World::object_of(const Content& p, const View& view, double pixels) {
  if (!is_there(p)) return {};
  const Evaluation::Look& l = p.look;
  TracedObject b;
  const Mat4 world = seen_from(view.eye, p.world);
  const bool ball = is_ball(p), detailed = has_details(*p.shape, blend_target(p));
  if (detailed && !ball && !(pixels > 0 && pixels < INFINITY)) return {};
  const Geometry g = realised(p, detailed && !ball ? Detail::for_pixels(pixels) : Detail{});
  std::shared_ptr<MeshScene> object = mesh_scene(g.mesh);
  const Bounds bounds = bounds_of(object->box, world * g.local);
  const double radius = bounds.radius(), away = length(bounds.center);
  if (!(radius > 0 && radius < far_away && away < far_away) || (!ball && g.mesh->positions.empty())) return {};
  const std::optional<Mat4> place = with_inverse(world * g.local);
  b.hairline = !ball && object->parts.empty();
  if (!place && !b.hairline) return {};
  b.place = b.hairline ? world * g.local : *place;
  b.normal_matrix = normals_of(b.place);
  b.color = {std::clamp(l.color.x, 0.0, 1e4), std::clamp(l.color.y, 0.0, 1e4), std::clamp(l.color.z, 0.0, 1e4)};
  b.opacity = 1 - std::clamp(l.transparency, 0.0, 1.0), b.shine = std::clamp(l.shininess, 0.0, 1.0);
  if (p.texture) b.texture = p.texture.get(), kept_.push_back(p.texture);
  if (p.finish) b.finish = p.finish.get(), kept_.push_back(p.finish), finishes_ = true;
  b.to_object = g.local;
  add_gradients(p, g.local, b);
  b.material = l.material, b.line = row_of(p.shape->kind).line;
  b.blur = 0.1 * coplanar_tolerance * (away + radius);
  const bool holes = p.texture ? has_holes(p.texture) : object->has_holes;
  const bool see_through = p.gradients && p.gradients->see_through();
  b.mask = camera_rays;
  if (l.casts && !b.hairline) b.mask |= ambient_rays;
  if (l.casts && !b.hairline && b.material != Material::glow && b.opacity > 0.5)
    b.mask |= b.opacity < 1 || holes || see_through || (b.finish && b.finish->transmission > 0)
                  ? translucent_shadow_rays
                  : shadow_rays;
  list_triangles(*object);
  b.solid = object.get();
  return b;
}

void World::add_gradients(const Content& p, const Mat4& local, TracedObject& b) {
  if (!p.gradients) return;
  const Box box = gradient_box(*p.shape, blend_target(p), p.look.blend);
  for (const auto& [from, to] : {std::pair(&p.gradients->fill, &b.fill), std::pair(&p.gradients->stroke, &b.stroke)}) {
    if (from->kind == GradientKind::none) continue;
    const auto made = std::make_shared<const Graded>(Graded{GradientColors(*from), placed_gradient(*from, box, local)});
    *to = made.get();
    kept_.push_back(made);
  }
}

World::TracedObject World::ObjectStates::at(double time) const {
  const TimeStep step(time, all.size());
  TracedObject b = all[step.nearest()];
  const TracedObject &from = all[step.first], &to = all[step.first + 1];
  const double s = step.share;
  for (std::size_t i = 0; i < 16; ++i) b.place.m[i] = (1 - s) * from.place.m[i] + s * to.place.m[i];
  for (std::size_t i = 0; i < 16; ++i) b.to_object.m[i] = (1 - s) * from.to_object.m[i] + s * to.to_object.m[i];
  b.normal_matrix = normals_of(b.place);
  b.color = mix(from.color, to.color, s);
  b.opacity = (1 - s) * from.opacity + s * to.opacity, b.shine = (1 - s) * from.shine + s * to.shine;
  if (from.solid != to.solid) b.last = from.solid, b.next = to.solid, b.share = s;
  return b;
}

// An instance of the mesh, which moves from state to state; and so do the corners of its triangles.
GeometryHandle World::instance(std::span<const TracedObject> states) const {
  std::vector<const MeshScene*> meshes;
  for (const TracedObject& b : states) meshes.push_back(b.solid);
  const bool bends = std::any_of(meshes.begin(), meshes.end(), [&](auto* m) { return m != meshes.front(); });
  GeometryHandle g(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_INSTANCE));
  const SceneHandle own = bends ? scene_of(triangles(meshes)) : nullptr;
  rtcSetGeometryInstancedScene(g.get(), bends ? own.get() : meshes.front()->scene.get());
  rtcSetGeometryTimeStepCount(g.get(), static_cast<unsigned>(states.size()));
  for (unsigned k = 0; k < states.size(); ++k) {
    std::array<float, 12> columns;
    for (int i = 0; i < 12; ++i)
      columns[static_cast<std::size_t>(i)] = static_cast<float>(states[k].place(i % 3, i / 3));
    rtcSetGeometryTransform(g.get(), k, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
  }
  return g;
}

// Ribbons that face the eye, as wide everywhere as a line in the picture.
GeometryHandle World::hairlines(std::span<const TracedObject> states, const View& view) const {
  const std::vector<std::uint32_t>& edges = states.front().solid->mesh->edges;
  const std::size_t ends = edges.size() / 2 * 2;
  for (const TracedObject& b : states)
    if (edges.size() < 2 || !indices_fit(edges, b.solid->mesh->positions.size())) return {};
  GeometryHandle g(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_FLAT_LINEAR_CURVE));
  rtcSetGeometryTimeStepCount(g.get(), static_cast<unsigned>(states.size()));
  auto* starts = new_buffer<std::uint32_t>(g.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, ends / 2);
  if (starts == nullptr) return {};
  for (std::size_t k = 0; k < ends; k += 2) starts[k / 2] = static_cast<std::uint32_t>(k);
  const double pixel = 2 / (view.sx * view.width);  // at depth 1, or anywhere if orthographic
  for (unsigned n = 0; n < states.size(); ++n) {
    const TracedObject& b = states[n];
    auto* vertices = new_buffer<std::array<float, 4>>(g.get(), RTC_BUFFER_TYPE_VERTEX, n, RTC_FORMAT_FLOAT4, ends);
    if (vertices == nullptr) return {};
    for (std::size_t k = 0; k < ends; ++k) {
      const Vec3 p = transform_point(b.place, wide(b.solid->mesh->positions[edges[k]]));
      const double reach = hairline_reach * pixel * (view.orthographic ? 1 : std::abs(view.depth(p)));
      vertices[k] = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z),
                     static_cast<float>(reach)};
    }
  }
  return g;
}

// Returns whether Embree can go from each state to the next one.
bool World::mixable(const std::vector<TracedObject>& states) {
  const TracedObject& first = states.front();
  return std::all_of(states.begin(), states.end(), [&](const TracedObject& b) {
    const Mesh *const mesh = b.solid->mesh.get(), *const own = first.solid->mesh.get();
    return b.hairline == first.hairline && b.line == first.line && b.material == first.material &&
           (mesh == own || (mesh != nullptr && own != nullptr && same_triangles(*mesh, *own)));
  });
}

void World::add(const Course& course, std::uint32_t place, const View& view) {
  double pixels = 0;
  for (const Content& p : course.states) pixels = std::max(pixels, pixels_of(p, view));
  std::vector<std::optional<TracedObject>> found;
  for (const Content& p : course.states) found.push_back(object_of(p, view, pixels));
  std::vector<TracedObject> states;
  for (const auto& b : found)
    if (b) states.push_back(*b);
  if (states.empty()) return;
  if (states.size() == found.size() && (states.size() == 1 || (course.mixes && mixable(states))))
    return attach(std::move(states), place, place, 0, 1, view);
  // Each state by itself.
  const double steps = static_cast<double>(found.size()) - 1;
  for (std::size_t k = 0; k < found.size();) {
    const std::size_t first = k++;
    while (k < found.size() && course.states[k] == course.states[first]) ++k;
    if (!found[first]) continue;
    const double from = first == 0 ? -1 : (static_cast<double>(first) - 0.5) / steps;
    const double to = k == found.size() ? 2 : (static_cast<double>(k) - 0.5) / steps;
    objects_.emplace_back();
    attach({*found[first], *found[first]}, place, static_cast<unsigned>(objects_.size() - 1), static_cast<float>(from),
           static_cast<float>(to), view);
  }
}

void World::attach(std::vector<TracedObject> states, std::uint32_t order, unsigned id, float from, float to,
                   const View& view) {
  unsigned mask = 0;
  bool all_opaque = true, bends = false;
  for (const TracedObject& b : states) {
    mask |= b.mask, all_opaque = all_opaque && (b.mask & shadow_rays) != 0;
    bends = bends || b.solid != states.front().solid;
  }
  if (!states.front().hairline && !bends) need_scene(*mesh_scenes_[states.front().solid->mesh.get()]);
  if ((mask & shadow_rays) != 0 && !all_opaque) mask = (mask & ~shadow_rays) | translucent_shadow_rays;
  const GeometryHandle g = states.front().hairline ? hairlines(states, view) : instance(states);
  if (g == nullptr) return;
  if (from > 0 || to < 1) rtcSetGeometryTimeRange(g.get(), from, to);
  thin_ |= (mask & translucent_shadow_rays) != 0;
  rtcSetGeometryMask(g.get(), mask);
  rtcCommitGeometry(g.get());
  rtcAttachGeometryByID(all_.get(), g.get(), id);
  objects_[id] = {std::move(states), order};
}

}  // namespace betwixt::traced
