// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/shadow.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "render/balls.h"
#include "render/shadow_levels.h"

namespace betwixt {
namespace {

const char* const uniforms = R"(
uniform mat4 clip;
uniform vec4 light;
uniform float push;  // 1: away from the light, by `look.x` metres
)";
const char* const shadow_vertex = R"(
#ifdef VEIL
flat out float solidity;
#endif
void main() {
  vec4 p = vec4(position, 1.0);
#ifdef VEIL
  solidity = 2.0 * color.a - 1.0;
#endif
#ifdef BALL
  vec4 e;
  p.xyz = outline(position.xy, light, e);
#endif
  vec3 at = vec3(dot(row_x, p), dot(row_y, p), dot(row_z, p));
  at += push * look.x * (light.w > 0.5 ? at * inversesqrt(max(dot(at, at), 1e-30)) : -light.xyz);
  gl_Position = clip * vec4(at, 1.0);
}
)";
// What lets some light through casts a shadow with holes, which softening makes a lighter one; what lets half of it
// through casts none. So a thing that fades out takes its shadow with it.
const char* const shadow_fragment = R"(
#ifdef VEIL
flat in float solidity;
void main() {
  // Bayer's order over four by four texels: any count of holes is spread evenly.
  const float order[16] = float[16](0.5, 8.5, 2.5, 10.5, 12.5, 4.5, 14.5, 6.5, 3.5, 11.5, 1.5, 9.5, 15.5, 7.5, 13.5, 5.5);
  ivec2 at = ivec2(gl_FragCoord.xy) & 3;
  float noise = order[at.y * 4 + at.x] / 16.0;
  if (noise >= solidity) discard;
}
#else
void main() {}
#endif
)";

constexpr double side = 1.07;  // of one of six, which overlap

Mat4 looking(Vec3 from, Vec3 backward) {
  const Vec3 helper = std::abs(backward.y) < 0.9 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  const Vec3 right = normalize(cross(helper, backward)), up = cross(backward, right);
  Mat4 r;
  for (int c = 0; c < 3; ++c) r(0, c) = right[c], r(1, c) = up[c], r(2, c) = backward[c];
  r(0, 3) = -dot(right, from), r(1, 3) = -dot(up, from), r(2, 3) = -dot(backward, from);
  return r;
}

void set_caster(const gl::Program& program, const Mat4& clip, Vec3 light, bool sun) {
  const Vec3 at = sun ? light : Vec3{};  // the direction towards a sun; a lamp is the origin
  glUseProgram(program.id());
  glUniformMatrix4fv(gl::uniform(program, "clip"), 1, GL_FALSE, to_float(clip).data());
  glUniform4f(gl::uniform(program, "light"), static_cast<float>(at.x), static_cast<float>(at.y),
              static_cast<float>(at.z), sun ? 0 : 1);
}

Result<gl::Program> new_caster(const char* defines) {
  return gl::new_program(std::string(vertex_inputs) + uniforms + ball_outline + shadow_vertex, shadow_fragment,
                         defines);
}

}  // namespace

Result<Shadows> Shadows::create() {
  Shadows s;
  if (const Status made = s.make_layers(1); !made) return made.error();
  auto meshes = new_caster("");  // to know whether the driver can
  if (!meshes) return meshes.error();
  s.meshes_ = *std::move(meshes);
  return s;
}

const gl::Program* Shadows::need(gl::Program Shadows::*which, const Part& one, const Made& light) {
  gl::Program& program = this->*which;
  if (program.id() == 0) {
    auto made = new_caster(which == &Shadows::balls_ ? "#define BALL" : "#define VEIL");
    if (!made) return nullptr;
    program = *std::move(made);
    set_caster(program, one.clip, light.place, light.sun);
  }
  return &program;
}

// Makes as many as were ever needed, in steps. All have the size of the first.
Status Shadows::make_layers(std::size_t count) {
  if (count <= count_) return Nothing{};
  std::size_t made = 1;
  while (made < count) made *= 2;
  auto layers = gl::new_depth_layers(map_size, static_cast<int>(made));
  if (!layers) return layers.error();
  std::tie(layers_, framebuffer_) = *std::move(layers);
  count_ = made;
  for (One& one : all_)
    for (Part& part : one.parts) part.stale = true;
  return Nothing{};
}

