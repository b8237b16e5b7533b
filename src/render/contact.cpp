// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/contact.h"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace betwixt {
namespace {

constexpr int seen_unit = 0, depth_unit = 1, closed_unit = 2;

// What is deeper than FARTHEST is the background, or a floor so far away that its depths are all the same.
const char* const common = R"(
uniform highp sampler2D depths;
uniform vec2 lens;         // metres before the eye, or their inverse, are x + y * depth
uniform float perspective;
uniform vec2 across;       // metres from the middle to the border, one before the eye (perspective) or anywhere
uniform vec2 middle_at;    // where the axis meets the picture, in its halves
uniform vec2 size;         // of `depths`
uniform float radius;      // in pixels of `depths`
float away(float depth) {
  float d = lens.x + lens.y * depth;
  return perspective > 0.5 ? 1.0 / d : d;
}
float depth_at(ivec2 at) { return texelFetch(depths, at, 0).r; }
// How many metres a depth more is, there; and how many the radius is.
float metres(float z) { return abs(lens.y) * mix(1.0, z * z, perspective); }
float reach(float z) { return radius * 2.0 * across.y / size.y * mix(1.0, z, perspective); }

// What depth grows by from pixel to pixel, on the side where those next to it are more in line with it, as depths of a plane
// are, with half of what they are not, as on a ball; and how much they are not.
vec2 slope(ivec2 at, ivec2 off, float depth) {
  ivec2 a = at - 2 * off, b = at + 2 * off;
  float a1 = depth_at(max(at - off, 0)), a2 = depth_at(max(a, 0));
  float b1 = depth_at(min(at + off, ivec2(size) - 1)), b2 = depth_at(min(b, ivec2(size) - 1));
  float bent_a = any(lessThan(a, ivec2(0))) ? 1e9 : abs(2.0 * a1 - a2 - depth);
  float bent_b = any(greaterThanEqual(b, ivec2(size))) ? 1e9 : abs(2.0 * b1 - b2 - depth);
  return bent_a < bent_b ? vec2(1.5 * depth - 2.0 * a1 + 0.5 * a2, bent_a) : vec2(2.0 * b1 - 0.5 * b2 - 1.5 * depth, bent_b);
}
vec3 slopes(ivec2 at, float depth) {
  vec2 x = slope(at, ivec2(1, 0), depth), y = slope(at, ivec2(0, 1), depth);
  return vec3(x.x, y.x, max(x.y, y.y));
}
)";

