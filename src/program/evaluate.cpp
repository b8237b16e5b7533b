// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "program/compiled.h"
#include "scene/extent.h"

namespace betwixt {
namespace {

Vec3 mix(Vec3 a, Vec3 b, double s) { return a + s * (b - a); }

}  // namespace

std::vector<double> Program::Compiled::at(Time t, Asking& asking, bool for_contacts) const {
  std::vector<double> numbers = rest;
  for (const CurveUse& use : curves) evaluate(use, t, &numbers[use.offset]);
  if (!lives.empty())
    for (const Binding& b : bindings)
      if (b.live >= 0 && b.channels > 0 &&
          (!for_contacts || spec_of(document.scene(), b.function).matters_to_contacts()))
        evaluate(b, t, asking, &numbers[b.offset]);
  return numbers;
}

void Program::Compiled::evaluate(const CurveUse& use, Time t, double* out) const {
  set.evaluate(use.curve, t, out);
  if (!use.bounded) return;
  for (int i = 0; i < use.curve.channels; ++i) out[i] = std::clamp(out[i], use.low, use.high);
}

void Program::Compiled::evaluate(const Binding& b, Time t, Asking& asking, double* out) const {
  if (b.live >= 0) {
    held_numbers(live_value(b.live, t, asking), b.orientation, out);
    return;
  }
  std::copy_n(&rest[b.offset], 4, out);
  for (std::uint32_t i = 0; i < b.curves; ++i) {
    const CurveUse& use = curves[b.first_curve + i];
    evaluate(use, t, out + (use.offset - b.offset));
  }
}

Value Program::Compiled::value(const Binding& b, Time t, Asking& asking) const {
  if (b.live >= 0) return live_value(b.live, t, asking);
  if (b.steps < 0) return b.constant;
  const Between w = between(b, t);
  return steps[static_cast<std::size_t>(b.steps)].values()[w.s >= 1 ? w.b : w.a];
}

std::optional<Vec3> Program::Compiled::aim(std::uint32_t camera, Time t, const double* numbers,
                                           const std::function<Vec3(std::uint32_t)>& place, Asking& asking) const {
  const Binding& b = find(camera, fn::look_at);
  if (b.channels == 3 && b.live < 0) return vec3(numbers + b.offset);
  const auto point = [&](const Value& v) -> std::optional<Vec3> {
    if (const auto* p = std::get_if<Vec3>(&v)) return *p;
    const auto* id = std::get_if<ObjectId>(&v);
    if (!id || !find_object(document.scene(), *id)) return std::nullopt;
    return place(node_of[id->index]);
  };
  if (b.live >= 0) return point(live_value(b.live, t, asking));
  if (b.steps < 0) return point(b.constant);
  const Between w = between(b, t);
  const auto values = steps[static_cast<std::size_t>(b.steps)].values();
  const auto from = point(values[w.a]), to = point(values[w.b]);
  if (!from || !to || w.a == w.b) return w.s >= 1 ? to : from;
  return mix(*from, *to, w.s);
}

Value Program::Compiled::shape_part(const Binding& b, Time t, const double* numbers, Asking& asking) const {
  const double* n = numbers + b.offset;
  if (b.channels == 1) return n[0];
  if (b.channels > 1) return Vec3{n[0], n[1], b.channels > 2 ? n[2] : 0};
  if (b.steps >= 0) {
    const Between w = between(b, t);
    const auto values = steps[static_cast<std::size_t>(b.steps)].values();
    const auto *from = std::get_if<Points>(&values[w.a]), *to = std::get_if<Points>(&values[w.b]);
    if (from && to && w.a != w.b && (*from)->size() == (*to)->size()) {
      std::vector<Vec3> between_them((*from)->size());
      for (std::size_t i = 0; i < between_them.size(); ++i) between_them[i] = mix((**from)[i], (**to)[i], w.s);
      return Points(std::move(between_them));
    }
  }
  return value(b, t, asking);
}

Shape Program::Compiled::shape(std::uint32_t object, Time t, const double* numbers, Asking& asking) const {
  const Scene& scene = document.scene();
  Shape s;
  s.kind = scene.objects[object].kind;
  const auto described = shaping.find(s.kind);
  if (described == shaping.end()) return s;
  for (const FunctionId f : described->second)
    spec_of(scene, f).shape(s, shape_part(find(object, f), t, numbers, asking), scene);
  return s;
}

namespace {

Material material_of(const std::string& word) {
  return word == "matte"   ? Material::matte
         : word == "metal" ? Material::metal
         : word == "glow"  ? Material::glow
                           : Material::plastic;
}

}  // namespace

void Program::Compiled::add_solids(Frame& frame, const double* numbers, const std::vector<Mat4>& w,
                                   Asking& asking) const {
  const Scene& scene = document.scene();
  const Time t = frame.time;
  const auto body = bodies(t);
  const auto shape_of = [&](std::uint32_t object) {
    const Node& n = nodes[node_of[object]];
    return n.shape ? n.shape : std::make_shared<const Shape>(shape(object, t, numbers, asking));
  };
  for (std::uint32_t object = 0; object < node_of.size(); ++object) {
    if (node_of[object] == ObjectId::nothing) continue;
    const Node& n = nodes[node_of[object]];
    if (!drawable(n.kind) || numbers[n.display] == 0) continue;
    Item item;
    item.id = {object};
    item.world = w[node_of[object]];
    item.body = {nodes[body[node_of[object]]].object};

    // Its own shape, another object's, or on the way between two.
    const auto look = [&](const Value& v) {
      const ObjectId other = std::get<ObjectId>(v);
      const Object* o = find_object(scene, other);
      return shape_of(o && drawable(o->kind) ? other.index : object);
    };
    const Binding& geometry = find(object, fn::geometry);
    if (geometry.steps < 0) {
      item.shape = look(value(geometry, t, asking));
    } else {
      const Between b = between(geometry, t);
      const auto values = steps[static_cast<std::size_t>(geometry.steps)].values();
      item.shape = look(values[b.a]);
      if (b.a != b.b && b.s != 0) item.toward = look(values[b.b]), item.blend = b.s;
    }
    frame.items.push_back(std::move(item));
  }
}

void Program::Compiled::add_items(Frame& frame, const double* numbers, const std::vector<Mat4>& worlds,
                                  Asking& asking) const {
  const Scene& scene = document.scene();
  const Time t = frame.time;
  add_solids(frame, numbers, worlds, asking);
  for (Item& item : frame.items) {
    const std::uint32_t object = item.id.index;
    item.color = vec3(numbers + nodes[node_of[object]].color);
    item.transparency = std::clamp(numbers[find(object, fn::transparency).offset], 0.0, 1.0);
    item.shininess = std::clamp(numbers[find(object, fn::shininess).offset], 0.0, 1.0);
    item.material = material_of(*std::get<Text>(value(find(object, fn::material), t, asking)));
    const auto picture = scene.pictures->find(*std::get<Text>(value(find(object, fn::texture), t, asking)));
    if (picture != scene.pictures->end()) item.texture = picture->second;
  }
}

void Program::Compiled::add_lights(Frame& frame, const double* numbers, const std::vector<Mat4>& w,
                                   Asking& asking) const {
  for (std::uint32_t object = 0; object < node_of.size(); ++object) {
    if (node_of[object] == ObjectId::nothing) continue;
    const Node& n = nodes[node_of[object]];
    if (n.kind != Kind::light || numbers[n.display] == 0) continue;
    Light l;
    l.id = {object};
    l.position = translation_of(w[node_of[object]]);
    l.sun = *std::get<Text>(value(find(object, fn::shines), frame.time, asking)) == "sun";
    // A sun shines from where it stands towards the middle of the world; one that stands there shines down.
    l.direction = normalize(-l.position, {0, -1, 0});
    l.color = numbers[find(object, fn::intensity).offset] * vec3(numbers + n.color);
    const Vec3 own = vec3(numbers + n.scale);
    l.range = numbers[find(object, fn::range).offset] *
              std::max({std::abs(own.x), std::abs(own.y), std::abs(own.z)});  // R-H9
    frame.lights.push_back(l);
  }
}

std::optional<std::uint32_t> Program::Compiled::camera_at(Time t) const {
  const Scene& scene = document.scene();
  for (const auto* by_time : {&*scene.cuts, &*scene.views}) {
    const auto next = by_time->upper_bound(t);
    if (next != by_time->begin() && std::prev(next)->second) return std::prev(next)->second.index;
  }
  for (const Node& n : nodes)  // those of display lists are looked through while their lists say so
    if (n.kind == Kind::camera && !scene.objects[n.object].derived) return n.object;
  return std::nullopt;
}

Camera Program::Compiled::camera(Time t, const double* numbers, const std::vector<Mat4>& w) const {
  const auto through = camera_at(t);
  if (!through) return own_camera();
  const std::uint32_t object = *through;
  const auto number = [&](FunctionId f) { return numbers[find(object, f).offset]; };
  Camera c;
  const Mat4& m = w[node_of[object]];
  const Vec3 at = translation_of(m);
  // A rigid motion, whatever scales the camera has been put through.
  const Vec3 back = normalize(transform_vector(m, {0, 0, 1})), up = transform_vector(m, {0, 1, 0});
  const Mat4 upright = look_at({}, -back);  // for a camera whose own up is scaled to nothing
  const Vec3 right = normalize(cross(up, back), transform_vector(upright, {1, 0, 0})), over = cross(back, right);
  c.world = translation(at);
  for (int i = 0; i < 3; ++i) c.world(i, 0) = right[i], c.world(i, 1) = over[i], c.world(i, 2) = back[i];
  constexpr double gate = 36;  // mm
  const double fov = number(fn::fov);
  c.fov = fov > 0 ? std::min(fov, 3.1) : 2 * std::atan(gate / (2 * std::max(number(fn::lens), 0.1)));
  c.height = number(fn::camera_height);
  c.orthographic = c.height > 0;
  return c;
}

// A box around all that is seen during the film. Grounds and walls count only where there is nothing else.
Extent Program::Compiled::stage() const {
  Extent things, grounds;
  const auto [from, to] = document.range();
  constexpr int looks = 24;
  for (int k = 0; k <= looks; ++k) {
    Frame f;
    f.time = {from.flicks + (to - from).flicks / looks * k};
    Asking asking;
    const auto numbers = at(f.time, asking);
    add_items(f, numbers.data(), worlds(f.time, numbers.data(), asking), asking);
    for (const Item& item : f.items) {
      const Extent e = extent(*item.shape);
      if (e.empty()) continue;
      Extent& all = row_of(item.shape->kind).ground ? grounds : things;
      for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p = transform_point(item.world, {corner & 1 ? e.high.x : e.low.x, corner & 2 ? e.high.y : e.low.y,
                                                    corner & 4 ? e.high.z : e.low.z});
        if (finite(p)) all.add(p);
      }
    }
  }
  if (!things.empty()) return things;
  return grounds.empty() ? Extent{{-1, -1, -1}, {1, 1, 1}} : grounds;
}