// The view of a map. Positions are relative to the lamp, or for suns to a point near the centre of the shown objects,
// which moves in steps, so that f32 is enough for small objects far from the world's origin.
Shadows::Part Shadows::part_of_sun(const Things& things, const Made& light, const Numbers& shown) const {
  Part part;
  Ball ball = around_all(things, shown, light.anchor);
  // Its size and place change in steps, so that edges do not crawl while objects move.
  ball.radius = std::exp2(std::ceil(std::log2(ball.radius) * 4) / 4) * 1.02;
  part.map.texel = 2 * ball.radius / map_size;
  Vec3 step = 1 / ball.radius * ball.center;
  for (int i = 0; i < 3; ++i) step[i] = std::round(step[i]) * ball.radius;
  part.origin = light.anchor + step;
  const Mat4 view = looking({0, 0, 0}, light.place);
  const Vec3 c = transform_point(view, ball.center), shift = transform_point(view, step);
  double low = c.z - ball.radius, high = c.z + ball.radius;
  for (const std::uint32_t i : casters_) {
    const Bounds& b = things[i].bounds;
    const double z = transform_point(view, b.center - light.anchor).z, r = b.radius();
    high = std::max(high, z + r), low = std::min(low, z - r);
  }
  Mat4 projection;
  projection(0, 0) = projection(1, 1) = 1 / ball.radius;
  projection(0, 3) = (shift.x - std::round(c.x / part.map.texel) * part.map.texel) / ball.radius;
  projection(1, 3) = (shift.y - std::round(c.y / part.map.texel) * part.map.texel) / ball.radius;
  projection(2, 2) = -2 / (high - low), projection(2, 3) = (high + low - 2 * shift.z) / (high - low);
  part.map.spread = light.size * 0.5 * (high - low) / ball.radius;
  part.map.top = (high - c.z - ball.radius) / (high - low);
  part.clip = projection * view;
  return part;
}

namespace {

// The view of a lamp in a direction: axis, width, and the near distance.
struct Cone {
  Vec3 backward;
  double tangent = 0, before = 0;
};

// Returns a cone that contains all of them, if there is one.
std::optional<Cone> cone_of(const Things& things, std::span<const std::uint32_t> shown, Vec3 lamp, Vec3 anchor) {
  const Vec3 back = (lamp - anchor) - around_all(things, shown, anchor).center;
  Cone cone{normalize(back, {0, 1, 0}), 0, INFINITY};
  for (const std::uint32_t i : shown) {
    const Vec3 to = things[i].bounds.center - lamp;
    const double d = length(to), r = things[i].bounds.radius(), ahead = -dot(to, cone.backward);
    if (d <= r || ahead <= 0) return std::nullopt;
    const double angle = std::atan2(std::sqrt(std::max(d * d - ahead * ahead, 0.0)), ahead) + std::asin(r / d);
    if (angle >= std::atan(widest)) return std::nullopt;
    cone.tangent = std::max(cone.tangent, std::tan(angle)), cone.before = std::min(cone.before, d - r);
  }
  // In steps, so that edges do not crawl while objects move.
  cone.tangent = std::min(std::exp2(std::ceil(std::log2(std::max(cone.tangent, 1e-9)) * 4) / 4) * 1.02, widest);
  return cone;
}

// Returns whether a ball, relative to the map's origin, may be in the map or cast a shadow in it.
bool reaches(const Mat4& clip, Vec3 center, double radius) {
  for (int row = 0; row < 2; ++row)
    for (const double sign : {-1.0, 1.0}) {
      const auto at = [&](int c) { return clip(3, c) + sign * clip(row, c); };
      const Vec3 n{at(0), at(1), at(2)};
      if (dot(n, center) + at(3) < -radius * length(n)) return false;
    }
  return true;
}

// Returns half of an object's least measure.
double half_thickness(const Thing& t, Store& store) {
  const Form::Realised& plain = t.form->plain(store);
  const Mat4 m = t.world * plain.local;
  const Vec3 half = plain.mesh->box.half();
  double least = INFINITY;
  for (int k = 0; k < 3; ++k) least = std::min(least, half[k] * length(column(m, k)));
  return least;
}

}  // namespace

