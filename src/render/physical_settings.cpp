// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a frame, a sky and a finish set in the programs of physical surfaces.
#include <algorithm>
#include <cmath>

#include "render/physical.h"
#include "render/physical_units.h"

namespace betwixt {
namespace {

// The irradiance of a dome with these colours above and below, for films without a sky.
std::array<Vec3, 9> dome(const Lighting& lighting) {
  return {0.5 * (lighting.sky + lighting.ground), 0.5 * (lighting.sky - lighting.ground)};
}

}  // namespace

void PhysicalSurfaces::set_frame(Look& look) {
  const auto& frame = *frame_;
  const View& view = frame.view;
  const Lighting& lighting = frame.lighting;
  const auto at = [&](const char* name) { return place(look, name); };
  const Mat4 c = view.clip();
  glUniformMatrix4fv(at("clip"), 1, GL_FALSE, to_float(c).data());
  glUniformMatrix4fv(at("clip_again"), 1, GL_FALSE, to_float(c).data());
  glUniform4fv(at("depth_row"), 1, four({c(2, 0), c(2, 1), c(2, 2)}, c(2, 3)).data());
  glUniform4fv(at("w_row"), 1, four({c(3, 0), c(3, 1), c(3, 2)}, c(3, 3)).data());
  glUniform4fv(at("toward_eye"), 1, (view.orthographic ? four(view.backward, 0) : four({}, 1)).data());
  std::array<std::array<float, 4>, Lighting::most> places{}, colors{}, aims{}, across{}, forms{};
  for (std::size_t i = 0; i < lighting.lights.size(); ++i) {
    const Lighting::One& l = lighting.lights[i];
    places[i] = four(l.place, l.sun ? 0 : 1);
    colors[i] = four(l.color, l.sun ? 0 : 1 / (l.range * l.range));
    const auto [edge_out, cos_out] = sine_cosine(l.cone / 2);
    const auto [edge_in, cos_in] = sine_cosine(l.cone / 2 * (1 - std::clamp(l.cone_edge, 0.001, 1.0)));
    aims[i] = four(l.aim, l.cone > 0 ? cos_out : -2);
    across[i] = four(l.across, l.half_width);
    forms[i] = {static_cast<float>(l.half_height), static_cast<float>(l.shape),
                static_cast<float>(1 / std::max(cos_in - cos_out, 1e-6)), 1};
  }
  const auto count = static_cast<GLsizei>(Lighting::most);
  glUniform1i(at("lights"), static_cast<GLint>(lighting.lights.size()));
  glUniform4fv(at("light_place"), count, places.front().data());
  glUniform4fv(at("light_color"), count, colors.front().data());
  glUniform4fv(at("light_aim"), count, aims.front().data());
  glUniform4fv(at("light_across"), count, across.front().data());
  glUniform4fv(at("light_form"), count, forms.front().data());
  std::array<std::array<float, 3>, 9> sums{};
  for (std::size_t i = 0; i < 9; ++i)
    for (int k = 0; k < 3; ++k) sums[i][static_cast<std::size_t>(k)] = static_cast<float>(irradiance_[i][k]);
  glUniform3fv(at("irradiance"), 9, sums.front().data());
  glUniform4f(at("sky_turn"), static_cast<float>(sky_.cosine()), static_cast<float>(sky_.sine()),
              static_cast<float>(sky_ ? sky_.share() : 1), frame.around.fog && sky_.seen_behind() ? 1 : 0);
  glUniform1f(at("blurs"), sky_ ? SkyLight::levels : 0);
  const Surroundings::Fog fog = frame.around.fog.value_or(Surroundings::Fog{});
  glUniform3fv(at("fog_color"), 1, four(fog.color, 0).data());
  glUniform2f(at("fog_range"), static_cast<float>(fog.from),
              frame.around.fog ? static_cast<float>(1 / (fog.to - fog.from)) : 0);
  glUniform1f(at("encodes"), encodes_ ? 1 : 0);
  glUniform1f(at("receives"), receives_ ? 1 : 0);
  if (slide_) {
    const auto [sine, cosine] = sine_cosine(lighting.lights[slide_light_].cone / 2);
    glUniform2f(at("slide_of"), static_cast<float>(slide_light_), static_cast<float>(cosine / (2 * sine)));
  }
  if ((common_ & shadowed) != 0) set_shadow_maps(look.program, frame);
}

// Sends the light from all around: the cube, or a dome of one colour above and below.
void PhysicalSurfaces::need_sky_light() {
  irradiance_ = sky_ ? sky_.light()->irradiance() : dome(frame_->lighting);
  if (around_.id() != 0 && sky_ && sky_.light() == sent_) return;
  GLuint id = 0;
  glGenTextures(1, &id);
  around_ = gl::Texture(id);
  glActiveTexture(GL_TEXTURE0 + around_at);
  glBindTexture(GL_TEXTURE_CUBE_MAP, id);
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, sky_ ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  sent_ = sky_.light();
  if (!sky_) {
    glTexStorage2D(GL_TEXTURE_CUBE_MAP, 1, GL_RGBA16F, 2, 2);
    const Vec3 above = 1.6 * frame_->lighting.sky, under = 1.6 * frame_->lighting.ground,
               beside = 0.5 * (above + under);
    for (GLenum face = 0; face < 6; ++face) {
      const Vec3 first = face == 2 ? above : face == 3 ? under : 0.5 * (above + beside);
      const Vec3 second = face == 2 ? above : face == 3 ? under : 0.5 * (under + beside);
      const std::array<std::array<float, 4>, 4> texels{four(first, 1), four(first, 1), four(second, 1),
                                                       four(second, 1)};
      glTexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, 0, 0, 2, 2, GL_RGBA, GL_FLOAT, texels.data());
    }
    return;
  }
  glTexStorage2D(GL_TEXTURE_CUBE_MAP, SkyLight::levels, GL_RGBA16F, SkyLight::side, SkyLight::side);
  for (int k = 0; k < SkyLight::levels; ++k) {
    const SkyLight::Level& level = sky_.light()->cube()[static_cast<std::size_t>(k)];
    const auto face_size = static_cast<std::size_t>(3 * level.side * level.side);
    std::vector<float> rgba(face_size / 3 * 4, 1);
    for (GLenum face = 0; face < 6; ++face) {
      for (std::size_t i = 0; i < face_size; ++i)
        rgba[i / 3 * 4 + i % 3] = std::min(level.rgb[face * face_size + i], 65000.0F);
      glTexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, k, 0, 0, level.side, level.side, GL_RGBA, GL_FLOAT,
                      rgba.data());
    }
  }
}

