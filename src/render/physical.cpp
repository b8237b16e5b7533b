// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/physical.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/balls.h"
#include "render/patterns.h"
#include "render/physical_shading.h"
#include "render/shading.h"

namespace betwixt {
namespace {

// Texture units.
constexpr int picture_at = 0, shadows_at = 1, depths_at = 2, around_at = 3, behind_at = 4, normals_at = 5,
              roughness_at = 6, metalness_at = 7, occlusion_at = 8, emission_at = 9, seen_at = 10;
constexpr int seeds = 40;

std::array<float, 4> quad(Vec3 v, double w) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), static_cast<float>(w)};
}

std::vector<float> spread_seeds() {
  std::vector<float> r;
  for (int k = 0; k < seeds; ++k) {
    const double away = std::sqrt((k + 0.5) / seeds);
    const auto [sine, cosine] = sine_cosine(pi * (3 - std::sqrt(5.0)) * k);
    r.push_back(static_cast<float>(away * cosine)), r.push_back(static_cast<float>(away * sine));
  }
  return r;
}

bool is_lamp_with_front(const Lighting::One& l) { return l.shape != LightShape::point || l.cone > 0; }

// The irradiance of a dome with these colours above and below, for films without a sky.
std::array<Vec3, 9> dome(const Lighting& lighting) {
  return {0.5 * (lighting.sky + lighting.ground), 0.5 * (lighting.sky - lighting.ground)};
}

std::array<float, 12> texel_rows(Vec3 c) {
  std::array<float, 12> r{};
  for (std::size_t i = 0; i < 12; ++i) r[i] = static_cast<float>(c[static_cast<int>(i % 3)]);
  return r;
}

}  // namespace

unsigned PhysicalSurfaces::shadow_features(const Surfaces::FrameSettings& frame) {
  if (frame.shadows.empty()) return 0;
  if (frame.shadows.back().light > 0 || frame.shadows.front().spread > 0) return rich;
  return frame.shadows.size() > 1 ? levels : 0U;
}

bool needs_physical(const Things& things, const Scenery& scenery, const SkyAround& sky) {
  const Surroundings& around = scenery.surroundings;
  if (around.flat) return false;
  if (sky) return true;
  for (const Light& l : scenery.lights)
    if (l.shape != LightShape::point || l.cone > 0) return true;
  return std::any_of(things.all().begin(), things.all().end(),
                     [](const Thing& t) { return t.visible && t.finish != nullptr; });
}

PhysicalSurfaces::Look* PhysicalSurfaces::need(unsigned features) {
  Look& look = looks_[features];
  if (look.refused) return nullptr;
  if (look.program.id() == 0) {
    constexpr std::pair<Feature, const char*> names[] = {
        {ball, "BALL"},         {pictures, "PICTURES"}, {projected, "PROJECTED"}, {pattern, "PATTERN"},
        {coated, "COATED"},     {through, "THROUGH"},   {ground, "GROUND"},       {areas, "AREAS"},
        {shadowed, "SHADOWED"}, {contact, "RECEIVES"},  {rich, "RICH"},           {levels, "LEVELS"}};
    std::string defines = fmt::format("#define TAPS 2\n#define SEEDS {}\n#define CASTERS {}\n#define MAPS {}\n", seeds,
                                      (features & rich) != 0 ? Lighting::most_casting : 1,
                                      (features & (rich | levels)) != 0 ? Shadows::most_maps : 1);
    for (const auto& [bit, name] : names)
      if ((features & bit) != 0) defines += fmt::format("#define {}\n", name);
    if (unclamped_) defines += "#define OPEN\n";
    const std::string vertex = (features & ground) != 0 ? std::string(gl::fill_vertex)
                                                        : std::string(vertex_inputs) + ball_outline + physical_vertex;
    std::string fragment = std::string(encoded_function) + physical_inputs;
    if ((features & shadowed) != 0) fragment += shadow_lookup;
    if ((features & pattern) != 0) fragment += pattern_shader;
    auto made = gl::new_program(vertex, fragment + physical_fragment, defines);
    if (!made) {
      look.refused = true;
      return nullptr;
    }
    look.program = *std::move(made);
    gl::set_samplers(look.program, {{"picture", picture_at},
                                    {"shadows", shadows_at},
                                    {"depths", depths_at},
                                    {"around", around_at},
                                    {"behind_it", behind_at},
                                    {"normals", normals_at},
                                    {"roughness_map", roughness_at},
                                    {"metalness_map", metalness_at},
                                    {"occlusion_map", occlusion_at},
                                    {"emission_map", emission_at},
                                    {"seen", seen_at}});
    glUniform2fv(place(look, "seeds"), seeds, spread_seeds().data());
  }
  glUseProgram(look.program.id());
  if (look.frame != frame_number_) set_frame(look), look.frame = frame_number_;
  return &look;
}