void Shadows::look(One& one, const Things& things) const {
  const Made& light = *one.made;
  one.parts.clear();
  if (light.sun) {
    for (const Numbers& shown : one.levels) one.parts.push_back(part_of_sun(things, light, shown));
    return;
  }
  const auto put = [&](const Cone& cone) {
    Part part;
    Mat4 projection;
    const double far = std::max(light.range, 1e-6), near = far * 1e-3;
    projection(0, 0) = projection(1, 1) = 1 / cone.tangent;
    projection(2, 2) = -(far + near) / (far - near), projection(2, 3) = -2 * far * near / (far - near);
    projection(3, 2) = -1, projection(3, 3) = 0;
    // A point at distance w has the depth (1/near - 1/w) / (1/near - 1/far).
    const double inverse = 1 / near - 1 / far;
    part.map.perspective = true, part.map.texel = 2 * cone.tangent / map_size;
    part.map.spread = light.size * inverse / (2 * cone.tangent);
    part.map.top = (1 / near - 1 / std::clamp(cone.before, near, far)) / inverse;
    part.origin = light.place;
    part.clip = projection * looking({0, 0, 0}, cone.backward);
    one.parts.push_back(part);
  };
  const Numbers& all = one.levels.back();
  const std::optional<Cone> around = cone_of(things, all, light.place, light.anchor);
  for (const Numbers& shown : one.levels)  // if it is finer than the last one
    if (const auto cone = cone_of(things, shown, light.place, light.anchor);
        &shown != &all && cone && cone->tangent < 0.6 * (around ? around->tangent : side))
      put(*cone);
  if (around) return put(*around);
  const std::size_t before = one.parts.size();
  for (const Vec3 back : {Vec3{0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, -1}, {0, -1, 0}}) {
    put({back, side, 0});
    const bool any = std::any_of(all.begin(), all.end(), [&](std::uint32_t i) {
      const Bounds& b = things[i].bounds;
      return reaches(one.parts.back().clip, b.center - light.place, b.radius());
    });
    if (!any) one.parts.pop_back();
  }
  if (one.parts.size() <= light.room) return;
  one.parts.resize(before);
  const Vec3 back = (light.place - light.anchor) - around_all(things, all, light.anchor).center;
  put({normalize(back, {0, 1, 0}), widest, 0});
}

void Shadows::find_casters(Things& things, Vec3 anchor) {
  const std::pair now(things.casters(), anchor);
  if (found_ == now) return;
  found_ = now;
  casters_.clear();
  for (std::uint32_t i = 0; i < things.all().size(); ++i)
    if (things[i].casts && length(things[i].bounds.center - anchor) < 1e15) casters_.push_back(i);
}

std::span<const Shadows::Map> Shadows::update(Things& things, std::span<const Lighting::One> casting, bool floor) {
  if (casting.empty()) return {};
  const Vec3 eye = things.view().eye;
  // Whole kilometres near the eye: steps are measured from there, and stay while the eye moves.
  Vec3 anchor;
  for (int i = 0; i < 3; ++i) anchor[i] = 1000 * std::round(eye[i] / 1000);
  find_casters(things, anchor);
  if (casters_.empty()) return {};
  std::size_t used = 0;
  for (std::size_t k = 0; k < casting.size(); ++k) {
    const Lighting::One& light = casting[k];
    One& one = all_[k];
    const std::size_t room = most_maps - used - (casting.size() - 1 - k);  // each of the others keeps one
    const Made now{things.casters(),
                   light.sun,
                   light.sun ? light.place : light.world,
                   light.range,
                   light.size,
                   anchor,
                   floor,
                   room};
    const bool others = !one.made || !(*one.made == now);
    one.made = now;
    if (others || things.all_changed()) {
      std::vector<Numbers> found = levels(things, now);
      while (found.size() > room) found.erase(found.begin());
      if (others || found != one.levels) {
        const std::vector<Part> before = std::exchange(one.parts, {});
        const std::vector<Numbers> shown = std::exchange(one.levels, std::move(found));
        look(one, things);
        // Each map of a sun follows from its own level.
        for (std::size_t i = 0; light.sun && !others && i < std::min(before.size(), one.parts.size()); ++i)
          if (shown[i] == one.levels[i]) one.parts[i].stale = before[i].stale;
      }
    }
    if (one.first != used)
      for (Part& part : one.parts) part.stale = true;
    one.first = used, used += one.parts.size();
  }
  if (!make_layers(used))
    while (casting.size() > 1 && used > count_)
      used = all_[casting.size() - 1].first, casting = casting.first(casting.size() - 1);
  used = std::min(used, count_);
  for (std::size_t k = 0; k < casting.size(); ++k) {
    One& one = all_[k];
    for (std::size_t i = 0; i < one.parts.size() && one.first + i < used; ++i) {
      Part& part = one.parts[i];
      if (std::exchange(part.stale, false)) draw(part, one.first + i, things, *one.made);
      Map& map = maps_[one.first + i];
      map = part.map, map.light = k;
      map.clip = part.clip * translation(eye - part.origin);
    }
  }
  return std::span(maps_).first(used);
}

