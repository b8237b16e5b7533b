// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The table `mark` of code: angles and dimensions between objects that move.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "procedure/axes_library.h"
#include "procedure/coordinates.h"

namespace betwixt::lua {
namespace {

constexpr double mark_gap = 0.08;  // between a mark and its label, or the thing that it is at

Vec3 unit_or(Vec3 v, Vec3 otherwise) { return length(v) > 1e-12 ? (1 / length(v)) * v : otherwise; }

// Reads places: names of objects, which stand for their origins, or vectors. Returns why not, or "".
std::string read_places(lua_State* l, Machine& m, int first, std::span<Vec3> out) {
  if (!m.call->questions) return "only code that computes a value can use it";
  for (Vec3& place : out) {
    const int at = first++;
    if (lua_type(l, at) == LUA_TSTRING) {
      const std::string name = lua_tostring(l, at);
      const auto world = world_of(m, name);
      if (!world) return "there is no object '" + name + "'";
      place = transform_point(*world, {});
      continue;
    }
    const auto v = to_value(l, at);
    const Vec3* said = v ? std::get_if<Vec3>(&*v) : nullptr;
    if (!said) return "the name of an object or a vector is missing";
    place = *said;
  }
  return "";
}

// Pushes points of the world in the space of the object whose value they are.
int push_own_points(lua_State* l, Machine& m, std::vector<Vec3> points) {
  return into_space(m, "", points), push_points(l, points), 1;
}
// Pushes the place of a label below the mark that the first argument names: `half` its size away from a point of the
// world, in a direction.
int push_beside(lua_State* l, Machine& m, Vec3 from, Vec3 way, Vec3 half) {
  std::vector<Vec3> at{from + (std::abs(way.x) * half.x + std::abs(way.y) * half.y) * way};
  return into_space(m, lua_type(l, 1) == LUA_TSTRING ? lua_tostring(l, 1) : "", at), push_place(l, at[0]), 1;
}
Vec3 half_at(lua_State* l, int at) { return {lua_tonumber(l, at), lua_tonumber(l, at + 1), 0}; }

// Pushes a number with so many digits behind the point.
int push_digits(lua_State* l, double v, int at, const char* after = "") {
  const auto digits = static_cast<int>(std::clamp(lua_tonumber(l, at), 0.0, 12.0));
  const std::string out = fmt::format("{:.{}f}{}", v, digits, after);
  return lua_pushlstring(l, out.data(), out.size()), 1;
}

// ---- Angles

// An angle: from one direction towards another one at right angles to it.
struct Corner {
  Vec3 at, first, across;
  double sweep = 0;
  Vec3 way(double angle) const { return std::cos(angle) * first + std::sin(angle) * across; }
  bool right() const { return std::abs(sweep - pi / 2) < 0.1 * pi / 180; }
};

// Reads A, B, C and whether the angle turns anticlockwise from A to C; otherwise it is the smaller one.
std::string read_corner(lua_State* l, Machine& m, int first, Corner& out) {
  std::array<Vec3, 3> p;
  if (auto why = read_places(l, m, first, p); !why.empty()) return why;
  out.at = p[1], out.first = unit_or(p[0] - p[1], {1, 0, 0});
  const Vec3 other = unit_or(p[2] - p[1], out.first);
  const double along = dot(out.first, other);
  const Vec3 rest = other - along * out.first;
  out.sweep = std::atan2(length(rest), along);
  const Vec3 left = unit_or({-out.first.y, out.first.x, 0}, {0, 1, 0});
  out.across = length(rest) > 1e-9 ? unit_or(rest, left) : left;
  if (lua_toboolean(l, first + 3) && cross(out.first, out.across).z < 0)
    out.across = -1 * out.across, out.sweep = 2 * pi - out.sweep;
  return "";
}

// mark.angle(A, B, C, TURNING, RADIUS): the points of an arc, or of a square at a right angle.
int points_of_angle(lua_State* l, Machine& m) {
  Corner c;
  if (const auto why = read_corner(l, m, 1, c); !why.empty()) return fail_with(l, "mark.angle: " + why);
  const double radius = lua_tonumber(l, 5), side = 0.6 * radius;
  if (c.right())
    return push_own_points(l, m, {c.at + side * c.first, c.at + side * (c.first + c.across), c.at + side * c.across});
  std::vector<Vec3> points;
  const int pieces = c.sweep > pi ? 64 : 32;
  for (int i = 0; i <= pieces; ++i) points.push_back(c.at + radius * c.way(c.sweep * i / pieces));
  return push_own_points(l, m, std::move(points));
}
// mark.angle_label(MARK, A, B, C, TURNING, RADIUS, W, H): the middle of a label, half as large, behind the arc. In a
// narrow angle it is further away, where it fits between the legs, up to three times the radius.
int label_of_angle(lua_State* l, Machine& m) {
  Corner c;
  if (const auto why = read_corner(l, m, 2, c); !why.empty()) return fail_with(l, "mark.angle_label: " + why);
  const Vec3 half = half_at(l, 7), way = c.way(c.sweep / 2);
  const double radius = lua_tonumber(l, 6), across = std::abs(way.y) * half.x + std::abs(way.x) * half.y;
  double away = radius + mark_gap;
  if (c.sweep < pi)
    away = std::max(away, std::min((across + mark_gap) / std::tan(std::max(c.sweep / 2, 1e-6)), 3 * radius));
  return push_beside(l, m, c.at + away * way, way, half);
}
// mark.degrees(A, B, C, TURNING, DECIMALS): the angle as a text.
int degrees_of_angle(lua_State* l, Machine& m) {
  Corner c;
  if (const auto why = read_corner(l, m, 1, c); !why.empty()) return fail_with(l, "mark.degrees: " + why);
  return push_digits(l, c.sweep * 180 / pi, 5, "°");
}

// ---- Dimensions

// A line beside two places.
struct Beside {
  Vec3 a, b, along, out;  // its ends, its direction, and the direction away from the places
  double away = 0;        // from the places to it, along `out`
};
std::string read_beside(lua_State* l, Machine& m, int first, Beside& to) {
  std::array<Vec3, 2> p;
  if (auto why = read_places(l, m, first, p); !why.empty()) return why;
  const double offset = lua_tonumber(l, first + 2);
  to.along = unit_or(p[1] - p[0], {1, 0, 0});
  to.out = (offset < 0 ? -1.0 : 1.0) * unit_or({-to.along.y, to.along.x, 0}, {0, 1, 0});
  to.away = std::abs(offset);
  to.a = p[0] + to.away * to.out, to.b = p[1] + to.away * to.out;
  return "";
}

// mark.dimension(A, B, OFFSET, TIP): the two ends of the line, TIP before the ends of its tips.
int points_of_dimension(lua_State* l, Machine& m) {
  Beside d;
  if (const auto why = read_beside(l, m, 1, d); !why.empty()) return fail_with(l, "mark.dimension: " + why);
  const double tip = std::min(lua_tonumber(l, 4), 0.49 * length(d.b - d.a));
  return push_own_points(l, m, {d.a + tip * d.along, d.b - tip * d.along});
}
// mark.dimension_ends(A, B, OFFSET): the short lines from the places to a little behind the line.
int ends_of_dimension(lua_State* l, Machine& m) {
  Beside d;
  if (const auto why = read_beside(l, m, 1, d); !why.empty()) return fail_with(l, "mark.dimension_ends: " + why);
  const Vec3 from = std::max(d.away - mark_gap, 0.0) * d.out, to = mark_gap * d.out, none{HUGE_VAL, HUGE_VAL, 0};
  return push_own_points(l, m, {d.a - from, d.a + to, none, d.b - from, d.b + to});
}
// mark.dimension_label(MARK, A, B, OFFSET, W, H): the middle of a label, half as large, beside the line.
int label_of_dimension(lua_State* l, Machine& m) {
  Beside d;
  if (const auto why = read_beside(l, m, 2, d); !why.empty()) return fail_with(l, "mark.dimension_label: " + why);
  return push_beside(l, m, 0.5 * (d.a + d.b) + mark_gap * d.out, d.out, half_at(l, 5));
}
// mark.distance(A, B, DECIMALS): their distance as a text.
int distance_of_places(lua_State* l, Machine& m) {
  std::array<Vec3, 2> p;
  if (const auto why = read_places(l, m, 1, p); !why.empty()) return fail_with(l, "mark.distance: " + why);
  return push_digits(l, length(p[1] - p[0]), 3);
}

}  // namespace

const luaL_Reg mark_functions[] = {{"angle", of_piece<points_of_angle>},
                                   {"angle_label", of_piece<label_of_angle>},
                                   {"degrees", of_piece<degrees_of_angle>},
                                   {"dimension", of_piece<points_of_dimension>},
                                   {"dimension_ends", of_piece<ends_of_dimension>},
                                   {"dimension_label", of_piece<label_of_dimension>},
                                   {"distance", of_piece<distance_of_places>},
                                   {nullptr, nullptr}};

}  // namespace betwixt::lua
