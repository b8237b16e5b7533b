// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/utf8.h"
#include "betwixt/program.h"
#include "procedure/machine.h"
#include "track/types.h"

namespace betwixt::lua {
namespace {

struct Shape {
  const char* name;
  const char* article;
  int count;
  const char* fields[4];
  Value (*example)();
};
template <class T>
Value plain() {
  return T{};
}
constexpr Shape shapes[kinds] = {{"", "", 0, {}, plain<double>},
                                 {"vec", "a vector", 3, {"x", "y", "z"}, plain<Vec3>},
                                 {"rgb", "a color", 3, {"r", "g", "b"}, plain<Color>},
                                 {"euler", "angles", 3, {"x", "y", "z"}, plain<Angles>},
                                 {"quat", "a quaternion", 4, {"w", "x", "y", "z"}, plain<Quat>},
                                 {"matrix", "a matrix", 16, {}, plain<Matrix>}};
const Shape& shape(Kind k) { return shapes[static_cast<int>(k)]; }

Quat quat_of(const double* n) { return {n[0], n[1], n[2], n[3]}; }

const char* article(lua_State* l, int index, Kind k) {
  if (k != Kind::none) return shape(k).article;
  switch (lua_type(l, index)) {
    case LUA_TNIL:
      return "nothing";
    case LUA_TBOOLEAN:
      return "true or false";
    case LUA_TNUMBER:
      return "a number";
    case LUA_TSTRING:
      return "a text";
    case LUA_TTABLE:
      return "a list";
    default:
      return "a function";
  }
}

// Uses no C++ strings, because Lua's error would skip their destructors.
int no_arithmetic(lua_State* l, char op, Kind ka, Kind kb) {
  const char *const a = article(l, 1, ka), *const b = article(l, 2, kb);
  const char* const hint =
      ka == Kind::matrix || kb == Kind::matrix ? "; its .x, .y and .z are numbers, as in value('a.world.x')" : "";
  if (op == '+') return luaL_error(l, "%s and %s cannot be added%s", a, b, hint);
  if (op == '-') return luaL_error(l, "%s cannot be subtracted from %s%s", b, a, hint);
  if (op == '*') return luaL_error(l, "%s and %s cannot be multiplied%s", a, b, hint);
  return luaL_error(l, "%s cannot be divided by %s%s", a, b, hint);
}

// a op b, component by component; a number applies to each. Quaternions multiply as successive rotations, and rotate
// vectors.
template <char op>
int arithmetic(lua_State* l) {
  double a[16], b[16], out[4];
  Kind ka = read(l, 1, a), kb = read(l, 2, b);
  const bool number_a = lua_type(l, 1) == LUA_TNUMBER, number_b = lua_type(l, 2) == LUA_TNUMBER;
  if constexpr (op == '*') {
    if (ka == Kind::quat && kb == Kind::quat) {
      const Quat q = quat_of(a) * quat_of(b);
      const double n[] = {q.w, q.x, q.y, q.z};
      return push(l, Kind::quat, n), 1;
    }
    if (ka == Kind::quat && kb == Kind::vector) {
      const Vec3 v = transform_vector(rotation(quat_of(a)), {b[0], b[1], b[2]});
      const double n[] = {v.x, v.y, v.z};
      return push(l, Kind::vector, n), 1;
    }
  }
  if constexpr (op == '*') {  // matrices apply from right to left
    if (ka == Kind::matrix && kb == Kind::matrix) return push(l, matrix_of(a) * matrix_of(b)), 1;
    if (ka == Kind::matrix && kb == Kind::vector) {
      const Vec3 v = transform_point(matrix_of(a), {b[0], b[1], b[2]});
      const double n[] = {v.x, v.y, v.z};
      return push(l, Kind::vector, n), 1;
    }
  }
  constexpr bool scales = op == '*' || op == '/';
  const Kind kind = ka != Kind::none ? ka : kb;
  const bool fits = (ka == kb && kind != Kind::quat) || (ka == kb && !scales) ||
                    (scales && kb == Kind::none && number_b) || (op == '*' && ka == Kind::none && number_a);
  if (!fits || kind == Kind::matrix) return no_arithmetic(l, op, ka, kb);
  if (ka == Kind::none) std::fill(a, a + 4, lua_tonumber(l, 1));
  if (kb == Kind::none) std::fill(b, b + 4, lua_tonumber(l, 2));
  for (int i = 0; i < shape(kind).count; ++i)
    out[i] = op == '+' ? a[i] + b[i] : op == '-' ? a[i] - b[i] : op == '*' ? a[i] * b[i] : a[i] / b[i];
  return push(l, kind, out), 1;
}

int negative(lua_State* l) {
  double a[16];
  const Kind kind = read(l, 1, a);
  if (kind == Kind::matrix || kind == Kind::none)
    return luaL_error(l, "%s cannot be negated, but its .x, .y and .z can", article(l, 1, kind));
  for (int i = 0; i < shape(kind).count; ++i) a[i] = -a[i];
  return push(l, kind, a), 1;
}

int equal(lua_State* l) {
  double a[16], b[16];
  const Kind ka = read(l, 1, a), kb = read(l, 2, b);
  lua_pushboolean(l, ka == kb && ka != Kind::none && std::equal(a, a + shape(ka).count, b));
  return 1;
}

bool push_list(lua_State* l, std::size_t count, auto&& one) {
  lua_createtable(l, static_cast<int>(count), 0);
  for (std::size_t i = 0; i < count; ++i) {
    push(l, one(i));
    lua_rawseti(l, -2, static_cast<lua_Integer>(i) + 1);
  }
  return true;
}

Error no_value(std::string what) { return fail(ErrorCode::type, std::move(what)); }

// Reads a list of vectors or of texts.
Result<Value> list_value(lua_State* l, int index) {
  const auto count = lua_rawlen(l, index);
  std::vector<Vec3> points;
  std::vector<std::string> names;
  for (lua_Unsigned i = 1; i <= count; ++i) {
    lua_rawgeti(l, index, static_cast<lua_Integer>(i));
    double n[16];
    const Kind kind = lua_type(l, -1) == LUA_TTABLE ? read(l, -1, n) : Kind::none;
    if (kind == Kind::vector && (finite({n, 3}) || n[0] == HUGE_VAL)) {  // vec(huge, …) lifts the pen
      points.push_back(n[0] == HUGE_VAL ? Vec3{HUGE_VAL, HUGE_VAL, HUGE_VAL} : Vec3{n[0], n[1], n[2]});
      lua_pop(l, 1);
      continue;
    }
    const bool simple = lua_type(l, -1) != LUA_TTABLE || kind != Kind::none;  // lists cannot be nested
    auto one = simple ? to_value(l, lua_gettop(l)) : Result<Value>(Value(0.0));
    lua_pop(l, 1);
    if (!one) return one;
    if (const auto* v = std::get_if<Vec3>(&*one)) points.push_back(*v);
    if (const auto* t = std::get_if<Text>(&*one)) names.push_back(**t);
  }
  if (points.size() == count) return Value(Points(std::move(points)));
  if (count > 0 && names.size() == count) return Value(Names(std::move(names)));
  return no_value("a list must contain only vectors or only texts");
}

}  // namespace

Mat4 matrix_of(const double* n) {
  Mat4 m;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) m(row, column) = n[4 * row + column];
  return m;
}
void push(lua_State* l, const Mat4& m) {
  double n[16];
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) n[4 * row + column] = m(row, column);
  push(l, Kind::matrix, n);
}

