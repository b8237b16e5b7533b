// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Builds a frame from an evaluator: items, lights, the camera.
#include <algorithm>
#include <cmath>

#include "program/deferred_evaluation.h"
#include "program/evaluator.h"
#include "program/stage.h"
#include "scene/camera_functions.h"

namespace betwixt {
namespace {

Casting casting_of(const std::string& word) {
  return word == "on"     ? Casting::on
         : word == "off"  ? Casting::off
         : word == "soft" ? Casting::soft
                          : Casting::strongest;
}

LightShape area_of(const std::string& word) {
  return word == "disc" ? LightShape::disc : word == "rectangle" ? LightShape::rectangle : LightShape::point;
}

void add_problem(Frame& frame, const Error& e) {
  if (std::find(frame.problems.begin(), frame.problems.end(), e.message) != frame.problems.end()) return;
  frame.reports.push_back({Problem::other, {}, {}, e.message}), frame.problems.push_back(e.message);
}

}  // namespace

// Sets what only lamps with a front have.
void Evaluator::aim_light(Light& l, std::uint32_t node, Asking& asking) const {
  const auto find = [&](FunctionId f) -> const Binding& { return compiled_.find(compiled_.nodes[node].object, f); };
  const Mat4 m = world(node);
  l.direction = normalize(transform_vector(m, {0, 0, -1}), {0, -1, 0});
  const Vec3 across = transform_vector(m, {1, 0, 0});
  l.across = normalize(across - dot(across, l.direction) * l.direction, {1, 0, 0});
  const double* const size = &numbers_[find(fn::light_size).offset];
  l.width = size[0] * length(across), l.height = size[1] * length(transform_vector(m, {0, 1, 0}));
  const std::uint32_t picture = compiled_.texture(compiled_.value(find(fn::light_picture), now_, asking));
  if (picture != nothing) l.picture = compiled_.textures[picture];
}

void Evaluator::add_items(Frame& frame, const std::vector<std::int32_t>& layers) const {
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const Looks& l = looks[i];
    if (!l.visible) continue;
    const auto node = static_cast<std::uint32_t>(i);
    Item item;
    item.id = {compiled_.nodes[node].object};
    item.world = worlds()[i];
    item.body = {compiled_.nodes[body_[node]].object};
    item.shape = shape(l.shape);
    if (l.toward != nothing) item.toward = shape(l.toward), item.blend = l.blend;
    item.color = l.color, item.transparency = l.transparency, item.shininess = l.shininess;
    item.material = l.material, item.casts = l.casts;
    if (l.texture != nothing) {
      auto picture = compiled_.picture(l.texture);
      if (picture)
        item.texture = *std::move(picture);
      else
        add_problem(frame, picture.error());
    }
    if (l.finish != nothing) item.finish = finish(l.finish);
    if (l.gradients != nothing) item.gradients = gradients(l.gradients);
    if (!layers.empty()) item.layer = layers[i];
    frame.items.push_back(std::move(item));
  }
}

std::vector<Light> Evaluator::lights(Asking& asking) const {
  std::vector<Light> out;
  for (const std::uint32_t node : compiled_.lights) {
    const Node& n = compiled_.nodes[node];
    const auto find = [&](FunctionId f) -> const Binding& { return compiled_.find(n.object, f); };
    if (numbers_[n.display] == 0) continue;
    Light l;
    l.id = {n.object};
    l.position = translation_of(world(node));
    l.sun = *std::get<Text>(compiled_.value(find(fn::shines), now_, asking)) == "sun";
    l.casting = casting_of(*std::get<Text>(compiled_.value(find(fn::casting), now_, asking)));
    // A sun shines from its position towards the origin of the world. A sun at the origin shines down.
    l.direction = normalize(-l.position, {0, -1, 0});
    l.color = numbers_[find(fn::intensity).offset] * vec3(&numbers_[n.color]);
    const Vec3 own = vec3(&numbers_[n.scale]);
    // A light's range scales with its own scale, not with its parents'.
    l.range = numbers_[find(fn::range).offset] * std::max({std::abs(own.x), std::abs(own.y), std::abs(own.z)});
    l.shape = area_of(*std::get<Text>(compiled_.value(find(fn::light_shape), now_, asking)));
    l.cone = numbers_[find(fn::cone).offset], l.cone_edge = numbers_[find(fn::cone_edge).offset];
    if (l.shape != LightShape::point || l.cone > 0) aim_light(l, node, asking);
    out.push_back(l);
  }
  return out;
}

