// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The table `plot` of code: what plots, areas, sums, tangents and fields show of a formula.
#include <algorithm>
#include <cmath>
#include <limits>

#include "procedure/axes_library.h"
#include "procedure/coordinates.h"
#include "procedure/curve_sampling.h"

namespace betwixt::lua {
namespace {

constexpr double beyond = std::numeric_limits<double>::infinity();
constexpr Vec3 lifted{beyond, beyond, beyond};
constexpr int most_names = 20;  // of plots that name plots

bool is_word(const std::string& s) {
  return !s.empty() && std::all_of(s.begin(), s.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '-' || c == '/' || c >= 0x80;
  }) && !std::isdigit(static_cast<unsigned char>(s[0]));
}

// Returns the formula that a text stands for: the name of a plot stands for its formula; a ' after it is the slope.
struct Meant {
  std::string formula;
  int slopes = 0;
};
Meant meant(Machine& m, std::string text) {
  Meant out;
  for (int i = 0; i < most_names; ++i) {
    std::string name = text;
    int slopes = 0;
    for (; name.ends_with('\''); ++slopes) name.pop_back();
    if (!is_word(name) || name == "x" || name == "y" || name == "u" || name == "t") break;
    const auto there = value_now(m, name + ".of");
    if (!there || !std::holds_alternative<Text>(*there)) break;
    text = *std::get<Text>(*there), out.slopes += slopes;
  }
  out.formula = std::move(text);
  return out;
}

// Returns the place of a single = in a formula, or npos.
std::size_t equals_sign(const std::string& f) {
  for (std::size_t i = 0; i < f.size(); ++i)
    if (f[i] == '=' && (i == 0 || std::string_view("=<>~").find(f[i - 1]) == std::string_view::npos)) {
      if (i + 1 < f.size() && f[i + 1] == '=') {
        ++i;
        continue;
      }
      return i;
    }
  return std::string::npos;
}

// A formula that is called from C. The function stays on the stack of Lua.
class Formula {
 public:
  // Returns why the formula cannot be used, or "".
  std::string open(lua_State* l, Machine& m, const std::string& text) {
    state_ = l, machine_ = &m;
    const Meant what = meant(m, text);
    slopes_ = what.slopes;
    std::string formula = what.formula;
    equation_ = equals_sign(formula) != std::string::npos;
    formula = as_difference(formula);
    if (auto why = push_formula(l, m, formula); !why.empty()) return "of \"" + what.formula + "\": " + why;
    index_ = lua_gettop(l);
    return "";
  }
  bool equation() const { return equation_; }
  const std::string& problem() const { return problem_; }

  // Returns the result: a number as (number, NaN, 0), or a vector.
  Vec3 operator()(double x, double y = 0) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const Vec3 nothing{none, none, none};
    if (!problem_.empty()) return nothing;
    if (slopes_ > 0) {
      const double h = std::max(1e-4, 1e-4 * std::abs(x));
      const int outer = slopes_--;
      const double rise = (*this)(x + h).x - (*this)(x - h).x;
      slopes_ = outer;
      return {rise / (2 * h), none, 0};
    }
    const int top = lua_gettop(state_);  // another formula may be above
    lua_pushvalue(state_, index_);
    lua_pushnumber(state_, x), lua_pushnumber(state_, y);
    machine_->lenient = false;
    const int status = lua_pcall(state_, 2, 3, 0);
    machine_->lenient = true;
    if (status != LUA_OK) {
      problem_ = lua_type(state_, -1) == LUA_TSTRING ? lua_tostring(state_, -1) : "it failed";
      if (problem_.starts_with("procedure:1: ")) problem_.erase(0, 13);
      lua_settop(state_, top);
      return nothing;
    }
    double n[16];
    Vec3 out = nothing;
    if (read(state_, -3, n) == Kind::vector)
      out = {n[0], n[1], n[2]};
    else if (lua_type(state_, -3) == LUA_TNUMBER)
      out = {lua_tonumber(state_, -3), lua_type(state_, -2) == LUA_TNUMBER ? lua_tonumber(state_, -2) : none,
             lua_type(state_, -1) == LUA_TNUMBER ? lua_tonumber(state_, -1) : 0};
    lua_settop(state_, top);
    return out;
  }

 private:
  lua_State* state_ = nullptr;
  Machine* machine_ = nullptr;
  int index_ = 0, slopes_ = 0;
  bool equation_ = false;
  std::string problem_;
};

// What every function here begins with.
struct Plotting {
  AxesSpace space;
  Formula of;
  double from = 0, to = 1;

  // `name`: of the plot; "": of the object whose value it is.
  std::string open(lua_State* l, Machine& m, const std::string& name = "") {
    if (auto why = find_axes(m, name, space); !why.empty()) return why;
    if (!space.x.good() || !(space.size.x > 0)) return "its axes have no length: give x two different numbers";
    if (auto why = of.open(l, m, text_now(m, name + ".of")); !why.empty()) return why;
    from = number_now(m, name + ".from"), to = number_now(m, name + ".to");
    return "";
  }
  bool along_axis() const { return from == to; }
  // Sets the range to that of the axis if none is given, and keeps it within the axis.
  void within_axis() {
    const double low = std::min(space.x.low, space.x.high), high = std::max(space.x.low, space.x.high);
    if (along_axis()) from = low, to = high;
    from = std::clamp(from, low, high), to = std::clamp(to, low, high);
  }
  Vec3 half() const {
    if (space.kind != betwixt::Kind::axes || space.size.z > 0) return {1e300, 1e300, 1e300};
    return 0.5 * space.size;
  }
  double tolerance() const { return std::max(space.size.x, space.size.y) / 8000; }

