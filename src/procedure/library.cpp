// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The globals of code. It gets read-only proxies of the tables, so that it can leave no changes.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "procedure/arithmetic.h"
#include "procedure/axes_library.h"
#include "procedure/machine.h"
#include "procedure/queries.h"

namespace betwixt::lua {
namespace {

// --- plain functions (may raise; see machine.h) ---

// The cost in steps of Lua's own functions, which may process a whole list or text in one call.
enum class Charge { text, list, range, move, sort };
double span(lua_State* l, int first, int last, double otherwise) {
  const double a = luaL_optnumber(l, first, 1), b = luaL_optnumber(l, last, otherwise);
  return b >= a ? b - a + 1 : 0;
}
// A comparison may read whole texts.
double sorting(lua_State* l, double size) { return size * (1 + std::log2(size + 1)) * Machine::of(l).steps_each(); }
template <Charge how>
int charged(lua_State* l) {
  const double size = lua_type(l, 1) == LUA_TTABLE ? static_cast<double>(lua_rawlen(l, 1)) : 0;
  double steps = 0;
  if constexpr (how == Charge::text)
    for (int i = 1; i <= lua_gettop(l); ++i) steps += lua_type(l, i) == LUA_TSTRING ? lua_rawlen(l, i) / 16.0 : 1;
  if constexpr (how == Charge::list) steps = size + lua_gettop(l);
  if constexpr (how == Charge::range) steps = span(l, lua_type(l, 2) == LUA_TSTRING ? 3 : 2, 3, size) + size;
  if constexpr (how == Charge::move) steps = span(l, 2, 3, 0);
  if constexpr (how == Charge::sort) steps = sorting(l, size);
  charge(l, steps);
  lua_pushvalue(l, lua_upvalueindex(1));
  lua_insert(l, 1);
  lua_call(l, lua_gettop(l) - 1, LUA_MULTRET);
  const int results = lua_gettop(l);
  if (results > 8) charge(l, results);
  return results;
}

// Returns the least or greatest of the arguments, which may be many.
template <bool least>
int extreme(lua_State* l) {
  const int count = lua_gettop(l);
  int found = 1;
  luaL_argcheck(l, count >= 1, 1, "number expected, got no value");
  if (count > 8) charge(l, count);
  for (int i = 1; i <= count; ++i) {
    luaL_checknumber(l, i);
    if (least ? lua_compare(l, i, found, LUA_OPLT) : lua_compare(l, found, i, LUA_OPLT)) found = i;
  }
  return lua_pushvalue(l, found), 1;
}

// Functions of this program's own C library (cmake/steady.cmake). Lua is a shared library, so in other processes, such
// as Python, its own functions are those of the system, which may differ in the last bit.
template <auto function>
int of_one(lua_State* l) {
  return lua_pushnumber(l, function(luaL_checknumber(l, 1))), 1;
}
int arc_tangent(lua_State* l) {
  return lua_pushnumber(l, std::atan2(luaL_checknumber(l, 1), luaL_optnumber(l, 2, 1))), 1;
}
int logarithm(lua_State* l) {
  const double x = luaL_checknumber(l, 1), base = luaL_optnumber(l, 2, 0);
  const bool natural = lua_isnoneornil(l, 2);
  return lua_pushnumber(l, natural      ? std::log(x)
                           : base == 2  ? std::log2(x)
                           : base == 10 ? std::log10(x)
                                        : std::log(x) / std::log(base)),
         1;
}
constexpr luaL_Reg steady[] = {{"sin", of_one<[](double x) { return std::sin(x); }>},
                               {"cos", of_one<[](double x) { return std::cos(x); }>},
                               {"tan", of_one<[](double x) { return std::tan(x); }>},
                               {"asin", of_one<[](double x) { return std::asin(x); }>},
                               {"acos", of_one<[](double x) { return std::acos(x); }>},
                               {"exp", of_one<[](double x) { return std::exp(x); }>},
                               {"ln", of_one<[](double x) { return std::log(x); }>},
                               {"atan", arc_tangent},
                               {"log", logarithm},
                               {nullptr, nullptr}};

constexpr double longest_text = 1'000'000;
int repeat(lua_State* l) {
  std::size_t size = 0, between = 0;
  luaL_checklstring(l, 1, &size);
  luaL_optlstring(l, 3, "", &between);
  const double times = std::max(0.0, luaL_checknumber(l, 2));
  if (times * static_cast<double>(size + between) > longest_text)
    return luaL_error(l, "rep: a text of more than 1000000 characters");
  charge(l, times / (size + between > 0 ? 256 : 16));  // an empty text may be repeated very often
  return charged<Charge::text>(l);
}

int no_writing(lua_State* l) {
  if (lua_type(l, 2) != LUA_TSTRING) return luaL_error(l, "this table cannot be written");
  return luaL_error(l, "'%s' would be a global, but globals are not kept: use local %s", lua_tostring(l, 2),
                    lua_tostring(l, 2));
}
int no_library_writing(lua_State* l) { return luaL_error(l, "a library cannot be written"); }

// --- guarded functions (see machine.h) ---

int to_text(lua_State* l, Machine&) {
  const std::string s = written(l, 1);
  return lua_pushlstring(l, s.data(), s.size()), 1;
}

// Checks the arguments of string.format. Forbids %p, and writes tables and functions without their addresses.
int format_arguments(lua_State* l, Machine&) {
  const char* f = lua_tostring(l, 1);
  if (!f) return fail_with(l, "format: the first argument must be a text");
  for (; *f; ++f)
    if (*f == '%') {
      for (++f; *f && !std::isalpha(static_cast<unsigned char>(*f)) && *f != '%';) ++f;
      if (*f == 'p') return fail_with(l, "format: there is no %p");
      if (!*f) break;
    }
  for (int i = 2; i <= lua_gettop(l); ++i)
    if (lua_type(l, i) == LUA_TTABLE || lua_type(l, i) == LUA_TFUNCTION) {
      const std::string s = written(l, i);
      lua_pushlstring(l, s.data(), s.size());
      lua_replace(l, i);
    }
  return lua_gettop(l);
}
int format(lua_State* l) {
  guarded<format_arguments>(l);
  std::size_t size = 0;
  const char* const f = lua_tolstring(l, 1, &size);
  charge(l, 32.0 * static_cast<double>(std::count(f, f + size, '%')));  // a number may have 400 digits
  return charged<Charge::text>(l);
}

// Returns the next key of the sorted list (upvalue 1) whose value is not nil.
int next_pair(lua_State* l) {
  for (;;) {
    const lua_Integer i = lua_tointeger(l, lua_upvalueindex(2)) + 1;
    lua_pushinteger(l, i);
    lua_replace(l, lua_upvalueindex(2));
    lua_settop(l, 1);
    if (lua_rawgeti(l, lua_upvalueindex(1), i) == LUA_TNIL) return 1;
    lua_pushvalue(l, -1);
    if (lua_rawget(l, 1) != LUA_TNIL) return 2;
  }
}

// Pushes the list of a table's keys, unsorted, after the table.
int keys_of(lua_State* l, Machine&) {
  if (lua_type(l, 1) != LUA_TTABLE) return fail_with(l, "pairs: a table is needed");
  lua_settop(l, 1);
  lua_newtable(l);
  lua_Integer count = 0;
  lua_pushnil(l);
  while (lua_next(l, 1)) {
    lua_pop(l, 1);
    const int type = lua_type(l, -1);
    if (type != LUA_TNUMBER && type != LUA_TSTRING) return fail_with(l, "pairs: the keys must be numbers or texts");
    lua_pushvalue(l, -1);
    lua_rawseti(l, 2, ++count);
  }
  return 2;
}

int sorted_pairs(lua_State* l, Machine&) {
  std::vector<lua_Integer> order(lua_rawlen(l, 2));
  std::iota(order.begin(), order.end(), 1);
  std::sort(order.begin(), order.end(), [l](lua_Integer a, lua_Integer b) {
    const int type_a = lua_rawgeti(l, 2, a), type_b = lua_rawgeti(l, 2, b);
    const bool less = type_a != type_b ? type_a == LUA_TNUMBER : lua_compare(l, -2, -1, LUA_OPLT) != 0;
    lua_pop(l, 2);
    return less;
  });
  lua_createtable(l, static_cast<int>(order.size()), 0);
  for (std::size_t i = 0; i < order.size(); ++i) {
    lua_rawgeti(l, 2, order[i]);
    lua_rawseti(l, 3, static_cast<lua_Integer>(i) + 1);
  }
  lua_pushinteger(l, 0);
  lua_pushcclosure(l, next_pair, 2);
  lua_pushvalue(l, 1);
  return 2;
}
int pairs(lua_State* l) {
  const Machine& m = Machine::of(l);
  charge(l, static_cast<double>(m.made() / 512));  // a table may have many empty slots
  guarded<keys_of>(l);
  charge(l, sorting(l, static_cast<double>(lua_rawlen(l, 2))));
  return guarded<sorted_pairs>(l);
}

// --- assembly ---

// Replaces the table on top by a read-only proxy.
void protect(lua_State* l, lua_CFunction writing) {
  lua_newtable(l);
  lua_createtable(l, 0, 2);
  lua_rotate(l, -3, -1);
  lua_setfield(l, -2, "__index");
  lua_pushcfunction(l, writing);
  lua_setfield(l, -2, "__newindex");
  lua_setmetatable(l, -2);
}

// Copies functions of the library that `open` opens into the table on top, wrapped by `through` if given.
void copy(lua_State* l, lua_CFunction open, std::initializer_list<const char*> names, lua_CFunction through = nullptr) {
  lua_pushcfunction(l, open);
  lua_call(l, 0, 1);
  for (const char* name : names) {
    if (lua_getfield(l, -1, name) == LUA_TFUNCTION && through) lua_pushcclosure(l, through, 1);
    lua_setfield(l, -3, name);
  }
  lua_pop(l, 1);
}
// Wraps the function `name` of the table on top.
void wrap(lua_State* l, const char* name, lua_CFunction through) {
  lua_getfield(l, -1, name);
  lua_pushcclosure(l, through, 1);
  lua_setfield(l, -2, name);
}

// couple("hand") and the like: an attachment, as in a row.
template <int how>
int holding(lua_State* l) {
  static constexpr const char* words[] = {"hang on %s", "attach to %s", "couple to %s"};
  return lua_pushfstring(l, words[how], luaL_checkstring(l, 1)), 1;
}

constexpr luaL_Reg own[] = {{"tostring", guarded<to_text>}, {"pairs", pairs},       {"hang", holding<0>},
                            {"attach", holding<1>},         {"couple", holding<2>}, {nullptr, nullptr}};

}  // namespace

void open_library(lua_State* l, Machine& m) {
  const auto of_math = {"abs", "ceil", "floor", "fmod", "modf", "sqrt", "deg", "rad", "ult", "tointeger", "huge", "pi"};
  constexpr luaL_Reg extremes[] = {{"min", extreme<true>}, {"max", extreme<false>}, {nullptr, nullptr}};
  lua_newtable(l);  // the library
  copy(l, luaopen_base, {"assert", "error", "ipairs", "select", "type", "rawequal", "rawlen"});
  copy(l, luaopen_base, {"tonumber"}, charged<Charge::text>);
  copy(l, luaopen_math, of_math);
  luaL_setfuncs(l, steady, 0);
  luaL_setfuncs(l, extremes, 0);
  luaL_setfuncs(l, own, 0);
  luaL_setfuncs(l, query_functions, 0);
  luaL_setfuncs(l, arithmetic_functions, 0);
  lua_pushnumber(l, 2 * pi);
  lua_setfield(l, -2, "tau");

  lua_newtable(l);
  copy(l, luaopen_math, of_math);
  luaL_setfuncs(l, steady, 0);
  luaL_setfuncs(l, extremes, 0);
  copy(l, luaopen_math, {"type", "maxinteger", "mininteger"});
  protect(l, no_library_writing);
  lua_setfield(l, -2, "math");

  lua_newtable(l);
  copy(l, luaopen_table, {"concat", "unpack"}, charged<Charge::range>);
  copy(l, luaopen_table, {"insert", "remove", "pack"}, charged<Charge::list>);
  copy(l, luaopen_table, {"move"}, charged<Charge::move>);
  copy(l, luaopen_table, {"sort"}, charged<Charge::sort>);
  protect(l, no_library_writing);
  lua_setfield(l, -2, "table");

  lua_newtable(l);
  copy(l, luaopen_string, {"byte", "char", "len", "lower", "reverse", "sub", "upper"}, charged<Charge::text>);
  copy(l, luaopen_string, {"rep", "format"});
  wrap(l, "rep", repeat);
  wrap(l, "format", format);
  protect(l, no_library_writing);
  lua_pushliteral(l, "");  // makes them methods of texts
  lua_getmetatable(l, -1);
  lua_pushvalue(l, -3);
  lua_setfield(l, -2, "__index");
  lua_pop(l, 2);
  lua_setfield(l, -2, "string");

  const auto table = [l](const char* name, const luaL_Reg* functions) {
    lua_newtable(l);
    luaL_setfuncs(l, functions, 0);
    protect(l, no_library_writing);
    lua_setfield(l, -2, name);
  };
  table("axes", axes_functions);
  table("plot", plot_functions);
  table("chart", chart_functions);
  table("block", code_functions);
  table("link", link_functions);
  table("mark", mark_functions);

  // The order of lookup: the globals of this call, the library, the procedures.
  lua_createtable(l, 0, 1);
  lua_pushcfunction(l, find_global);
  lua_setfield(l, -2, "__index");
  lua_setmetatable(l, -2);
  lua_newtable(l);
  lua_createtable(l, 0, 1);
  lua_rotate(l, -3, -1);
  lua_setfield(l, -2, "__index");
  lua_setmetatable(l, -2);
  lua_pushvalue(l, -1);
  m.now = luaL_ref(l, LUA_REGISTRYINDEX);
  protect(l, no_writing);
  lua_rawseti(l, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
}

}  // namespace betwixt::lua
