// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "program/deferred_evaluation.h"
#include "program/on_axes.h"
#include "program/traces.h"

namespace betwixt {
namespace {

Vec3 mix(Vec3 a, Vec3 b, double s) { return a + s * (b - a); }

}  // namespace

void Program::Compiled::evaluate(const Binding& b, Time t, Asking& asking, double* out) const {
  if (b.live >= 0) {
    held_numbers(live_value(b.live, t, asking), b.orientation, out);
    return;
  }
  if (b.coded < 0) return evaluate_curves(b, t, out);
  const auto numbers = coded_value(
      *this, b, t, asking, [](const Answer& a) { return &a.numbers; },
      [&] {
        std::array<double, 4> n{};
        evaluate_curves(b, t, n.data());
        return n;
      });
  std::copy(numbers.begin(), numbers.end(), out);
}

Between Program::Compiled::between(const Binding& b, Time t, Asking& asking) const {
  const StepTrack& track = steps_of(b);
  return coded_value(
      *this, b, t, asking, [&](const Answer& a) { return track.fits(a.between) ? &a.between : nullptr; },
      [&] { return track.at(t, set); });
}

namespace {

// Blends two lists of points. Returns nullopt if they are no lists, or differ in length.
std::optional<Value> points_between(const StepTrack& track, const Between& w) {
  const auto values = track.values();
  const auto *from = std::get_if<Points>(&values[w.a]), *to = std::get_if<Points>(&values[w.b]);
  if (!from || !to || from == to || (*from)->size() != (*to)->size()) return std::nullopt;
  std::vector<Vec3> all((*from)->size());
  if (w.splines) {
    const auto as_many = [](const Value& a, const Value& b) {
      const auto *p = std::get_if<Points>(&a), *q = std::get_if<Points>(&b);
      return p && q && (*p)->size() == (*q)->size();
    };
    const Weights four = track.weigh(w, as_many);
    for (std::size_t k = 0; k < 4; ++k)
      if (four.weights[k] != 0)
        for (std::size_t i = 0; i < all.size(); ++i)
          all[i] = all[i] + four.weights[k] * (*std::get<Points>(values[four.values[k]]))[i];
  } else {
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = mix((**from)[i], (**to)[i], w.s);
  }
  return Points(std::move(all));
}

}  // namespace

Value Program::Compiled::value(const Binding& b, Time t, Asking& asking) const {
  if (b.live >= 0) return live_value(b.live, t, asking);
  if (b.steps < 0) return b.constant;
  const Between w = between(b, t, asking);
  const auto values = steps_of(b).values();
  if (auto points = points_between(steps_of(b), w)) return *std::move(points);
  return values[w.s >= 1 ? w.b : w.a];
}

std::optional<Vec3> Program::Compiled::aim(std::uint32_t object, FunctionId f, Time t, const double* numbers,
                                           const std::function<Vec3(std::uint32_t)>& place, Asking& asking) const {
  const Binding& b = find(object, f);
  const Vec3 beside = f == fn::look_at ? vec3(numbers + find(object, fn::look_offset).offset) : Vec3{};
  if (b.channels == 3 && b.live < 0) return beside + vec3(numbers + b.offset);
  const auto point = [&](const Value& v) -> std::optional<Vec3> {
    if (const auto* p = std::get_if<Vec3>(&v)) return *p + beside;
    const auto* id = std::get_if<ObjectId>(&v);
    const auto node = id ? node_of_object(*id) : std::nullopt;
    return node ? std::optional(place(*node) + beside) : std::nullopt;
  };
  if (b.live >= 0) return point(live_value(b.live, t, asking));
  if (b.steps < 0) return point(b.constant);
  const Between w = between(b, t, asking);
  const auto values = steps_of(b).values();
  const auto from = point(values[w.a]), to = point(values[w.b]);
  if (!from || !to || w.a == w.b) return w.s >= 1 ? to : from;
  return mix(*from, *to, w.s);
}

Value Program::Compiled::shape_part(const Binding& b, Time t, const double* numbers, Asking& asking) const {
  double own[4];
  if (b.channels > 0 && !numbers) evaluate(b, t, asking, own);
  const double* n = numbers ? numbers + b.offset : own;
  if (b.channels == 1) return n[0];
  if (b.channels > 1) return Vec3{n[0], n[1], b.channels > 2 ? n[2] : 0};
  return value(b, t, asking);
}

Shape Program::Compiled::shape(std::uint32_t object, Time t, const double* numbers, Asking& asking) const {
  const Scene& scene = document.scene();
  Shape s;
  const auto piece = pieces_of_formulas.find(object);  // shares the functions of the whole
  const Kind kind = scene.objects[piece == pieces_of_formulas.end() ? object : piece->second.whole].kind;
  s.kind = kind == Kind::code ? Kind::text : kind;
  const auto described = shaping.find(kind);
  if (described == shaping.end()) return s;
  for (const FunctionId f : described->second)
    spec_of(scene, f).shape(s, shape_part(find_shown(object, f), t, numbers, asking), scene);
  show_parts(s, object);
  if (s.kind == Kind::trace) s.points = trace(*this, object, t, asking);
  if (points_by_axes(scene, scene.objects[object])) s.points = placed_points(*this, object, s.points, t, asking);
  return s;
}

// Leaves out the letters of a formula that other objects draw, or those that do not belong to a part.
void Program::Compiled::show_parts(Shape& s, std::uint32_t object) const {
  if (s.kind != Kind::text) return;
  if (const auto piece = pieces_of_formulas.find(object); piece != pieces_of_formulas.end())
    s.parts = piece->second.key, s.only_parts = true;
  else if (const auto whole = apart.find(object); whole != apart.end())
    s.parts = whole->second;
}

std::optional<TextTurn> Program::Compiled::text_turn(std::uint32_t object, Time t, Asking& asking) const {
  static const FunctionId tex = *find_built_in(Kind::text, "tex");
  for (const FunctionId f : {tex, FunctionId{fn::text}}) {
    const Binding& b = find_shown(object, f);
    if (b.live >= 0 || b.steps < 0) continue;
    const Between w = between(b, t, asking);
    const auto values = steps_of(b).values();
    if (w.a != w.b && !(values[w.a] == values[w.b])) return TextTurn{f, values[w.b], w.s};
  }
  return std::nullopt;
}

std::shared_ptr<const Shape> turned_text(const Shape& from, const TextTurn& turn, const Scene& scene) {
  Shape to = from;
  spec_of(scene, turn.function).shape(to, turn.to, scene);
  to.matches = true;
  return std::make_shared<const Shape>(std::move(to));
}

std::shared_ptr<const Shape> Program::Compiled::drawn_shape(std::uint32_t drawable, Time t, Asking& asking) const {
  const Drawable& d = drawables[drawable];
  if (d.shape < shapes.size()) return shapes[d.shape];
  Shape made = shape(nodes[drawable].object, t, nullptr, asking);
  if (d.skin >= 0) made.mesh = posed(d.skin, t, asking);
  return std::make_shared<const Shape>(std::move(made));
}

}  // namespace betwixt
