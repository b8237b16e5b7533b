// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The table `plot` of code: what plots, areas, sums and tangents show of a formula.
#include <algorithm>
#include <cmath>

#include "procedure/plotting.h"

namespace betwixt::lua {
namespace {

std::vector<Vec3> places(const std::vector<CurvePoint>& all) {
  std::vector<Vec3> out;
  out.reserve(all.size());
  for (const CurvePoint& p : all) out.push_back(p.breaks() ? lifted : p.place);
  return out;
}

std::vector<CurvePoint> solutions(Plotting& p) {
  const auto number = [&p](double u, double v) { return Vec3{p.space.x.number_at(u), p.space.y.number_at(v), 0}; };
  const double aspect = p.space.size.y / std::max(p.space.size.x, 1e-9);
  const int columns = 128, rows = std::clamp(static_cast<int>(128 * aspect), 8, 256);
  return level_lines(
      [&](double u, double v) {
        const Vec3 n = number(u, v);
        return p.of(n.x, n.y).x;
      },
      columns, rows, [&](double u, double v) { return p.space.place(number(u, v)); });
}

int curve_of(lua_State* l, Machine& m) {
  Plotting p;
  if (auto why = p.open(l, m); !why.empty()) return fail_with(l, why);
  std::vector<CurvePoint> all;
  if (p.of.equation()) {
    all = solutions(p);
  } else {
    const double middle = p.along_axis() ? p.space.x.number_at(0.5) : p.from;
    const bool parametric = std::isfinite(p.of(middle).y) || p.space.kind == betwixt::Kind::polar_axes;
    if (!parametric) p.within_axis();
    if (parametric && p.along_axis()) p.from = 0, p.to = 2 * pi;
    all = clipped(p.curve(p.of), p.half());
  }
  if (!p.of.problem().empty()) return fail_with(l, p.of.problem());
  return push_points(l, places(all)), 1;
}

Vec3 kept_inside(Vec3 p, Vec3 half) {
  for (int i = 0; i < 2; ++i) p[i] = std::clamp(p[i], -half[i], half[i]);
  return p;
}

int area_of(lua_State* l, Machine& m) {
  Plotting p;
  if (auto why = p.open(l, m); !why.empty()) return fail_with(l, why);
  Formula base;
  if (auto why = base.open(l, m, text_now(m, ".base")); !why.empty()) return fail_with(l, why);
  base.step = p.of.step;
  p.within_axis();
  if (p.from > p.to) std::swap(p.from, p.to);
  const auto top = p.curve(p.of), bottom = p.curve(base);
  for (const Formula* f : {&p.of, &base})
    if (!f->problem().empty()) return fail_with(l, f->problem());
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < top.size();) {
    std::size_t end = i;
    while (end < top.size() && !top[end].breaks()) ++end;
    if (end - i > 1) {
      const double low = top[i].at, high = top[end - 1].at;
      if (!out.empty()) out.push_back(lifted);
      for (std::size_t k = i; k < end; ++k) out.push_back(kept_inside(top[k].place, p.half()));
      out.push_back(kept_inside(p.space.place({high, base(high).x, 0}), p.half()));
      for (std::size_t k = bottom.size(); k-- > 0;)
        if (!bottom[k].breaks() && bottom[k].at > low && bottom[k].at < high)
          out.push_back(kept_inside(bottom[k].place, p.half()));
      out.push_back(kept_inside(p.space.place({low, base(low).x, 0}), p.half()));
    }
    i = end + 1;
  }
  return push_points(l, out), 1;
}

// The rectangles of a Riemann sum, from left to right.
struct Rectangles {
  double step = 0;
  std::vector<std::pair<double, double>> all;  // the left side and the height
};
Rectangles rectangles(Machine& m, Plotting& p, const std::string& name) {
  p.within_axis();
  const int count = static_cast<int>(std::clamp(std::round(number_now(m, name + ".count")), 0.0, 2000.0));
  const std::string touch = text_now(m, name + ".touch");
  const double share = touch == "right" ? 1 : touch == "middle" ? 0.5 : 0;
  Rectangles out;
  out.step = count > 0 ? (p.to - p.from) / count : 0;
  for (int i = 0; i < count; ++i) {
    const double x = p.from + i * out.step, y = p.of(x + share * out.step).x;
    if (std::isfinite(y)) out.all.emplace_back(x, y);
  }
  return out;
}

int riemann_of(lua_State* l, Machine& m) {
  Plotting p;
  if (auto why = p.open(l, m); !why.empty()) return fail_with(l, why);
  const Rectangles sum = rectangles(m, p, "");
  if (!p.of.problem().empty()) return fail_with(l, p.of.problem());
  const double zero = p.space.y.scale == AxisScale::log ? p.space.y.low : 0;
  std::vector<Vec3> out;
  for (const auto& [x, y] : sum.all) {
    if (!out.empty()) out.push_back(lifted);
    for (const auto& [a, b] : {std::pair{x, zero}, {x + sum.step, zero}, {x + sum.step, y}, {x, y}})
      out.push_back(kept_inside(p.space.place({a, b, 0}), p.half()));
  }
  return push_points(l, out), 1;
}

// Returns the integral of a formula over its base, by Gauss' rule with three points in each of many equal pieces.
double integral(Plotting& p, Formula& base) {
  constexpr int pieces = 400;
  constexpr std::pair<double, double> rule[] = {
      {-0.7745966692414834, 5.0 / 18}, {0, 8.0 / 18}, {0.7745966692414834, 5.0 / 18}};
  p.within_axis();
  const double step = (p.to - p.from) / pieces;
  double sum = 0;
  for (int i = 0; i < pieces; ++i)
    for (const auto& [at, weight] : rule) {
      const double x = p.from + (i + 0.5 + at / 2) * step, height = p.of(x).x - base(x).x;
      if (std::isfinite(height)) sum += weight * step * height;
    }
  return sum;
}

// plot.sum(NAME): the area of a Riemann sum, or the integral that an area shows.
int sum_of(lua_State* l, Machine& m) {
  if (lua_type(l, 1) != LUA_TSTRING)
    return fail_with(l, "plot.sum: write the name of an area or a Riemann sum, in quotes");
  const std::string name = lua_tostring(l, 1);
  const bool area = value_now(m, name + ".base").has_value();
  if (!area && !value_now(m, name + ".touch"))
    return fail_with(l, "plot.sum: '" + name + "' is neither an area nor a Riemann sum");
  Plotting p;
  if (auto why = p.open(l, m, name); !why.empty()) return fail_with(l, why);
  double sum = 0;
  if (area) {
    Formula base;
    if (auto why = base.open(l, m, text_now(m, name + ".base")); !why.empty()) return fail_with(l, why);
    base.step = p.of.step;
    sum = integral(p, base);
    if (!base.problem().empty()) return fail_with(l, base.problem());
  } else {
    const Rectangles all = rectangles(m, p, name);
    for (const auto& [x, y] : all.all) sum += y * all.step;
  }
  if (!p.of.problem().empty()) return fail_with(l, p.of.problem());
  return lua_pushnumber(l, sum), 1;
}

// plot.at(NAME, X): what the formula of a plot gives there, a number or a vector.
int at_of(lua_State* l, Machine& m) {
  if (lua_type(l, 1) != LUA_TSTRING || !lua_isnumber(l, 2))
    return fail_with(l, "plot.at: write the name of a plot in quotes, and a number: plot.at('f', 2)");
  const std::string name = lua_tostring(l, 1);
  if (!value_now(m, name + ".of")) return fail_with(l, "plot.at: '" + name + "' has no formula");
  Plotting p;
  if (auto why = p.open(l, m, name); !why.empty()) return fail_with(l, why);
  const Vec3 v = p.of(lua_tonumber(l, 2));
  if (!p.of.problem().empty()) return fail_with(l, p.of.problem());
  if (std::isfinite(v.y)) return push_place(l, v), 1;
  return lua_pushnumber(l, v.x), 1;
}

int tangent_of(lua_State* l, Machine& m) {
  Plotting p;
  if (auto why = p.open(l, m); !why.empty()) return fail_with(l, why);
  const double at = number_now(m, ".at"), step = number_now(m, ".step"), long_ = number_now(m, ".length");
  const double h = step != 0 ? step : 1e-5 * std::abs(p.space.x.high - p.space.x.low);
  const auto place = [&](double x) { return p.space.place({x, p.of(x).x, 0}); };
  const Vec3 here = place(at), a = step != 0 ? here : place(at - h), b = place(at + h);
  if (!p.of.problem().empty()) return fail_with(l, p.of.problem());
  const Vec3 way = normalize(b - a, {0, 0, 0});
  std::vector<Vec3> out;
  if (std::isfinite(here.y) && length(way) > 0.5) {
    const Vec3 middle = step != 0 ? 0.5 * (a + b) : here;
    const double half = std::max(long_, step != 0 ? length(b - a) + 0.5 : 0) / 2;
    out = {middle - half * way, middle + half * way};
  }
  return push_points(l, out), 1;
}

}  // namespace

const luaL_Reg plot_functions[] = {{"curve", plotted<curve_of>},     {"area", plotted<area_of>},
                                   {"riemann", plotted<riemann_of>}, {"at", plotted<at_of>},
                                   {"sum", plotted<sum_of>},         {"tangent", plotted<tangent_of>},
                                   {"field", plotted<field_of>},     {"streamlines", plotted<streamlines_of>},
                                   {"surface", plotted<surface_of>}, {nullptr, nullptr}};

}  // namespace betwixt::lua
