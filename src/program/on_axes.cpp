// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/on_axes.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "program/asking.h"
#include "track/procedure.h"

namespace betwixt {
namespace {

// Reads functions of axes at one time.
struct AxesReader {
  const Program::Compiled& c;
  const ObjectId id;
  const Kind kind;
  const Time t;
  Asking& asking;

  template <class T>
  T read(std::string_view name) const {
    const Target target{id, *find_built_in(kind, name)};
    asking.note_read(target);
    const Value v = c.read(target, t, asking);
    const auto* typed = std::get_if<T>(&v);
    return typed ? *typed : T{};
  }
  Vec3 vector(std::string_view name) const { return read<Vec3>(name); }
  double number(std::string_view name) const { return read<double>(name); }
  Axis axis(std::string_view name, std::string_view scale = {}) const {
    const Vec3 v = vector(name);
    const Text word = scale.empty() ? Text() : read<Text>(scale);
    return {v.x, v.y, v.z, *word == "log" ? AxisScale::log : *word == "time" ? AxisScale::time : AxisScale::linear};
  }

  AxesSpace space() const {
    AxesSpace out;
    out.kind = kind, out.digits = number("digits");
    switch (kind) {
      case Kind::number_line:
        out.x = axis("x", "x-scale"), out.size = {number("length"), 0, 0};
        break;
      case Kind::polar_axes:
        out.x = axis("r"), out.size = {2 * number("radius"), 2 * number("radius"), 0};
        break;
      case Kind::plane_grid:
        out.x = axis("x"), out.y = axis("y"), out.size = vector("size");
        out.right = vector("right"), out.up = vector("up");
        break;
      default:
        out.x = axis("x", "x-scale"), out.y = axis("y", "y-scale"), out.size = vector("size");
        if (out.size.z > 0) out.z = axis("z");
        break;
    }
    return out;
  }
};

class PlacedByAxes final : public Routine {
 public:
  PlacedByAxes() { language = "built in", source = "axes.place('', value('.position'))", varies = true; }
  Result<Value> value(Questions& q, const std::vector<Value>&, std::uint64_t& cost) const override {
    AxesSpace space;
    if (const Status found = q.axes("", q.seconds(), space, cost); !found) return found.error();
    const Result<Value> numbers = q.value(".position", q.seconds(), cost);
    if (!numbers) return numbers.error();
    const Vec3 place = space.place(std::get<Vec3>(*numbers));
    if (!std::isfinite(place.x + place.y + place.z))
      return fail(ErrorCode::range, "its position is not on its axes: a logarithmic axis has numbers above 0 only");
    return Value(place);
  }
};

bool is_place(Vec3 p) { return std::isfinite(p.x + p.y + p.z); }

// The places of numbers on axes that spread them evenly, without a question about each of a million.
struct StraightAxes {
  Vec3 scale{1, 1, 1}, move;
};
std::optional<StraightAxes> straight_axes(const AxesSpace& s) {
  if (s.kind != Kind::axes || s.x.scale == AxisScale::log || s.y.scale == AxisScale::log) return std::nullopt;
  StraightAxes out;
  const Axis* const axes[] = {&s.x, &s.y, &s.z};
  for (int i = 0; i < (s.size.z > 0 ? 3 : 2); ++i) {
    out.scale[i] = s.size[i] / (axes[i]->high - axes[i]->low);
    out.move[i] = -axes[i]->low * out.scale[i] - s.size[i] / 2;
  }
  return out;
}

// Returns the places that are wanted. Nothing joins them.
template <class Place, class Wanted>
std::vector<Vec3> kept(const std::vector<Vec3>& numbers, const Place& place, const Wanted& wanted) {
  std::vector<Vec3> out(numbers.size());
  std::size_t count = 0;
  for (const Vec3 n : numbers) {
    out[count] = place(n);
    count += wanted(out[count]) ? 1 : 0;
  }
  out.resize(count);
  return out;
}

// Data are shown inside the axes only, as plots are.
template <class Place>
std::vector<Vec3> inside(const std::vector<Vec3>& numbers, const AxesSpace& space, const Place& place) {
  if (space.kind != Kind::axes) return kept(numbers, place, [](Vec3 p) { return is_place(p); });
  Vec3 half = 0.5 * space.size + 1e-9 * Vec3{1, 1, 1};
  if (!(space.size.z > 0)) half.z = std::numeric_limits<double>::max();
  return kept(numbers, place,
              [half](Vec3 p) { return std::abs(p.x) <= half.x && std::abs(p.y) <= half.y && std::abs(p.z) <= half.z; });
}

// Returns the places of a line, which breaks where there is none.
template <class Place>
std::vector<Vec3> broken(const std::vector<Vec3>& numbers, const Place& place) {
  std::vector<Vec3> out;
  out.reserve(numbers.size());
  for (const Vec3 n : numbers) {
    const Vec3 p = place(n);
    out.push_back(is_place(p) ? p : Vec3{HUGE_VAL, HUGE_VAL, HUGE_VAL});
  }
  return out;
}

}  // namespace

ObjectId axes_of(const Scene& scene, const Object& o) {
  const Slot* slot = o.find(fn::on_axes);
  const auto* id = slot && slot->set ? std::get_if<ObjectId>(&*slot->set) : nullptr;
  const Object* axes = id ? find_object(scene, *id) : nullptr;
  return axes && has_coordinates(axes->kind) ? *id : ObjectId{};
}

Result<AxesSpace> axes_space(const Program::Compiled& c, ObjectId id, Time t, Asking& asking) {
  const Scene& scene = c.document.scene();
  const Object* o = find_object(scene, id);
  if (o && !has_coordinates(o->kind)) id = axes_of(scene, *o), o = find_object(scene, id);
  if (!o) return fail(ErrorCode::name, "it is not on axes: write on=NAME, the name of axes, where you create it");
  return AxesReader{c, id, o->kind, t, asking}.space();
}

bool position_by_axes(const Scene& scene, const Object& o) {
  return !has_points(o.kind) && o.kind != Kind::line_chart && axes_of(scene, o);
}

bool points_by_axes(const Scene& scene, const Object& o) {
  const bool places = find_built_in(o.kind, "of").has_value();  // the formula of a plot gives places
  return has_points(o.kind) && !places && axes_of(scene, o);
}

Points placed_points(const Program::Compiled& c, std::uint32_t object, const Points& numbers, Time t, Asking& asking) {
  const auto space = axes_space(c, {object}, t, asking);
  if (!space) return numbers;
  const Kind kind = c.document.scene().objects[object].kind;
  const auto all = [&](const auto& place) {
    return kind == Kind::scatter  ? inside(*numbers, *space, place)
           : kind == Kind::points ? kept(*numbers, place, [](Vec3 p) { return is_place(p); })
                                  : broken(*numbers, place);
  };
  if (const auto straight = straight_axes(*space))
    return Points(all([by = *straight](Vec3 n) {
      return Vec3{by.scale.x * n.x + by.move.x, by.scale.y * n.y + by.move.y, by.scale.z * n.z + by.move.z};
    }));
  return Points(all([&](Vec3 n) { return space->place(n); }));
}

const Value& placed_by_axes() {
  static const Value code = Procedure{std::make_shared<const PlacedByAxes>()};
  return code;
}

}  // namespace betwixt