GLint PhysicalSurfaces::place(Look& look, const char* name) {
  const auto [at, fresh] = look.places.try_emplace(name, 0);
  if (fresh) at->second = gl::uniform(look.program, name);
  return at->second;
}

void PhysicalSurfaces::set_frame(Look& look) {
  const auto& frame = *frame_;
  const View& view = frame.view;
  const Lighting& lighting = frame.lighting;
  const auto at = [&](const char* name) { return place(look, name); };
  const Mat4 c = view.clip();
  glUniformMatrix4fv(at("clip"), 1, GL_FALSE, to_float(c).data());
  glUniformMatrix4fv(at("clip_again"), 1, GL_FALSE, to_float(c).data());
  glUniform4fv(at("depth_row"), 1, quad({c(2, 0), c(2, 1), c(2, 2)}, c(2, 3)).data());
  glUniform4fv(at("w_row"), 1, quad({c(3, 0), c(3, 1), c(3, 2)}, c(3, 3)).data());
  glUniform4fv(at("toward_eye"), 1, (view.orthographic ? quad(view.backward, 0) : quad({}, 1)).data());
  std::array<std::array<float, 4>, Lighting::most> places{}, colors{}, aims{}, across{}, forms{};
  for (std::size_t i = 0; i < lighting.lights.size(); ++i) {
    const Lighting::One& l = lighting.lights[i];
    places[i] = quad(l.place, l.sun ? 0 : 1);
    colors[i] = quad(l.color, l.sun ? 0 : 1 / (l.range * l.range));
    const auto [edge_out, cos_out] = sine_cosine(l.cone / 2);
    const auto [edge_in, cos_in] = sine_cosine(l.cone / 2 * (1 - std::clamp(l.cone_edge, 0.001, 1.0)));
    aims[i] = quad(l.aim, l.cone > 0 ? cos_out : -2);
    across[i] = quad(l.across, l.half_width);
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
              static_cast<float>(sky_ ? sky_.share() : 1), 0);
  glUniform1f(at("blurs"), sky_ ? SkyLight::levels - 1 : 0);
  const Surroundings::Fog fog = frame.around.fog.value_or(Surroundings::Fog{});
  glUniform3fv(at("fog_color"), 1, quad(fog.color, 0).data());
  glUniform2f(at("fog_range"), static_cast<float>(fog.from),
              frame.around.fog ? static_cast<float>(1 / (fog.to - fog.from)) : 0);
  glUniform1f(at("encodes"), encodes_ ? 1 : 0);
  glUniform1f(at("receives"), receives_ ? 1 : 0);
  if ((common_ & shadowed) != 0) set_shadow_maps(look.program, frame);
}

