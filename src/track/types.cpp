// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/types.h"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

#include "track/twerpers.h"

namespace betwixt {
namespace {

template <class T>
Value plain() {
  return T{};
}

// In the order of Type.
constexpr TypeRow type_table[] = {
    {.type = Type::scalar,
     .word = "number",
     .phrase = "a number",
     .example = plain<double>,
     .channels = 1,
     .twerper = Twerper::smooth,
     .changes = Changes::gradually,
     .rate = Type::scalar,
     .tangents = true,
     .computed = true,
     .dials = true},
    {.type = Type::angle,
     .word = "angle",
     .phrase = "an angle",
     .example = plain<double>,
     .channels = 1,
     .twerper = Twerper::smooth,
     .changes = Changes::gradually,
     .rate = Type::scalar,
     .angles = true,
     .tangents = true,
     .computed = true,
     .dials = true},
    {.type = Type::pair,
     .phrase = "a pair of numbers",
     .example = plain<Vec3>,
     .components = "xy",
     .channels = 2,
     .twerper = Twerper::smooth,
     .changes = Changes::gradually,
     .rate = Type::pair,
     .tangents = true,
     .computed = true,
     .dials = true},
    {.type = Type::vector,
     .word = "vector",
     .phrase = "a vector",
     .example = plain<Vec3>,
     .components = "xyz",
     .channels = 3,
     .twerper = Twerper::smooth,
     .changes = Changes::gradually,
     .rate = Type::vector,
     .tangents = true,
     .computed = true,
     .dials = true,
     .rotates = true},
    {.type = Type::color,
     .word = "color",
     .phrase = "a colour",
     .example = plain<Color>,
     .components = "rgb",
     .channels = 3,
     .twerper = Twerper::linear,
     .changes = Changes::gradually,
     .rate = Type::vector,
     .light = true,
     .computed = true,
     .dials = true},
    {.type = Type::boolean,
     .word = "boolean",
     .phrase = "on or off",
     .example = plain<bool>,
     .channels = 1,
     .computed = true,
     .dials = true},
    {.type = Type::rotation,
     .word = "rotation",
     .phrase = "a rotation",
     .example = plain<Angles>,
     .components = "xyz",
     .component = Type::angle,
     .channels = 4,
     .twerper = Twerper::smooth,
     .changes = Changes::by_turning,
     .rate = Type::vector,
     .angles = true,
     .tangents = true,
     .computed = true,
     .dials = true,
     .rotates = true},
    {.type = Type::orientation,
     .word = "orientation",
     .phrase = "an orientation",
     .example = plain<Quat>,
     .channels = 4,
     .twerper = Twerper::slerp,
     .changes = Changes::by_turning,
     .rate = Type::vector,
     .tangents = true,
     .computed = true,
     .rotates = true},
    {.type = Type::shape,
     .word = "shape",
     .phrase = "a shape",
     .example = plain<ObjectId>,
     .changes = Changes::gradually,
     .computed = true},
    {.type = Type::aim,
     .phrase = "a point or an object",
     .example = plain<ObjectId>,
     .components = "xyz",
     .channels = 3,
     .changes = Changes::gradually,
     .computed = true,
     .rotates = true},
    {.type = Type::text, .word = "text", .phrase = "a text", .example = plain<Text>, .computed = true, .dials = true},
    {.type = Type::points,
     .phrase = "a list of points",
     .example = plain<Points>,
     .changes = Changes::gradually,
     .computed = true,
     .rotates = true},
    {.type = Type::names, .phrase = "a list of names", .example = plain<Names>, .computed = true},
    {.type = Type::attachment, .phrase = "an attachment", .example = plain<Attachment>, .computed = true},
    {.type = Type::transform, .phrase = "a transform", .example = plain<Matrix>, .computed = true},
    {.type = Type::motion,
     .phrase = "a motion",
     .example = plain<Moves>,
     .changes = Changes::gradually,
     .computed = true},
};
consteval bool in_order() {
  for (std::size_t i = 0; i < std::size(type_table); ++i)
    if (type_table[i].type != static_cast<Type>(i)) return false;
  return true;
}
static_assert(in_order());

// Calls f for each number of a value, const or not, in order. Returns how many there are.

template <class V, class F>
int each_number(V& value, F&& f) {
  const auto all = [&f](auto&... numbers) { return (f(numbers), ...), static_cast<int>(sizeof...(numbers)); };
  return std::visit(
      [&](auto& v) -> int {
        using T = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<T, double>) {
          return all(v);
        } else if constexpr (std::is_same_v<T, bool>) {
          double truth = v ? 1 : 0;
          f(truth);
          if constexpr (!std::is_const_v<V>) v = truth != 0;
          return 1;
        } else if constexpr (std::is_same_v<T, Vec3>) {
          return all(v.x, v.y, v.z);
        } else if constexpr (std::is_same_v<T, Color>) {
          return all(v.r, v.g, v.b);
        } else if constexpr (std::is_same_v<T, Angles>) {
          return all(v.xyz.x, v.xyz.y, v.xyz.z);
        } else if constexpr (std::is_same_v<T, Quat>) {
          return all(v.w, v.x, v.y, v.z);
        } else {
          return 0;
        }
      },
      value);
}

}  // namespace

