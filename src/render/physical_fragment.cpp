// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/physical_shading.h"

namespace betwixt {

const char* const physical_fragment = R"(
vec3 in_sky(vec3 d) { return vec3(sky_turn.x * d.x - sky_turn.y * d.z, d.y, sky_turn.y * d.x + sky_turn.x * d.z); }
vec3 irradiance_at(vec3 in_world) {
  vec3 n = in_sky(in_world);
  vec3 sum = irradiance[0] + irradiance[1] * n.y + irradiance[2] * n.z + irradiance[3] * n.x + irradiance[4] * (n.x * n.y) +
             irradiance[5] * (n.y * n.z) + irradiance[6] * (3.0 * n.z * n.z - 1.0) + irradiance[7] * (n.x * n.z) +
             irradiance[8] * (n.x * n.x - n.y * n.y);
  return sky_turn.z * max(sum, 0.0);
}

// The share of light that a rough surface reflects from all around: for a reflectance of 0 and what a reflectance adds.
vec2 reflected_shares(float nv, float rough) {
  vec4 r = rough * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
  float edge = 1.0 - nv, edge2 = edge * edge;
  float a = min(r.x * r.x, edge2 * edge2 * edge2) * r.x + r.y;
  return vec2(-1.04, 1.04) * a + r.zw;
}

// How much fog there is before the sky: the less, the higher one looks.
float haze(float up) {
  float low = 1.0 - clamp(up, 0.0, 1.0), low2 = low * low;
  return sky_turn.w * low2 * low2 * low2 * low2;
}

// What a surface of this roughness mirrors from a direction: see SkyLight::roughness_of.
vec3 mirrored_from(vec3 d, float rough) {
  float level = blurs * rough * (2.0 - rough);
  vec3 c = sky_turn.z * textureLod(around, in_sky(d), level).rgb;
  c = blurs > 0.0 && level > blurs - 1.0 ? mix(c, irradiance_at(d), min(level - blurs + 1.0, 1.0)) : c;
  return mix(c, fog_color, haze(d.y) * (1.0 - rough));
}
// What a rough surface mirrors is nearer to its normal, since light from below the horizon does not count.
float fourth_power(float rough) { return rough * rough * rough * rough; }

#if defined(COATED)
// The share of light from all around that a sheen reflects, as three.js has it: low at the front, high at the rim.
float sheen_albedo(float nv, float rough) {
  float inverse = 1.0 / (rough + 0.1), square = rough * rough;
  float a = -1.9362 + 1.0678 * rough + 0.4573 * square - 0.8469 * inverse;
  float b = -0.6014 + 0.5538 * rough - 0.4670 * square - 0.1255 * inverse;
  return min(exp(a * nv + b), 1.0);
}
#endif

#if defined(AREAS)
// A share of the light of a polygon: that of one of its edges.
vec3 edge_of(vec3 a, vec3 b) {
  float x = dot(a, b), y = abs(x);
  float v = (0.8543985 + (0.4965155 + 0.0145206 * y) * y) / (3.4175940 + (4.1616724 + y) * y);
  float angle = x > 0.0 ? v : 0.5 * inversesqrt(max(1.0 - x * x, 1e-7)) - v;
  return cross(a, b) * angle;
}
// The light of a rectangle on a surface, over pi; what of it is below the horizon is left out.
float light_of_area(vec3 middle, vec3 x, vec3 y, vec3 n) {
  vec3 a = normalize(middle - x - y), b = normalize(middle + x - y), c = normalize(middle + x + y), d = normalize(middle - x + y);
  vec3 f = edge_of(a, b) + edge_of(b, c) + edge_of(c, d) + edge_of(d, a);
  float l = length(f);
  float z = dot(middle, n) >= 0.0 ? abs(dot(f, n)) : -abs(dot(f, n));
  return max((l * l + z) / (l + 1.0), 0.0);
}
#endif

#if defined(GROUND)
const float half_pi = 1.5707963;
vec2 seen_at(vec3 d) {
  float across = abs(d.x) + abs(d.z) < 1e-6 ? 0.0 : atan(d.z, d.x);
  return vec2(across / (4.0 * half_pi) + 0.5, 0.5 - asin(clamp(d.y, -1.0, 1.0)) / (2.0 * half_pi));
}
vec3 disc_seen(vec3 d) {
  float off = length(cross(d, disc.xyz)) / max(disc.w, 1e-6), ahead = dot(d, disc.xyz) > 0.0 ? 1.0 : 0.0;
  return ahead * (1.0 - smoothstep(0.94, 1.06, off)) * smoothstep(-0.004, 0.004, d.y) * disc_color;
}
#else
#if defined(PICTURES)
vec2 laid(vec2 p) {
  p = vec2(turned.x * p.x - turned.y * p.y, turned.y * p.x + turned.x * p.y);
  return p * tile.xy + tile.zw;
}
vec2 at_picture;
#if defined(PROJECTED)
vec3 by_axis;
vec2 at_x, at_y, at_z;
vec4 looked(sampler2D from) {
  return texture(from, at_x) * by_axis.x + texture(from, at_y) * by_axis.y + texture(from, at_z) * by_axis.z;
}
#else
vec4 looked(sampler2D from) { return texture(from, at_picture); }
#endif
#endif
// `v` as far as it goes along a surface with the normal n: the facets of a mesh are not quite along it.
vec3 along(vec3 v, vec3 n) { return v - n * dot(n, v); }
// A normal on a surface whose height changes by `rise` to the next pixels, which are at x and y.
vec3 bumped(vec3 n, vec3 x, vec3 y, vec2 rise) {
  vec3 r1 = cross(y, n), r2 = cross(n, x);
  float det = dot(x, r1);
  vec3 made = abs(det) * n - sign(det) * (rise.x * r1 + rise.y * r2);
  return made * inversesqrt(max(dot(made, made), 1e-30));
}
#if defined(INNER)
// The share of light that a wall reflects inside, by the square of the sine of the angle to its normal.
float reflected_inside(float sine2, float ior, float f0) {
  float leaving = 1.0 - ior * ior * sine2, rim = 1.0 - sqrt(max(leaving, 0.0)), rim2 = rim * rim;
  return f0 + (1.0 - f0) * rim2 * rim2 * rim;
}
#endif
#if defined(THROUGH)
// Whether something nearer than this depth is at a place of the copied picture, or next to it.
bool stands_before(float depth, vec2 at, vec2 beside) {
  float least = 1.0;
  for (int i = 0; i < 9; ++i) least = min(least, texture(behind_depth, at + beside * vec2(i % 3 - 1, i / 3 - 1)).r);
  return least < depth - 1e-6;
}
// The place on the way from a pixel to where the bent ray leaves, as far along it as nothing stands before the surface.
vec2 place_behind(vec2 straight, vec2 bent, float depth, vec2 beside) {
  float good = 0.0, bad = 1.0;
  int tries = stands_before(depth, bent, beside) ? 6 : 0;
  for (int i = 0; i < tries; ++i) {
    float between = 0.5 * (good + bad);
    bool before = stands_before(depth, mix(straight, bent, between), beside);
    bad = before ? between : bad, good = before ? good : between;
  }
  return tries == 0 ? bent : mix(straight, bent, good);
}
#endif
#if defined(PATTERN)
vec3 in_pattern(vec3 p) {
  return vec3(pattern_tile.z * p.x - pattern_tile.w * p.y, pattern_tile.w * p.x + pattern_tile.z * p.y, p.z) * vec3(pattern_tile.x, pattern_tile.y, pattern_tile.x);
}
#endif
#endif

void main() {
  float metal = 0.0, rough = 1.0, dielectric = 1.0, strength = 1.0, open_to = 1.0;
  vec3 shines = vec3(0.0);
  bool glows = false;
#if defined(GROUND)
  vec2 p = 2.0 * at - 1.0;
  vec3 through_picture = normalize(ray + p.x * ray_x + p.y * ray_y);
  vec3 back = mix(mix(top, bottom, mix(at.y, smoothstep(0.0, 1.0, at.y), shape.x)), mix(rolled(sky_turn.z * texture(seen, seen_at(in_sky(through_picture))).rgb + disc_seen(through_picture)), fog_color, haze(through_picture.y)), shape.y);
  vec3 along = mix(ray, through_picture, toward_eye.w), from = p.x * from_x + p.y * from_y;
  float drop = min(along.y, -1e-6), go = (floor_height - from.y) / drop;
  vec3 spot = from + max(go, 0.0) * along, n = vec3(0.0, 1.0, 0.0);
  float cover = go > 0.0 ? floor_color.a * drop * drop / (drop * drop + 1e-3) : 0.0;
  vec4 base = vec4(floor_color.rgb, 1.0), there = vec4(spot, 1.0);
  dielectric = 0.0;
  gl_FragDepth = cover > 0.0 ? clamp(0.5 * dot(depth_row, there) / dot(w_row, there) + 0.5, 0.0, 0.9999998) : 1.0;
#else
  vec4 base = own_color();
  vec3 spot = at, across = facing, on = local, on_facing = local_facing;
#if defined(BALL)
  vec2 go = onto_ball(disc, e);
  spot += go.x * go.y * (at * e.w - move);
  across += go.x * go.y * (facing * e.w - turn);
  on_facing = disc + go.x * go.y * (disc * e.w - e.xyz);
  on = on_facing * ball_radius;
  vec4 there = vec4(spot, 1.0);
  gl_FragDepth = 0.5 * dot(depth_row, there) / dot(w_row, there) + 0.5;
#endif
  vec3 n = across * inversesqrt(max(dot(across, across), 1e-30));
#if !defined(BALL)
  if (!gl_FrontFacing) n = -n;
#endif
  vec3 smooth_n = n;
  metal = mix(gloss.y == 2.0 ? 1.0 : 0.0, base_finish.x, has_finish);
  rough = mix(gloss.y == 1.0 ? 1.0 : 0.8 - 0.75 * gloss.x, base_finish.y, has_finish);
  dielectric = mix(gloss.y == 1.0 ? 0.0 : 1.0, base_finish.z, has_finish);
  strength = base_finish.w;
  glows = gloss.y == 3.0;
  shines = emission;
#if defined(PICTURES)
#if defined(PROJECTED)
  vec3 w = abs(on_facing) / max(length(on_facing), 1e-30);
  w = w * w, w = w * w;
  by_axis = w / (w.x + w.y + w.z);
  at_x = laid(vec2(-sign(on_facing.x) * on.z, -on.y)), at_y = laid(vec2(on.x, sign(on_facing.y) * on.z)), at_z = laid(vec2(sign(on_facing.z) * on.x, -on.y));
  at_picture = by_axis.x > max(by_axis.y, by_axis.z) ? at_x : by_axis.y > by_axis.z ? at_y : at_z;
#else
  at_picture = laid(place);
#endif
  base *= looked(picture);
  rough *= looked(roughness_map).g, metal *= looked(metalness_map).b;
  open_to = looked(occlusion_map).r;
  shines *= looked(emission_map).rgb;
  vec3 bent = looked(normals).rgb * 2.0 - 1.0;
  vec3 px = dFdx(spot), py = dFdy(spot);
  vec2 ux = dFdx(at_picture), uy = dFdy(at_picture);
  // The rows of the target may go down or up.
  vec3 rx = cross(py, n), ry = cross(n, px);
  float way = dot(px, rx) < 0.0 ? -1.0 : 1.0;
  vec3 tangent = way * (rx * ux.x + ry * uy.x), other = way * (rx * ux.y + ry * uy.y);
  float size = max(dot(tangent, tangent), dot(other, other));
  // The pictures' rows go down, their normals' y goes up.
  vec3 made = size > 0.0 ? (tangent * bent.x - other * bent.y) * (strength * inversesqrt(size)) + n * max(bent.z, 0.0) : n;
  n = dot(made, made) > 1e-12 ? normalize(made) : n;
#endif
#if defined(PATTERN)
  vec3 on_x = dFdx(on), on_y = dFdy(on), wide = abs(in_pattern(on_x)) + abs(in_pattern(on_y)), m = normalize(on_facing);
  float widest = max(wide.x, max(wide.y, wide.z));
  on_x = along(on_x, m), on_y = along(on_y, m);
  Patterned has;
  float heights[3];
  // Each pixel works out its own slopes: differences that four pixels share show as blocks.
  for (int i = 0; i < pattern_points; ++i) {
    vec3 there = i == 0 ? on : i == 1 ? on + on_x : on + on_y;
    Patterned one = patterned(pattern_kind, in_pattern(there) + vec3(pattern_move, 0.0), on_facing, widest, base.rgb, second, rough, metal);
    heights[i] = one.height;
    if (i == 0) has = one;
  }
  base.rgb = has.color, rough = has.rough, metal = has.metal;
  if (pattern_points == 3) n = bumped(n, along(dFdx(spot), n), along(dFdy(spot), n), vec2(heights[1] - heights[0], heights[2] - heights[0]) * (bumps * strength / max(abs(pattern_tile.x), 1e-6)));
#endif
#endif
  rough = clamp(rough, 0.045, 1.0);
  // What bends within a pixel is rougher as seen from here.
  vec3 bend_x = dFdx(n), bend_y = dFdy(n);
  float a0 = rough * rough, a2 = a0 * a0;
  a2 = min(a2 + min(0.25 * (dot(bend_x, bend_x) + dot(bend_y, bend_y)), 0.18), 1.0);
  float a = sqrt(a2);
  // A picture of the sky needs less of that than a lamp, which is a point.
  float rough_seen = sqrt(sqrt(min(a0 * a0 + min(0.1 * (dot(bend_x, bend_x) + dot(bend_y, bend_y)), 0.03), 1.0)));
  vec3 v = toward_eye.xyz - toward_eye.w * spot;
  v *= inversesqrt(max(dot(v, v), 1e-30));
  float nv = clamp(dot(n, v), 1e-4, 1.0);
  vec3 f0 = mix(vec3(0.04 * dielectric), base.rgb, metal);
#if defined(THROUGH)
  float bends = (through.y - 1.0) / (through.y + 1.0);
  f0 = mix(vec3(bends * bends * dielectric), base.rgb, metal);
#endif
  float f90 = mix(min(dielectric, 1.0), 1.0, metal);
  vec2 shares = reflected_shares(nv, rough);
  float single = shares.x + shares.y;
  vec3 repeated = 1.0 + f0 * (1.0 / max(single, 1e-3) - 1.0);  // light that is reflected several times between the facets

  vec3 diffuse = vec3(0.0), specular = vec3(0.0);
  vec3 r = 2.0 * dot(n, v) * n - v;
#if defined(COATED)
  vec3 coat_light = vec3(0.0), sheen_light = vec3(0.0);
  float coat_a = max(coat.y, 0.045), coat_a2;
  coat_a *= coat_a, coat_a2 = coat_a * coat_a;
  float coat_nv = clamp(dot(smooth_n, v), 1e-4, 1.0);
  float sheen_a = max(sheen.w * sheen.w, 0.01);
#endif
#if defined(SHADOWED) && !defined(RICH)
  float unshadowed = lit(spot, n);
#endif
  for (int i = 0; i < lights; ++i) {
    vec3 to = light_place[i].xyz - light_place[i].w * spot;
    float wide_a = a, norm = 1.0, strength_here = 1.0;
    vec3 l;
    float nl;
#if defined(AREAS)
    if (light_form[i].y > 0.5) {
      vec3 x = light_across[i].xyz * light_across[i].w, y = cross(light_aim[i].xyz, light_across[i].xyz) * light_form[i].x;
      float front = dot(light_aim[i].xyz, -to);
      if (light_form[i].y < 1.5) x *= 0.8862269, y *= 0.8862269;  // a square with the area of the disc
      strength_here = front > 0.0 ? light_of_area(to, x, y, n) : 0.0;
      // Where the reflection meets the area, or comes nearest to it.
      float rn = dot(r, light_aim[i].xyz), reach = rn < -1e-4 ? dot(to, light_aim[i].xyz) / rn : 1e4;
      vec3 off = r * max(reach, 0.0) - to;
      float ox = clamp(dot(off, x) / max(dot(x, x), 1e-20), -1.0, 1.0), oy = clamp(dot(off, y) / max(dot(y, y), 1e-20), -1.0, 1.0);
      vec3 nearest = to + ox * x + oy * y;
      float d = length(nearest);
      l = nearest / max(d, 1e-20);
      nl = max(dot(n, l), 0.0);
      wide_a = min(a + 0.25 * (length(x) + length(y)) / max(d, 1e-6), 1.0);
      norm = a / wide_a, norm *= norm;
    } else
#endif
    {
      float d2 = max(dot(to, to), 1e-30);
      l = to * inversesqrt(d2);
      nl = dot(n, l);
      float window = max(1.0 - d2 * light_color[i].w, 0.0);
      strength_here = max(nl, 0.0) * window * window;
#if defined(AREAS)
      float toward = dot(light_aim[i].xyz, -l) - light_aim[i].w;
      float cone = light_aim[i].w < -1.5 ? 1.0 : clamp(toward * light_form[i].z, 0.0, 1.0);
      strength_here *= cone * cone * (3.0 - 2.0 * cone);
#endif
    }
#if defined(SHADOWED) && defined(RICH)
    if (i < casting) strength_here *= lit(i, spot, n, dot(n, normalize(to)), strength_here > 0.0);
#elif defined(SHADOWED)
    strength_here *= i == 0 ? unshadowed : 1.0;
#endif
    vec3 arriving = light_color[i].rgb * strength_here;
#if defined(PROJECTS)
    if (i == int(slide_of.x)) {
      vec3 away = -to / max(dot(light_aim[i].xyz, -to), 1e-9) * slide_of.y;
      vec2 on_slide = 0.5 + vec2(dot(away, light_across[i].xyz), dot(away, cross(light_aim[i].xyz, light_across[i].xyz)));
      arriving *= textureLod(slide, on_slide, 0.0).rgb;
    }
#endif
    diffuse += arriving;
#if !defined(GROUND)
    vec3 h = normalize(l + v);
    float nh = clamp(dot(n, h), 0.0, 1.0), vh = clamp(dot(v, h), 0.0, 1.0), nlc = max(nl, 1e-4);
    float w2 = wide_a * wide_a, k = nh * nh * (w2 - 1.0) + 1.0;
    float dist = w2 / (k * k);
    float seen_by = 0.5 / (nlc * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nlc * nlc * (1.0 - a2) + a2));
    float rim = 1.0 - vh, rim2 = rim * rim;
    vec3 fresnel = f0 + (f90 - f0) * (rim2 * rim2 * rim);
    specular += arriving * (dist * norm * seen_by) * fresnel;
#if defined(COATED)
    float ch = clamp(dot(smooth_n, h), 0.0, 1.0), ck = ch * ch * (coat_a2 - 1.0) + 1.0;
    float cf = 0.04 + 0.96 * rim2 * rim2 * rim;
    coat_light += arriving * (coat_a2 / (ck * ck) * cf * 0.25 / max(vh * vh, 0.01));
    float inv = 1.0 / sheen_a, sin2 = max(1.0 - nh * nh, 0.0078);
    float charlie = (2.0 + inv) * pow(sin2, 0.5 * inv) * 0.5;
    sheen_light += arriving * sheen.rgb * (charlie / (4.0 * (nlc + nv - nlc * nv)));
#endif
#endif
  }
  specular *= repeated;
  vec3 falling = irradiance_at(n) * open_to;
#if defined(GROUND)
  vec3 sum = base.rgb * (diffuse + falling), soft = base.rgb * falling;
  float opacity = 1.0;
#else
  // Light from all around, with what is reflected several times.
  vec3 mirrored = mirrored_from(normalize(mix(r, n, fourth_power(rough_seen))), rough_seen);
#if defined(PICTURES)
  float covers = clamp(pow(nv + open_to, exp2(-16.0 * rough - 1.0)) - 1.0 + open_to, 0.0, 1.0);
#else
  const float covers = 1.0;
#endif
  vec3 once = f0 * shares.x + f90 * shares.y, mean = f0 + (1.0 - f0) * 0.047619;
  vec3 again = once * mean / (1.0 - (1.0 - single) * mean) * (1.0 - single);
  vec3 left = 1.0 - (once + again);
  vec3 body = base.rgb * (1.0 - metal);
  vec3 soft = body * left * falling;
  vec3 lit_body = body * left * diffuse;
  vec3 shiny = specular + (mirrored * once + falling * again) * covers;
  float opacity = base.a;
#if defined(THROUGH)
  // What is behind it, along the bent ray, or straight through a thin wall.
  vec3 inside = refract(-v, n, 1.0 / through.y);
  vec3 leaves = spot + (through.z > 0.0 ? inside * through.z : vec3(0.0));
  vec4 on_screen = clip_again * vec4(leaves, 1.0), before_it = clip_again * vec4(spot, 1.0);
  // As wide a part of the picture for any size and number of samples; four lookups hide the squares of coarse levels.
  float blur_by = log2(1.0 + (exp2(10.0 * rough * clamp(through.y * 2.0 - 2.0, 0.0, 1.0)) - 1.0) * through.w);
  vec2 texel = 1.0 / vec2(textureSize(behind_it, 0)), apart = 0.5 * min(blur_by, 1.0) * exp2(blur_by) * texel;
  vec3 here = before_it.xyz / before_it.w * 0.5 + 0.5;
  vec2 spot_behind = place_behind(here.xy, on_screen.xy / on_screen.w * 0.5 + 0.5, here.z, max(2.0 * apart, 1.4 * texel));
  vec3 seen_through = 0.25 * (textureLod(behind_it, spot_behind + apart, blur_by).rgb + textureLod(behind_it, spot_behind - apart, blur_by).rgb +
                              textureLod(behind_it, spot_behind + vec2(apart.x, -apart.y), blur_by).rgb + textureLod(behind_it, spot_behind - vec2(apart.x, -apart.y), blur_by).rgb);
  vec3 passing = seen_through * base.rgb * left * (1.0 - metal);
  soft = mix(soft, vec3(0.0), through.x), lit_body = mix(lit_body, passing, through.x);
#endif
  vec3 sum = (lit_body + soft) * opacity + shiny + shines;
  opacity = opacity + (1.0 - opacity) * max(once.r, max(once.g, once.b));
#if defined(INNER)
  // How slanting light meets the wall depends on where it came in: as for a ball, or straight as for a block.
  float sine2 = 1.0 - nv * nv;
  opacity = through.x * mix(reflected_inside(sine2 / (through.y * through.y), through.y, bends * bends), reflected_inside(sine2, through.y, bends * bends), 0.4);
  sum = mirrored * base.rgb * opacity;
#endif
#if defined(COATED)
  float sheen_all = sheen_albedo(nv, sheen.w);
  sum = sum * (1.0 - max(sheen.r, max(sheen.g, sheen.b)) * sheen_all) + sheen_light + sheen.rgb * falling * sheen_all;
  float cr = 1.0 - coat_nv, cr2 = cr * cr, coat_share = coat.x * (0.04 + 0.96 * cr2 * cr2 * cr);
  vec3 coat_r = reflect(-v, smooth_n);
  sum = sum * (1.0 - coat_share) + coat.x * coat_light + coat_share * mirrored_from(coat_r, sqrt(coat_a)) * open_to;
#endif
#endif
#if defined(RECEIVES)
  const vec3 luminance = vec3(0.2126, 0.7152, 0.0722);
  float open = dot(soft, luminance) / max(dot(sum, luminance), 1e-6);
  float received = mix(0.5, 1.0, clamp(open, 0.0, 1.0));
#endif
)";

}  // namespace betwixt
