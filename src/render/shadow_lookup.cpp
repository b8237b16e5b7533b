// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/shading.h"

namespace betwixt {

const char* const shadow_lookup = R"(
// Where a map is looked up for a point on a surface towards n: a little above it, against shadows of itself, by as many
// texels as the light is slanting. The floor is in no map and casts none.
vec4 in_light(int i, vec3 spot, vec3 n, float nl) {
  mat4 m = shadow_clip[i];
#if defined(GROUND)
  return m * vec4(spot, 1.0);
#else
  float distance_to_light = dot(vec4(m[0].w, m[1].w, m[2].w, m[3].w), vec4(spot, 1.0));
  float texels = 0.4 + 2.0 * sqrt(max(1.0 - nl * nl, 0.0));
  return m * vec4(spot + texels * (shadow_shape[i].x + shadow_shape[i].y * distance_to_light) * n, 1.0);
#endif
}

// How much a map says: less towards its border, and nothing behind a lamp.
float within(vec4 seen, vec2 p) {
  vec2 border = clamp((1.0 - abs(2.0 * p - 1.0)) * 16.0, 0.0, 1.0);
  return seen.w > 0.0 ? border.x * border.y : 0.0;
}

#if defined(RICH)
// How much deeper the surface is in the map, along it; as steep as the light is wide at most.
vec2 slope(int i, vec4 seen, vec3 n) {
  vec3 a = normalize(cross(n, abs(n.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0))), b = cross(n, a);
  vec4 u = shadow_clip[i] * vec4(a, 0.0), v = shadow_clip[i] * vec4(b, 0.0);
  u.xyz = u.xyz * seen.w - seen.xyz * u.w, v.xyz = v.xyz * seen.w - seen.xyz * v.w;
  float d = u.x * v.y - u.y * v.x;
  vec2 g = vec2(u.z * v.y - v.z * u.y, u.x * v.z - v.x * u.z) / (abs(d) > 1e-30 ? d : 1e-30);
  return g * min(1.0, 0.7 / max(shadow_shape[i].z * length(g), 1e-30));
}

// How much of a light reaches a point, as a map has it, if it is wanted. Percentage-closer soft shadows: what is in the way, in the
// cone from the point to the light's disc, says by its mean depth how wide the penumbra is.
float lit_by(int i, vec4 seen, vec3 p, vec3 n, bool wanted) {
  float spread = shadow_shape[i].z, reach = min(spread * max(p.z - shadow_shape[i].w, 0.0), 0.1);
  bool soft = spread > 0.0;
  float blockers = 0.0, before = 0.0, nearby = 0.0, nearer = 0.0;
  int looks = wanted && reach > 0.0 ? SEEDS : 0;
  for (int k = 0; k < looks; ++k) {
    float away = seeds[k].z, out_there = reach * away * away * away;  // much denser in the middle: what is near stands there
    float there = texture(depths, vec3(p.xy + out_there * seeds[k].xy, i)).r, far = there < 1.0 ? spread * (p.z - there) : 0.0;
    float blocks = step(max(out_there * away, 1e-9), 1.5 * far);  // wider: it says where to look closely
    float close = blocks / max(far, 1e-9), close2 = close * close;
    far *= blocks;
    blockers += far, before += far * far, nearby += close2, nearer += close2 * close;
  }
  float radius = max(before / max(blockers, 1e-12), 0.5 * shadow_step);
  // If something near stands before something far, one penumbra for both would let light into the shadow of what is near, or
  // blur it. So each of them has its own, and the darker one counts.
  float near_radius = max(nearby / max(nearer, 1e-30), 0.5 * shadow_step);
  float apart = blockers > 0.0 ? 1.0 - smoothstep(0.5, 0.85, near_radius / radius) : 0.0;
  int taps = !wanted ? 0 : !soft ? TAPS * TAPS : blockers > 0.0 ? SEEDS : 0;
  vec2 tilt = vec2(0.0);
  float narrow = 0.0, sum = 0.0, sum_near = 0.0;
  for (int k = 0; k < (soft ? min(taps, 1) : 0); ++k) {  // a loop, since software skips nothing else
    tilt = slope(i, seen, n);
    // Where nothing stands right in the way, what is near counts in its own cone only.
    narrow = texture(shadows, vec4(p.xy, i, p.z)) * radius / (1.5 * spread);
  }
  for (int k = 0; k < taps; ++k) {
    vec2 off = soft ? radius * seeds[k].xy : (vec2(k % TAPS, k / TAPS) - 0.5 * float(TAPS - 1)) * shadow_step;
    sum += texture(shadows, vec4(p.xy + off, i, min(p.z - narrow * seeds[k].z + dot(tilt, off), 1.0)));
  }
  int more = apart > 0.0 && sum > 0.0 ? taps : 0;
  for (int k = 0; k < more; ++k) {
    vec2 off = near_radius * seeds[k].xy;
    sum_near += texture(shadows, vec4(p.xy + off, i, min(p.z + dot(tilt, off), 1.0)));
  }
  sum = more == 0 ? sum : min(sum, sum_near);
  return taps == 0 ? 1.0 : sum / float(taps);
}

// How much of a light reaches a point: its maps say, the finest first, and where that ends the next.
float lit(int light, vec3 spot, vec3 n, float nl, bool wanted) {
  float left = 1.0, sum = 0.0;
  int end = wanted ? shadow_end[light] : 0;
  for (int i = light == 0 ? 0 : shadow_end[light - 1]; i < end; ++i) {
    vec4 seen = in_light(i, spot, n, nl);
    vec3 p = seen.xyz / seen.w * 0.5 + 0.5;  // deeper than 1 where nothing is that casts
    float part = left * within(seen, p.xy);
    sum += part * lit_by(i, seen, p, n, part > 0.0), left -= part;
    end = left > 0.0 ? end : 0;
  }
  return sum + left;
}
#else
// How much of the first light reaches a point, as a map has it, if it is wanted.
float lit_by(int i, vec3 p, bool wanted) {
  p.z = min(p.z, 1.0);
  float sum = 0.0;
#if defined(LEVELS)
  int rows = wanted ? TAPS : 0;
#else
  const int rows = TAPS;
#endif
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < TAPS; ++x) {
      vec2 off = (vec2(x, y) - 0.5 * float(TAPS - 1)) * shadow_step;
      sum += texture(shadows, vec4(p.xy + off, i, p.z));
    }
  return sum * (1.0 / float(TAPS * TAPS));
}

// As above, of the first light.
float lit(vec3 spot, vec3 n) {
  vec3 to = light_place[0].xyz - light_place[0].w * spot;
  float nl = dot(n, to) * inversesqrt(max(dot(to, to), 1e-30)), left = 1.0, sum = 0.0;
#if defined(LEVELS)
  int end = nl > 0.0 ? shadow_end[0] : 0;
  for (int i = 0; i < end; ++i) {
#else
  const int i = 0;
  {
#endif
    vec4 seen = in_light(i, spot, n, nl);
    vec3 p = seen.xyz / seen.w * 0.5 + 0.5;
    float part = left * within(seen, p.xy);
    sum += part * lit_by(i, p, part > 0.0), left -= part;
#if defined(LEVELS)
    end = left > 0.0 ? end : 0;
#endif
  }
  return sum + left;
}
#endif

)";

}  // namespace betwixt
