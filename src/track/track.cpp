// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/track.h"

#include <cmath>

#include "track/twerpers.h"

namespace betwixt {

bool fits(Twerper twerper, Type type, std::string* why) {
  const bool orientation = type == Type::orientation || type == Type::rotation;
  const bool steps = type == Type::boolean || type == Type::attachment || type == Type::text || type == Type::names ||
                     type == Type::transform;
  const auto no = [&](std::string reason) {
    if (why) *why = std::move(reason);
    return false;
  };
  if (is_own(twerper))
    return steps ? no("a twerper cannot blend " + std::string(to_string(type)) + ": it changes at its events only")
                 : true;
  const std::string name(name_of(twerper));
  if (twerper == Twerper::unset || twerper == Twerper::hold) return true;
  if (steps)
    return no("'" + name + "' cannot blend " + std::string(to_string(type)) + ": it changes at its events only");
  if (row_of(twerper).for_numbers != Twerper::unset && !orientation)
    return no("'" + name + "' turns orientations; this is " + std::string(to_string(type)));
  return true;
}

Twerper default_twerper(Type type) {
  switch (type) {
    case Type::scalar:
    case Type::angle:
    case Type::pair:
    case Type::vector:
      return Twerper::smooth;
    case Type::color:
      return Twerper::linear;
    case Type::rotation:  // orientations; angles are vectors
    case Type::orientation:
      return Twerper::slerp;
    default:
      return Twerper::hold;
  }
}

double to_linear(double s) {
  const double a = std::abs(s);
  return std::copysign(a <= 0.04045 ? a / 12.92 : std::pow((a + 0.055) / 1.055, 2.4), s);
}

double to_srgb(double l) {
  const double a = std::abs(l);
  const double s = a <= 0.0031308 ? a * 12.92 : 1.055 * std::pow(a, 1 / 2.4) - 0.055;
  // What was written as eight bits or in up to twelve decimals comes back as it was written; the rest is off by a
  // rounding or two.
  for (const double grid : {255.0, 1e12}) {
    const double near = std::round(s * grid) / grid;
    if (std::abs(near - s) < 1e-14 * std::max(1.0, s)) return std::copysign(near, l);
  }
  return std::copysign(s, l);
}

Vec3 to_linear(Color c) { return {to_linear(c.r), to_linear(c.g), to_linear(c.b)}; }
Color to_srgb(Vec3 l) { return {to_srgb(l.x), to_srgb(l.y), to_srgb(l.z)}; }

}  // namespace betwixt
