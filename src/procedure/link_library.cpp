// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The table `link` of code: lines between two objects that move.
#include <algorithm>
#include <array>
#include <cmath>

#include "procedure/axes_library.h"
#include "procedure/coordinates.h"

namespace betwixt::lua {
namespace {

// The border of an object: a rectangle, or a circle if its height is 0.
struct Border {
  Vec3 middle;
  double width = 0, height = 0;  // half of them
  // Returns how far the border is from the middle, in this direction.
  double reach(Vec3 way) const {
    if (height == 0) return width;
    const double x = std::abs(way.x), y = std::abs(way.y);
    return std::min(x > 1e-12 ? width / x : 1e9, y > 1e-12 ? height / y : 1e9);
  }
};

// Returns the transform of an object to the world; "": of the object whose value it is.
std::optional<Mat4> world_now(Machine& m, const std::string& name) {
  const auto v = value_now(m, name + ".world");
  const auto* matrix = v ? std::get_if<Matrix>(&*v) : nullptr;
  return matrix ? std::optional<Mat4>(**matrix) : std::nullopt;
}

// Reads NAME, X, Y, W, H at an argument: an object, the middle of its border and half the size of the border.
std::string read_border(lua_State* l, Machine& m, int first, Border& out) {
  if (lua_type(l, first) != LUA_TSTRING) return "the name of an object is missing";
  std::array<double, 4> numbers{};
  for (int i = 0; i < 4; ++i) {
    if (!lua_isnumber(l, first + 1 + i)) return "the numbers of a border are missing";
    numbers[static_cast<std::size_t>(i)] = lua_tonumber(l, first + 1 + i);
  }
  const std::string name = lua_tostring(l, first);
  const auto world = world_now(m, name);
  if (!world) return "there is no object '" + name + "'";
  out.middle = transform_point(*world, {numbers[0], numbers[1], 0});
  out.width = numbers[2] * length(transform_vector(*world, {1, 0, 0}));
  out.height = numbers[3] * length(transform_vector(*world, {0, 1, 0}));
  return "";
}

Vec3 unit(Vec3 v) { return length(v) > 1e-12 ? (1 / length(v)) * v : Vec3{1, 0, 0}; }

// Returns the way from a to b outside their borders, `gap` apart from them.
std::vector<Vec3> way_between(const Border& a, const Border& b, const std::string& route, double gap) {
  const Vec3 d = b.middle - a.middle;
  const auto leaves = [&](const Border& from, Vec3 way) { return from.middle + (from.reach(way) + gap) * way; };
  if (route == "angled") {
    // Along the longer direction, across in the middle.
    const bool flat = std::abs(d.x) >= std::abs(d.y);
    const Vec3 way = flat ? Vec3{d.x < 0 ? -1.0 : 1.0, 0, 0} : Vec3{0, d.y < 0 ? -1.0 : 1.0, 0};
    const Vec3 from = leaves(a, way), to = leaves(b, -1 * way), half = 0.5 * (from + to);
    return flat ? std::vector<Vec3>{from, {half.x, from.y, from.z}, {half.x, to.y, to.z}, to}
                : std::vector<Vec3>{from, {from.x, half.y, from.z}, {to.x, half.y, to.z}, to};
  }
  if (route != "curved") return {leaves(a, unit(d)), leaves(b, unit(-1 * d))};
  const Vec3 bulge = 0.5 * (a.middle + b.middle) + 0.22 * Vec3{-d.y, d.x, 0};
  const Vec3 from = leaves(a, unit(bulge - a.middle)), to = leaves(b, unit(bulge - b.middle));
  std::vector<Vec3> out;
  for (int i = 0; i <= 24; ++i) {
    const double u = i / 24.0;
    out.push_back((1 - u) * (1 - u) * from + 2 * u * (1 - u) * bulge + u * u * to);
  }
  return out;
}

// Takes a length from the end of a way.
void shorten(std::vector<Vec3>& points, double by) {
  while (points.size() > 2 && length(points.back() - points[points.size() - 2]) <= by) {
    by -= length(points.back() - points[points.size() - 2]);
    points.pop_back();
  }
  Vec3& last = points.back();
  last = last - by * unit(last - points[points.size() - 2]);
}

// link.points(A, X, Y, W, H, B, X, Y, W, H, ROUTE, GAP, TIP): the points of a line from A to B. It ends TIP before B.
int points_of_link(lua_State* l, Machine& m) {
  Border a, b;
  if (!m.call->questions) return fail_with(l, "link.points: only code that computes a value can use it");
  for (const auto& [first, border] : {std::pair{1, &a}, {6, &b}})
    if (auto why = read_border(l, m, first, *border); !why.empty()) return fail_with(l, "link.points: " + why);
  const std::string route = lua_type(l, 11) == LUA_TSTRING ? lua_tostring(l, 11) : "straight";
  std::vector<Vec3> points = way_between(a, b, route, lua_tonumber(l, 12));
  shorten(points, lua_tonumber(l, 13));
  // The line may be below another object.
  const auto own = world_now(m, "");
  if (const auto inward = own ? inverse(*own) : std::nullopt)
    for (Vec3& p : points) p = transform_point(*inward, p);
  return push_points(l, points), 1;
}

std::vector<Vec3> points_now(lua_State* l, Machine& m) {
  if (lua_type(l, 1) != LUA_TSTRING || !m.call->questions) return {};
  const auto v = value_now(m, std::string(lua_tostring(l, 1)) + ".points");
  const auto* points = v ? std::get_if<Points>(&*v) : nullptr;
  return points ? **points : std::vector<Vec3>();
}

// link.tip(LINE): the last point of a line.
int tip_of_link(lua_State* l, Machine& m) {
  const auto all = points_now(l, m);
  return push_place(l, all.empty() ? Vec3{} : all.back()), 1;
}
// link.turn(LINE): the angle of its last piece.
int turn_of_link(lua_State* l, Machine& m) {
  const auto all = points_now(l, m);
  const Vec3 d = all.size() < 2 ? Vec3{1, 0, 0} : all.back() - all[all.size() - 2];
  return lua_pushnumber(l, std::atan2(d.y, d.x)), 1;
}
// link.middle(LINE, HALF): the place of the middle of a label, half as wide, beside the middle of a line.
int middle_of_link(lua_State* l, Machine& m) {
  const auto all = points_now(l, m);
  if (all.size() < 2) return push_place(l, {}), 1;
  const std::size_t half = all.size() / 2;
  const Vec3 a = all[half - 1], b = all[half], d = unit(b - a), across{-d.y, d.x, 0};
  const Vec3 at = all.size() % 2 == 0 ? 0.5 * (a + b) : b;
  const double away = 0.08 + std::abs(across.x) * lua_tonumber(l, 2) + std::abs(across.y) * 0.12;
  return push_place(l, at + (across.y < 0 ? -away : away) * across), 1;
}

// link.beside(A, X, Y, Z, RIGHT, UP, ABOVE): the place in the space of the object ABOVE ("": the world) that lies RIGHT
// and UP in the world from the point (X Y Z) of A.
int beside_of_link(lua_State* l, Machine& m) {
  if (lua_type(l, 1) != LUA_TSTRING) return fail_with(l, "link.beside: the name of an object is missing");
  const auto world = world_now(m, lua_tostring(l, 1));
  if (!world) return fail_with(l, "link.beside: there is no object '" + std::string(lua_tostring(l, 1)) + "'");
  const Vec3 at = transform_point(*world, {lua_tonumber(l, 2), lua_tonumber(l, 3), lua_tonumber(l, 4)}) +
                  Vec3{lua_tonumber(l, 5), lua_tonumber(l, 6), 0.02};
  const std::string above = lua_type(l, 7) == LUA_TSTRING ? lua_tostring(l, 7) : "";
  const auto outer = above.empty() ? std::nullopt : world_now(m, above);
  const auto inward = outer ? inverse(*outer) : std::nullopt;
  return push_place(l, inward ? transform_point(*inward, at) : at), 1;
}

}  // namespace

const luaL_Reg link_functions[] = {{"points", of_piece<points_of_link>}, {"tip", of_piece<tip_of_link>},
                                   {"turn", of_piece<turn_of_link>},     {"beside", of_piece<beside_of_link>},
                                   {"middle", of_piece<middle_of_link>}, {nullptr, nullptr}};

}  // namespace betwixt::lua
