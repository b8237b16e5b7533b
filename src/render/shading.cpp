// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/shading.h"

namespace betwixt {

const char* const surface_vertex = R"(
uniform mat4 clip;
uniform vec4 toward_eye;  // a direction and 0 (orthographic), or the origin and 1
#if defined(PHYSICAL)
uniform mat4 to_object;  // from mesh space
out vec3 local, local_facing;
#endif
#if defined(TEXTURED)
out vec2 place;
#endif
#if defined(BALL)
out vec3 disc;         // the same as `at` in mesh space
flat out vec4 e;       // the eye in mesh space
flat out vec3 move, turn;  // what e is to positions and normals
#endif
out vec3 at, facing;
flat out vec4 paint;
flat out vec2 gloss;
vec3 normal_of(vec3 n) { return normal_x * n.x + normal_y * n.y + normal_z * n.z; }
void main() {
  vec4 p = vec4(position, 1.0);
  facing = normal_of(normal);
#if defined(TEXTURED)
  place = uv;
#endif
  place_gradient(p);
#if defined(BALL)
  p.xyz = outline(position.xy, toward_eye, e);
  disc = p.xyz;
  facing = normal_of(disc);
  turn = normal_of(e.xyz);
  move = (1.0 - e.w) * toward_eye.xyz;
#endif
#if defined(PHYSICAL)
  local = (to_object * p).xyz;
  local_facing = transpose(inverse(mat3(to_object))) * normal;
#endif
  at = vec3(dot(row_x, p), dot(row_y, p), dot(row_z, p));
  paint = color;
  gloss = look;
  gl_Position = clip * vec4(at, 1.0);
}
)";

const char* const surface_inputs = R"(
#if defined(GROUND)
in vec2 at;
uniform vec4 floor_color;                     // and 1, or 0 where there is none
uniform float floor_height;                   // in eye space
uniform vec3 ray, ray_x, ray_y, from_x, from_y;  // through the picture's middle, and what its borders add
uniform vec3 top, bottom, under;              // of the background; of the sky: above, at the horizon, below
uniform vec2 shape;                           // 1: the background bends; 1: it is a sky
uniform float empty;                          // 1: there is nothing behind everything
#else
in vec3 at, facing;
flat in vec4 paint;
flat in vec2 gloss;
#endif
uniform vec4 toward_eye;
uniform vec4 part_color;  // and 1: the thing's own colour multiplies it
uniform float unlit;     // 1: all show their own colours
uniform vec3 fog_color;
uniform vec2 fog_range;  // metres, and 1 / how many there are from nothing to all
uniform int lights;
uniform vec4 light_place[16];  // a position and 1, or a direction and 0
uniform vec4 light_color[16];  // and 1 / range², 0 for suns
uniform vec3 sky, ground;
#if defined(RECEIVES)
uniform float receives;  // 1: alpha says how much contact shading there is, 0: opacity
#endif
uniform float encodes;      // 1: colours are written encoded, 0: as linear light
uniform sampler2DArrayShadow shadows;  // a layer for each of the first lights
uniform float shadow_step;             // between look-ups, in the map's measure
uniform mat4 shadow_clip[MAPS];
uniform vec4 shadow_shape[MAPS];  // of a texel, metres across, and the same per metre of distance; spread, top
uniform int shadow_end[CASTERS];  // which of the maps is the first that is no longer that light's
#if defined(RICH)
uniform int casting;            // how many lights cast
uniform sampler2DArray depths;  // the same layers, as they are
uniform vec3 seeds[SEEDS];      // points of a disc of radius 1, evenly spread, and how far they are from its middle
#if !defined(GROUND)
uniform vec4 floor_color;  // and 1, or 0 where there is none
uniform float floor_height;
uniform vec3 top, bottom, under;  // what metals mirror: from above, from the horizon, from below
#endif
#endif
#if defined(TEXTURED)
in vec2 place;
uniform sampler2D picture;
#elif defined(BALL)
in vec3 disc;
flat in vec4 e;
flat in vec3 move, turn;
#endif
uniform vec4 depth_row, w_row;  // of the clip matrix
out vec4 color;

)";

const char* const surface_functions = R"(
// What is brighter than can be shown rolls off, and goes over into white: Khronos' neutral tone mapping without its toe.
vec3 rolled(vec3 c) {
#if defined(OPEN)
  return c;
#endif
  const float start = 0.8, room = 1.0 - start;
  float peak = max(c.r, max(c.g, c.b)), over = max(peak - start, 0.0);
  float shown = peak - over + room * over / (room + over);
  return mix(c * (shown / max(peak, 1e-30)), vec3(shown), 1.0 - 1.0 / (0.15 * (peak - shown) + 1.0));
}