const Camera& Program::Compiled::own_camera() const {
  std::call_once(own_camera_once, [this] {
    const Extent all = stage();
    Camera& c = own_camera_made;
    c.fov = 2 * std::atan(36.0 / 70);
    // The widest picture people make is 16:9; what fits its height and width fits taller ones better.
    const Vec3 middle = 0.5 * (all.low + all.high), half = 0.5 * (all.high - all.low);
    const double across = std::tan(c.fov / 2), up = across * 9 / 16;
    const Mat4 turned = look_at(normalize(Vec3{0, 0.12, 1}), {});
    double distance = 1e-3;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 p = half * Vec3{corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0};
      const auto along = [&](int axis) {
        return p.x * turned(0, axis) + p.y * turned(1, axis) + p.z * turned(2, axis);
      };
      distance = std::max(distance, along(2) + 1.1 * std::max(std::abs(along(0)) / across, std::abs(along(1)) / up));
    }
    c.world = look_at(middle + distance * normalize(Vec3{0, 0.12, 1}), middle);
  });
  return own_camera_made;
}

Frame Program::frame(Time t) const {
  Frame f;
  f.time = t;
  Asking asking;
  const TwerperFailures failed;
  const auto numbers = code_->at(t, asking);
  const auto worlds = code_->worlds(t, numbers.data(), asking);
  code_->add_items(f, numbers.data(), worlds, asking);
  code_->add_lights(f, numbers.data(), worlds, asking);
  f.camera = code_->camera(t, numbers.data(), worlds);
  const Scene& scene = code_->document.scene();
  if (scene.background) f.background = to_linear(*scene.background);
  for (auto& [when, text] : code_->document.notes(t, t)) f.notes.push_back(text);
  code_->say(failed, asking);
  f.problems = code_->notices;
  f.problems.insert(f.problems.end(), asking.problems.begin(), asking.problems.end());
  return f;
}

}  // namespace betwixt