Kind read(lua_State* l, int index, double* numbers) {
  if (lua_type(l, index) != LUA_TTABLE || !lua_getmetatable(l, index)) return Kind::none;
  lua_rawgeti(l, -1, 1);
  const auto kind = static_cast<Kind>(lua_tointeger(l, -1));
  lua_pop(l, 2);
  index = lua_absindex(l, index);
  for (int i = 0; i < shape(kind).count; ++i) {
    if (kind == Kind::matrix) {
      lua_rawgeti(l, index, i + 1);
    } else {
      lua_pushstring(l, shape(kind).fields[i]);
      lua_rawget(l, index);
    }
    numbers[i] = lua_type(l, -1) == LUA_TNUMBER ? lua_tonumber(l, -1) : std::nan("");
    lua_pop(l, 1);
  }
  return kind;
}

// Larger whole numbers stay doubles, because Lua's integer products wrap around.
void push_number(lua_State* l, double d) {
  constexpr double most = 2147483648;
  if (std::abs(d) <= most && d == std::floor(d) && !(d == 0 && std::signbit(d)))
    lua_pushinteger(l, static_cast<lua_Integer>(d));
  else
    lua_pushnumber(l, d);
}

void push(lua_State* l, Kind kind, const double* numbers) {
  const Shape& s = shape(kind);
  const bool matrix = kind == Kind::matrix;
  lua_createtable(l, matrix ? 16 : 0, matrix ? 3 : s.count);
  for (int i = 0; i < s.count; ++i) {
    push_number(l, numbers[i]);
    if (matrix)
      lua_rawseti(l, -2, i + 1);
    else
      lua_setfield(l, -2, s.fields[i]);
  }
  for (int i = 0; matrix && i < 3; ++i) {
    push_number(l, numbers[4 * i + 3]);
    lua_setfield(l, -2, shape(Kind::vector).fields[i]);
  }
  lua_rawgeti(l, LUA_REGISTRYINDEX, Machine::of(l).metatable[static_cast<int>(kind)]);
  lua_setmetatable(l, -2);
}

