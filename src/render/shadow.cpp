// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/shadow.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "render/balls.h"

namespace betwixt {
namespace {

const char* const uniforms = R"(
uniform mat4 clip;
uniform vec4 light;
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
  gl_Position = clip * vec4(dot(row_x, p), dot(row_y, p), dot(row_z, p), 1.0);
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

struct Ball {
  Vec3 center;
  double radius = 0;
};

Ball around(const Ball& a, const Ball& b) {
  const double d = length(b.center - a.center);
  if (d + b.radius <= a.radius) return a;
  if (d + a.radius <= b.radius) return b;
  const double r = (d + a.radius + b.radius) / 2;
  return {a.center + (r - a.radius) / d * (b.center - a.center), r};
}

Ball ball_of(const Thing& t, Vec3 anchor) { return {t.bounds.center - anchor, t.bounds.radius()}; }

Ball around_all(const Things& things, std::span<const std::uint32_t> casters, Vec3 anchor) {
  Ball all = ball_of(things[casters.front()], anchor);
  for (const std::uint32_t i : casters) all = around(all, ball_of(things[i], anchor));
  return all;
}

// How many pixels a metre at the thing has, and about how large it is in the picture, wherever in it.
struct Apparent {
  double pixels, size;
};
Apparent apparent(const Thing& t, const View& view) {
  const double r = t.bounds.radius(), away = std::max(length(t.bounds.center - view.eye) - r, 0.5 * r);
  const double pixels = 0.5 * view.sx * view.width / (view.orthographic ? 1 : away);
  return {pixels, pixels * r};
}

// Of casters by their size all but those that dwarf the rest (grounds and walls), whose own shadows nobody misses; and
// the ball around them.
Ball without_grounds(const Things& things, Vec3 anchor, std::vector<std::uint32_t>& by_size) {
  Ball all;
  for (std::size_t k = 0; k < by_size.size(); ++k) {
    const Ball one = ball_of(things[by_size[k]], anchor);
    if (k > 0 && one.radius > 4 * all.radius) {
      by_size.resize(k);
      break;
    }
    all = k == 0 ? one : around(all, one);
  }
  return all;
}

Mat4 looking(Vec3 from, Vec3 backward) {
  const Vec3 helper = std::abs(backward.y) < 0.9 ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  const Vec3 right = normalize(cross(helper, backward)), up = cross(backward, right);
  Mat4 r;
  for (int c = 0; c < 3; ++c) r(0, c) = right[c], r(1, c) = up[c], r(2, c) = backward[c];
  r(0, 3) = -dot(right, from), r(1, 3) = -dot(up, from), r(2, 3) = -dot(backward, from);
  return r;
}

}  // namespace

Result<Shadows> Shadows::create() {
  Shadows s;
  if (const Status made = s.make_layers(1); !made) return made.error();
  const std::string source = std::string(vertex_inputs) + uniforms + ball_outline + shadow_vertex;
  for (auto* to : {&s.meshes_, &s.balls_, &s.veils_}) {
    auto program = gl::new_program(source, shadow_fragment,
                                   to == &s.balls_   ? "#define BALL"
                                   : to == &s.veils_ ? "#define VEIL"
                                                     : "");
    if (!program) return program.error();
    *to = *std::move(program);
  }
  return s;
}

// One as long as one light casts: all are as large as the first.
Status Shadows::make_layers(std::size_t count) {
  if (count <= count_) return Nothing{};
  auto layers = gl::new_depth_layers(map_size, static_cast<int>(count));
  if (!layers) return layers.error();
  std::tie(layers_, framebuffer_) = *std::move(layers);
  count_ = count;
  for (One& one : all_) one.made.reset();
  return Nothing{};
}

// The map's view. Positions are relative to the lamp, or for suns to a place by the middle of what is shown, which
// jumps by steps, so that f32 is enough for what is small and far from the world's origin.
void Shadows::look(One& one, const Things& things, const Lighting::One& light) const {
  const Vec3 anchor = one.made->anchor;
  Ball ball = around_all(things, one.fine, anchor);
  Map& map = one.map;
  map.perspective = !light.sun;
  Mat4 projection;
  if (light.sun) {
    // Measured and placed in steps, so that edges do not swim while things move about.
    ball.radius = std::exp2(std::ceil(std::log2(ball.radius) * 4) / 4) * 1.02;
    map.texel = 2 * ball.radius / map_size;
    Vec3 step = 1 / ball.radius * ball.center;
    for (int i = 0; i < 3; ++i) step[i] = std::round(step[i]) * ball.radius;
    one.origin = anchor + step;
    const Mat4 view = looking({0, 0, 0}, light.place);
    const Vec3 c = transform_point(view, ball.center), shift = transform_point(view, step);
    double low = c.z - ball.radius, high = c.z + ball.radius;
    for (const std::uint32_t i : casters_) {
      const Bounds& b = things[i].bounds;
      const double z = transform_point(view, b.center - anchor).z, r = b.radius();
      high = std::max(high, z + r), low = std::min(low, z - r);
    }
    projection(0, 0) = projection(1, 1) = 1 / ball.radius;
    projection(0, 3) = (shift.x - std::round(c.x / map.texel) * map.texel) / ball.radius;
    projection(1, 3) = (shift.y - std::round(c.y / map.texel) * map.texel) / ball.radius;
    projection(2, 2) = -2 / (high - low), projection(2, 3) = (high + low - 2 * shift.z) / (high - low);
    map.spread = light.size * 0.5 * (high - low) / ball.radius, map.top = (high - c.z - ball.radius) / (high - low);
    one.clip = projection * view;
  } else {
    one.origin = light.world;
    const Vec3 back = (light.world - anchor) - ball.center;
    const double d = std::max(length(back), 1e-9);
    const double tangent =
        d > ball.radius ? std::min(ball.radius / std::sqrt(d * d - ball.radius * ball.radius), 2.5) : 2.5;
    map.texel = 2 * tangent / map_size;
    const double far = std::max(light.range, 1e-6), near = far * 1e-3;
    projection(0, 0) = projection(1, 1) = 1 / tangent;
    projection(2, 2) = -(far + near) / (far - near), projection(2, 3) = -2 * far * near / (far - near);
    projection(3, 2) = -1, projection(3, 3) = 0;
    // What is w away has the depth (1/near - 1/w) / (1/near - 1/far).
    const double inverse = 1 / near - 1 / far, before = std::clamp(d - ball.radius, near, far);
    map.spread = light.size * inverse / (2 * tangent), map.top = (1 / near - 1 / before) / inverse;
    one.clip = projection * looking({0, 0, 0}, normalize(back, {0, 1, 0}));
  }
}

// What the map must show finely: all but grounds; and where the map would be coarse for what is seen best, all but what
// is small beside it. How large that is which the eye is within, as above a ground, says nothing then: without small
// things far off it may be seen to dwarf the rest.
std::vector<std::uint32_t> Shadows::subject(const Things& things, Vec3 anchor) const {
  std::vector<std::uint32_t> found = by_size_;
  const Ball all = without_grounds(things, anchor, found);
  Apparent best{}, outside{};
  for (const std::uint32_t i : found) {
    const Apparent a = apparent(things[i], things.view());
    best = {std::max(best.pixels, a.pixels), std::max(best.size, a.size)};
    if (length(things[i].bounds.center - things.view().eye) > things[i].bounds.radius())
      outside.size = std::max(outside.size, a.size);
  }
  constexpr double coarse = 6, small = 0.2;  // pixels a texel; of the largest
  if (2 * all.radius / map_size * best.pixels <= coarse) return found;
  const double least = small * (outside.size > 0 ? outside.size : best.size);
  std::erase_if(found, [&](std::uint32_t i) { return apparent(things[i], things.view()).size < least; });
  without_grounds(things, anchor, found);
  return found;
}

void Shadows::find_casters(const Things& things, Vec3 anchor) {
  const std::pair now(things.casters(), anchor);
  if (found_ == now) return;
  found_ = now;
  casters_.clear();
  for (std::uint32_t i = 0; i < things.all().size(); ++i)
    if (things[i].casts && length(things[i].bounds.center - anchor) < 1e15) casters_.push_back(i);
  by_size_ = casters_;
  std::stable_sort(by_size_.begin(), by_size_.end(), [&](std::uint32_t a, std::uint32_t b) {
    return things[a].bounds.radius() < things[b].bounds.radius();
  });
}

std::span<const Shadows::Map> Shadows::update(Things& things, std::span<const Lighting::One> casting) {
  if (casting.empty()) return {};
  const Vec3 eye = things.view().eye;
  // A whole kilometre by the eye: steps are measured from there, and they stay while the eye moves about.
  Vec3 anchor;
  for (int i = 0; i < 3; ++i) anchor[i] = 1000 * std::round(eye[i] / 1000);
  find_casters(things, anchor);
  if (casters_.empty()) return {};
  if (casting.size() > count_ && !make_layers(Lighting::most_casting)) casting = casting.first(count_);
  for (std::size_t k = 0; k < casting.size(); ++k) {
    const Lighting::One& light = casting[k];
    One& one = all_[k];
    const Made now{things.casters(), light.sun, light.sun ? light.place : light.world, light.range, light.size, anchor};
    const bool others = !one.made || !(*one.made == now);
    one.made = now;
    if (others || things.all_changed()) {
      std::vector<std::uint32_t> fine = subject(things, anchor);
      if (others || fine != one.fine) {
        one.fine = std::move(fine);
        look(one, things, light);
        draw(one, k, things, light);
      }
    }
    maps_[k] = one.map;
    maps_[k].clip = one.clip * translation(eye - one.origin);
  }
  return std::span(maps_).first(casting.size());
}

// Those that let some light through, or those that let none.
void Shadows::draw_some(const One& one, Things& things, bool veils) {
  struct Group {
    Batch batch;
    std::vector<Instance> instances;
  };
  std::map<std::tuple<const StoredMesh*, bool, bool>, Group> groups;
  for (const std::uint32_t i : casters_) {
    const Thing& t = things[i];
    if (t.transparent != veils || t.look.transparency >= 0.5) continue;  // what lets half of it through casts none
    Mat4 world = t.world;
    for (int k = 0; k < 3; ++k) world(k, 3) -= one.origin[k];
    const Vec3 center = t.bounds.center - one.origin;
    const double away = one.map.perspective ? std::max(length(center) - t.size, 0.1 * t.size) : 1;
    const double texels = t.size / (away * one.map.texel);
    const bool ball = t.round && (!one.map.perspective || length(center) > 2 * t.bounds.radius());
    Mat4 local = scaling({t.shape->radius, t.shape->radius, t.shape->radius});
    StoredMesh* mesh = nullptr;
    if (ball) {
      mesh = things.store().disc(texels).get();
    } else {
      // Softened, a shadow's edge may be off by a good part of a texel.
      const Form::Realised& cast = t.form->at(Detail::for_pixels(0.4 * texels), things.store());
      mesh = cast.mesh.get(), local = cast.local;
    }
    Group& g = groups[{mesh, t.mirrored, t.closed}];
    g.batch = {mesh, nullptr, t.mirrored, t.closed, ball, false, 0, g.batch.count + 1};
    g.instances.push_back(instance_of(t, world * local));
  }
  std::vector<Instance> all;
  for (auto& [key, g] : groups) {
    g.batch.first = all.size();
    all.insert(all.end(), g.instances.begin(), g.instances.end());
  }
  instances_.set(std::move(all));
  for (const auto& [key, g] : groups) {
    glUseProgram(veils ? veils_.id() : g.batch.ball ? balls_.id() : meshes_.id());
    draw_triangles(g.batch, instances_, false);
  }
}

void Shadows::draw(One& one, std::size_t layer, Things& things, const Lighting::One& light) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, layers_.id(), 0, static_cast<GLint>(layer));
  glViewport(0, 0, map_size, map_size);
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
  const Vec3 at = light.sun ? light.place : Vec3{};
  for (const auto* program : {&meshes_, &balls_, &veils_}) {
    glUseProgram(program->id());
    glUniformMatrix4fv(gl::uniform(*program, "clip"), 1, GL_FALSE, to_float(one.clip).data());
    glUniform4f(gl::uniform(*program, "light"), static_cast<float>(at.x), static_cast<float>(at.y),
                static_cast<float>(at.z), light.sun ? 0 : 1);
  }
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDisable(GL_BLEND);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.5F, 2.0F);
  glCullFace(GL_FRONT);  // closed things cast by their far side: what faces the light is never in its own shadow
  for (const bool veils : {false, true}) draw_some(one, things, veils);
  glCullFace(GL_BACK);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

}  // namespace betwixt
