// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/physical.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/balls.h"
#include "render/physical_shading.h"
#include "render/physical_units.h"
#include "render/shading.h"
#include "scene/patterns.h"

namespace betwixt {
namespace {

bool is_lamp_with_front(const Lighting::One& l) { return l.shape != LightShape::point || l.cone > 0; }

}  // namespace

unsigned PhysicalSurfaces::shadow_features(const Surfaces::FrameSettings& frame) {
  return has_rich_shadows(frame) ? rich : frame.shadows.size() > 1 ? levels : 0U;
}

bool needs_physical(const Things& things, const Scenery& scenery, const SkyAround& sky) {
  const Surroundings& around = scenery.surroundings;
  if (around.flat) return false;
  if (sky) return true;
  for (const Light& l : scenery.lights)
    if (l.shape != LightShape::point || l.cone > 0) return true;
  return has_finishes(things);
}

bool has_finishes(const Things& things) {
  return std::any_of(things.all().begin(), things.all().end(),
                     [](const Thing& t) { return t.visible && t.finish != nullptr; });
}

PhysicalSurfaces::Look* PhysicalSurfaces::need(unsigned features) {
  Look& look = looks_[features];
  if (look.refused) return nullptr;
  if (look.program.id() == 0) {
    constexpr std::pair<Feature, const char*> names[] = {
        {ball, "BALL"},           {pictures, "PICTURES\n#define TEXTURED"},
        {projected, "PROJECTED"}, {pattern, "PATTERN"},
        {coated, "COATED"},       {through, "THROUGH"},
        {ground, "GROUND"},       {areas, "AREAS"},
        {shadowed, "SHADOWED"},   {contact, "RECEIVES"},
        {rich, "RICH"},           {levels, "LEVELS"},
        {projects, "PROJECTS"},   {gradient, "GRADIENT"},
        {inner, "INNER"}};
    std::string defines =
        fmt::format("#define TAPS 2\n#define SEEDS {}\n#define CASTERS {}\n#define MAPS {}\n#define PHYSICAL\n",
                    shadow_seeds, (features & rich) != 0 ? Lighting::most_casting : 1,
                    (features & (rich | levels)) != 0 ? Shadows::most_maps : 1);
    for (const auto& [bit, name] : names)
      if ((features & bit) != 0) defines += fmt::format("#define {}\n", name);
    if (unclamped_) defines += "#define OPEN\n";
    const std::string vertex = (features & ground) != 0
                                   ? std::string(gl::fill_vertex)
                                   : std::string(vertex_inputs) + ball_outline + gradient_vertex + surface_vertex;
    std::string fragment = std::string(encoded_function) + physical_inputs + gradient_shader;
    if ((features & shadowed) != 0) fragment += shadow_lookup;
    if ((features & pattern) != 0) fragment += pattern_shader;
    auto made = gl::new_program(vertex, fragment + surface_functions + physical_fragment + surface_end, defines);
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
                                    {"behind_depth", behind_depth_at},
                                    {"normals", normals_at},
                                    {"roughness_map", roughness_at},
                                    {"metalness_map", metalness_at},
                                    {"occlusion_map", occlusion_at},
                                    {"emission_map", emission_at},
                                    {"seen", seen_at},
                                    {"slide", slide_at}});
    glUniform3fv(place(look, "seeds"), shadow_seeds, sunflower().data());
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

GLuint PhysicalSurfaces::plain_texture(bool normals) {
  gl::Texture& texture = normals ? flat_ : white_;
  if (texture.id() == 0) {
    glActiveTexture(GL_TEXTURE0 + picture_at);  // which is set after the other pictures; making one binds it
    texture = gl::new_texture(GL_RGBA8, 1, 1, GL_NEAREST);
    const std::array<std::uint8_t, 4> flat{128, 128, 255, 255}, white{255, 255, 255, 255};
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, (normals ? flat : white).data());
  }
  return texture.id();
}

void PhysicalSurfaces::set(const Surfaces::FrameSettings& frame, SkyAround sky) {
  frame_ = &frame, sky_ = std::move(sky), ++frame_number_;
  encodes_ = false, receives_ = frame.contact;
  const auto& all = frame.lighting.lights;
  common_ = (frame.contact ? contact : 0U) | (frame.shadows.empty() ? 0U : shadowed) | shadow_features(frame) |
            (slide_ ? projects : 0U) | (std::any_of(all.begin(), all.end(), is_lamp_with_front) ? areas : 0U);
  need_sky_light();
  if (slide_) gl::use_texture(slide_at, Store::need_texture(*slide_));
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
  if (gradient_of(batch, part) != nullptr) f |= gradient;
  if (!finish) return f;
  if (finish->pattern != Pattern::none) f |= pattern;
  if (finish->clearcoat > 0 || !(finish->sheen == Vec3{})) f |= coated;
  if (finish->transmission > 0 && behind_.id() != 0 && t.finish) f |= through;
  return f;
}