GLuint PhysicalSurfaces::plain_texture(bool normals) {
  gl::Texture& texture = normals ? flat_ : white_;
  if (texture.id() == 0) {
    texture = gl::new_texture(GL_RGBA8, 1, 1, GL_NEAREST);
    const std::array<std::uint8_t, 4> flat{128, 128, 255, 255}, white{255, 255, 255, 255};
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, (normals ? flat : white).data());
  }
  return texture.id();
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
      auto rows = texel_rows(face == 2 ? above : face == 3 ? under : beside);
      for (std::size_t i = 0; i < 12 && face != 2 && face != 3; ++i)
        rows[i] =
            static_cast<float>((i < 6 ? 0.5 * (above + beside) : 0.5 * (under + beside))[static_cast<int>(i % 3)]);
      glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
      glTexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, 0, 0, 2, 2, GL_RGB, GL_FLOAT, rows.data());
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

void PhysicalSurfaces::set(const Surfaces::FrameSettings& frame, SkyAround sky) {
  frame_ = &frame, sky_ = std::move(sky), ++frame_number_;
  encodes_ = false, receives_ = frame.contact;
  const auto& all = frame.lighting.lights;
  common_ = (frame.contact ? contact : 0U) | (frame.shadows.empty() ? 0U : shadowed) | shadow_features(frame) |
            (std::any_of(all.begin(), all.end(), is_lamp_with_front) ? areas : 0U);
  need_sky_light();
  glActiveTexture(GL_TEXTURE0 + around_at);
  glBindTexture(GL_TEXTURE_CUBE_MAP, around_.id());
  // One level of the cube instead of two saves a twelfth of the time of films that ask for no light at all.
  if (sky_)
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER,
                    sky_.is_default() ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_LINEAR);
  if (frame.shadows.empty()) return;
  if (depths_.id() == 0) depths_ = gl::new_depth_sampler();
  gl::use_layers(shadows_at, frame.shadow_layers);
  gl::use_layers(depths_at, frame.shadow_layers);
  glBindSampler(depths_at, depths_.id());
}

void PhysicalSurfaces::write_encoded(bool encoded) { encodes_ = encoded, ++frame_number_; }

unsigned PhysicalSurfaces::features_of(const Batch& batch, const StoredPart& part, const Thing& t) const {
  unsigned f = common_ | (batch.ball ? ball : 0U);
  const Finish* const finish = batch.finish;
  const bool own = batch.texture != nullptr || part.texture != nullptr;
  if (own || (finish && finish->has_pictures())) {
    f |= pictures;
    const bool no_uv = batch.ball || batch.mesh->mesh->uvs.size() != batch.mesh->mesh->positions.size();
    if (finish &&
        (finish->projection == PictureProjection::box || (finish->projection == PictureProjection::automatic && no_uv)))
      f |= projected;
  }
  if (!finish) return f;
  if (finish->pattern != Pattern::none) f |= pattern;
  if (finish->clearcoat > 0 || !(finish->sheen == Vec3{})) f |= coated;
  if (finish->transmission > 0 && behind_.id() != 0 && t.finish) f |= through;
  return f;
}

void PhysicalSurfaces::set_finish(Look& look, const Batch& batch, const Thing& t, unsigned features) {
  const auto at = [&](const char* name) { return place(look, name); };
  static const Finish plain;
  const Finish& f = batch.finish ? *batch.finish : plain;
  const auto as = [](double x) { return static_cast<float>(x); };
  const auto [sine, cosine] = sine_cosine(f.turn);
  glUniform1f(at("has_finish"), batch.finish ? 1 : 0);
  glUniform4f(at("base_finish"), as(f.metalness), as(f.roughness), as(f.specular), as(f.normal_strength));
  glUniform3fv(at("emission"), 1, quad(f.emission, 0).data());
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
    glUniform3fv(at("second"), 1, quad(f.second, 0).data());
    glUniform1f(at("bumps"), as(f.pattern_bumps));
    glUniform4f(at("pattern_tile"), as(f.tile_x), as(f.tile_y), as(cosine), as(sine));
  }
  if ((features & coated) != 0) {
    glUniform2f(at("coat"), as(f.clearcoat), as(f.clearcoat_roughness));
    glUniform4fv(at("sheen"), 1, quad(f.sheen, f.sheen_roughness).data());
  }
  if ((features & through) != 0)
    glUniform4f(at("through"), as(f.transmission), as(f.ior), as(f.thickness), as(behind_levels_ - 1));
}

