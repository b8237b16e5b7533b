// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The table `chart` of code: where the parts of a chart are, by the values of all of them.
#include <algorithm>
#include <cmath>

#include "procedure/axes_library.h"
#include "procedure/coordinates.h"

namespace betwixt::lua {
namespace {

struct Chart {
  std::vector<double> values;
  double low = 0, high = 1;
  Vec3 size;
  double gap = 0;
  bool sorted = false, up = true;
  std::size_t one = 0;  // the part that is asked for

  double share(double v) const {
    return high != low ? (std::clamp(v, std::min(low, high), std::max(low, high)) - low) / (high - low) : 0;
  }
  double base() const { return low > 0 ? low : high < 0 ? high : 0; }
  double rank() const {
    if (!sorted) return static_cast<double>(one);
    double above = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
      above += values[i] > values[one] || (values[i] == values[one] && i < one) ? 1 : 0;
    return above;
  }
};

// Reads the values of the chart that the first argument names. Returns why not, or "".
std::string read_values(lua_State* l, Machine& m, Chart& out) {
  if (lua_type(l, 1) != LUA_TSTRING) return "the first argument must be the name of a chart, in quotes";
  if (!lua_isnumber(l, 2)) return "the second argument must be the number of a part";
  if (!m.call->questions) return "only code that computes a value can use it";
  const std::string name = lua_tostring(l, 1);
  const auto parts = value_now(m, name + ".parts");
  const auto* names = parts ? std::get_if<Names>(&*parts) : nullptr;
  const double one = lua_tonumber(l, 2);
  if (!names) return "there is no chart '" + name + "'";
  if (!(one >= 1 && one <= static_cast<double>((*names)->size()))) return "there is no part of that number";
  out.one = static_cast<std::size_t>(one) - 1;
  for (const std::string& part : **names) out.values.push_back(number_now(m, part + ".value"));
  return "";
}

std::string read_chart(lua_State* l, Machine& m, Chart& out) {
  if (auto why = read_values(l, m, out); !why.empty()) return why;
  const std::string name = lua_tostring(l, 1);
  const auto size = value_now(m, name + ".size"), range = value_now(m, name + ".range");
  if (!size || !range) return "it is no chart of bars";
  out.size = std::get<Vec3>(*size);
  out.gap = number_now(m, name + ".gap"), out.sorted = number_now(m, name + ".sorted") != 0;
  const Vec3 ends = std::get<Vec3>(*range);
  out.low = ends.x, out.high = ends.y;
  if (ends.x == ends.y) {
    out.low = out.high = 0;
    for (const double v : out.values) out.low = std::min(out.low, v), out.high = std::max(out.high, v);
  }
  out.up = number_now(m, ".upwards") != 0;
  return "";
}

int push_pair(lua_State* l, double x, double y) { return push_place(l, {x, y, 0}), 1; }

int extent_of(lua_State* l, Machine& m) {
  Chart c;
  if (auto why = read_chart(l, m, c); !why.empty()) return fail_with(l, "chart.extent: " + why);
  const double grows = c.share(c.values[c.one]) - c.share(c.base());
  const double room = (c.up ? c.size.x : c.size.y) / static_cast<double>(c.values.size()) * (1 - c.gap);
  return c.up ? push_pair(l, room, grows * c.size.y) : push_pair(l, grows * c.size.x, room);
}

int place_in_chart(lua_State* l, Machine& m) {
  Chart c;
  if (auto why = read_chart(l, m, c); !why.empty()) return fail_with(l, "chart.place: " + why);
  const double at = (c.rank() + 0.5) / static_cast<double>(c.values.size()), base = c.share(c.base()) - 0.5;
  return c.up ? push_pair(l, (at - 0.5) * c.size.x, base * c.size.y)
              : push_pair(l, base * c.size.x, (0.5 - at) * c.size.y);
}

// chart.slice(PIE, NUMBER, SHARE): the angle at a share of a slice; the first begins at the top, they go clockwise.
int slice_of(lua_State* l, Machine& m) {
  Chart c;
  if (auto why = read_values(l, m, c); !why.empty()) return fail_with(l, "chart.slice: " + why);
  if (!lua_isnumber(l, 3)) return fail_with(l, "chart.slice: the third argument must be a share from 0 to 1");
  double all = 0, before = 0;
  for (std::size_t i = 0; i < c.values.size(); ++i) {
    const double v = std::max(0.0, c.values[i]);
    all += v;
    if (i < c.one) before += v;
  }
  const double there = all > 0 ? (before + lua_tonumber(l, 3) * std::max(0.0, c.values[c.one])) / all : 0;
  return lua_pushnumber(l, pi / 2 - 2 * pi * there), 1;
}

// chart.number(PART): its value as a reader wants it: three digits, more for large whole numbers.
int number_of(lua_State* l, Machine& m) {
  if (lua_type(l, 1) != LUA_TSTRING)
    return fail_with(l, "chart.number: the argument must be the name of a bar, in quotes");
  if (!m.call->questions) return fail_with(l, "chart.number: only code that computes a value can use it");
  const double v = number_now(m, std::string(lua_tostring(l, 1)) + ".value");
  const double step = std::abs(v) >= 100 ? 1 : std::abs(v) >= 10 ? 0.1 : 0.01;
  const double rounded = std::round(v / step) * step;
  const bool whole = std::abs(rounded - std::round(rounded)) < step / 2;
  const std::string text = tick_label(Axis{0, 1, 0, AxisScale::linear}, rounded, whole ? 1 : step);
  return lua_pushlstring(l, text.data(), text.size()), 1;
}

template <int (*body)(lua_State*, Machine&)>
int charted(lua_State* l) {
  charge(l, 60);
  return guarded<body>(l);
}

}  // namespace

const luaL_Reg chart_functions[] = {{"extent", charted<extent_of>},
                                    {"place", charted<place_in_chart>},
                                    {"slice", charted<slice_of>},
                                    {"number", charted<number_of>},
                                    {nullptr, nullptr}};

}  // namespace betwixt::lua