void PhysicalSurfaces::draw_parts(const Things& things, const Batches& batches, const Batch& batch, unsigned more) {
  const Thing& t = things[batches.order[batch.first]];
  for (const StoredPart& part : batch.mesh->parts) {
    const unsigned features = features_of(batch, part, t) | more;
    Look* const look = need(features);
    if (look == nullptr) continue;
    set_finish(*look, batch, t, features);
    if ((features & pictures) != 0) {
      const StoredTexture* const own = batch.texture != nullptr ? batch.texture : part.texture.get();
      const GLuint id = own != nullptr ? Store::need_texture(*own) : 0;
      gl::use_texture(picture_at, id != 0 ? id : plain_texture(false));
    }
    const auto at = [&](const char* name) { return place(*look, name); };
    const Gradient* const graded = gradient_of(batch, part);
    if (graded != nullptr) set_gradient(*graded, t, at);
    set_part_color(part, graded, at);
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

// Makes the copy of the picture that clear objects show, or keeps it.
void PhysicalSurfaces::need_copy(const Canvas& canvas) {
  const int width = canvas.width() * canvas.side(), height = canvas.height() * canvas.side();
  if (behind_.id() != 0 && behind_width_ == width && behind_height_ == height) return;
  behind_width_ = width, behind_height_ = height, behind_levels_ = 1;
  for (int least = std::min(width, height); least > 1; least /= 2) ++behind_levels_;
  const auto mirror = [] {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_MIRRORED_REPEAT);
  };
  GLuint id = 0;
  glGenTextures(1, &id);
  behind_ = gl::Texture(id);
  gl::use_texture(behind_at, id);
  glTexStorage2D(GL_TEXTURE_2D, behind_levels_, canvas.format(), width, height);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  mirror();
  behind_depth_ = gl::new_texture(GL_DEPTH24_STENCIL8, width, height, GL_NEAREST);
  mirror();
  glGenFramebuffers(1, &id);
  behind_frame_ = gl::Framebuffer(id);
  glBindFramebuffer(GL_FRAMEBUFFER, id);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, behind_.id(), 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, behind_depth_.id(), 0);
  canvas.bind();
}

// Draws what the far walls of clear solids mirror inside, over what is there. Without them a block would have no edges
// before an even background.
void PhysicalSurfaces::draw_inner_walls(const Things& things, const Batches& batches) {
  inner_.set(things, batches.order);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT);
  for (const Batch& b : batches.batches) {
    if (b.mesh->parts.empty() || !b.closed || b.ball || !b.finish || !(b.finish->thickness > 0)) continue;
    Store::need_triangles(*b.mesh);
    set_facing(b.mirrored, true);
    glBindVertexArray(b.mesh->triangles.id());
    inner_.bind(b.first);
    draw_parts(things, batches, b, inner);
  }
  glCullFace(GL_BACK);
}

void PhysicalSurfaces::draw_through(const Canvas& canvas, const Things& things,
                                    std::span<const std::uint32_t> numbers) {
  if (numbers.empty()) return;
  need_copy(canvas);
  canvas.write_linear();
  encodes_ = false;
  receives_ = false, ++frame_number_;
  const Batches batches = sorted_singles(things, numbers);
  // What is nearer shows what is behind it through it, so each one sees those before it; a copy for each would cost too
  // much, so the picture is copied at most this often.
  constexpr std::size_t most_copies = 6;
  const std::size_t step = std::max<std::size_t>((batches.order.size() + most_copies - 1) / most_copies, 1);
  for (std::size_t first = 0; first < batches.order.size(); first += step) {
    const std::span<const std::uint32_t> some(batches.order.data() + first,
                                              std::min(step, batches.order.size() - first));
    const Batches now = sorted_singles(things, some);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    draw_inner_walls(things, now);
    // The depth stays that of what is opaque: clear objects that are drawn already are farther away.
    canvas.copy_color_to(behind_frame_.id(), first == 0);
    gl::use_texture(behind_depth_at, behind_depth_.id());
    gl::use_texture(behind_at, behind_.id());
    glGenerateMipmap(GL_TEXTURE_2D);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    draw_batches(things, now, clear_);
  }
}

void PhysicalSurfaces::draw_transparent(const Things& things, std::span<const std::uint32_t> numbers) {
  receives_ = false, ++frame_number_;
  const Batches batches = sorted_singles(things, numbers);
  draw_over(things, batches, glass_, true, [&](const Batch& b) { draw_parts(things, batches, b); });
}

void PhysicalSurfaces::draw_setting(const Surfaces::FrameSettings& frame, const Backdrop& gradient, bool encoded) {
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
  put_setting(look->program, frame);
  const auto put = [&](const char* name, Vec3 value) { glUniform3fv(place(*look, name), 1, four(value, 0).data()); };
  put("top", gradient.top), put("bottom", gradient.bottom);
  const SkyAround::Disc disc = sky_ ? sky_.disc() : SkyAround::Disc{};
  glUniform4fv(place(*look, "disc"), 1, four(disc.toward, disc.size).data());
  put("disc_color", disc.color);
  glUniform2f(place(*look, "shape"), gradient.bends ? 1 : 0, sky_seen ? 1 : 0);
  fill_behind();
  encodes_ = was, ++frame_number_;
}

}  // namespace betwixt
