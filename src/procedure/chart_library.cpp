// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The table `chart` of code: where the parts of a chart are, by the values of all of them.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "procedure/axes_library.h"
#include "procedure/coordinates.h"
#include "scene/letter_widths.h"

namespace betwixt::lua {
namespace {

struct Chart {
  std::string name;
  std::vector<double> values, rooms;
  double low = 0, high = 1;
  Vec3 size;
  double gap = 0;
  bool sorted = false, up = true;
  std::size_t one = 0;  // the part that is asked for

  double share(double v) const {
    return high != low ? (std::clamp(v, std::min(low, high), std::max(low, high)) - low) / (high - low) : 0;
  }
  double base() const { return low > 0 ? low : high < 0 ? high : 0; }
  double all_rooms() const { return std::max(1e-9, std::accumulate(rooms.begin(), rooms.end(), 0.0)); }
  // Returns the room of the parts before the one.
  double before() const {
    double all = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const bool above = sorted ? values[i] > values[one] || (values[i] == values[one] && i < one) : i < one;
      if (above) all += rooms[i];
    }
    return all;
  }
  // Sets the ends to those that are given, or to what the values need. A part that goes counts less and less.
  void fit(Vec3 range) {
    low = range.x, high = range.y;
    if (low != high) return;
    low = high = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
      low = std::min(low, values[i] * rooms[i]), high = std::max(high, values[i] * rooms[i]);
  }
};

// Reads the name of the chart, the first argument, and the names of its parts. Returns why not, or "".
std::string read_names(lua_State* l, Machine& m, std::string& chart, Names& out) {
  if (lua_type(l, 1) != LUA_TSTRING) return "the first argument must be the name of a chart, in quotes";
  if (!m.call->questions) return "only code that computes a value can use it";
  chart = lua_tostring(l, 1);
  const auto parts = value_now(m, chart + ".parts");
  const auto* names = parts ? std::get_if<Names>(&*parts) : nullptr;
  if (!names) return "there is no chart '" + chart + "'";
  return out = *names, "";
}
// Whatever has a value can be a part; one that was removed has no room.
double room_of(Machine& m, const std::string& part) {
  const auto v = value_now(m, part + ".room");
  const auto* room = v ? std::get_if<double>(&*v) : nullptr;
  return room ? std::clamp(*room, 0.0, 1.0) : value_now(m, part + ".value") ? 1 : 0;
}

// Each part needs the values of all, so they are read once, as `readings`.
std::string read_values(lua_State* l, Machine& m, Chart& out) {
  if (lua_type(l, 1) != LUA_TSTRING) return "the first argument must be the name of a chart, in quotes";
  if (!m.call->questions) return "only code that computes a value can use it";
  out.name = lua_tostring(l, 1);
  const auto known = value_now(m, out.name + ".readings");
  const auto* points = known ? std::get_if<Points>(&*known) : nullptr;
  if (!points) return "there is no chart '" + out.name + "'";
  for (const Vec3 p : **points) out.values.push_back(p.x), out.rooms.push_back(p.y);
  return "";
}
// Reads the number of a part too, the second argument.
std::string read_part(lua_State* l, Machine& m, Chart& out) {
  if (!lua_isnumber(l, 2)) return "the second argument must be the number of a part";
  if (auto why = read_values(l, m, out); !why.empty()) return why;
  const double one = lua_tonumber(l, 2);
  if (!(one >= 1 && one <= static_cast<double>(out.values.size()))) return "there is no part of that number";
  out.one = static_cast<std::size_t>(one) - 1;
  return "";
}

std::string read_chart(lua_State* l, Machine& m, Chart& out) {
  if (auto why = read_part(l, m, out); !why.empty()) return why;
  const auto size = value_now(m, out.name + ".size"), range = value_now(m, out.name + ".range");
  if (!size || !range) return "it is no chart of bars";
  out.size = std::get<Vec3>(*size);
  out.gap = number_now(m, out.name + ".gap"), out.sorted = number_now(m, out.name + ".sorted") != 0;
  out.fit(std::get<Vec3>(*range));
  out.up = number_now(m, ".upwards") != 0;
  return "";
}

// chart.readings(CHART): the value and the room of each part.
int readings_of(lua_State* l, Machine& m) {
  std::string chart;
  Names parts;
  if (auto why = read_names(l, m, chart, parts); !why.empty()) return fail_with(l, "chart.readings: " + why);
  std::vector<Vec3> out;
  for (const std::string& part : *parts) out.push_back({number_now(m, part + ".value"), room_of(m, part), 0});
  return push_points(l, out), 1;
}

int push_pair(lua_State* l, double x, double y) { return push_place(l, {x, y, 0}), 1; }

int extent_of(lua_State* l, Machine& m) {
  Chart c;
  if (auto why = read_chart(l, m, c); !why.empty()) return fail_with(l, "chart.extent: " + why);
  const double grows = c.share(c.values[c.one]) - c.share(c.base());
  const double room = (c.up ? c.size.x : c.size.y) / c.all_rooms() * c.rooms[c.one] * (1 - c.gap);
  return c.up ? push_pair(l, room, grows * c.size.y) : push_pair(l, grows * c.size.x, room);
}

int place_in_chart(lua_State* l, Machine& m) {
  Chart c;
  if (auto why = read_chart(l, m, c); !why.empty()) return fail_with(l, "chart.place: " + why);
  const double at = (c.before() + c.rooms[c.one] / 2) / c.all_rooms(), base = c.share(c.base()) - 0.5;
  return c.up ? push_pair(l, (at - 0.5) * c.size.x, base * c.size.y)
              : push_pair(l, base * c.size.x, (0.5 - at) * c.size.y);
}

// chart.fit(CHART, NUMBER, EVERY): the size of the label of a part, of which only one in so many has one: smaller if
// parts go and the next label comes nearer. 1 if all parts have their room.
int fit_of(lua_State* l, Machine& m) {
  Chart c;
  if (auto why = read_part(l, m, c); !why.empty()) return fail_with(l, "chart.fit: " + why);
  const auto every = static_cast<std::size_t>(std::clamp(lua_tonumber(l, 3), 1.0, 1e6));
  const double even = static_cast<double>(every) / static_cast<double>(c.values.size()) * c.all_rooms();
  const auto way_to = [&](std::size_t other) {  // between the middles of two parts
    const auto [low, high] = std::minmax(c.one, other);
    double all = (c.rooms[low] + c.rooms[high]) / 2;
    for (std::size_t i = low + 1; i < high; ++i) all += c.rooms[i];
    return all / even;
  };
  double size = 1;
  if (c.one >= every) size = std::min(size, way_to(c.one - every));
  if (c.one + every < c.rooms.size()) size = std::min(size, way_to(c.one + every));
  return lua_pushnumber(l, size * c.rooms[c.one]), 1;
}

// ---- Pies

// The angles of slices: the first begins at the top, they go clockwise.
struct Slices {
  std::vector<double> ends{0};  // the shares of the circle before each slice, and 1
  explicit Slices(const Chart& c) {
    for (std::size_t i = 0; i < c.values.size(); ++i)
      ends.push_back(ends.back() + std::max(0.0, c.values[i]) * c.rooms[i]);
    if (const double all = ends.back(); all > 0)
      for (double& e : ends) e /= all;
  }
  double share(std::size_t i) const { return ends[i + 1] - ends[i]; }
  double angle(std::size_t i, double at) const { return pi / 2 - 2 * pi * (ends[i] + at * share(i)); }
};

// chart.slice(PIE, NUMBER, SHARE): the angle at a share of a slice.
int slice_of(lua_State* l, Machine& m) {
  Chart c;
  if (auto why = read_part(l, m, c); !why.empty()) return fail_with(l, "chart.slice: " + why);
  if (!lua_isnumber(l, 3)) return fail_with(l, "chart.slice: the third argument must be a share from 0 to 1");
  return lua_pushnumber(l, Slices(c).angle(c.one, lua_tonumber(l, 3))), 1;
}

// Returns heights that are at least `apart` from each other, in order from the top, and else as near to those wanted
// as possible: neighbours that are too near share the mean of what they want.
std::vector<double> kept_apart(const std::vector<double>& wanted, double apart) {
  struct Block {
    double sum;
    std::size_t count;
    double mean() const { return sum / static_cast<double>(count); }
  };
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    blocks.push_back({wanted[i] + static_cast<double>(i) * apart, 1});
    while (blocks.size() > 1 && blocks.back().mean() > blocks[blocks.size() - 2].mean()) {
      const Block last = blocks.back();
      blocks.pop_back();
      blocks.back().sum += last.sum, blocks.back().count += last.count;
    }
  }
  std::vector<double> out;
  for (const Block& b : blocks)
    for (std::size_t k = 0; k < b.count; ++k) out.push_back(b.mean() - static_cast<double>(out.size()) * apart);
  return out;
}

