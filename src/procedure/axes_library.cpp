// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "procedure/axes_library.h"

#include "procedure/coordinates.h"
#include "procedure/machine.h"

namespace betwixt::lua {
namespace {

// A function of axes: their name is the first argument.
using OfAxes = int (*)(lua_State*, const AxesSpace&);
template <OfAxes body>
int found(lua_State* l, Machine& m) {
  AxesSpace space;
  const auto why = find_axes(l, m, space);
  return why.empty() ? body(l, space) : fail_with(l, "axes: " + why);
}
template <OfAxes body>
int asked(lua_State* l) {
  charge(l, 60);
  const int results = guarded<found<body>>(l);
  if (results > 0 && lua_type(l, -1) == LUA_TTABLE) charge(l, static_cast<double>(lua_rawlen(l, -1)));
  return results;
}

int place_on_axes(lua_State* l, const AxesSpace& s) {
  double n[16];
  if (read(l, 2, n) != Kind::vector) return fail_with(l, "axes.place: the second argument must be a vector of numbers");
  return push_place(l, s.place({n[0], n[1], n[2]})), 1;
}

int numbers_on_axes(lua_State* l, const AxesSpace& s) {
  double n[16];
  if (read(l, 2, n) != Kind::vector) return fail_with(l, "axes.numbers: the second argument must be a place, a vector");
  const auto p = s.numbers_at({n[0], n[1], n[2]});
  if (!p) return fail_with(l, "axes.numbers: these axes have no length");
  return push_place(l, *p), 1;
}

// A function of one axis, which the second argument names.
using OfAxis = int (*)(lua_State*, const AxesSpace&, char axis);
template <OfAxis body>
int of_axis(lua_State* l, const AxesSpace& s) {
  const std::string_view word = lua_type(l, 2) == LUA_TSTRING ? lua_tostring(l, 2) : "";
  if (word != "x" && word != "y" && word != "z")
    return fail_with(l, "axes: the second argument must be 'x', 'y' or 'z'");
  return body(l, s, word[0]);
}

int ticks_on_axes(lua_State* l, const AxesSpace& s, char axis) {
  const Ticks ticks = ticks_of(s, axis);
  lua_createtable(l, static_cast<int>(ticks.numbers.size()), 0);
  for (std::size_t i = 0; i < ticks.numbers.size(); ++i) {
    push_number(l, ticks.numbers[i]);
    lua_rawseti(l, -2, static_cast<lua_Integer>(i + 1));
  }
  return 1;
}
int line_of_axes(lua_State* l, const AxesSpace& s, char axis) { return push_points(l, axis_line(s, axis)), 1; }
int tip_of_axes(lua_State* l, const AxesSpace& s, char axis) { return push_place(l, axis_tip(s, axis)), 1; }
int grid_of_axes(lua_State* l, const AxesSpace& s) { return push_points(l, grid_lines(s)), 1; }

// A label that is shown, by its number among those of an axis: the third argument. Without text if there are fewer.
struct Label {
  double number = 0;
  std::string text;
};
Label label_at(lua_State* l, const AxesSpace& s, char axis) {
  const Ticks ticks = ticks_of(s, axis);
  double left = lua_tonumber(l, 3);
  for (std::size_t i = 0; i < ticks.labels.size(); ++i)
    if (!ticks.labels[i].empty() && --left < 0.5) return {ticks.numbers[i], ticks.labels[i]};
  return {};
}
int label_of_axes(lua_State* l, const AxesSpace& s, char axis) {
  const Label label = label_at(l, s, axis);
  return lua_pushlstring(l, label.text.data(), label.text.size()), 1;
}
int label_place_of_axes(lua_State* l, const AxesSpace& s, char axis) {
  const Label label = label_at(l, s, axis);
  return push_place(l, label.text.empty() ? Vec3{} : label_place(s, axis, label.number)), 1;
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

std::optional<Value> value_now(Machine& m, const std::string& target) {
  auto found = m.call->questions->value(target, m.call->seconds, m.call->steps);
  return found ? std::optional(*std::move(found)) : std::nullopt;
}
double number_now(Machine& m, const std::string& target) {
  const auto v = value_now(m, target);
  const auto* d = v ? std::get_if<double>(&*v) : nullptr;
  const auto* b = v ? std::get_if<bool>(&*v) : nullptr;
  return d ? *d : b && *b ? 1 : 0;
}
std::string text_now(Machine& m, const std::string& target) {
  const auto v = value_now(m, target);
  const auto* text = v ? std::get_if<Text>(&*v) : nullptr;
  return text ? std::string(**text) : std::string();
}

void push_place(lua_State* l, Vec3 p) {
  const double n[] = {p.x, p.y, p.z};
  push(l, Kind::vector, n);
}
void push_points(lua_State* l, const std::vector<Vec3>& points) {
  lua_createtable(l, static_cast<int>(points.size()), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    push_place(l, points[i]);
    lua_rawseti(l, -2, static_cast<lua_Integer>(i + 1));
  }
}

const luaL_Reg axes_functions[] = {{"place", asked<place_on_axes>},
                                   {"numbers", asked<numbers_on_axes>},
                                   {"ticks", asked<of_axis<ticks_on_axes>>},
                                   {"line", asked<of_axis<line_of_axes>>},
                                   {"grid", asked<grid_of_axes>},
                                   {"tip", asked<of_axis<tip_of_axes>>},
                                   {"label", asked<of_axis<label_of_axes>>},
                                   {"label_place", asked<of_axis<label_place_of_axes>>},
                                   {nullptr, nullptr}};

}  // namespace betwixt::lua
