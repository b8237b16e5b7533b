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

}  // namespace

const luaL_Reg arithmetic_functions[] = {{"vec", make_vector},
                                         {"rgb", make<Kind::color, 3>},
                                         {"hsv", make_hsv},
                                         {"euler", make<Kind::angles, 3>},
                                         {"quat", make<Kind::quat, 4>},
                                         {"axis", make_axis},
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