// The label of one slice. Those of each half are in a column along the circle; the smallest slices have none if there
// are too many.
struct SliceLabel {
  bool shown = false, right = true;
  Vec3 place;  // the middle of its inner end
};
SliceLabel slice_label(const Chart& c, double radius, double em) {
  const Slices slices(c);
  const auto is_right = [&](std::size_t i) { return std::cos(slices.angle(i, 0.5)) >= 0; };
  const double away = radius + 0.9 * em, apart = 1.25 * em;
  SliceLabel out;
  out.right = is_right(c.one);
  std::vector<std::size_t> side;
  for (std::size_t i = 0; i < c.values.size(); ++i)
    if (is_right(i) == out.right && slices.share(i) > 1e-3) side.push_back(i);
  const auto most = static_cast<std::size_t>(std::max(1.0, 2 * away / apart + 1));
  if (side.size() > most) {
    std::vector<std::size_t> largest = side;
    std::stable_sort(largest.begin(), largest.end(),
                     [&](std::size_t a, std::size_t b) { return slices.share(a) > slices.share(b); });
    largest.resize(most);
    std::erase_if(side, [&](std::size_t i) { return std::find(largest.begin(), largest.end(), i) == largest.end(); });
  }
  // From the top: the order of the slices on the right, the reverse on the left.
  if (!out.right) std::reverse(side.begin(), side.end());
  const auto own = std::find(side.begin(), side.end(), c.one);
  if (own == side.end()) return out;
  std::vector<double> wanted;
  for (const std::size_t i : side) wanted.push_back(away * std::sin(slices.angle(i, 0.5)));
  const double y = kept_apart(wanted, apart)[static_cast<std::size_t>(own - side.begin())];
  // No corner of the label is inside the circle.
  const double inner = std::max(0.0, std::abs(y) - 0.6 * em), edge = radius + 0.4 * em;
  const double x = std::max(0.25 * em, std::sqrt(std::max(0.0, edge * edge - inner * inner)));
  out.shown = true, out.place = {out.right ? x : -x, y - 0.36 * em, 0};
  return out;
}

