// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/surfaces.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/balls.h"
#include "render/canvas.h"

namespace betwixt {
namespace {

const char* const vertex = R"(
uniform mat4 clip;
uniform vec4 toward_eye;  // a direction and 0 (orthographic), or the origin and 1
#if defined(TEXTURED)
out vec2 place;
#elif defined(BALL)
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
#elif defined(BALL)
  p.xyz = outline(position.xy, toward_eye, e);
  disc = p.xyz;
  facing = normal_of(disc);
  turn = normal_of(e.xyz);
  move = (1.0 - e.w) * toward_eye.xyz;
#endif
  at = vec3(dot(row_x, p), dot(row_y, p), dot(row_z, p));
  paint = color;
  gloss = look;
  gl_Position = clip * vec4(at, 1.0);
}
)";

const char* const fragment = R"(
in vec3 at, facing;
flat in vec4 paint;
flat in vec2 gloss;
uniform vec4 toward_eye;
uniform vec3 part_color;
uniform int lights;
uniform vec4 light_place[16];  // a position and 1, or a direction and 0
uniform vec4 light_color[16];  // and 1 / range², 0 for suns
uniform vec3 sky, ground;
uniform sampler2DShadow shadow;
uniform float encodes;      // 1: colours are written encoded, 0: as linear light
uniform float shadow_step;  // between look-ups, in the map's measure
uniform mat4 shadow_clip;
uniform vec2 shadow_texel;  // metres across, or the same per metre of distance
#if defined(TEXTURED)
in vec2 place;
uniform sampler2D picture;
#elif defined(BALL)
in vec3 disc;
flat in vec4 e;
flat in vec3 move, turn;
uniform vec4 depth_row, w_row;  // of the clip matrix
#endif
out vec4 color;

// How much of the first light reaches p, a point on a surface towards n. Looked up a little above it, against shadows of itself.
float lit(vec3 spot, vec3 n) {
  float distance_to_light = dot(vec4(shadow_clip[0].w, shadow_clip[1].w, shadow_clip[2].w, shadow_clip[3].w), vec4(spot, 1.0));
  vec4 in_light = shadow_clip * vec4(spot + (shadow_texel.x + shadow_texel.y * distance_to_light) * n, 1.0);
  vec3 p = in_light.xyz / in_light.w * 0.5 + 0.5;
  p.z = min(p.z, 1.0);
  float sum = 0.0;
  for (int y = 0; y < TAPS; ++y)
    for (int x = 0; x < TAPS; ++x) {
      vec2 off = (vec2(x, y) - 0.5 * float(TAPS - 1)) * shadow_step;
      sum += textureLod(shadow, vec3(p.xy + off, p.z), 0.0);
    }
  sum *= 1.0 / float(TAPS * TAPS);
  // Fades out towards the border of the map, and behind the light.
  vec2 border = clamp((1.0 - abs(2.0 * p.xy - 1.0)) * 16.0, 0.0, 1.0);
  return in_light.w > 0.0 ? mix(1.0, sum, border.x * border.y) : 1.0;
}

// Sky above, ground below, a soft horizon between.
vec3 surroundings(float up, float blur) {
  return mix(ground, sky, clamp(0.5 + up / (0.35 + 1.65 * blur), 0.0, 1.0));
}