#if defined(BALL)
// From the disc along the line of sight to the sphere: how far, and 1 / the length of that line.
vec2 onto_ball(vec3 from, vec4 eye) {
  vec3 along = from * eye.w - eye.xyz;
  float stretch = inversesqrt(max(dot(along, along), 1e-30));
  along *= stretch;
  float b = dot(from, along);
  return vec2(-b - sqrt(max(b * b - dot(from, from) + 1.0, 0.0)), stretch);
}
#endif
)";

const char* const surface_fragment = R"(
// Sky above, ground below, a soft horizon between.
vec3 surroundings(float up, float blur) {
  return mix(ground, sky, clamp(0.5 + up / (0.35 + 1.65 * blur), 0.0, 1.0));
}

#if defined(RICH) && !defined(GROUND)
// What is left of light where so much of it is mirrored. In the wide primaries of BT.2020, as light and metals have spectra:
// in those of sRGB a blue sky has too little red for gold, which would be green.
const mat3 wide = mat3(0.6274, 0.0691, 0.0164, 0.3293, 0.9195, 0.0880, 0.0433, 0.0114, 0.8956);
const mat3 narrow = mat3(1.6605, -0.1246, -0.0182, -0.5876, 1.1329, -0.1006, -0.0728, -0.0083, 1.1187);
vec3 tinted(vec3 light, vec3 share) { return max(narrow * (wide * light * (wide * share)), 0.0); }

// What a metal mirrors along d: what is above, and the floor as it is lit where it is met, without shadows, which would be
// stains without the things; the rougher, the less sharp.
vec3 mirrored(vec3 from, vec3 d, float blur, bool wanted) {
  float up = 1.0 - clamp(d.y, 0.0, 1.0), dim = 0.02 + 0.6 * blur;
  vec3 above = mix(mix(top, bottom, up * up), mix(top, bottom, 0.6), smoothstep(0.08, 0.5, blur));
  vec3 spot = from + max(from.y - floor_height, 0.0) / max(-d.y, 0.02 + 0.4 * blur) * d, light = sky;
  spot.y = floor_height;
  int count = wanted && floor_color.a > 0.0 && d.y < dim ? lights : 0;
  for (int i = 0; i < count; ++i) {
    vec3 to = light_place[i].xyz - light_place[i].w * spot;
    float d2 = max(dot(to, to), 1e-30), window = max(1.0 - d2 * light_color[i].w, 0.0);
    float strength = max(to.y * inversesqrt(d2), 0.0) * window * window;
    light += light_color[i].rgb * strength;
  }
  return mix(mix(under, floor_color.rgb * light, floor_color.a), above, smoothstep(-dim, dim, d.y));
}
#endif

#if defined(GROUND)
// How much fog there is before the sky: the less, the higher one looks.
float haze(float up) {
  float low = 1.0 - clamp(up, 0.0, 1.0), low2 = low * low;
  return fog_range.y > 0.0 ? low2 * low2 * low2 * low2 : 0.0;
}
// What is behind everything, where one looks along d and `down` from the picture's top.
vec3 behind(vec3 d, float down) {
  float up = 1.0 - clamp(d.y, 0.0, 1.0), below = clamp(-4.0 * d.y, 0.0, 1.0);
  vec3 sky_color = mix(mix(top, bottom, up * up), under, below * below * (3.0 - 2.0 * below));
  return mix(mix(top, bottom, mix(down, smoothstep(0.0, 1.0, down), shape.x)), mix(rolled(sky_color), fog_color, haze(d.y)), shape.y);
}
#endif