void PhysicalSurfaces::set_finish(Look& look, const Batch& batch, const Thing& t, unsigned features) {
  const auto at = [&](const char* name) { return place(look, name); };
  static const Finish plain;
  const Finish& f = batch.finish ? *batch.finish : plain;
  const auto as = [](double x) { return static_cast<float>(x); };
  const auto [sine, cosine] = sine_cosine(f.turn);
  glUniform1f(at("has_finish"), batch.finish ? 1 : 0);
  glUniform4f(at("base_finish"), as(f.metalness), as(f.roughness), as(f.specular), as(f.normal_strength));
  glUniform3fv(at("emission"), 1, four(f.emission, 0).data());
  glUniformMatrix4fv(at("to_object"), 1, GL_FALSE, to_float(t.to_object).data());
  if (batch.ball) glUniform1f(at("ball_radius"), as(t.shape->radius));
  if ((features & pictures) != 0) {
    glUniform4f(at("tile"), as(f.tile_x), as(f.tile_y), as(f.move_x), as(f.move_y));
    glUniform2f(at("turned"), as(cosine), as(sine));
    const auto use = [&](int unit, const std::shared_ptr<const StoredTexture>& from, bool light) {
      const GLuint id = from ? light ? Store::need_texture(*from) : Store::need_plain_texture(*from) : 0;
      gl::use_texture(unit, id != 0 ? id : plain_texture(unit == normals_at));
    };
    use(normals_at, t.maps.normals, false), use(roughness_at, t.maps.roughness, false);
    use(metalness_at, t.maps.metalness, false), use(occlusion_at, t.maps.occlusion, false);
    use(emission_at, t.maps.emission, true);
  }
  if ((features & pattern) != 0) {
    glUniform1i(at("pattern_kind"), static_cast<GLint>(f.pattern));
    glUniform1i(at("pattern_points"), f.pattern_bumps > 0 ? 3 : 1);
    glUniform3fv(at("second"), 1, four(f.second, 0).data());
    glUniform1f(at("bumps"), as(f.pattern_bumps));
    glUniform4f(at("pattern_tile"), as(f.tile_x), as(f.tile_y), as(cosine), as(sine));
    glUniform2f(at("pattern_move"), as(f.move_x), as(f.move_y));
  }
  if ((features & coated) != 0) {
    glUniform2f(at("coat"), as(f.clearcoat), as(f.clearcoat_roughness));
    glUniform4fv(at("sheen"), 1, four(f.sheen, f.sheen_roughness).data());
  }
  if ((features & through) != 0)
    glUniform4f(at("through"), as(f.transmission), as(f.ior), as(f.thickness), as(behind_width_ / 1024.0));
}

}  // namespace betwixt
