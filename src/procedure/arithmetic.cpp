// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The functions here may raise Lua errors; see machine.h.
#include "procedure/arithmetic.h"

#include <algorithm>
#include <cmath>

#include "procedure/machine.h"
#include "procedure/noise.h"
#include "track/track.h"

namespace betwixt::lua {
namespace {

double number(lua_State* l, int i) { return luaL_checknumber(l, i); }

template <Kind kind, int count>
int make(lua_State* l) {
  double n[4];
  for (int i = 0; i < count; ++i) n[i] = number(l, i + 1);
  return push(l, kind, n), 1;
}

int make_axis(lua_State* l) {
  const Quat q = axis_angle({number(l, 1), number(l, 2), number(l, 3)}, number(l, 4));
  const double n[] = {q.w, q.x, q.y, q.z};
  return push(l, Kind::quat, n), 1;
}

int make_vector(lua_State* l) {  // in a plane two numbers are enough
  const double n[] = {number(l, 1), number(l, 2), luaL_optnumber(l, 3, 0)};
  return push(l, Kind::vector, n), 1;
}

int make_hsv(lua_State* l) {
  const Color c = from_hsv(number(l, 1), number(l, 2), number(l, 3));
  const double n[] = {c.r, c.g, c.b};
  return push(l, Kind::color, n), 1;
}

Vec3 vector(lua_State* l, int i) {
  double n[16];
  if (read(l, i, n) != Kind::vector) luaL_argerror(l, i, "a vector is needed");
  return {n[0], n[1], n[2]};
}
int push_vector(lua_State* l, Vec3 v) {
  const double n[] = {v.x, v.y, v.z};
  return push(l, Kind::vector, n), 1;
}
int length_of(lua_State* l) { return lua_pushnumber(l, length(vector(l, 1))), 1; }
int dot_of(lua_State* l) { return lua_pushnumber(l, dot(vector(l, 1), vector(l, 2))), 1; }
int cross_of(lua_State* l) { return push_vector(l, cross(vector(l, 1), vector(l, 2))); }
int normalized(lua_State* l) { return push_vector(l, normalize(vector(l, 1), {0, 0, 0})); }

Vec3 up_to_three(lua_State* l) { return {number(l, 1), luaL_optnumber(l, 2, 0), luaL_optnumber(l, 3, 0)}; }
int noise_of(lua_State* l) { return lua_pushnumber(l, noise(up_to_three(l), std::clamp(lua_gettop(l), 1, 3))), 1; }
int random_of(lua_State* l) { return lua_pushnumber(l, hashed(up_to_three(l))), 1; }
int clamp_of(lua_State* l) {
  if (lua_isinteger(l, 1) && lua_isinteger(l, 2) && lua_isinteger(l, 3))
    return lua_pushinteger(l, std::max(lua_tointeger(l, 2), std::min(lua_tointeger(l, 1), lua_tointeger(l, 3)))), 1;
  return lua_pushnumber(l, std::fmax(number(l, 2), std::fmin(number(l, 1), number(l, 3)))), 1;
}
int round_of(lua_State* l) { return push_number(l, std::floor(number(l, 1) + 0.5)), 1; }
int sign_of(lua_State* l) { return push_number(l, (number(l, 1) > 0) - (number(l, 1) < 0)), 1; }
int smoothstep(lua_State* l) {
  const double low = number(l, 1), high = number(l, 2), x = number(l, 3);
  const double u = low == high ? x >= high : std::fmax(0, std::fmin((x - low) / (high - low), 1));
  return lua_pushnumber(l, u * u * (3 - 2 * u)), 1;
}
// mix(a, b, u) = a (1 - u) + b u, for numbers and all types with arithmetic.
int mix(lua_State* l) {
  const double u = number(l, 3);
  lua_settop(l, 2);
  lua_pushnumber(l, u);
  lua_arith(l, LUA_OPMUL);
  lua_insert(l, 1);
  lua_pushnumber(l, 1 - u);
  lua_arith(l, LUA_OPMUL);
  lua_insert(l, 1);
  lua_arith(l, LUA_OPADD);
  return 1;
}

// matrix(position, rotation, scale): scales, rotates, then moves; each may be nil. matrix(list): 16 numbers, row after
// row.
int make_matrix(lua_State* l) {
  double n[16];
  if (lua_type(l, 1) == LUA_TTABLE && read(l, 1, n) == Kind::none) {
    for (int i = 0; i < 16; ++i) {
      lua_rawgeti(l, 1, i + 1);
      if (lua_type(l, -1) != LUA_TNUMBER) return luaL_error(l, "matrix: a list needs 16 numbers");
      n[i] = lua_tonumber(l, -1);
      lua_pop(l, 1);
    }
    return push(l, Kind::matrix, n), 1;
  }
  const Vec3 place = lua_isnoneornil(l, 1) ? Vec3{} : vector(l, 1);
  Mat4 m;
  if (!lua_isnoneornil(l, 2)) {
    const Kind kind = read(l, 2, n);
    if (kind == Kind::quat)
      m = rotation(normalize(Quat{n[0], n[1], n[2], n[3]}));
    else if (kind == Kind::angles)
      m = rotation(from_angles({n[0], n[1], n[2]}));
    else
      return luaL_argerror(l, 2, "a rotation is needed: euler, quat or axis");
  }
  const bool even = lua_type(l, 3) == LUA_TNUMBER;
  const Vec3 scale = lua_isnoneornil(l, 3) ? Vec3{1, 1, 1} : even ? number(l, 3) * Vec3{1, 1, 1} : vector(l, 3);
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) m(row, column) *= scale[column];
  m(0, 3) = place.x, m(1, 3) = place.y, m(2, 3) = place.z;
  return push(l, m), 1;
}
int inverse_of(lua_State* l) {
  double n[16];
  const Kind kind = read(l, 1, n);
  if (kind == Kind::quat) {
    const double out[] = {n[0], -n[1], -n[2], -n[3]};
    return push(l, Kind::quat, out), 1;
  }
  if (kind != Kind::matrix) return luaL_argerror(l, 1, "a matrix or a quaternion is needed");
  const auto m = inverse(matrix_of(n));
  if (!m) return luaL_error(l, "inverse: this matrix has none, because it scales by 0");
  return push(l, *m), 1;
}

}  // namespace

const luaL_Reg arithmetic_functions[] = {{"vec", make_vector},
                                         {"rgb", make<Kind::color, 3>},
                                         {"hsv", make_hsv},
                                         {"euler", make<Kind::angles, 3>},
                                         {"quat", make<Kind::quat, 4>},
                                         {"axis", make_axis},
                                         {"matrix", make_matrix},
                                         {"inverse", inverse_of},
                                         {"length", length_of},
                                         {"dot", dot_of},
                                         {"cross", cross_of},
                                         {"normalize", normalized},
                                         {"noise", noise_of},
                                         {"random", random_of},
                                         {"hash", random_of},
                                         {"round", round_of},
                                         {"sign", sign_of},
                                         {"clamp", clamp_of},
                                         {"mix", mix},
                                         {"smoothstep", smoothstep},
                                         {nullptr, nullptr}};

}  // namespace betwixt::lua