// chart.label(PIE, NUMBER, EM): the place of the label of a slice, its alignment, and whether there is room for it.
int label_of(lua_State* l, Machine& m) {
  Chart c;
  if (auto why = read_part(l, m, c); !why.empty()) return fail_with(l, "chart.label: " + why);
  const SliceLabel label = slice_label(c, number_now(m, c.name + ".radius"), std::max(1e-6, lua_tonumber(l, 3)));
  push_place(l, label.place);
  lua_pushstring(l, label.right ? "left" : "right");
  lua_pushboolean(l, label.shown);
  return 3;
}

// ---- Numbers

std::string number_text(double v, double step) {
  const double rounded = std::round(v / step) * step;
  const bool whole = std::abs(rounded - std::round(rounded)) < step / 2;
  return tick_label(Axis{0, 1, 0, AxisScale::linear}, rounded, whole ? 1 : step);
}

// chart.number(PART, WIDEST): its value as a reader wants it: three digits, more for large whole numbers. If that is
// wider than the given number of em, it has fewer digits, or is empty.
int number_of(lua_State* l, Machine& m) {
  if (lua_type(l, 1) != LUA_TSTRING)
    return fail_with(l, "chart.number: the argument must be the name of a bar, in quotes");
  if (!m.call->questions) return fail_with(l, "chart.number: only code that computes a value can use it");
  const double v = number_now(m, std::string(lua_tostring(l, 1)) + ".value");
  const double widest = lua_isnumber(l, 2) ? lua_tonumber(l, 2) : 1e300;
  double step = std::abs(v) >= 100 ? 1 : std::abs(v) >= 10 ? 0.1 : 0.01;
  std::string text = number_text(v, step);
  for (; step < 1 && letters_width(text) > widest; text = number_text(v, step)) step = std::min(1.0, 10 * step);
  for (const auto& [unit, sign] : {std::pair{1e3, "k"}, {1e6, "M"}, {1e9, "G"}})
    if (letters_width(text) > widest && std::abs(v) >= unit) text = number_text(v / unit, 1) + sign;
  if (letters_width(text) > widest) text.clear();
  return lua_pushlstring(l, text.data(), text.size()), 1;
}

// ---- Line charts