// Draws the casters that let some light through, or those that let none.
void Shadows::draw_some(const Part& one, Things& things, const Made& light, bool veils) {
  struct Group {
    Batch batch;
    std::vector<Instance> instances;
  };
  std::map<std::tuple<const StoredMesh*, bool, bool, bool>, Group> groups;
  for (const std::uint32_t i : casters_) {
    const Thing& t = things[i];
    if (t.transparent != veils || t.look.transparency >= 0.5)
      continue;  // an object that lets half of the light through casts no shadow
    const Vec3 center = t.bounds.center - one.origin;
    if (!reaches(one.clip, center, t.bounds.radius())) continue;
    Mat4 world = t.world;
    for (int k = 0; k < 3; ++k) world(k, 3) -= one.origin[k];
    const double away = one.map.perspective ? std::max(length(center) - t.size, 0.1 * t.size) : 1;
    const double texels = t.size / (away * one.map.texel);
    const bool ball = t.round && (!one.map.perspective || length(center) > 2 * t.bounds.radius());
    Mat4 local = scaling({t.shape->radius, t.shape->radius, t.shape->radius});
    StoredMesh* mesh = nullptr;
    if (ball) {
      mesh = things.store().disc(texels).get();
    } else {
      // The edge of a soft shadow may be off by a good part of a texel.
      const Form::Realised& cast = t.form->at(Detail::for_pixels(0.4 * texels), things.store());
      mesh = cast.mesh.get(), local = cast.local;
    }
    const bool within = one.map.perspective && length(center) <= t.bounds.radius();
    const bool far =
        t.closed && !ball && (t.shape->kind != Kind::box || detailed(*t.shape) || t.form->blends() || within);
    Group& g = groups[{mesh, t.mirrored, t.closed, far}];
    g.batch = {mesh, nullptr, nullptr, nullptr, t.mirrored, t.closed, ball, false, 0, g.batch.count + 1};
    g.instances.push_back(instance_of(t, world * local));
    g.instances.back().look[0] = static_cast<float>(far ? half_thickness(t, things.store()) : 0);
  }
  std::vector<Instance> all;
  for (auto& [key, g] : groups) {
    g.batch.first = all.size();
    all.insert(all.end(), g.instances.begin(), g.instances.end());
  }
  instances_.set(std::move(all));
  for (const auto& [key, g] : groups) {
    const gl::Program* const program = need(veils          ? &Shadows::veils_
                                            : g.batch.ball ? &Shadows::balls_
                                                           : &Shadows::meshes_,
                                            one, light);
    if (program == nullptr) continue;
    glUseProgram(program->id());
    // Closed objects cast by their far side, or by their middle if that is nearer to the light: then lit surfaces are
    // not in their own shadow, however few triangles there are, and no light leaks in where an object touches or enters
    // another. Boxes, which are exact, cast by their near side.
    const bool far = std::get<3>(key);
    glCullFace(far ? GL_FRONT : GL_BACK);
    (far ? glDisable : glEnable)(GL_POLYGON_OFFSET_FILL);
    draw_triangles(g.batch, instances_, false);
    if (!far) continue;
    const GLint push = gl::uniform(*program, "push");
    glUniform1f(push, 1);
    glCullFace(GL_BACK);
    draw_triangles(g.batch, instances_, false);
    glUniform1f(push, 0);
  }
}

void Shadows::draw(const Part& one, std::size_t layer, Things& things, const Made& light) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, layers_.id(), 0, static_cast<GLint>(layer));
  glViewport(0, 0, map_size, map_size);
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
  for (const auto* program : {&meshes_, &balls_, &veils_})
    if (program->id() != 0) set_caster(*program, one.clip, light.place, light.sun);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDisable(GL_BLEND);
  glPolygonOffset(1.0F, 2.0F);
  for (const bool veils : {false, true}) draw_some(one, things, light, veils);
  glCullFace(GL_BACK);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

}  // namespace betwixt
