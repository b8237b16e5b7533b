// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/surfaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/balls.h"
#include "render/physical_units.h"
#include "render/shading.h"

namespace betwixt {
namespace {

// Lookups along a side, and the texels between them: each blends four texels, so no steps are visible.
constexpr int shadow_taps = 2;
constexpr float shadow_step = 2;
constexpr int picture_unit = 0, shadow_unit = 1, depth_unit = 2;

// Returns whether the simple programs are not enough.
bool is_rich(const Surfaces::FrameSettings& frame) {
  return has_rich_shadows(frame) || (frame.metal && (frame.around.sky || frame.around.ground));
}

// Returns the largest depth of everything that is drawn after each of them.
std::vector<double> depths_later(const Things& things, const Batches& sorted) {
  std::vector<double> farthest(sorted.order.size(), -INFINITY);
  for (std::size_t i = farthest.size(); i-- > 1;) {
    const Thing& t = things[sorted.order[i]];
    farthest[i - 1] = std::max(farthest[i], t.depth + t.bounds.radius());
  }
  return farthest;
}

// Draws the depth alone, so that afterwards only the nearest of the lit surfaces are drawn.
void draw_depth(const std::function<void()>& draw) {
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDepthMask(GL_TRUE);
  draw();
  glDepthMask(GL_FALSE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace

std::array<float, 3 * shadow_seeds> sunflower() {
  std::array<float, 3 * shadow_seeds> r;
  const double golden = pi * (3 - std::sqrt(5.0));
  for (int k = 0; k < shadow_seeds; ++k) {
    const double away = std::sqrt((k + 0.5) / shadow_seeds);
    r[static_cast<std::size_t>(3 * k)] = static_cast<float>(away * std::cos(golden * k));
    r[static_cast<std::size_t>(3 * k + 1)] = static_cast<float>(away * std::sin(golden * k));
    r[static_cast<std::size_t>(3 * k + 2)] = static_cast<float>(away);
  }
  return r;
}

bool has_rich_shadows(const Surfaces::FrameSettings& frame) {
  return !frame.shadows.empty() && (frame.shadows.back().light > 0 || frame.shadows.front().spread > 0);
}

Result<Surfaces::Look> Surfaces::new_look(bool fills, std::size_t variant, const char* defines) const {
  const std::string vertex = fills ? std::string(gl::fill_vertex)
                                   : std::string(vertex_inputs) + ball_outline + gradient_vertex + surface_vertex;
  auto program = gl::new_program(
      vertex,
      std::string(encoded_function) + surface_inputs + gradient_shader + shadow_lookup + surface_functions +
          surface_fragment + surface_end,
      fmt::format("#define TAPS {}\n#define SEEDS {}\n#define CASTERS {}\n#define MAPS {}\n{}{}{}{}{}", shadow_taps,
                  shadow_seeds, (variant & rich) != 0 ? Lighting::most_casting : 1,
                  (variant & (rich | levels)) != 0 ? Shadows::most_maps : 1,
                  (variant & rich) != 0 ? "#define RICH\n" : "", (variant & levels) != 0 ? "#define LEVELS\n" : "",
                  (variant & contact) != 0 ? "#define RECEIVES\n" : "", unclamped_ ? "#define OPEN\n" : "", defines));
  if (!program) return program.error();
  Look look;
  look.program = *std::move(program);
  look.encodes = gl::uniform(look.program, "encodes");
  look.receives = gl::uniform(look.program, "receives");
  look.part_color = gl::uniform(look.program, "part_color");
  gl::set_samplers(look.program, {{"shadows", shadow_unit}, {"depths", depth_unit}, {"picture", picture_unit}});
  if ((variant & rich) != 0) glUniform3fv(gl::uniform(look.program, "seeds"), shadow_seeds, sunflower().data());
  return look;
}

// Makes one program, to know whether the driver can.
Result<Surfaces> Surfaces::create(bool unclamped) {
  Surfaces s;
  s.unclamped_ = unclamped;
  auto simple = s.new_look(false, 0, "");
  if (!simple) return simple.error();
  s.variants_[0].plain = *std::move(simple);
  s.depths_ = gl::new_depth_sampler();
  return s;
}

const Surfaces::Look* Surfaces::need(Look Looks::*which) {
  Look& look = looks().*which;
  if (look.program.id() != 0) return &look;
  const bool ground = which == &Looks::ground;
  const char* const defines = ground                             ? "#define GROUND"
                              : which == &Looks::textured        ? "#define TEXTURED"
                              : which == &Looks::balls           ? "#define BALL"
                              : which == &Looks::graded          ? "#define GRADIENT"
                              : which == &Looks::graded_textured ? "#define GRADIENT\n#define TEXTURED"
                                                                 : "";
  auto made = new_look(ground, variant_, defines);
  if (!made) {
    looks().refused = true;
    if (variant_ == 0) return nullptr;
    use(variant_);
    return need(which);
  }
  look = *std::move(made);
  prepare(look);
  return &look;
}

template <class F>
void Surfaces::each_made(F&& f) {
  Looks& all = looks();
  for (const Look* look : {&all.textured, &all.balls, &all.plain, &all.graded, &all.graded_textured})
    if (look->program.id() != 0) f(*look);
}

// Sets everything that depends on the frame.
void Surfaces::prepare(const Look& look) const {
  set_program(look, *frame_);
  if ((variant_ & rich) != 0) set_mirrored(look, *frame_);
  glUniform1f(look.encodes, encodes_ ? 1 : 0);
  glUniform1f(look.receives, receives_ ? 1 : 0);
}

void Surfaces::set_program(const Look& look, const FrameSettings& frame) {
  const View& view = frame.view;
  const Lighting& lighting = frame.lighting;
  const Surroundings& around = frame.around;
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
  set_shadow_maps(look.program, frame);
}

void set_shadow_maps(const gl::Program& program, const Surfaces::FrameSettings& frame) {
  const auto at = [&](const char* name) { return gl::uniform(program, name); };
  // Without shadow maps, everything is lit.
  std::array<std::array<float, 16>, Shadows::most_maps> clips{};
  std::array<std::array<float, 4>, Shadows::most_maps> shapes{};
  std::array<GLint, Lighting::most_casting> ends{};
  for (std::size_t i = 0; i < frame.shadows.size(); ++i) {
    const Shadows::Map& map = frame.shadows[i];
    clips[i] = to_float(map.clip);
    shapes[i] = four({map.perspective ? 0 : map.texel, map.perspective ? map.texel : 0, map.spread}, map.top);
    ends[map.light] = static_cast<GLint>(i + 1);
  }
  for (std::size_t i = 1; i < ends.size(); ++i) ends[i] = std::max(ends[i], ends[i - 1]);
  const std::size_t casting = frame.shadows.empty() ? 0 : frame.shadows.back().light + 1;
  const auto count = static_cast<GLsizei>(std::max<std::size_t>(frame.shadows.size(), 1));
  glUniformMatrix4fv(at("shadow_clip"), count, GL_FALSE, clips.front().data());
  glUniform4fv(at("shadow_shape"), count, shapes.front().data());
  glUniform1i(at("casting"), static_cast<GLint>(casting));
  if (casting > 0) glUniform1iv(at("shadow_end"), static_cast<GLsizei>(casting), ends.data());
  glUniform1f(at("shadow_step"), shadow_step / Shadows::map_size);
}

// Sets what metals reflect besides the floor: the sky, or else ambient light, so bright that it looks like metal.
void Surfaces::set_mirrored(const Look& look, const FrameSettings& frame) {
  const auto at = [&](const char* name) { return gl::uniform(look.program, name); };
  const auto& [view, lighting, shadows, layers, around, metal, contact, clear] = frame;
  glUseProgram(look.program.id());
  glUniform3fv(at("top"), 1, four(around.sky ? in_metal(lighting.zenith) : 3 * lighting.sky, 0).data());
  glUniform3fv(at("bottom"), 1, four(around.sky ? in_metal(lighting.horizon) : 3 * lighting.sky, 0).data());
  glUniform3fv(at("under"), 1, four(around.sky ? in_metal(lighting.below) : 3 * lighting.ground, 0).data());
  glUniform4fv(at("floor_color"), 1, four(around.ground.value_or(Vec3{}), around.ground ? 1 : 0).data());
  glUniform1f(at("floor_height"), static_cast<float>(-view.eye.y));
}

// Chooses the variant, or one with as many of its features as the driver takes.
void Surfaces::use(std::size_t variant) {
  const std::size_t simpler[] = {variant, variant & contact, 0};
  variant_ =
      *std::find_if(std::begin(simpler), std::end(simpler) - 1, [&](std::size_t v) { return !variants_[v].refused; });
  each_made([&](const Look& look) { prepare(look); });
}

void Surfaces::set(const FrameSettings& frame) {
  frame_ = &frame;
  encodes_ = false, receives_ = frame.contact;
  use((frame.contact ? contact : 0) | (is_rich(frame) ? rich : frame.shadows.size() > 1 ? levels : 0));
  flat_ = frame.around.flat;
  if (frame.shadows.empty()) return;
  gl::use_layers(shadow_unit, frame.shadow_layers);
  gl::use_layers(depth_unit, frame.shadow_layers);
  glBindSampler(depth_unit, depths_.id());
}

void Surfaces::draw_setting(const FrameSettings& frame, const Backdrop& gradient, bool encoded) {
  const Look* const made = need(&Looks::ground);
  if (made == nullptr) return;
  const Look& ground = *made;
  set_program(ground, frame);
  put_setting(ground.program, frame);
  const auto put = [&](const char* name, Vec3 value) {
    glUniform3fv(gl::uniform(ground.program, name), 1, four(value, 0).data());
  };
  const Lighting& light = frame.lighting;
  const bool sky = frame.around.sky && !frame.around.clear;
  put("top", sky ? light.zenith : gradient.top), put("bottom", sky ? light.horizon : gradient.bottom);
  put("under", light.below);
  glUniform2f(gl::uniform(ground.program, "shape"), gradient.bends ? 1 : 0, sky ? 1 : 0);
  glUniform1f(ground.encodes, encoded ? 1 : 0);
  glUniform1f(ground.receives, frame.contact ? 1 : 0);
  fill_behind();
}

void put_setting(const gl::Program& program, const Surfaces::FrameSettings& frame) {
  const View& v = frame.view;
  const auto put = [&](const char* name, Vec3 value) {
    glUniform3fv(gl::uniform(program, name), 1, four(value, 0).data());
  };
  // An orthographic picture shows the sky as if it were in perspective.
  const Vec3 aside = v.shift_x / v.sx * v.right + v.shift_y / v.sy * v.up;
  put("ray", v.orthographic ? -v.backward : -v.backward - aside);
  put("ray_x", v.orthographic ? Vec3{} : 1 / v.sx * v.right);
  put("ray_y", v.orthographic ? -0.5 * v.up : -1 / v.sy * v.up);
  put("from_x", v.orthographic ? 1 / v.sx * v.right : Vec3{});
  put("from_y", v.orthographic ? -1 / v.sy * v.up : Vec3{});
  glUniform1f(gl::uniform(program, "empty"), frame.clear ? 1 : 0);
  const bool seen = frame.around.ground && v.eye.y > 0;
  glUniform4fv(gl::uniform(program, "floor_color"), 1, four(frame.around.ground.value_or(Vec3{}), seen ? 1 : 0).data());
  glUniform1f(gl::uniform(program, "floor_height"), static_cast<float>(-v.eye.y));
}

void fill_behind() {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  gl::fill();
}

void Surfaces::draw_parts(const Things& things, const Batches& batches, const Batch& batch) {
  for (const StoredPart& part : batch.mesh->parts) {
    const StoredTexture* const picture = batch.texture != nullptr ? batch.texture : part.texture.get();
    const GLuint texture = picture != nullptr ? Store::need_texture(*picture) : 0;
    const Gradient* const gradient = gradient_of(batch, part);
    const Look* const look = need(batch.ball            ? &Looks::balls
                                  : gradient != nullptr ? texture != 0 ? &Looks::graded_textured : &Looks::graded
                                  : texture != 0        ? &Looks::textured
                                                        : &Looks::plain);
    if (look == nullptr) continue;
    if (texture != 0) gl::use_texture(picture_unit, texture);
    glUseProgram(look->program.id());
    if (gradient != nullptr) {
      const auto at = [&](const char* name) { return gl::uniform(look->program, name); };
      set_gradient(*gradient, things[batches.order[batch.first]], at);
    }
    set_part_color(part, gradient, [&](const char*) { return look->part_color; });
    glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(part.count), GL_UNSIGNED_INT,
                            reinterpret_cast<const void*>(part.first * sizeof(std::uint32_t)),
                            static_cast<GLsizei>(batch.count));
  }
}

void Surfaces::write_encoded(bool encoded) {
  encodes_ = encoded;
  each_made([&](const Look& look) {
    glUseProgram(look.program.id());
    glUniform1f(look.encodes, encoded ? 1 : 0);
  });
}

void Surfaces::receive_contact(bool receives) {
  receives_ = receives;
  each_made([&](const Look& look) {
    glUseProgram(look.program.id());
    glUniform1f(look.receives, receives ? 1 : 0);
  });
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
    draw_parts(things, batches, b);
  }
}

void Surfaces::draw_transparent(const Things& things, std::span<const std::uint32_t> numbers) {
  receive_contact(false);
  const Batches batches = sorted_singles(things, numbers);
  draw_over(things, batches, glass_, !flat_, [&](const Batch& b) { draw_parts(things, batches, b); });
}

void draw_over(const Things& things, const Batches& batches, Instances& instances, bool lit,
               const std::function<void(const Batch&)>& draw) {
  instances.set(things, batches.order);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  Once once;
  const std::vector<double> later = depths_later(things, batches);
  for (const Batch& b : batches.batches) {
    if (b.mesh->parts.empty()) continue;
    Store::need_triangles(*b.mesh);
    set_facing(b.mirrored, true);
    glBindVertexArray(b.mesh->triangles.id());
    instances.bind(b.first);
    (b.closed ? glEnable : glDisable)(GL_CULL_FACE);
    if (b.line) {
      const Thing& line = things[batches.order[b.first]];
      const bool hides = later[b.first] > line.depth - line.bounds.radius();  // some part of it may be behind
      if (lit && line.look.material != Material::glow && !hides) draw_depth([&] { draw(b); });
      once.begin();
    } else if (b.closed) {
      glCullFace(GL_FRONT);
      draw(b);
      glCullFace(GL_BACK);
    }
    draw(b);
    Once::end();
  }
  glDepthMask(GL_TRUE);
}

}  // namespace betwixt