void PhysicalSurfaces::draw_parts(const Things& things, const Batches& batches, const Batch& batch) {
  const Thing& t = things[batches.order[batch.first]];
  for (const StoredPart& part : batch.mesh->parts) {
    const unsigned features = features_of(batch, part, t);
    Look* const look = need(features);
    if (look == nullptr) continue;
    set_finish(*look, batch, t, features);
    if ((features & pictures) != 0) {
      const StoredTexture* const own = batch.texture != nullptr ? batch.texture : part.texture.get();
      const GLuint id = own != nullptr ? Store::need_texture(*own) : 0;
      gl::use_texture(picture_at, id != 0 ? id : plain_texture(false));
    }
    glUniform4f(place(*look, "part_color"), part.color[0], part.color[1], part.color[2], part.tinted ? 1.F : 0.F);
    glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(part.count), GL_UNSIGNED_INT,
                            reinterpret_cast<const void*>(part.first * sizeof(std::uint32_t)),
                            static_cast<GLsizei>(batch.count));
  }
}

void PhysicalSurfaces::draw_batches(const Things& things, const Batches& batches, Instances& instances) {
  instances.set(things, batches.order);
  for (const Batch& b : batches.batches) {
    if (b.mesh->parts.empty()) continue;
    (b.closed && !b.ball ? glEnable : glDisable)(GL_CULL_FACE);
    Store::need_triangles(*b.mesh);
    set_facing(b.mirrored, true);
    glBindVertexArray(b.mesh->triangles.id());
    instances.bind(b.first);
    draw_parts(things, batches, b);
  }
}

void PhysicalSurfaces::draw_opaque(const Things& things, std::span<const std::uint32_t> numbers) {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  draw_batches(things, batches_of(things, numbers), solid_);
}

void PhysicalSurfaces::draw_through(const Canvas& canvas, const Things& things,
                                    std::span<const std::uint32_t> numbers) {
  if (numbers.empty()) return;
  const int width = canvas.width() * canvas.side(), height = canvas.height() * canvas.side();
  if (behind_.id() == 0 || behind_width_ != width || behind_height_ != height) {
    behind_width_ = width, behind_height_ = height, behind_levels_ = 1;
    for (int least = std::min(width, height); least > 8; least /= 2) ++behind_levels_;
    GLuint id = 0;
    glGenTextures(1, &id);
    behind_ = gl::Texture(id);
    gl::use_texture(behind_at, id);
    glTexStorage2D(GL_TEXTURE_2D, behind_levels_, canvas.format(), width, height);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_MIRRORED_REPEAT);
    glGenFramebuffers(1, &id);
    behind_frame_ = gl::Framebuffer(id);
    glBindFramebuffer(GL_FRAMEBUFFER, id);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, behind_.id(), 0);
    canvas.bind();
  }
  receives_ = false, ++frame_number_;
  const Batches batches = sorted_singles(things, numbers);
  // What is nearer shows what is behind it through it, so each one sees those before it; a copy for each would cost too
  // much, so the picture is copied at most this often.
  constexpr std::size_t most_copies = 6;
  const std::size_t step = std::max<std::size_t>((batches.order.size() + most_copies - 1) / most_copies, 1);
  for (std::size_t first = 0; first < batches.order.size(); first += step) {
    canvas.copy_color_to(behind_frame_.id());
    gl::use_texture(behind_at, behind_.id());
    glGenerateMipmap(GL_TEXTURE_2D);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    const std::span<const std::uint32_t> some(
        batches.order.begin() + static_cast<std::ptrdiff_t>(first),
        batches.order.begin() + static_cast<std::ptrdiff_t>(std::min(first + step, batches.order.size())));
    draw_batches(things, sorted_singles(things, some), clear_);
  }
}