bool push(lua_State* l, const Value& v) {
  const auto push_text = [l](const std::string& t) { return lua_pushlstring(l, t.data(), t.size()), true; };
  if (const auto* d = std::get_if<double>(&v)) return push_number(l, *d), true;
  if (const auto* b = std::get_if<bool>(&v)) return lua_pushboolean(l, *b), true;
  if (const auto* t = std::get_if<Text>(&v)) return push_text(**t);
  if (const auto* m = std::get_if<Moves>(&v)) return push_text(to_string(**m));
  if (const auto* p = std::get_if<Points>(&v))
    return push_list(l, (*p)->size(), [&](std::size_t i) { return (**p)[i]; });
  if (const auto* n = std::get_if<Names>(&v))
    return push_list(l, (*n)->size(), [&](std::size_t i) { return Text((**n)[i]); });
  for (int k = 1; k < kinds; ++k)
    if (v.index() == shapes[k].example().index()) return push(l, static_cast<Kind>(k), numbers(v).data()), true;
  return false;
}

Result<Value> to_value(lua_State* l, int index) {
  double n[16];
  switch (lua_type(l, index)) {
    case LUA_TNIL:
    case LUA_TNONE:
      return no_value("it returned no value");
    case LUA_TBOOLEAN:
      return Value(lua_toboolean(l, index) != 0);
    case LUA_TNUMBER: {
      const double d = lua_tonumber(l, index);
      if (!std::isfinite(d)) return fail(ErrorCode::range, "it returned a number that is not finite");
      return Value(d);
    }
    case LUA_TSTRING: {
      std::size_t size = 0;
      const char* text = lua_tolstring(l, index, &size);
      return Value(Text(clean_text({text, size})));
    }
    case LUA_TTABLE:
      break;
    default:
      return no_value(std::string("a ") + luaL_typename(l, index) + " is not a value");
  }
  const Kind kind = read(l, index, n);
  if (kind == Kind::none) return list_value(l, lua_absindex(l, index));
  if (!finite({n, static_cast<std::size_t>(shape(kind).count)}))
    return fail(ErrorCode::range,
                std::string("it returned ") + shape(kind).article + " with a number that is not finite");
  if (kind == Kind::matrix) {
    const Mat4 m = matrix_of(n);
    const bool affine = n[12] == 0 && n[13] == 0 && n[14] == 0 && n[15] == 1;
    return affine ? Result<Value>(Matrix(m)) : no_value("the last row of its matrix is not 0 0 0 1");
  }
  Value v = with_numbers(shape(kind).example(), n);
  if (auto* q = std::get_if<Quat>(&v)) *q = normalize(*q);
  return v;
}

std::string written(lua_State* l, int index) {
  if (lua_type(l, index) == LUA_TBOOLEAN) return lua_toboolean(l, index) ? "true" : "false";
  if (lua_type(l, index) == LUA_TSTRING || lua_type(l, index) == LUA_TNUMBER) {
    lua_pushvalue(l, index);  // on a copy, because a number would become a text in place
    std::size_t size = 0;
    const char* text = lua_tolstring(l, -1, &size);
    std::string out(text, size);
    lua_pop(l, 1);
    return out;
  }
  double n[16];
  const Kind kind = read(l, index, n);
  if (kind == Kind::none) return luaL_typename(l, index);
  std::string out = shape(kind).name;
  for (int i = 0; i < shape(kind).count; ++i) {
    char number[32];
    std::snprintf(number, sizeof number, "%s%.14g", i ? ", " : "(", n[i]);
    out += number;
  }
  return out + ")";
}

void make_kinds(lua_State* l, Machine& m) {
  static constexpr luaL_Reg methods[] = {{"__add", arithmetic<'+'>}, {"__sub", arithmetic<'-'>},
                                         {"__mul", arithmetic<'*'>}, {"__div", arithmetic<'/'>},
                                         {"__unm", negative},        {"__eq", equal},
                                         {nullptr, nullptr}};
  for (int k = 1; k < kinds; ++k) {
    luaL_newlib(l, methods);
    lua_pushinteger(l, k);
    lua_rawseti(l, -2, 1);
    m.metatable[k] = luaL_ref(l, LUA_REGISTRYINDEX);
  }
}

}  // namespace betwixt::lua