void main() {
#if defined(GROUND)
  vec2 p = 2.0 * at - 1.0;
  vec3 through = normalize(ray + p.x * ray_x + p.y * ray_y);
  vec3 back = behind(through, at.y);
  vec3 along = mix(ray, through, toward_eye.w), from = p.x * from_x + p.y * from_y;
  float drop = min(along.y, -1e-6), go = (floor_height - from.y) / drop;
  vec3 spot = from + max(go, 0.0) * along, across = vec3(0.0, 1.0, 0.0);
  // Where one looks along it, what is behind everything is seen in its place.
  float cover = go > 0.0 ? floor_color.a * drop * drop / (drop * drop + 1e-3) : 0.0;
  vec4 base = vec4(floor_color.rgb, 1.0), there = vec4(spot, 1.0);
  vec2 gloss = vec2(0.0, 1.0);
  gl_FragDepth = cover > 0.0 ? clamp(0.5 * dot(depth_row, there) / dot(w_row, there) + 0.5, 0.0, 0.9999998) : 1.0;
#else
  vec4 base = own_color();
#endif
#if defined(TEXTURED)
  base *= texture(picture, place);
#endif
  float metal = gloss.y == 2.0 ? 1.0 : 0.0;
  float glossy = gloss.y == 1.0 ? 0.0 : 1.0;
  float shine = gloss.x;
  float roughness = mix(0.8, 0.08, shine);
  float a = roughness * roughness, a2 = a * a;
  vec3 f0 = mix(vec3(0.045 * min(1.0, 0.25 + shine)), base.rgb, metal) * glossy;

#if !defined(GROUND)
  vec3 spot = at, across = facing;
#endif
#if defined(BALL)
  vec2 go = onto_ball(disc, e);
  spot += go.x * go.y * (at * e.w - move);
  across += go.x * go.y * (facing * e.w - turn);
  vec4 there = vec4(spot, 1.0);
  gl_FragDepth = 0.5 * dot(depth_row, there) / dot(w_row, there) + 0.5;
#endif
  vec3 n = across * inversesqrt(max(dot(across, across), 1e-30));
#if !defined(BALL) && !defined(GROUND)
  if (!gl_FrontFacing) n = -n;
#endif
  vec3 v = toward_eye.xyz - toward_eye.w * spot;
  v *= inversesqrt(max(dot(v, v), 1e-30));
  float nv = dot(n, v);

  vec3 diffuse = vec3(0.0), specular = vec3(0.0);
#if !defined(RICH)
  float unshadowed = lit(spot, n);
#endif
  for (int i = 0; i < lights; ++i) {
    vec3 to = light_place[i].xyz - light_place[i].w * spot;
    float d2 = max(dot(to, to), 1e-30);
    vec3 l = to * inversesqrt(d2);
    float nl = dot(n, l);
    float window = max(1.0 - d2 * light_color[i].w, 0.0);
    float strength = max(nl, 0.0) * window * window;
#if defined(RICH)
    if (i < casting) strength *= lit(i, spot, n, nl, strength > 0.0);
#else
    strength *= i == 0 ? unshadowed : 1.0;
#endif
    vec3 arriving = light_color[i].rgb * strength;
    diffuse += arriving;
    // GGX about the half vector h = l + v, of which only n·h and h·h are needed.
    float nh = nl + nv, hh = 2.0 + 2.0 * dot(l, v);
    float peak = hh / max(nh * nh * (a2 - 1.0) + hh, 1e-6);
    specular += arriving * (peak * peak);
  }
  specular *= a2 / (1.0 + 2.0 * roughness);
  vec3 r = 2.0 * nv * n - v;
  float rim = 1.0 - clamp(nv, 0.0, 1.0), rim2 = rim * rim;
  vec3 fresnel = f0 + (max(vec3(shine * shine * glossy), f0) - f0) * (rim2 * rim2 * rim);
  vec3 ambient = surroundings(n.y, 1.0);
  vec3 body = base.rgb * (1.0 - metal);
  vec3 soft = body * ambient;
  vec3 around = surroundings(r.y, roughness) * (1.0 + 2.0 * metal);
#if defined(RICH) && !defined(GROUND)
  vec3 around_metal = tinted(mirrored(spot, r, roughness, metal > 0.0), fresnel);
  vec3 shiny = specular * f0 + mix(fresnel * around, around_metal, metal);
#else
  vec3 shiny = specular * f0 + fresnel * around;
#endif
  float opacity = base.a;
  vec3 sum = (body * diffuse + soft) * opacity + shiny;
  opacity = opacity + (1.0 - opacity) * max(fresnel.r, max(fresnel.g, fresnel.b));
#if defined(RECEIVES)
  // Contact keeps the light from everywhere away; some of the lamps' too, which are no points.
  const vec3 luminance = vec3(0.2126, 0.7152, 0.0722);
  float open = dot(soft * base.a + shiny - specular * f0, luminance) / max(dot(sum, luminance), 1e-6);
  float received = mix(0.65, 1.0, clamp(open, 0.0, 1.0));
#endif
  bool glows = gloss.y == 3.0 || unlit > 0.5;
)";

const char* const surface_end = R"(
  sum = rolled(sum);
  color = glows ? vec4(base.rgb * base.a, base.a) : vec4(sum, opacity);
  float far = mix(-dot(spot, toward_eye.xyz), length(spot), toward_eye.w);
  color.rgb = mix(color.rgb, fog_color * color.a, clamp((far - fog_range.x) * fog_range.y, 0.0, 1.0));
#if defined(GROUND)
  color.rgb = mix(back, color.rgb, cover);
  color.a = mix(color.a, cover, empty);
#endif
#if defined(RECEIVES)
  received *= glows ? 0.0 : 1.0 - clamp((far - fog_range.x) * fog_range.y, 0.0, 1.0);
#if defined(GROUND)
  received *= cover;
#endif
  color.a = mix(color.a, received, receives);
#endif
  color.rgb = mix(color.rgb, encoded(color.rgb), encodes);
}
)";

}  // namespace betwixt
