// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/things.h"

#include <algorithm>
#include <cstring>

#include "base/stages.h"
#include "exchange/gradient_place.h"

namespace betwixt {
namespace {

constexpr double largest = 1e15;  // metres; squares of f32 stay finite

template <class T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

bool same_camera(const Camera& a, const Camera& b) {
  return same_bits(a.world, b.world) && a.orthographic == b.orthographic && same_bits(a.fov, b.fov) &&
         same_bits(a.height, b.height) && same_bits(a.shift_x, b.shift_x) && same_bits(a.shift_y, b.shift_y);
}

// Compares all but the shapes and textures of the numbers.
bool same_look(Evaluation::Look a, const Evaluation::Look& b) {
  a.shape = b.shape, a.toward = b.toward, a.texture = b.texture, a.finish = b.finish, a.gradients = b.gradients;
  return a == b;
}

bool usable(const Thing& t) {
  const Evaluation::Look& l = t.look;
  return l.visible && t.shape != nullptr && finite(t.world) && finite(l.color) && std::isfinite(l.transparency) &&
         std::isfinite(l.shininess) && std::isfinite(l.blend) && l.transparency < 1;
}

// In a drawing a line is as flat as everything else. Otherwise it would stick out of what is a little in front of it.
bool can_press(const Thing& t, const Box& box) {
  return t.line && t.shape->width > 0 && box.high.z - box.low.z <= 1.01 * t.shape->width;
}

double largest_measure(const Box& box, const Mat4& m) {
  const Vec3 half = box.half();
  return std::max({length(column(m, 0)) * half.x, length(column(m, 1)) * half.y, length(column(m, 2)) * half.z});
}

bool is_round(const Thing& t) {
  const double size = t.bounds.radius();
  return t.shape->kind == Kind::sphere && !t.form->blends() && t.texture == nullptr && t.gradients == nullptr &&
         !t.transparent && std::abs(determinant(t.world) * std::pow(t.shape->radius, 3)) > 1e-4 * size * size * size;
}

}  // namespace

Instance instance_of(const Thing& t, const Mat4& m) {
  Instance r{};
  std::array<Vec3, 3> c;
  double scale = 0;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 4; ++k) r.rows[static_cast<std::size_t>(4 * i + k)] = static_cast<float>(m(i, k));
    c[static_cast<std::size_t>(i)] = {m(0, i), m(1, i), m(2, i)};
  }
  // The inverse transpose up to its length: the cross products of the columns.
  std::array<Vec3, 3> n = {cross(c[1], c[2]), cross(c[2], c[0]), cross(c[0], c[1])};
  for (const Vec3& v : n) scale = std::max(scale, length(v));
  scale = scale > 0 ? (t.mirrored ? -1 : 1) / scale : 0;
  for (std::size_t i = 0; i < 9; ++i) r.normal[i] = static_cast<float>(scale * n[i / 3][static_cast<int>(i % 3)]);
  const Evaluation::Look& look = t.look;
  for (int i = 0; i < 3; ++i)
    r.color[static_cast<std::size_t>(i)] = static_cast<float>(std::clamp(look.color[i], 0.0, 1e4));
  r.color[3] = static_cast<float>(1 - std::clamp(look.transparency, 0.0, 1.0));
  r.look = {static_cast<float>(std::clamp(look.shininess, 0.0, 1.0)), static_cast<float>(look.material)};
  return r;
}

bool Things::same(const Thing& t, const Columns& c, std::uint32_t i) const {
  const Evaluation::Look& l = c.looks[i];
  return same_bits(t.world, c.worlds[i]) && same_look(t.look, l) && t.shape == found(l.shape, c.shape) &&
         t.toward == found(l.toward, c.shape) && t.picture == found(l.texture, c.texture) &&
         t.finish == found(l.finish, c.finish) && t.gradients == found(l.gradients, c.gradients);
}

void Things::find_changed(const Columns& c) {
  const std::size_t before = things_.size(), now = c.worlds.size();
  changed_.clear();
  if (c.changed && before == now) {
    changed_.assign(c.changed->begin(), c.changed->end());
    return;
  }
  if (now < before) ++casters_;
  things_.resize(now);
  for (std::uint32_t i = 0; i < now; ++i)
    if (i >= before || !same(things_[i], c, i)) changed_.push_back(i);
}

