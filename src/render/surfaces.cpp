// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/surfaces.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/balls.h"
#include "render/shading.h"

namespace betwixt {
namespace {

std::array<float, 4> four(Vec3 v, double w) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), static_cast<float>(w)};
}

// Look-ups along a side, and how many texels lie between them: each blends four texels, so no step can be seen.
constexpr int shadow_taps = 2;
constexpr float shadow_step = 2;
constexpr int shadow_unit = 1, picture_unit = 0;

}  // namespace

Result<Surfaces::Look> Surfaces::new_look(bool fills, const char* defines) {
  const std::string vertex =
      fills ? std::string(gl::fill_vertex) : std::string(vertex_inputs) + ball_outline + surface_vertex;
  auto program = gl::new_program(vertex, std::string(encoded_function) + surface_fragment,
                                 fmt::format("#define TAPS {}\n{}", shadow_taps, defines));
  if (!program) return program.error();
  Look look;
  look.program = *std::move(program);
  look.encodes = gl::uniform(look.program, "encodes");
  look.part_color = gl::uniform(look.program, "part_color");
  gl::set_samplers(look.program, {{"shadow", shadow_unit}, {"picture", picture_unit}});
  return look;
}

Result<Surfaces> Surfaces::create() {
  Surfaces s;
  for (auto& [look, variant] :
       {std::pair{&s.plain_, ""}, {&s.textured_, "#define TEXTURED"}, {&s.balls_, "#define BALL"}}) {
    auto made = new_look(false, variant);
    if (!made) return made.error();
    *look = *std::move(made);
  }
  return s;
}

void Surfaces::set_program(const Look& look, const Circumstances& frame) {
  const auto& [view, lighting, shadow, around] = frame;
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
  glUniform1f(at("unlit"), around.flat ? 1 : 0);
  const Surroundings::Fog fog = around.fog.value_or(Surroundings::Fog{});
  glUniform3fv(at("fog_color"), 1, four(fog.color, 0).data());
  glUniform2f(at("fog_range"), static_cast<float>(fog.from),
              around.fog ? static_cast<float>(1 / (fog.to - fog.from)) : 0);
  // Without a shadow nothing is before the light.
  glUniformMatrix4fv(at("shadow_clip"), 1, GL_FALSE, to_float(shadow ? shadow->clip() : scaling({})).data());
  const auto texel = static_cast<float>(shadow ? 2 * shadow->texel() : 0);
  const bool perspective = shadow && shadow->perspective();
  glUniform2f(at("shadow_texel"), perspective ? 0 : texel, perspective ? texel : 0);
  glUniform1f(at("shadow_step"), shadow_step / Shadow::map_size);
}

void Surfaces::set(const Circumstances& frame) {
  for (const Look* look : {&textured_, &balls_, &plain_}) set_program(*look, frame);
  if (frame.shadow != nullptr) gl::use_texture(shadow_unit, frame.shadow->map());
}

void Surfaces::draw_setting(const Circumstances& frame, const Gradient& gradient, bool encoded) {
  if (ground_.program.id() == 0) {
    auto made = new_look(true, "#define GROUND");
    if (!made) return;  // the same stages as those of all others
    ground_ = *std::move(made);
  }
  set_program(ground_, frame);
  const View& v = frame.view;
  const Surroundings& around = frame.around;
  const auto put = [&](const char* name, Vec3 value) {
    glUniform3fv(gl::uniform(ground_.program, name), 1, four(value, 0).data());
  };
  // Of an orthographic picture the sky is seen as if from somewhere.
  put("ray", -v.backward);
  put("ray_x", v.orthographic ? Vec3{} : 1 / v.sx * v.right);
  put("ray_y", v.orthographic ? -0.5 * v.up : -1 / v.sy * v.up);
  put("from_x", v.orthographic ? 1 / v.sx * v.right : Vec3{});
  put("from_y", v.orthographic ? -1 / v.sy * v.up : Vec3{});
  const Lighting& light = frame.lighting;
  put("top", around.sky ? light.zenith : gradient.top), put("bottom", around.sky ? light.horizon : gradient.bottom);
  put("under", light.below);
  glUniform2f(gl::uniform(ground_.program, "shape"), gradient.bends ? 1 : 0, around.sky ? 1 : 0);
  const bool seen = around.ground && v.eye.y > 0;
  glUniform4fv(gl::uniform(ground_.program, "floor_color"), 1,
               four(around.ground.value_or(Vec3{}), seen ? 1 : 0).data());
  glUniform1f(gl::uniform(ground_.program, "floor_height"), static_cast<float>(-v.eye.y));
  glUniform1f(ground_.encodes, encoded ? 1 : 0);
  put("part_color", {1, 1, 1});
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  gl::fill();
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