Camera Evaluator::camera() const {
  const auto through = compiled_.camera_at(now_);
  if (!through && deferred_ && compiled_.asks_for_camera()) {
    const Answer* known = deferred_->answer({Question::camera, 0});
    Camera somewhere;
    somewhere.aspect = compiled_.document.aspect();
    return known ? known->camera : somewhere;
  }
  return through ? camera_of(*through) : own_camera(compiled_);
}

std::optional<CameraChange> Evaluator::camera_change() const {
  const auto changing = compiled_.changing_at(now_);
  if (!changing) return std::nullopt;
  return CameraChange{changing->from ? camera_of(*changing->from) : own_camera(compiled_), changing->share,
                      changing->kind};
}

Camera Evaluator::camera_of(std::uint32_t object) const {
  const auto number = [&](FunctionId f) { return numbers_[compiled_.find(object, f).offset]; };
  Camera c;
  c.aspect = compiled_.document.aspect();
  const Mat4 m = world(compiled_.node_of[object]);
  const Vec3 at = translation_of(m);
  // A rigid transform, without the scales of the camera and its parents.
  const Vec3 back = normalize(transform_vector(m, {0, 0, 1})), up = transform_vector(m, {0, 1, 0});
  const Mat4 upright = look_at({}, -back);  // in case the camera's up vector is scaled to zero
  const Vec3 right = normalize(cross(up, back), transform_vector(upright, {1, 0, 0})), over = cross(back, right);
  c.world = translation(at);
  for (int i = 0; i < 3; ++i) c.world(i, 0) = right[i], c.world(i, 1) = over[i], c.world(i, 2) = back[i];
  constexpr double gate = 36;  // mm
  const double fov = number(fn::fov);
  c.fov = fov > 0 ? std::min(fov, 3.1) : 2 * std::atan(gate / (2 * std::max(number(fn::lens), 0.1)));
  c.height = number(fn::camera_height);
  c.orthographic = c.height > 0;
  c.shutter = number(fn::shutter);
  if (const double stop = number(fn::f_stop); stop < sharp && !c.orthographic) {
    c.aperture = 1e-3 * gate / (2 * std::tan(c.fov / 2)) / stop;
    c.focus = focus(object, c);
  }
  return c;
}

// Returns the distance to the focus along the camera's axis. A focus that is not in front of the camera is ignored.
double Evaluator::focus(std::uint32_t object, const Camera& c) const {
  Asking asking;
  asking.deferred = deferred_;
  const Vec3 eye = translation_of(c.world), back{c.world(0, 2), c.world(1, 2), c.world(2, 2)};
  const auto away = [&](Vec3 at) { return dot(eye - at, back); };
  const auto in_world = [&](std::uint32_t i) { return translation_of(world(i)); };
  const auto before = [&](std::uint32_t i) { return Vec3{0, 0, -away(in_world(i))}; };  // in the form of a distance
  double far = 0;
  if (const auto said = compiled_.aim(object, fn::focus, now_, numbers_.data(), before, asking))
    far = -said->z;
  else if (const auto looked = compiled_.aim(object, fn::look_at, now_, numbers_.data(), in_world, asking))
    far = away(*looked);
  else
    far = away({});
  return far > 1e-6 ? far : Camera().focus;
}

}  // namespace betwixt
