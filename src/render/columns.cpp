// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/columns.h"

#include <algorithm>

#include "program/surroundings.h"

namespace betwixt {
namespace {

// Returns the number of the last element, after adding the value if it is a new one.
template <class T>
std::uint32_t number_of(std::vector<T>& all, const T& one) {
  if (one == nullptr) return Evaluation::Look::none;
  if (all.empty() || all.back() != one) all.push_back(one);
  return static_cast<std::uint32_t>(all.size() - 1);
}

}  // namespace

bool same_light(const Light& a, const Light& b) {
  return a.sun == b.sun && a.position == b.position && a.direction == b.direction && a.color == b.color &&
         a.range == b.range && a.casting == b.casting && a.shape == b.shape && a.across == b.across &&
         a.width == b.width && a.height == b.height && a.cone == b.cone && a.cone_edge == b.cone_edge &&
         a.picture == b.picture;
}

Columns columns_of(const Evaluation& e) {
  const Scene& scene = e.program().document().scene();
  return {.worlds = e.worlds(), .looks = e.looks(), .shape = [&e](std::uint32_t n) -> const auto& {return e.shape(n);
}
, .texture = [&e](std::uint32_t n) { return e.texture(n); }, .finish = [&e](std::uint32_t n) -> const auto& {
  return e.finish(n);
}
, .gradients = [&e](std::uint32_t n) -> const auto& { return e.gradients(n); }
, .changed = {}, .lights = e.lights(), .camera = e.camera(), .background = background_of(scene),
  .surroundings = surroundings_of(scene)
};  // namespace betwixt
}

Content content_of(const Columns& c, std::uint32_t i) {
  const Evaluation::Look& l = c.looks[i];
  Content p{c.worlds[i],
            l,
            found(l.shape, c.shape),
            found(l.toward, c.shape),
            found(l.texture, c.texture),
            found(l.finish, c.finish),
            found(l.gradients, c.gradients)};
  p.look.shape = p.look.toward = p.look.texture = p.look.finish = p.look.gradients = Evaluation::Look::none;
  return p;
}

bool Scenery::take(const Columns& c) {
  const bool same = background == c.background && surroundings == c.surroundings &&
                    std::equal(lights.begin(), lights.end(), c.lights.begin(), c.lights.end(), same_light);
  lights = c.lights, background = c.background, surroundings = c.surroundings;
  return !same;
}

FrameColumns::FrameColumns(const Frame& frame) : frame_(frame) {
  worlds_.reserve(frame.items.size()), looks_.reserve(frame.items.size());
  for (const Item& i : frame.items) {
    worlds_.push_back(i.world);
    looks_.push_back({.color = i.color,
                      .transparency = i.transparency,
                      .shininess = i.shininess,
                      .blend = i.blend,
                      .shape = number_of(shapes_, i.shape),
                      .toward = number_of(shapes_, i.toward),
                      .texture = number_of(textures_, i.texture),
                      .finish = number_of(finishes_, i.finish),
                      .gradients = number_of(gradients_, i.gradients),
                      .material = i.material,
                      .visible = true,
                      .casts = i.casts});
  }
}

Columns FrameColumns::columns() const {
  return {.worlds = worlds_, .looks = looks_, .shape = [this](std::uint32_t n) -> const auto& {return shapes_[n];
}
, .texture = [this](std::uint32_t n) { return textures_[n]; }, .finish = [this](std::uint32_t n) -> const auto& {
  return finishes_[n];
}
, .gradients = [this](std::uint32_t n) -> const auto& { return gradients_[n]; }
, .changed = {}, .lights = frame_.lights, .camera = frame_.camera, .background = frame_.background,
  .surroundings = frame_.surroundings
}
;
}

}  // namespace betwixt