void PhysicalSurfaces::draw_transparent(const Things& things, std::span<const std::uint32_t> numbers) {
  const Batches batches = sorted_singles(things, numbers);
  glass_.set(things, batches.order);
  receives_ = false, ++frame_number_;
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  Once once;
  for (const Batch& b : batches.batches) {
    if (b.mesh->parts.empty()) continue;
    Store::need_triangles(*b.mesh);
    set_facing(b.mirrored, true);
    glBindVertexArray(b.mesh->triangles.id());
    glass_.bind(b.first);
    (b.closed ? glEnable : glDisable)(GL_CULL_FACE);
    if (b.line) {
      once.begin();
    } else if (b.closed) {
      glCullFace(GL_FRONT);
      draw_parts(things, batches, b);
      glCullFace(GL_BACK);
    }
    draw_parts(things, batches, b);
    Once::end();
  }
  glDepthMask(GL_TRUE);
}

void PhysicalSurfaces::draw_setting(const Surfaces::FrameSettings& frame, const Gradient& gradient, bool encoded) {
  const bool sky_seen = sky_.seen_behind() && sky_;
  const bool was = std::exchange(encodes_, encoded);
  ++frame_number_;
  Look* const look = need((common_ & ~static_cast<unsigned>(contact)) | ground | (frame.contact ? contact : 0U));
  if (look == nullptr) return;
  if (sky_seen && (seen_.id() == 0 || seen_of_ != sky_.light())) {
    constexpr int width = 2048, height = 1024;
    std::vector<float> rgba(static_cast<std::size_t>(4 * width * height), 1);
    std::vector<Vec3> turns;
    for (int x = 0; x < width; ++x) {
      const auto [sine, cosine] = sine_cosine(2 * pi * ((x + 0.5) / width - 0.5));
      turns.push_back({cosine, 0, sine});
    }
    for (int y = 0; y < height; ++y) {
      const auto [sine, cosine] = sine_cosine(pi * (0.5 - (y + 0.5) / height));
      for (int x = 0; x < width; ++x) {
        const Vec3 c = sky_.light()->seen(
            {cosine * turns[static_cast<std::size_t>(x)].x, sine, cosine * turns[static_cast<std::size_t>(x)].z});
        float* const to = &rgba[4 * (static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x))];
        for (int i = 0; i < 3; ++i) to[i] = static_cast<float>(std::min(c[i], 65000.0));
      }
    }
    seen_ = gl::new_texture(GL_RGBA16F, width, height, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, rgba.data());
    seen_of_ = sky_.light();
  }
  gl::use_texture(seen_at, seen_.id());
  const View& v = frame.view;
  const auto put = [&](const char* name, Vec3 value) { glUniform3fv(place(*look, name), 1, quad(value, 0).data()); };
  const Vec3 aside = v.shift_x / v.sx * v.right + v.shift_y / v.sy * v.up;
  put("ray", v.orthographic ? -v.backward : -v.backward - aside);
  put("ray_x", v.orthographic ? Vec3{} : 1 / v.sx * v.right);
  put("ray_y", v.orthographic ? -0.5 * v.up : -1 / v.sy * v.up);
  put("from_x", v.orthographic ? 1 / v.sx * v.right : Vec3{});
  put("from_y", v.orthographic ? -1 / v.sy * v.up : Vec3{});
  put("top", gradient.top), put("bottom", gradient.bottom);
  const bool floor = frame.around.ground && v.eye.y > 0;
  glUniform2f(place(*look, "shape"), gradient.bends ? 1 : 0, sky_seen ? 1 : 0);
  glUniform1f(place(*look, "empty"), frame.clear ? 1 : 0);
  glUniform4fv(place(*look, "floor_color"), 1, quad(frame.around.ground.value_or(Vec3{}), floor ? 1 : 0).data());
  glUniform1f(place(*look, "floor_height"), static_cast<float>(-v.eye.y));
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  gl::fill();
  encodes_ = was, ++frame_number_;
}

}  // namespace betwixt