bool Things::take(const Columns& c) {
  const InStage stage(Stage::gather);
  forms_.next_picture();
  const std::size_t before = things_.size();
  find_changed(c);
  for (const std::uint32_t i : changed_) adopt(things_[i], c, i);
  const bool touched = c.surroundings.contact && c.surroundings.ground;
  all_changed_ = !camera_ || !same_camera(*camera_, c.camera) || flat_ != c.surroundings.flat || touched_ != touched;
  flat_ = c.surroundings.flat, touched_ = touched;
  if (!all_changed_ && changed_.empty() && things_.size() == before) return false;
  if (all_changed_) {
    camera_ = c.camera;
    view_ = make_view(c.camera, width_, height_, good_);
    for (Thing& t : things_) see(t);
  } else {
    for (const std::uint32_t i : changed_) see(things_[i]);
  }
  double nearest = largest, farthest = 0;
  for (const Thing& t : things_) {
    if (!t.visible) continue;
    const double reach = view_.reach(t.bounds);
    nearest = std::min(nearest, t.depth - reach), farthest = std::max(farthest, t.depth + reach);
  }
  // The floor in front of the objects needs depths as far as contact shading reaches.
  if (touched_) nearest -= 2 * contact_reach / view_.sy * (view_.orthographic ? 1 : std::max(nearest, 0.0));
  view_.fit(nearest, farthest);
  return true;
}

void Things::adopt(Thing& t, const Columns& c, std::uint32_t i) {
  const Evaluation::Look& l = c.looks[i];
  auto shape = found(l.shape, c.shape), toward = found(l.toward, c.shape);
  auto picture = found(l.texture, c.texture);
  if (t.casts) ++casters_;
  if (t.shape != shape || t.toward != toward || t.look.blend != l.blend) t.form = nullptr;
  if (t.picture != picture) t.texture = picture ? store_.texture(picture) : nullptr;
  t.world = c.worlds[i], t.look = l;
  t.shape = std::move(shape), t.toward = std::move(toward), t.picture = std::move(picture);
  t.gradients = found(l.gradients, c.gradients);
  if (auto finish = found(l.finish, c.finish); finish != t.finish) {
    const auto map = [&](const std::shared_ptr<const Picture>& p) { return p ? store_.texture(p) : nullptr; };
    t.maps = {};
    if (finish)
      t.maps = {map(finish->normals), map(finish->roughness_map), map(finish->metalness_map),
                map(finish->occlusion_map), map(finish->emission_map)};
    t.finish = std::move(finish);
  }
  t.there = t.casts = false;
  if (usable(t)) place(t);
  if (t.casts) ++casters_;
}

void Things::place(Thing& t) {
  if (t.form == nullptr) t.form = forms_.find(t.shape, t.toward, t.look.blend);
  const Form::Realised& plain = t.form->plain(store_);
  if (plain.mesh->mesh->positions.empty()) return;
  const Mat4 local = t.world * plain.local;
  t.bounds = bounds_of(plain.mesh->box, local);
  if (!(t.bounds.radius() > 0 && t.bounds.radius() < largest)) return;
  t.there = true;
  t.size = largest_measure(plain.mesh->box, local);
  t.surface = !plain.mesh->parts.empty();
  const double d = determinant(local);
  t.mirrored = d < 0;
  t.closed = plain.mesh->mesh->closed && d != 0;
  if (t.gradients) t.gradient_box = gradient_box(*t.shape, t.toward.get(), t.look.blend);
  t.transparent = t.look.transparency > 0 || (t.gradients && t.gradients->see_through()) ||
                  (t.texture != nullptr ? t.texture->see_through : plain.mesh->see_through);
  t.round = is_round(t);
  t.line = row_of(t.shape->kind).line;
  t.casts = t.surface && t.look.casts && t.look.material != Material::glow;
}

void Things::see(Thing& t) {
  t.visible = false;
  if (!t.there || !good_) return;
  const Bounds seen{t.bounds.center - view_.eye, t.bounds.half};
  if (!(length(seen.center) < largest)) return;
  t.depth = view_.depth(seen.center);
  t.visible = view_.sees(seen);
  if (!t.visible) return;
  Mat4 world = t.world;
  for (int i = 0; i < 3; ++i) world(i, 3) -= view_.eye[i];
  const double across = view_.pixels(seen), radius = 0.5 * across * t.size / seen.radius();
  t.ball = purpose_ == Purpose::surfaces && t.round && (view_.orthographic || t.depth > 2 * seen.radius());
  if (t.ball) {
    const double r = t.shape->radius;
    t.mesh = store_.disc(radius).get();
    t.to_object = scaling({r, r, r});
    t.instance = instance_of(t, world * t.to_object);
    return;
  }
  const Detail detail = purpose_ == Purpose::surfaces ? Detail::for_pixels(radius)
                                                      : Detail{across < 150   ? 24
                                                               : across < 800 ? 48
                                                                              : 96,
                                                               true};
  const Form::Realised& shown = t.form->at(detail, store_);
  t.mesh = shown.mesh.get();
  t.pressed = flat_ && purpose_ == Purpose::surfaces && can_press(t, t.mesh->box);
  Mat4 local = t.to_object = shown.local;
  if (t.pressed) {
    const Vec3 middle{0, 0, t.mesh->box.middle().z};
    local = local * translation(middle) * scaling({1, 1, 0}) * translation(-1 * middle);
  }
  t.instance = instance_of(t, world * local);
}

}  // namespace betwixt