// chart.range(CHART): the numbers at the ends of its y axis.
int range_of(lua_State* l, Machine& m) {
  Chart c;
  if (auto why = read_values(l, m, c); !why.empty()) return fail_with(l, "chart.range: " + why);
  const auto range = value_now(m, c.name + ".range");
  c.fit(range && std::holds_alternative<Vec3>(*range) ? std::get<Vec3>(*range) : Vec3{});
  return c.low == c.high ? push_pair(l, c.low, c.low + 1) : push_pair(l, c.low, c.high);
}

// chart.span(CHART): the ends of an x axis with a place for each part.
int span_of(lua_State* l, Machine& m) {
  Chart c;
  if (auto why = read_values(l, m, c); !why.empty()) return fail_with(l, "chart.span: " + why);
  return push_place(l, {0, c.all_rooms(), 1}), 1;
}

// chart.slot(CHART, NUMBER): the number of a part on such an axis.
int slot_of(lua_State* l, Machine& m) {
  Chart c;
  if (auto why = read_part(l, m, c); !why.empty()) return fail_with(l, "chart.slot: " + why);
  return lua_pushnumber(l, c.before() + c.rooms[c.one] / 2), 1;
}

// The dots of a line chart that are there. One that comes or goes is between its neighbours and its value.
std::vector<Vec3> dots_of(Machine& m, const Chart& c) {
  std::vector<Vec3> at;
  const auto parts = value_now(m, c.name + ".parts");
  const auto* names = parts ? std::get_if<Names>(&*parts) : nullptr;
  if (!names || (*names)->size() != c.values.size()) return {};
  for (const std::string& part : **names) at.push_back({number_now(m, part + ".at"), c.values[at.size()], 0});
  std::vector<Vec3> out = at;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (c.rooms[i] >= 1) continue;
    std::size_t before = i, after = i;
    while (before > 0 && c.rooms[before] < 1) --before;
    while (after + 1 < at.size() && c.rooms[after] < 1) ++after;
    if (c.rooms[before] < 1) before = after;
    if (c.rooms[after] < 1) after = before;
    if (c.rooms[before] < 1) continue;  // none is whole
    const double way = at[after].x - at[before].x, share = way != 0 ? (at[i].x - at[before].x) / way : 0;
    const double line = at[before].y + std::clamp(share, 0.0, 1.0) * (at[after].y - at[before].y);
    out[i].y = line + c.rooms[i] * (at[i].y - line);
  }
  return out;
}

// chart.dot(CHART, NUMBER): the place of a dot, in the numbers of its axes.
int dot_of(lua_State* l, Machine& m) {
  constexpr Vec3 in_front{0, 0, 0.01};  // of the line
  std::string name;
  Names parts;
  if (auto why = read_names(l, m, name, parts); !why.empty()) return fail_with(l, "chart.dot: " + why);
  const double one = lua_tonumber(l, 2);
  if (!(one >= 1 && one <= static_cast<double>(parts->size())))
    return fail_with(l, "chart.dot: there is no part of that number");
  const auto at = static_cast<std::size_t>(one) - 1;
  const std::string& part = (*parts)[at];
  if (room_of(m, part) >= 1)
    return push_place(l, Vec3{number_now(m, part + ".at"), number_now(m, part + ".value"), 0} + in_front), 1;
  Chart c;
  if (auto why = read_values(l, m, c); !why.empty()) return fail_with(l, "chart.dot: " + why);
  const std::vector<Vec3> all = dots_of(m, c);
  return push_place(l, at < all.size() ? all[at] + in_front : in_front), 1;
}

int line_of_chart(lua_State* l, Machine& m) {
  Chart c;
  if (auto why = read_values(l, m, c); !why.empty()) return fail_with(l, "chart.line: " + why);
  std::vector<Vec3> out;
  const std::vector<Vec3> all = dots_of(m, c);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (c.rooms[i] > 0) out.push_back(all[i]);
  return push_points(l, out), 1;
}

}  // namespace

const luaL_Reg chart_functions[] = {{"readings", of_piece<readings_of>},
                                    {"extent", of_piece<extent_of>},
                                    {"place", of_piece<place_in_chart>},
                                    {"slice", of_piece<slice_of>},
                                    {"fit", of_piece<fit_of>},
                                    {"label", of_piece<label_of>},
                                    {"number", of_piece<number_of>},
                                    {"range", of_piece<range_of>},
                                    {"span", of_piece<span_of>},
                                    {"slot", of_piece<slot_of>},
                                    {"dot", of_piece<dot_of>},
                                    {"line", of_piece<line_of_chart>},
                                    {nullptr, nullptr}};

}  // namespace betwixt::lua
