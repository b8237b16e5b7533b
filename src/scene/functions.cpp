// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/functions.h"

#include <algorithm>
#include <array>
#include <vector>

namespace betwixt {
namespace {

constexpr std::uint32_t bit(Kind k) { return 1u << static_cast<unsigned>(k); }
constexpr std::uint32_t all = 0xffffffff & ~bit(Kind::layer) & ~bit(Kind::environment);

std::vector<FunctionSpec> make() {
  std::vector<FunctionSpec> f(fn::count);
  constexpr double least = 0, most = 1e12;  // measures: a metre to the power of twelve is past Pluto
  const auto set = [&](FunctionId id, FunctionSpec spec) { f[id] = std::move(spec); };
  set(fn::position, {"position", Type::vector, Vec3{}, all, Unit::metres, {}});
  set(fn::rotation, {"rotation", Type::rotation, Angles{}, all, Unit::none, {}});
  set(fn::scale, {"scale", Type::vector, Vec3{1, 1, 1}, all, Unit::none, {}});
  set(fn::pivot, {"pivot", Type::vector, Vec3{}, all, Unit::metres, {}});
  set(fn::attach_position, {"attach-position", Type::vector, Vec3{}, all, Unit::metres, {}});
  set(fn::color, {"color", Type::color, Color{}, all, Unit::none, {}});
  set(fn::shininess, {"shininess", Type::scalar, 0.0, all, Unit::none, {}, 0, 1});
  set(fn::transparency, {"transparency", Type::scalar, 0.0, all, Unit::none, {}, 0, 1});
  set(fn::geometry, {"geometry", Type::shape, ObjectId{}, all, Unit::none, {}});
  set(fn::display, {"display", Type::boolean, true, all, Unit::none, {}});
  set(fn::material,
      {"material", Type::text, Text(std::string("plastic")), all, Unit::none, "plastic|matte|metal|glow"});
  set(fn::texture, {"texture", Type::text, Text(), all, Unit::none, {}});
  set(fn::radius, {"radius",
                   Type::scalar,
                   1.0,
                   bit(Kind::sphere) | bit(Kind::disc) | bit(Kind::cylinder) | bit(Kind::cone) | bit(Kind::torus),
                   Unit::metres,
                   {},
                   least,
                   most});
  set(fn::box_size, {"size", Type::vector, Vec3{1, 1, 1}, bit(Kind::box), Unit::metres, {}, least, most});
  set(fn::plane_size, {"size", Type::pair, Vec3{1, 1, 0}, bit(Kind::plane), Unit::metres, {}, least, most});
  set(fn::text_size, {"size", Type::scalar, 1.0, bit(Kind::text), Unit::metres, {}, least, most});
  set(fn::point_size, {"size", Type::scalar, 0.05, bit(Kind::points), Unit::metres, {}, least, most});
  set(fn::height, {"height", Type::scalar, 1.0, bit(Kind::cylinder) | bit(Kind::cone), Unit::metres, {}, least, most});
  set(fn::tube, {"tube", Type::scalar, 0.3, bit(Kind::torus), Unit::metres, {}, least, most});
  set(fn::points, {"points",
                   Type::points,
                   Points(),
                   bit(Kind::polygon) | bit(Kind::polyline) | bit(Kind::points),
                   Unit::metres,
                   {}});
  set(fn::width, {"width", Type::scalar, 0.05, bit(Kind::polyline), Unit::metres, {}, least, most});
  set(fn::text, {"text", Type::text, Text(), bit(Kind::text), Unit::none, {}});
  set(fn::font, {"font", Type::text, Text(std::string("DejaVu Sans")), bit(Kind::text), Unit::none, {}});
  set(fn::depth, {"depth", Type::scalar, 0.0, bit(Kind::text), Unit::metres, {}, least, most});
  set(fn::file, {"file", Type::text, Text(), bit(Kind::mesh), Unit::none, {}});
  set(fn::range, {"range", Type::scalar, 20.0, bit(Kind::light), Unit::metres, {}, least, most});
  set(fn::intensity, {"intensity", Type::scalar, 1.0, bit(Kind::light), Unit::none, {}, 0, 1e6});
  set(fn::shines, {"shines", Type::text, Text(std::string("point")), bit(Kind::light), Unit::none, "point|sun"});
  set(fn::lens, {"lens", Type::scalar, 35.0, bit(Kind::camera), Unit::millimetres, {}, 0.1, 1e6});
  set(fn::fov, {"fov", Type::angle, 0.0, bit(Kind::camera), Unit::none, {}, 0, 3.1});
  set(fn::camera_height, {"height", Type::scalar, 0.0, bit(Kind::camera), Unit::metres, {}, least, most});
  set(fn::look_at, {"look-at", Type::aim, ObjectId{}, bit(Kind::camera), Unit::metres, {}});
  set(fn::attachment, {"attachment", Type::attachment, Attachment{}, all, Unit::none, {}});
  set(fn::weight, {"weight", Type::scalar, 1.0, bit(Kind::layer), Unit::none, {}, 0, 1});
  set(fn::mode, {"mode", Type::text, Text(std::string("add")), bit(Kind::layer), Unit::none, "add|mix"});
  set(fn::environments, {"environments", Type::names, Names(), all, Unit::none, {}});
  set(fn::drive, {"drive", Type::names, Names(), all, Unit::none, {}});
  set(fn::transform, {"transform", Type::transform, Matrix(), all, Unit::none, {}});
  set(fn::motion, {"motion", Type::motion, Moves(), all, Unit::none, {}});
  return f;
}

const std::vector<FunctionSpec>& table() {
  static const std::vector<FunctionSpec> t = make();
  return t;
}

}  // namespace

std::span<const FunctionSpec> built_in_functions() { return table(); }

std::optional<FunctionId> find_built_in(Kind kind, std::string_view name) {
  const auto& t = table();
  for (std::size_t i = 0; i < t.size(); ++i)
    if (t[i].name == name && (t[i].kinds & bit(kind))) return static_cast<FunctionId>(i);
  return std::nullopt;
}

std::optional<Kind> find_kind(std::string_view name) {
  const auto at = std::find(kind_names.begin(), kind_names.end(), name);
  if (at == kind_names.end()) return std::nullopt;
  return static_cast<Kind>(at - kind_names.begin());
}

int component_count(Type type) {
  switch (type) {
    case Type::pair:
      return 2;
    case Type::vector:
    case Type::color:
    case Type::rotation:
    case Type::aim:
      return 3;
    default:
      return 0;
  }
}

Type component_type(Type type) { return type == Type::rotation ? Type::angle : Type::scalar; }

std::string_view component_name(Type type, int component) {
  constexpr std::string_view xyz[] = {"x", "y", "z"}, rgb[] = {"r", "g", "b"};
  return (type == Type::color ? rgb : xyz)[component];
}

int find_component(Type type, std::string_view name) {
  for (int i = 0; i < component_count(type); ++i)
    if (component_name(type, i) == name) return i;
  return -1;
}

std::string a_kind(Kind kind) {
  const std::string_view name = kind_names[static_cast<std::size_t>(kind)];
  return (name[0] == 'e' ? "an " : "a ") + std::string(name);
}

}  // namespace betwixt