void main() {
  vec4 base = paint * vec4(part_color, 1.0);
#if defined(TEXTURED)
  base *= texture(picture, place);
#endif
  float metal = gloss.y == 2.0 ? 1.0 : 0.0;
  float glossy = gloss.y == 1.0 ? 0.0 : 1.0;
  float shine = gloss.x;
  float roughness = mix(0.8, 0.08, shine);
  float a = roughness * roughness, a2 = a * a;
  vec3 f0 = mix(vec3(0.045 * min(1.0, 0.25 + shine)), base.rgb, metal) * glossy;

  vec3 spot = at, across = facing;
#if defined(BALL)
  // From the disc along the line of sight to the sphere.
  vec3 along = disc * e.w - e.xyz;
  float stretch = inversesqrt(max(dot(along, along), 1e-30));
  along *= stretch;
  float b = dot(disc, along);
  float go = -b - sqrt(max(b * b - dot(disc, disc) + 1.0, 0.0));
  spot += go * stretch * (at * e.w - move);
  across += go * stretch * (facing * e.w - turn);
  vec4 there = vec4(spot, 1.0);
  gl_FragDepth = 0.5 * dot(depth_row, there) / dot(w_row, there) + 0.5;
#endif
  vec3 n = across * inversesqrt(max(dot(across, across), 1e-30));
#ifndef BALL
  if (!gl_FrontFacing) n = -n;
#endif
  vec3 v = toward_eye.xyz - toward_eye.w * spot;
  v *= inversesqrt(max(dot(v, v), 1e-30));
  float nv = dot(n, v);

  vec3 diffuse = vec3(0.0), specular = vec3(0.0);
  float unshadowed = lit(spot, n);
  for (int i = 0; i < lights; ++i) {
    vec3 to = light_place[i].xyz - light_place[i].w * spot;
    float d2 = max(dot(to, to), 1e-30);
    vec3 l = to * inversesqrt(d2);
    float nl = dot(n, l);
    float window = max(1.0 - d2 * light_color[i].w, 0.0);
    float strength = max(nl, 0.0) * window * window;
    strength *= i == 0 ? unshadowed : 1.0;
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
  vec3 shiny = specular * f0 + fresnel * surroundings(r.y, roughness) * (1.0 + 2.0 * metal);
  float opacity = base.a;
  vec3 sum = (body * diffuse + soft) * opacity + shiny;
  opacity = opacity + (1.0 - opacity) * max(fresnel.r, max(fresnel.g, fresnel.b));
  // A soft shoulder for what is over-bright.
  vec3 over = max(sum - 0.9, 0.0) * 10.0;
  sum = min(sum, 0.9) + 0.1 * over / (1.0 + over);
  bool glows = gloss.y == 3.0;
  color = glows ? vec4(base.rgb * base.a, base.a) : vec4(sum, opacity);
  color.rgb = mix(color.rgb, encoded(color.rgb), encodes);
}
)";

std::array<float, 4> four(Vec3 v, double w) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), static_cast<float>(w)};
}

// Look-ups along a side, and how many texels lie between them: each blends four texels, so no step can be seen.
constexpr int shadow_taps = 2;
constexpr float shadow_step = 2;
constexpr int shadow_unit = 1, picture_unit = 0;

}  // namespace

Result<Surfaces> Surfaces::create() {
  Surfaces s;
  const std::string source = std::string(vertex_inputs) + ball_outline + vertex;
  for (auto& [look, variant] :
       {std::pair{&s.plain_, ""}, {&s.textured_, "#define TEXTURED"}, {&s.balls_, "#define BALL"}}) {
    auto program = gl::new_program(source, std::string(encoded_function) + fragment,
                                   fmt::format("#define TAPS {}\n{}", shadow_taps, variant));
    if (!program) return program.error();
    look->program = *std::move(program);
    look->encodes = gl::uniform(look->program, "encodes");
    look->part_color = gl::uniform(look->program, "part_color");
    gl::set_samplers(look->program, {{"shadow", shadow_unit}, {"picture", picture_unit}});
  }
  return s;
}