// The share of the light from everywhere, by its cosine, that what is nearby keeps away: in slices through the line of
// sight, each half of them in 32 parts of the same light. What is met closes the parts from its front to some way
// behind it (Therrien et al. 2023, "Screen space indirect lighting with visibility bitmask"), the fewer times the
// farther away it is in space: beyond the radius never, whatever covers it in the picture. A pattern of pixels, PATTERN
// along a side, turns the slices, moves the steps and says how far away is too far.
const char* const measure_fragment = R"(
out vec4 color;
vec3 place(vec2 at, float z) { return vec3((2.0 * (at + 0.5) / size - 1.0 - middle_at) * across * mix(1.0, z, perspective), z); }
// The share in a slice from the line of sight up to an angle c and s are of, where the normal's are x and y; less what is the same.
float up_to(float angle, float c, float s, vec2 normal) {
  return 0.5 * angle * normal.y - 0.25 * ((2.0 * c * c - 1.0) * normal.x + 2.0 * c * s * normal.y);
}
uint parts_up_to(float share) {
  int count = int(floor(clamp(share, 0.0, 33.0)));
  return count >= 32 ? 0xffffffffu : (1u << uint(count)) - 1u;
}
float count_of(uint bits) {
  bits -= (bits >> 1u) & 0x55555555u;
  bits = (bits & 0x33333333u) + ((bits >> 2u) & 0x33333333u);
  return float((((bits + (bits >> 4u)) & 0x0f0f0f0fu) * 0x01010101u) >> 24u);
}
void main() {
  ivec2 last = ivec2(size) - 1, cell = ivec2(gl_FragCoord.xy), middle = min(SIDE2 * cell + SIDE2 / 2, last);
  float depth = depth_at(middle), z = away(depth), far = reach(z);
  vec3 s = slopes(middle, depth);
  vec3 here = place(vec2(middle), z), to_eye = -normalize(mix(vec3(0.0, 0.0, 1.0), here, perspective));
  vec3 n = cross(place(vec2(middle) + vec2(1.0, 0.0), away(depth + s.x)) - here,
                 place(vec2(middle) + vec2(0.0, 1.0), away(depth + s.y)) - here);
  n *= inversesqrt(max(dot(n, n), 1e-30));
  n *= dot(n, to_eye) < 0.0 ? -1.0 : 1.0;
  // What is so narrow, or curves so much, that it shows no plane is left as it is.
  float known = clamp(1.5 - 0.7 * s.z * metres(z) * radius / far, 0.0, 1.0);
  // What rises less than this above the plane does not count: depths have 24 bits.
  float bias = 0.03 + 4.0 * metres(z) * 6e-8 * radius / far;
  vec2 own = vec2(cell % PATTERN), all = vec2(1.0, PATTERN) / float(PATTERN * PATTERN);
  float turn = dot(own, all), start = dot(own.yx, all) + 0.5 / float(PATTERN * PATTERN);
  float sum = 0.0;
  int slices = depth < FARTHEST && known > 0.0 ? SLICES : 0;
  for (int k = 0; k < slices; ++k) {
    float phi = (float(k) + turn) * 3.14159265 / float(SLICES);
    vec2 way = vec2(cos(phi), sin(phi));
    vec3 aside = vec3(way, 0.0) - dot(vec3(way, 0.0), to_eye) * to_eye;
    aside *= inversesqrt(max(dot(aside, aside), 1e-30));
    vec2 normal = vec2(dot(n, to_eye), dot(n, aside));
    float share = max(length(normal), 1e-6);
    normal /= share;
    for (int side = -1; side <= 1; side += 2) {
      float f = float(side), too_far = fract(turn + 0.618034 * float(2 * k + (side + 1) / 2));
      float plane = up_to(atan(normal.y, normal.x) + f * 1.57079633, -f * normal.y, f * normal.x, normal);
      float whole = plane + 0.25 * normal.x, scale = 32.0 / max(whole, 1e-6);
      uint closed = 0u;
      for (int j = 0; j < STEPS; ++j) {
        float t = (float(j) + start) / float(STEPS);
        ivec2 at = middle + side * ivec2(round((1.0 + (radius - 1.0) * t * t) * way)), inside = clamp(at, ivec2(0), last);
        float there = depth_at(inside);
        vec3 v = place(vec2(inside), away(there)) - here, w = v - THICK * far * to_eye;
        float part = dot(v, v) / (far * far);
        v *= inversesqrt(max(dot(v, v), 1e-30)), w *= inversesqrt(max(dot(w, w), 1e-30));
        float near = at == inside && there < FARTHEST ? max(1.0 - part * part, 0.0) : 0.0;
        near *= near * clamp(dot(v, n) / bias - 1.0, 0.0, 1.0);
        float c = clamp(dot(v, to_eye), -1.0, 1.0), d = clamp(dot(w, to_eye), -1.0, 1.0);
        float front = plane - up_to(f * acos(c), c, f * sqrt(1.0 - c * c), normal);
        float back = dot(w, n) > 0.0 ? plane - up_to(f * acos(d), d, f * sqrt(1.0 - d * d), normal) : 0.0;
        if (near > too_far) closed |= parts_up_to(front * scale + start) & ~parts_up_to(back * scale + start);
      }
      sum += share * whole * count_of(closed) / 32.0;
    }
  }
  color = vec4(min(known * sum / float(SLICES), 1.0), known, 0.0, 1.0);
}
)";

// The mean of the whole pattern, densest in the middle, where it lies in the plane of what is in their middle.
const char* const smooth_fragment = R"(
uniform sampler2D closed;
out vec4 color;
void main() {
  ivec2 cell = ivec2(gl_FragCoord.xy), end = ivec2(size) - 1, last = textureSize(closed, 0) - 1;
  ivec2 middle = min(SIDE2 * cell, end);
  float depth = depth_at(middle), z = away(depth), scale = 13.0 * metres(z) / reach(z);
  vec3 s = slopes(middle, depth);
  float sum = 0.0, all = 0.0;
  const int side = 2 * PATTERN;
  int looks = depth < FARTHEST ? side * side : 0;
  for (int k = 0; k < looks; ++k) {
    ivec2 off = ivec2(k % side, k / side) - PATTERN, there = clamp(cell + off, ivec2(0), last);
    vec2 middling = 1.0 - abs(vec2(off) + 0.5) / float(PATTERN);  // each part of the pattern counts the same
    ivec2 at = min(SIDE2 * there + SIDE2 / 2, end);
    float apart = abs(depth_at(at) - depth - dot(s.xy, vec2(at - middle))) * scale;
    vec2 measured = texelFetch(closed, there, 0).rg;
    float weight = middling.x * middling.y * measured.g * max(1.0 - apart, 0.0) + 1e-4;
    sum += weight * measured.r, all += weight;
  }
  color = vec4(sum / max(all, 1e-30));
}
)";

