// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The table `link` of code: lines between two objects that move.
#include <algorithm>
#include <array>
#include <cmath>

#include "procedure/axes_library.h"
#include "procedure/coordinates.h"
#include "scene/link_way.h"

namespace betwixt::lua {

std::optional<Mat4> world_of(Machine& m, const std::string& name) {
  const auto v = value_now(m, name + ".world");
  const auto* matrix = v ? std::get_if<Matrix>(&*v) : nullptr;
  return matrix ? std::optional<Mat4>(**matrix) : std::nullopt;
}

void into_space(Machine& m, const std::string& name, std::vector<Vec3>& points) {
  const auto world = world_of(m, name);
  if (const auto inward = world ? inverse(*world) : std::nullopt)
    for (Vec3& p : points)
      if (std::isfinite(p.x)) p = transform_point(*inward, p);
}

namespace {

// Reads NAME, X, Y, W, H at an argument: an object, the middle of its border and half the size of the border.
std::string read_border(lua_State* l, Machine& m, int first, LinkBorder& out) {
  if (lua_type(l, first) != LUA_TSTRING) return "the name of an object is missing";
  std::array<double, 4> numbers{};
  for (int i = 0; i < 4; ++i) {
    if (!lua_isnumber(l, first + 1 + i)) return "the numbers of a border are missing";
    numbers[static_cast<std::size_t>(i)] = lua_tonumber(l, first + 1 + i);
  }
  const std::string name = lua_tostring(l, first);
  const auto world = world_of(m, name);
  if (!world) return "there is no object '" + name + "'";
  out.middle = transform_point(*world, {numbers[0], numbers[1], 0});
  out.width = numbers[2] * length(transform_vector(*world, {1, 0, 0}));
  out.height = numbers[3] * length(transform_vector(*world, {0, 1, 0}));
  return "";
}

// link.points(A, X, Y, W, H, B, X, Y, W, H, ROUTE, GAP, TIP): the points of a line from A to B. It ends TIP before B.
int points_of_link(lua_State* l, Machine& m) {
  LinkBorder a, b;
  if (!m.call->questions) return fail_with(l, "link.points: only code that computes a value can use it");
  for (const auto& [first, border] : {std::pair{1, &a}, {6, &b}})
    if (auto why = read_border(l, m, first, *border); !why.empty()) return fail_with(l, "link.points: " + why);
  const std::string route = lua_type(l, 11) == LUA_TSTRING ? lua_tostring(l, 11) : "straight";
  // The line may be below another object, whose scale its tip and its loop have too.
  const auto own = world_of(m, "");
  const double metre = own ? length(transform_vector(*own, {1, 0, 0})) : 1;
  std::vector<Vec3> points = link_way(a, b, route, lua_tonumber(l, 12), metre * lua_tonumber(l, 13), metre);
  return into_space(m, "", points), push_points(l, points), 1;
}

std::vector<Vec3> points_now(lua_State* l, Machine& m) {
  if (lua_type(l, 1) != LUA_TSTRING || !m.call->questions) return {};
  const auto v = value_now(m, std::string(lua_tostring(l, 1)) + ".points");
  const auto* points = v ? std::get_if<Points>(&*v) : nullptr;
  return points ? **points : std::vector<Vec3>();
}

// Returns the points of a line from the end at which a tip is: with true as the second argument, from its beginning.
std::vector<Vec3> points_to_tip(lua_State* l, Machine& m) {
  std::vector<Vec3> all = points_now(l, m);
  if (lua_toboolean(l, 2)) std::reverse(all.begin(), all.end());
  return all;
}
// link.tip(LINE, FIRST): the last point of a line; with FIRST, the first one.
int tip_of_link(lua_State* l, Machine& m) {
  const auto all = points_to_tip(l, m);
  return push_place(l, all.empty() ? Vec3{} : all.back()), 1;
}
// link.turn(LINE, FIRST): the angle of the piece that ends there.
int turn_of_link(lua_State* l, Machine& m) {
  const auto all = points_to_tip(l, m);
  const Vec3 d = all.size() < 2 ? Vec3{1, 0, 0} : all.back() - all[all.size() - 2];
  return lua_pushnumber(l, std::atan2(d.y, d.x)), 1;
}
// link.middle(LINE, HALF, AT, SIDE): the place of the middle of a label, half as wide, beside a line: see LinkLabel.
// Without AT and SIDE it is above its middle.
int middle_of_link(lua_State* l, Machine& m) {
  const std::string side = lua_type(l, 4) == LUA_TSTRING ? lua_tostring(l, 4) : "above";
  const auto known = std::find(link_sides.begin(), link_sides.end(), side);
  if (known == link_sides.end()) return fail_with(l, "link.middle: there is no side '" + side + "'");
  const LinkLabel label{luaL_optnumber(l, 3, 0.5), static_cast<LinkSide>(known - link_sides.begin())};
  return push_place(l, place_of_label(points_now(l, m), lua_tonumber(l, 2), label)), 1;
}

// link.beside(A, X, Y, Z, RIGHT, UP[, ABOVE]): the place in the space of ABOVE, or else in the world, that lies RIGHT
// and UP in the world from the point (X Y Z) of A.
int beside_of_link(lua_State* l, Machine& m) {
  if (lua_type(l, 1) != LUA_TSTRING) return fail_with(l, "link.beside: the name of an object is missing");
  const auto world = world_of(m, lua_tostring(l, 1));
  if (!world) return fail_with(l, "link.beside: there is no object '" + std::string(lua_tostring(l, 1)) + "'");
  const Vec3 at = transform_point(*world, {lua_tonumber(l, 2), lua_tonumber(l, 3), lua_tonumber(l, 4)}) +
                  Vec3{lua_tonumber(l, 5), lua_tonumber(l, 6), 0.02};
  const std::string above = lua_type(l, 7) == LUA_TSTRING ? lua_tostring(l, 7) : "";
  const auto outer = above.empty() ? std::nullopt : world_of(m, above);
  const auto inward = outer ? inverse(*outer) : std::nullopt;
  return push_place(l, inward ? transform_point(*inward, at) : at), 1;
}

}  // namespace

const luaL_Reg link_functions[] = {{"points", of_piece<points_of_link>}, {"tip", of_piece<tip_of_link>},
                                   {"turn", of_piece<turn_of_link>},     {"beside", of_piece<beside_of_link>},
                                   {"middle", of_piece<middle_of_link>}, {nullptr, nullptr}};

}  // namespace betwixt::lua