void Surfaces::set_program(const Look& look, const View& view, const Lighting& lighting, const Shadow* shadow) const {
  const auto at = [&](const char* name) { return gl::uniform(look.program, name); };
  glUseProgram(look.program.id());
  glUniformMatrix4fv(at("clip"), 1, GL_FALSE, to_float(view.clip()).data());
  const Mat4 c = view.clip();
  glUniform4fv(at("depth_row"), 1, four({c(2, 0), c(2, 1), c(2, 2)}, c(2, 3)).data());
  glUniform4fv(at("w_row"), 1, four({c(3, 0), c(3, 1), c(3, 2)}, c(3, 3)).data());
  const auto eye = view.orthographic ? four(view.backward, 0) : four({}, 1);
  glUniform4fv(at("toward_eye"), 1, eye.data());
  std::array<std::array<float, 4>, Lighting::most> places{}, colors{};
  for (std::size_t i = 0; i < lighting.lights.size(); ++i) {
    const Lighting::One& l = lighting.lights[i];
    places[i] = four(l.place, l.sun ? 0 : 1);
    colors[i] = four(l.color, l.sun ? 0 : 1 / (l.range * l.range));
  }
  glUniform1i(at("lights"), static_cast<GLint>(lighting.lights.size()));
  glUniform4fv(at("light_place"), Lighting::most, places.front().data());
  glUniform4fv(at("light_color"), Lighting::most, colors.front().data());
  glUniform3fv(at("sky"), 1, four(lighting.sky, 0).data());
  glUniform3fv(at("ground"), 1, four(lighting.ground, 0).data());
  if (shadow == nullptr) return;
  glUniformMatrix4fv(at("shadow_clip"), 1, GL_FALSE, to_float(shadow->clip()).data());
  const auto texel = static_cast<float>(2 * shadow->texel());
  glUniform2f(at("shadow_texel"), shadow->perspective() ? 0 : texel, shadow->perspective() ? texel : 0);
  glUniform1f(at("shadow_step"), shadow_step / Shadow::map_size);
}

void Surfaces::set(const View& view, const Lighting& lighting, const Shadow* shadow) {
  for (const Look* look : {&textured_, &balls_, &plain_}) set_program(*look, view, lighting, shadow);
  if (shadow != nullptr) gl::use_texture(shadow_unit, shadow->map());
}

void Surfaces::draw_parts(const Batch& batch) {
  for (const StoredPart& part : batch.mesh->parts) {
    const StoredTexture* const picture = batch.texture != nullptr ? batch.texture : part.texture.get();
    const GLuint texture = picture != nullptr ? picture->texture.id() : 0;
    const Look& look = batch.ball ? balls_ : texture != 0 ? textured_ : plain_;
    if (texture != 0) gl::use_texture(picture_unit, texture);
    glUseProgram(look.program.id());
    glUniform3fv(look.part_color, 1, part.color.data());
    glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(part.count), GL_UNSIGNED_INT,
                            reinterpret_cast<const void*>(part.first * sizeof(std::uint32_t)),
                            static_cast<GLsizei>(batch.count));
  }
}

void Surfaces::write_encoded(bool encoded) const {
  for (const Look* look : {&textured_, &balls_, &plain_}) {
    glUseProgram(look->program.id());
    glUniform1f(look->encodes, encoded ? 1 : 0);
  }
}

void Surfaces::draw_opaque(const Things& things, std::span<const std::uint32_t> numbers) {
  const Batches batches = batches_of(things, numbers);
  solid_.set(things, batches.order);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  for (const Batch& b : batches.batches) {
    if (b.mesh->parts.empty()) continue;
    if (b.closed && !b.ball)
      glEnable(GL_CULL_FACE);
    else
      glDisable(GL_CULL_FACE);
    Store::need_triangles(*b.mesh);
    set_facing(b.mirrored, true);
    glBindVertexArray(b.mesh->triangles.id());
    solid_.bind(b.first);
    draw_parts(b);
  }
}

void Surfaces::draw_transparent(const Things& things, std::span<const std::uint32_t> numbers) {
  const Batches batches = sorted_singles(things, numbers);
  glass_.set(things, batches.order);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  for (const Batch& b : batches.batches) {
    if (b.mesh->parts.empty()) continue;
    Store::need_triangles(*b.mesh);
    set_facing(b.mirrored, true);
    glBindVertexArray(b.mesh->triangles.id());
    glass_.bind(b.first);
    if (b.closed) {
      glEnable(GL_CULL_FACE);
      glCullFace(GL_FRONT);
      draw_parts(b);
      glCullFace(GL_BACK);
    } else {
      glDisable(GL_CULL_FACE);
    }
    draw_parts(b);
  }
  glDepthMask(GL_TRUE);
}

}  // namespace betwixt
