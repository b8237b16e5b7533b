// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "procedure/axes_library.h"

#include "procedure/coordinates.h"
#include "procedure/machine.h"

namespace betwixt::lua {
namespace {

template <int (*body)(lua_State*, Machine&)>
int asked(lua_State* l) {
  charge(l, 60);
  const int results = guarded<body>(l);
  if (results > 0 && lua_type(l, -1) == LUA_TTABLE) charge(l, static_cast<double>(lua_rawlen(l, -1)));
  return results;
}

// Reads the axis that an argument names.
bool axis_at(lua_State* l, int i, char& out) {
  const char* word = lua_type(l, i) == LUA_TSTRING ? lua_tostring(l, i) : "";
  out = word[0];
  return (out == 'x' || out == 'y' || out == 'z' || out == 'r') && word[1] == 0;
}

int place_on_axes(lua_State* l, Machine& m) {
  AxesSpace s;
  double n[16];
  if (const auto why = find_axes(l, m, s); !why.empty()) return fail_with(l, "axes.place: " + why);
  if (read(l, 2, n) != Kind::vector) return fail_with(l, "axes.place: the second argument must be a vector of numbers");
  const Vec3 p = s.place({n[0], n[1], n[2]});
  const double out[] = {p.x, p.y, p.z};
  return push(l, Kind::vector, out), 1;
}

int numbers_on_axes(lua_State* l, Machine& m) {
  AxesSpace s;
  double n[16];
  if (const auto why = find_axes(l, m, s); !why.empty()) return fail_with(l, "axes.numbers: " + why);
  if (read(l, 2, n) != Kind::vector) return fail_with(l, "axes.numbers: the second argument must be a place, a vector");
  const auto p = s.numbers_at({n[0], n[1], n[2]});
  if (!p) return fail_with(l, "axes.numbers: these axes have no length");
  const double out[] = {p->x, p->y, p->z};
  return push(l, Kind::vector, out), 1;
}

int ticks_on_axes(lua_State* l, Machine& m) {
  AxesSpace s;
  char axis = 0;
  if (const auto why = find_axes(l, m, s); !why.empty()) return fail_with(l, "axes.ticks: " + why);
  if (!axis_at(l, 2, axis)) return fail_with(l, "axes.ticks: the second argument must be 'x', 'y' or 'z'");
  const Ticks ticks = ticks_of(s, axis);
  lua_createtable(l, static_cast<int>(ticks.numbers.size()), 0);
  for (std::size_t i = 0; i < ticks.numbers.size(); ++i) {
    push_number(l, ticks.numbers[i]);
    lua_rawseti(l, -2, static_cast<lua_Integer>(i + 1));
  }
  return 1;
}

int line_of_axes(lua_State* l, Machine& m) {
  AxesSpace s;
  char axis = 0;
  if (const auto why = find_axes(l, m, s); !why.empty()) return fail_with(l, "axes.line: " + why);
  if (!axis_at(l, 2, axis)) return fail_with(l, "axes.line: the second argument must be 'x', 'y' or 'z'");
  return push_points(l, axis_line(s, axis)), 1;
}

int tip_of_axes(lua_State* l, Machine& m) {
  AxesSpace s;
  char axis = 0;
  if (const auto why = find_axes(l, m, s); !why.empty()) return fail_with(l, "axes.tip: " + why);
  if (!axis_at(l, 2, axis)) return fail_with(l, "axes.tip: the second argument must be 'x', 'y' or 'z'");
  const Vec3 p = axis_tip(s, axis);
  const double out[] = {p.x, p.y, p.z};
  return push(l, Kind::vector, out), 1;
}

int grid_of_axes(lua_State* l, Machine& m) {
  AxesSpace s;
  if (const auto why = find_axes(l, m, s); !why.empty()) return fail_with(l, "axes.grid: " + why);
  return push_points(l, grid_lines(s)), 1;
}

// The labels of an axis that are not empty, in order.
struct Label {
  double number = 0;
  std::string text;
};
bool label_at(lua_State* l, const AxesSpace& s, Label& out, char& axis) {
  if (!axis_at(l, 2, axis) || lua_type(l, 3) != LUA_TNUMBER) return false;
  const Ticks ticks = ticks_of(s, axis);
  double left = lua_tonumber(l, 3);
  for (std::size_t i = 0; i < ticks.labels.size(); ++i)
    if (!ticks.labels[i].empty() && --left < 0.5) {
      out = {ticks.numbers[i], ticks.labels[i]};
      return true;
    }
  return true;
}
int label_of_axes(lua_State* l, Machine& m) {
  AxesSpace s;
  Label label;
  char axis = 0;
  if (const auto why = find_axes(l, m, s); !why.empty()) return fail_with(l, "axes.label: " + why);
  if (!label_at(l, s, label, axis)) return fail_with(l, "axes.label: write axes.label(NAME, 'x', number of the label)");
  return lua_pushlstring(l, label.text.data(), label.text.size()), 1;
}
int label_place_of_axes(lua_State* l, Machine& m) {
  AxesSpace s;
  Label label;
  char axis = 0;
  if (const auto why = find_axes(l, m, s); !why.empty()) return fail_with(l, "axes.label_place: " + why);
  if (!label_at(l, s, label, axis))
    return fail_with(l, "axes.label_place: write axes.label_place(NAME, 'x', number of the label)");
  const Vec3 p = label.text.empty() ? Vec3{} : label_place(s, axis, label.number);
  const double out[] = {p.x, p.y, p.z};
  return push(l, Kind::vector, out), 1;
}

}  // namespace

std::string find_axes(lua_State* l, Machine& m, AxesSpace& out) {
  if (lua_type(l, 1) != LUA_TSTRING) return "the first argument must be the name of axes, in quotes";
  return find_axes(m, lua_tostring(l, 1), out);
}
std::string find_axes(Machine& m, std::string_view name, AxesSpace& out) {
  if (!m.call->questions) return "only code that computes a value can use it";
  const Status found = m.call->questions->axes(name, m.call->seconds, out, m.call->steps);
  return found ? "" : found.error().message;
}

void push_points(lua_State* l, const std::vector<Vec3>& points) {
  lua_createtable(l, static_cast<int>(points.size()), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double n[] = {points[i].x, points[i].y, points[i].z};
    push(l, Kind::vector, n);
    lua_rawseti(l, -2, static_cast<lua_Integer>(i + 1));
  }
}

const luaL_Reg axes_functions[] = {{"place", asked<place_on_axes>},
                                   {"numbers", asked<numbers_on_axes>},
                                   {"ticks", asked<ticks_on_axes>},
                                   {"line", asked<line_of_axes>},
                                   {"grid", asked<grid_of_axes>},
                                   {"tip", asked<tip_of_axes>},
                                   {"label", asked<label_of_axes>},
                                   {"label_place", asked<label_place_of_axes>},
                                   {nullptr, nullptr}};

}  // namespace betwixt::lua