const TypeRow& row_of(Type type) { return type_table[static_cast<std::size_t>(type)]; }

const TypeRow* find_type(std::string_view word) {
  if (word == "scalar") word = "number";
  for (const TypeRow& r : type_table)
    if (r.word == word && !word.empty()) return &r;
  return nullptr;
}

std::vector<std::string_view> type_words() {
  std::vector<std::string_view> words;
  for (const TypeRow& r : type_table)
    if (!r.word.empty()) words.push_back(r.word);
  return words;
}

std::string_view to_string(Type type) { return row_of(type).phrase; }
bool has_velocity(Type type) { return row_of(type).rate.has_value(); }

int component_count(Type type) { return static_cast<int>(row_of(type).components.size()); }
std::string_view component_name(Type type, int component) {
  const std::string_view all = row_of(type).components;
  return component < static_cast<int>(all.size()) ? all.substr(static_cast<std::size_t>(component), 1) : "";
}
int find_component(Type type, std::string_view name) {
  const std::size_t at = name.size() == 1 ? row_of(type).components.find(name) : std::string_view::npos;
  return at == std::string_view::npos ? -1 : static_cast<int>(at);
}
Type component_type(Type type) { return row_of(type).component; }
Type component_track_type(Type type) { return row_of(type).light ? type : component_type(type); }

bool fits(Twerper twerper, Type type, std::string* why) {
  if (twerper == Twerper::unset || twerper == Twerper::hold) return true;
  const auto no = [&](std::string reason) {
    if (why) *why = std::move(reason);
    return false;
  };
  const Changes changes = row_of(type).changes;
  const bool matches = !is_own(twerper) && row_of(twerper).matches;
  if (matches)
    return type == Type::text || no(fmt::format("'match' is for texts and formulas; this is {}", to_string(type)));
  const std::string who = is_own(twerper) ? "a twerper" : fmt::format("'{}'", name_of(twerper));
  if (changes == Changes::in_steps)
    return no(fmt::format("{} cannot blend {}: it changes only at its events", who, to_string(type)));
  if (!is_own(twerper) && row_of(twerper).for_numbers != Twerper::unset && changes != Changes::by_turning)
    return no(fmt::format("{} is for orientations; this is {}", who, to_string(type)));
  return true;
}

bool numeric(const Value& v) {
  return each_number(v, [](double) {}) > 0;
}

int to_numbers(const Value& v, double* out) {
  return each_number(v, [&out](double number) { *out++ = number; });
}

double component_of(const Value& v, int component) {
  double n[4] = {};
  to_numbers(v, n);
  return n[component];
}

Value with_numbers(Value v, const double* numbers, int count) {
  if (std::holds_alternative<ObjectId>(v)) v = Vec3{};
  each_number(v, [&](double& number) {
    if (count-- > 0) number = *numbers++;
  });
  return v;
}

Value with_component(Value v, int component, double number) {
  if (std::holds_alternative<ObjectId>(v)) v = Vec3{};
  double n[4] = {};
  if (to_numbers(v, n) != 3) return v;
  n[component] = number;
  return with_numbers(std::move(v), n);
}

int number_count(Type type) {
  double n[4] = {};
  return std::min(to_numbers(with_numbers(row_of(type).example(), n, 0), n), row_of(type).channels);
}

Value value_of_numbers(Type type, const double* n, bool orientation) {
  if (orientation) return Quat{n[0], n[1], n[2], n[3]};
  return with_numbers(row_of(type).example(), n, row_of(type).channels);
}

std::optional<Value> fitted(const Value& v, Type type) {
  const TypeRow& row = row_of(type);
  const auto* number = std::get_if<double>(&v);
  const auto* three = std::get_if<Vec3>(&v);
  double n[4] = {};
  to_numbers(v, n);
  if ((number && row.channels == 1) || (three && !row.components.empty())) return value_of_numbers(type, n);
  if (type == Type::rotation && std::holds_alternative<Quat>(v)) return v;
  if (type == Type::orientation && three) return from_angles(*three);
  if (const auto* angles = std::get_if<Angles>(&v); angles && type == Type::orientation)
    return from_angles(angles->xyz);
  if (type == Type::text && number) return Text(fmt::format("{}", *number));
  if (v.index() == row.example().index()) return v;
  return std::nullopt;
}

}  // namespace betwixt