  std::vector<CurvePoint> curve(Formula& f) {
    CurveSampling s;
    const bool polar = space.kind == betwixt::Kind::polar_axes;
    // Steps of the parameter are even on the axis, not in its numbers.
    const bool even = space.x.scale == AxisScale::log && !polar;
    s.from = even ? space.x.share(from) : from, s.to = even ? space.x.share(to) : to;
    s.place = [this, &f, even, polar](double at) {
      const double x = even ? space.x.number_at(at) : at;
      const Vec3 r = f(x);
      if (std::isfinite(r.y)) return space.place(r);
      return polar ? space.place({r.x, x, 0}) : space.place({x, r.x, 0});
    };
    s.tolerance = tolerance();
    s.half = 1.2 * half();
    auto all = sampled(s);
    for (CurvePoint& p : all)
      if (even) p.at = space.x.number_at(p.at);
    return all;
  }
};

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

int sum_of(lua_State* l, Machine& m) {
  if (lua_type(l, 1) != LUA_TSTRING) return fail_with(l, "plot.sum: write the name of a Riemann sum, in quotes");
  const std::string name = lua_tostring(l, 1);
  Plotting p;
  if (auto why = p.open(l, m, name); !why.empty()) return fail_with(l, why);
  const Rectangles all = rectangles(m, p, name);
  if (!p.of.problem().empty()) return fail_with(l, p.of.problem());
  double sum = 0;
  for (const auto& [x, y] : all.all) sum += y * all.step;
  return lua_pushnumber(l, sum), 1;
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

// One arrow of a field: its outline, of a length that has no unit.
void add_arrow(std::vector<Vec3>& out, Vec3 middle, Vec3 way, double thick) {
  const double all = length(way);
  if (!(all > 1e-6)) return;
  const Vec3 along = (1 / all) * way, side{-along.y, along.x, 0};
  const double head = std::min(all * 0.5, 3.2 * thick), wide = head * 0.55, thin = std::min(thick, head * 0.4) / 2;
  const Vec3 start = middle - 0.5 * way, neck = middle + (0.5 - head / all) * way, tip = middle + 0.5 * way;
  if (!out.empty()) out.push_back(lifted);
  for (const Vec3 p : {start - thin * side, neck - thin * side, neck - wide * side, tip, neck + wide * side,
                       neck + thin * side, start + thin * side})
    out.push_back(p);
}

int field_of(lua_State* l, Machine& m) {
  Plotting p;
  if (auto why = p.open(l, m); !why.empty()) return fail_with(l, why);
  const double across = std::max(p.space.size.x, p.space.size.y);
  const double density = std::clamp(number_now(m, ".density"), 1.0, 100.0), cell = across / density;
  const int columns = std::max(1, static_cast<int>(p.space.size.x / cell)),
            rows = std::max(1, static_cast<int>(p.space.size.y / cell));
  struct Arrow {
    Vec3 at, way;
  };
  std::vector<Arrow> all;
  double longest = 0;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const double x = p.space.x.number_at((i + 0.5) / columns), y = p.space.y.number_at((j + 0.5) / rows);
      const Vec3 v = p.of(x, y), a = p.space.place({x, y, 0});
      // The length is that of the vector as the axes show it.
      const double h = 1e-6;
      const Vec3 way = (1 / h) * (p.space.place({x + h * v.x, y + h * v.y, 0}) - a);
      if (!std::isfinite(way.x) || !std::isfinite(way.y)) continue;
      all.push_back({a, way}), longest = std::max(longest, length(way));
    }
  if (!p.of.problem().empty()) return fail_with(l, p.of.problem());
  std::vector<Vec3> out;
  for (const Arrow& a : all) {
    const double share = longest > 0 ? length(a.way) / longest : 0;
    // Short arrows are a little longer than they should be, so that their direction is seen.
    add_arrow(out, a.at, (0.9 * cell * std::sqrt(share)) * normalize(a.way, {0, 0, 0}), 0.07 * cell);
  }
  return push_points(l, out), 1;
}

template <int (*body)(lua_State*, Machine&)>
int plotted(lua_State* l) {
  charge(l, 200);
  luaL_checkstack(l, 20, "too deep");
  if (!Machine::of(l).call->questions) return luaL_error(l, "only code that computes a value can use it");
  const int results = guarded<body>(l);
  if (results > 0 && lua_type(l, -1) == LUA_TTABLE) charge(l, static_cast<double>(lua_rawlen(l, -1)));
  return results;
}

}  // namespace

std::string as_difference(const std::string& formula) {
  const auto sign = equals_sign(formula);
  if (sign == std::string::npos) return formula;
  return "(" + formula.substr(0, sign) + ") - (" + formula.substr(sign + 1) + ")";
}

const luaL_Reg plot_functions[] = {{"curve", plotted<curve_of>},
                                   {"area", plotted<area_of>},
                                   {"riemann", plotted<riemann_of>},
                                   {"sum", plotted<sum_of>},
                                   {"tangent", plotted<tangent_of>},
                                   {"field", plotted<field_of>},
                                   {nullptr, nullptr}};

}  // namespace betwixt::lua
