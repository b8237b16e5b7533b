// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Converts the author's values to the numbers in the array, and back.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "program/compiled.h"
#include "track/operations.h"

namespace betwixt {

Vec3 to_angles(Quat q) {  // about the object's own x, then y, then z axis
  const Mat4 m = rotation(q);
  const double y = std::asin(std::clamp(m(0, 2), -1.0, 1.0));
  if (std::abs(m(0, 2)) > 1 - 1e-12) return {std::atan2(m(2, 1), m(1, 1)), y, 0};
  return {std::atan2(-m(1, 2), m(2, 2)), y, std::atan2(-m(0, 1), m(0, 0))};
}

int held_numbers(const Value& v, bool orientation, double* out) {
  if (const auto* a = std::get_if<Angles>(&v); a && orientation) return to_numbers(from_angles(a->xyz), out);
  const int n = to_numbers(v, out);
  if (std::holds_alternative<Color>(v))
    for (int i = 0; i < 3; ++i) out[i] = to_linear(out[i]);
  return n;
}

Value written_value(Type type, const double* n, bool orientation) {
  if (!row_of(type).light) return value_of_numbers(type, n, orientation);
  const double written[] = {to_srgb(n[0]), to_srgb(n[1]), to_srgb(n[2])};
  return value_of_numbers(type, written);
}

namespace {

// Reads a parent from code's text. A name alone means attach; "couple to NAME" and "hang on NAME" name the kind.
Result<Value> holder(const Value& v, const Scene& scene) {
  const auto* off = std::get_if<bool>(&v);
  if (off && !*off) return Value(Attachment{});
  const auto* text = std::get_if<Text>(&v);
  if (!text) return fail(ErrorCode::type, "it must return the name of the parent, \"none\" or false");
  std::string_view name = **text;
  if (name == "none") return Value(Attachment{});
  AttachmentKind kind = AttachmentKind::attach;
  for (const auto& [words, how] : {std::pair(std::string_view("couple to "), AttachmentKind::couple),
                                   std::pair(std::string_view("attach to "), AttachmentKind::attach),
                                   std::pair(std::string_view("hang on "), AttachmentKind::hang)})
    if (name.starts_with(words)) name.remove_prefix(words.size()), kind = how;
  const ObjectId id = scene.names.find(name);
  if (!id) return fail(ErrorCode::name, fmt::format("there is no object '{}'", name.substr(0, 60)));
  if (!placed(scene.objects[id.index].kind))
    return fail(ErrorCode::type, fmt::format("'{}' has no position, so it cannot be a parent", name));
  return Value(Attachment{kind, id, false});
}

}  // namespace

Result<Value> fit(const Value& v, Type type, const Scene& scene) {
  if (const auto fitting = fitted(v, type)) return *fitting;
  const auto* text = std::get_if<Text>(&v);
  if (type == Type::attachment) return holder(v, scene);
  if (type == Type::names && text) return Value(**text == "none" ? Names() : Names({**text}));
  if (const auto* points = std::get_if<Points>(&v); type == Type::names && points && (*points)->empty())
    return Value(Names());
  if (type == Type::motion && text) {
    auto motion = parse_motion(**text);
    if (!motion)
      return fail(ErrorCode::type,
                  fmt::format("\"{}\" is not a motion: {}", (*text)->substr(0, 60), motion.error().message));
    return Value(Moves(*std::move(motion)));
  }
  if (text && std::holds_alternative<ObjectId>(row_of(type).example())) {
    if (**text == "none") return Value(ObjectId{});
    if (const ObjectId id = scene.names.find(**text)) return Value(id);
    return fail(ErrorCode::name, fmt::format("there is no object '{}'", **text));
  }
  const char* is = std::holds_alternative<double>(v)   ? "a number"
                   : std::holds_alternative<Vec3>(v)   ? "a vector"
                   : text                              ? "a text"
                   : std::holds_alternative<Matrix>(v) ? "a matrix"
                                                       : "something else";
  return fail(ErrorCode::type, fmt::format("it must return {}, not {}", to_string(type), is));
}

std::optional<Value> laid_over(const Value& a, const Value& b, double w, bool mix) {
  const auto turn = [](const Value& v) -> std::optional<Quat> {
    if (const auto* q = std::get_if<Quat>(&v)) return *q;
    if (const auto* e = std::get_if<Angles>(&v)) return from_angles(e->xyz);
    return std::nullopt;
  };
  if (std::holds_alternative<Quat>(a) || std::holds_alternative<Quat>(b)) {
    const auto p = turn(a), q = turn(b);
    if (!p || !q) return std::nullopt;
    if (!mix) return *p * power(q->w < 0 ? -*q : *q, w);
    return slerp(*p, dot(*p, *q) < 0 ? -*q : *q, w);
  }
  if (a.index() != b.index()) return std::nullopt;
  if (const auto* from = std::get_if<Color>(&a); from && mix) {  // mixes linear light, not the written numbers
    const Vec3 x = to_linear(*from), y = to_linear(std::get<Color>(b));
    return to_srgb(x + w * (y - x));
  }
  if (!numeric(a) || std::holds_alternative<bool>(a)) return mix && w >= 0.5 ? b : a;
  if (mix) return add_scaled(a, *add_scaled(b, a, -1), w);
  return add_scaled(a, b, w);
}

}  // namespace betwixt