const char* const darken_fragment = R"(
uniform sampler2D seen, closed;
uniform float bounces;  // 1: light comes from surfaces around too, most of it where much is closed
out vec4 color;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy), last = textureSize(closed, 0) - 1, corner = at / SIDE2;
  float depth = depth_at(at), receives = texelFetch(seen, at, 0).a, z = away(depth), scale = 3.0 * metres(z) / reach(z);
  vec2 part = vec2(at - SIDE2 * corner) / float(SIDE2);
  float sum = 0.0, all = 0.0;
  int looks = depth < FARTHEST && receives > 0.0 ? 4 : 0;
  for (int k = 0; k < looks; ++k) {  // of its neighbours, those that are as far away
    ivec2 off = ivec2(k & 1, k >> 1), there = min(corner + off, last);
    vec2 w = mix(1.0 - part, part, vec2(off));
    float apart = (depth_at(min(SIDE2 * there, ivec2(size) - 1)) - depth) * scale;
    float weight = w.x * w.y / (1e-3 + apart * apart);
    sum += weight * texelFetch(closed, there, 0).r, all += weight;
  }
  if (sum <= 0.0) discard;  // to the byte as it was
  float share = sum / all;
  color = vec4(vec3(1.0 - receives * share * mix(1.0, 0.4 + 0.6 * share, bounces)), 1.0);
}
)";

}  // namespace

Result<ContactShading> ContactShading::create(const Canvas& canvas) {
  ContactShading c;
  const int width = canvas.width() * canvas.side(), height = canvas.height() * canvas.side();
  auto seen = gl::new_target(canvas.format(), GL_DEPTH24_STENCIL8, width, height);
  if (!seen) return seen.error();
  c.seen_ = *std::move(seen);
  for (gl::Target* t : {&c.closed_, &c.smooth_}) {
    auto made = gl::new_target(GL_RGBA8, 0, (canvas.width() + 1) / 2, (canvas.height() + 1) / 2);
    if (!made) return made.error();
    *t = *std::move(made);
  }
  const std::string defines = fmt::format(
      "#define SIDE2 {}\n#define SLICES 4\n#define STEPS 9\n#define THICK 1.0\n#define PATTERN {}\n#define FARTHEST "
      "0.99999\n",
      2 * canvas.side(), canvas.height() < 500 ? 2 : 4);
  for (const auto& [program, fragment] :
       {std::pair{&c.measure_, measure_fragment}, {&c.even_, smooth_fragment}, {&c.darken_, darken_fragment}}) {
    auto made = gl::new_program(gl::fill_vertex, std::string(common) + fragment, defines);
    if (!made) return made.error();
    *program = *std::move(made);
    gl::set_samplers(*program, {{"depths", depth_unit}, {"seen", seen_unit}, {"closed", closed_unit}});
  }
  return c;
}

void ContactShading::set(const gl::Program& program, const Canvas& canvas, const View& view) const {
  const auto at = [&](const char* name) { return gl::uniform(program, name); };
  const auto put = [&](const char* name, double x, double y) {
    glUniform2f(at(name), static_cast<float>(x), static_cast<float>(y));
  };
  glUseProgram(program.id());
  const double n = view.near, f = view.far;
  glUniform1f(at("perspective"), view.orthographic ? 0 : 1);
  if (view.orthographic)
    put("lens", n, f - n);
  else
    put("lens", 1 / n, 1 / f - 1 / n);
  put("across", 1 / view.sx, 1 / view.sy);
  put("middle_at", view.shift_x, -view.shift_y);
  put("size", seen_.width, seen_.height);
  glUniform1f(at("radius"), static_cast<float>(contact_reach * canvas.height() * canvas.side()));
}

void ContactShading::draw(const Canvas& canvas, const View& view, bool bounces) const {
  canvas.copy_to(seen_);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  gl::use_texture(seen_unit, seen_.color.id());
  gl::use_texture(depth_unit, seen_.depth.id());
  closed_.bind();
  set(measure_, canvas, view);
  gl::fill();
  gl::use_texture(closed_unit, closed_.color.id());
  smooth_.bind();
  set(even_, canvas, view);
  gl::fill();
  gl::use_texture(closed_unit, smooth_.color.id());
  canvas.bind();
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
  canvas.write_linear();
  set(darken_, canvas, view);
  glUniform1f(gl::uniform(darken_, "bounces"), bounces ? 1 : 0);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ZERO, GL_SRC_COLOR);
  gl::fill();
  glDisable(GL_BLEND);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace betwixt
