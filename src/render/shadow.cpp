// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/shadow.h"

#include <algorithm>

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

// What the map must show finely: all casters but those that dwarf the rest (grounds and walls), whose own shadows
// nobody misses.
Ball subject(const std::vector<const Thing*>& casters) {
  std::vector<const Thing*> by_size = casters;
  std::stable_sort(by_size.begin(), by_size.end(),
                   [](const Thing* a, const Thing* b) { return a->bounds.radius() < b->bounds.radius(); });
  Ball all{by_size.front()->bounds.center, by_size.front()->bounds.radius()};
  for (const Thing* t : by_size) {
    if (t->bounds.radius() > 4 * all.radius) break;
    all = around(all, {t->bounds.center, t->bounds.radius()});
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

Result<Shadow> Shadow::create() {
  Shadow s;
  auto target = gl::new_target(0, GL_DEPTH_COMPONENT24, map_size, map_size);
  if (!target) return target.error();
  const std::string source = std::string(vertex_inputs) + uniforms + ball_outline + shadow_vertex;
  for (auto* to : {&s.meshes_, &s.balls_, &s.veils_}) {
    auto program = gl::new_program(source, shadow_fragment,
                                   to == &s.balls_   ? "#define BALL"
                                   : to == &s.veils_ ? "#define VEIL"
                                                     : "");
    if (!program) return program.error();
    *to = *std::move(program);
  }
  s.target_ = *std::move(target);
  s.instances_ = gl::new_buffer();
  glBindTexture(GL_TEXTURE_2D, s.target_.depth.id());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  return s;
}

void Shadow::draw(const std::vector<const Thing*>& casters, const Lighting::One& light) {
  target_.bind();
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
  if (casters.empty()) return;
  Ball ball = subject(casters);
  perspective_ = !light.sun;
  Mat4 projection;
  if (light.sun) {
    // Measured and placed in steps, so that edges do not swim while things move about.
    ball.radius = std::exp2(std::ceil(std::log2(ball.radius) * 4) / 4) * 1.02;
    texel_ = 2 * ball.radius / map_size;
    Mat4 view = looking({0, 0, 0}, light.place);
    const Vec3 c = transform_point(view, ball.center);
    double low = c.z - ball.radius, high = c.z + ball.radius;
    for (const Thing* t : casters) {
      const double z = transform_point(view, t->bounds.center).z, r = t->bounds.radius();
      high = std::max(high, z + r), low = std::min(low, z - r);
    }
    projection(0, 0) = projection(1, 1) = 1 / ball.radius;
    projection(0, 3) = -std::round(c.x / texel_) * texel_ / ball.radius;
    projection(1, 3) = -std::round(c.y / texel_) * texel_ / ball.radius;
    projection(2, 2) = -2 / (high - low), projection(2, 3) = (high + low) / (high - low);
    clip_ = projection * view;
  } else {
    const Vec3 back = light.place - ball.center;
    const double d = std::max(length(back), 1e-9);
    const double tangent =
        d > ball.radius ? std::min(ball.radius / std::sqrt(d * d - ball.radius * ball.radius), 2.5) : 2.5;
    texel_ = 2 * tangent / map_size;
    const double far = std::max(light.range, 1e-6), near = far * 1e-3;
    projection(0, 0) = projection(1, 1) = 1 / tangent;
    projection(2, 2) = -(far + near) / (far - near), projection(2, 3) = -2 * far * near / (far - near);
    projection(3, 2) = -1, projection(3, 3) = 0;
    clip_ = projection * looking(light.place, normalize(back, {0, 1, 0}));
  }
  for (const auto* program : {&meshes_, &balls_, &veils_}) {
    glUseProgram(program->id());
    glUniformMatrix4fv(gl::uniform(*program, "clip"), 1, GL_FALSE, to_float(clip_).data());
    const Vec3 p = light.place;
    glUniform4f(gl::uniform(*program, "light"), static_cast<float>(p.x), static_cast<float>(p.y),
                static_cast<float>(p.z), light.sun ? 0 : 1);
  }
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDisable(GL_BLEND);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.5F, 2.0F);
  glCullFace(GL_FRONT);  // closed things cast by their far side: what faces the light is never in its own shadow
  for (const bool veils : {false, true}) {
    std::vector<const Thing*> some;
    for (const Thing* t : casters)
      if (t->transparent == veils) some.push_back(t);
    const Batches batches = batches_of(some, true);
    send_instances(instances_, batches.instances);
    for (const Batch& b : batches.batches) {
      glUseProgram(veils ? veils_.id() : b.ball ? balls_.id() : meshes_.id());
      draw_triangles(b, instances_, false);
    }
  }
  glCullFace(GL_BACK);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

}  // namespace betwixt
