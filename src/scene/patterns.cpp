// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/patterns.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace betwixt {

namespace shader {

// The part of GLSL that patterns.inc needs.
struct vec2 {
  float x, y;
  vec2(float x_, float y_) : x(x_), y(y_) {}
};
struct vec3 {
  float x = 0, y = 0, z = 0;
  vec3() = default;
  template <class X, class Y, class Z>
  vec3(X x_, Y y_, Z z_) : x(static_cast<float>(x_)), y(static_cast<float>(y_)), z(static_cast<float>(z_)) {}
};
inline vec2 operator+(vec2 a, vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline vec2 operator-(vec2 a, vec2 b) { return {a.x - b.x, a.y - b.y}; }
inline vec2 operator*(vec2 a, float s) { return {a.x * s, a.y * s}; }
inline vec3 operator+(vec3 a, vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline vec3 operator-(vec3 a, vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline vec3 operator*(vec3 a, vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline vec3 operator*(vec3 a, float s) { return {a.x * s, a.y * s, a.z * s}; }
inline float dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline float length(vec3 a) { return std::sqrt(dot(a, a)); }
inline float floor(float x) { return std::floor(x); }
inline vec2 floor(vec2 v) { return {floor(v.x), floor(v.y)}; }
inline vec3 floor(vec3 v) { return {floor(v.x), floor(v.y), floor(v.z)}; }
inline float fract(float x) { return x - std::floor(x); }
inline vec3 fract(vec3 v) { return {fract(v.x), fract(v.y), fract(v.z)}; }
inline float abs(float x) { return std::fabs(x); }
inline float sqrt(float x) { return std::sqrt(x); }
inline float min(float a, float b) { return a < b ? a : b; }
inline float max(float a, float b) { return a < b ? b : a; }
inline float clamp(float x, float low, float high) { return min(max(x, low), high); }
inline float mix(float a, float b, float s) { return a + s * (b - a); }
inline vec3 mix(vec3 a, vec3 b, float s) { return a + (b - a) * s; }
inline float smoothstep(float from, float to, float x) {
  const float s = clamp((x - from) / (to - from), 0.0F, 1.0F);
  return s * s * (3.0F - 2.0F * s);
}

#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wimplicit-float-conversion"
#define BETWIXT_SHADER(...) __VA_ARGS__
#include "scene/patterns.inc"
#undef BETWIXT_SHADER
#pragma clang diagnostic pop

vec3 narrow(Vec3 v) { return {v.x, v.y, v.z}; }

}  // namespace shader

#define BETWIXT_SHADER(...) #__VA_ARGS__
const char* const pattern_shader =
#include "scene/patterns.inc"
    ;
#undef BETWIXT_SHADER

PatternPoint pattern_at(const Finish& f, Vec3 color, Vec3 at, Vec3 normal, double width) {
  const shader::Patterned made =
      shader::patterned(static_cast<int>(f.pattern), shader::narrow(at), shader::narrow(normal),
                        static_cast<float>(width), shader::narrow(color), shader::narrow(f.second),
                        static_cast<float>(f.roughness), static_cast<float>(f.metalness));
  return {{static_cast<double>(made.color.x), static_cast<double>(made.color.y), static_cast<double>(made.color.z)},
          static_cast<double>(made.rough),
          static_cast<double>(made.metal),
          static_cast<double>(made.height)};
}

PatternPoint mean_of_pattern(const Finish& f, Vec3 color) {
  constexpr int count = 6000;
  constexpr double wide = 4;  // several bricks and boards
  PatternPoint mean;
  for (int k = 0; k < count; ++k) {
    // Points that fill a cube evenly: multiples of three roots, without their whole numbers.
    const auto part = [&](double step) { return wide * (k * step - std::floor(k * step)); };
    const Vec3 at{part(0.8191725134), part(0.6710436067), part(0.5497004779)};
    const std::array<Vec3, 3> across{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const PatternPoint p = pattern_at(f, color, at, across[static_cast<std::size_t>(k % 3)], 0);
    mean.color = mean.color + 1.0 / count * p.color;
    mean.roughness += p.roughness / count, mean.metalness += p.metalness / count, mean.height += p.height / count;
  }
  return mean;
}

}  // namespace betwixt
