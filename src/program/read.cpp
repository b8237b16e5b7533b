// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Values read back, one or many at a time.
#include "program/code.h"

namespace betwixt {
namespace {

// All numbers and worlds of one time, made when first wanted.
struct Moment {
  const Program::Compiled& c;
  Time t;
  std::vector<double> all_numbers;
  std::vector<Mat4> all_worlds;

  const double* numbers() {
    if (all_numbers.empty()) all_numbers = c.at(t);
    return all_numbers.data();
  }
  const std::vector<Mat4>& worlds() {
    if (all_worlds.empty()) all_worlds = c.worlds(t, numbers());
    return all_worlds;
  }
};

Reading read_value(const Target& target, const Binding& b, Type type, Moment& m) {
  const Program::Compiled& c = m.c;
  if (type == Type::aim && b.steps >= 0) {
    const Between w = c.between(b, m.t);
    if (w.a != w.b)
      if (const auto p = c.aim(target.object.index, m.t, m.numbers(), &m.worlds())) return *p;
  }
  if (type == Type::points && b.steps >= 0) return c.shape(target.object.index, m.t, m.numbers()).points;
  return std::visit([](const auto& x) -> Reading { return x; }, c.value(b, m.t));
}

Reading read_one(const Target& target, Moment& m) {
  const Program::Compiled& c = m.c;
  if (target.function == world_function) return m.worlds()[c.node_of[target.object.index]];
  const Binding& b = c.find(target.object.index, target.function);
  const Type type = spec_of(c.document.scene(), target.function).type;
  if (b.channels == 0) {
    Reading r = read_value(target, b, type, m);
    if (const auto* p = std::get_if<Vec3>(&r); p && target.component >= 0) return (*p)[target.component];
    return r;
  }
  double n[4];
  c.evaluate(b, m.t, n);
  const auto whole = [&]() -> Reading {
    switch (type) {
      case Type::scalar:
      case Type::angle:
        return n[0];
      case Type::boolean:
        return n[0] != 0;
      case Type::pair:
        return Vec3{n[0], n[1], 0};
      case Type::color:
        return to_srgb(vec3(n));
      case Type::rotation:
      case Type::orientation:
        if (b.orientation) return Quat{n[0], n[1], n[2], n[3]};
        return Angles{vec3(n)};
      default:
        return vec3(n);
    }
  }();
  if (target.component < 0) return whole;
  if (const auto* color = std::get_if<Color>(&whole)) return component_of(*color, target.component);
  return n[target.component];
}

}  // namespace

Reading Program::read(const Target& target, Time t) const {
  Moment m{*code_, t, {}, {}};
  return read_one(target, m);
}

std::vector<Reading> Program::read(const std::vector<Target>& targets, Time t) const {
  Moment m{*code_, t, {}, {}};
  std::vector<Reading> out;
  out.reserve(targets.size());
  for (const Target& target : targets) out.push_back(read_one(target, m));
  return out;
}

std::vector<double> numbers(const Reading& r) {
  if (const auto* m = std::get_if<Mat4>(&r)) {
    std::vector<double> out;
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 4; ++k) out.push_back((*m)(i, k));
    return out;
  }
  double n[4];
  int count = 0;
  std::visit(
      [&](const auto& x) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(x)>, Mat4>) count = to_numbers(Value(x), n);
      },
      r);
  return {n, n + count};
}

}  // namespace betwixt
