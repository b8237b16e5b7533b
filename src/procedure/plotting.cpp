// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "procedure/plotting.h"

#include <algorithm>
#include <cmath>

namespace betwixt::lua {
namespace {

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

}  // namespace

std::string as_difference(const std::string& formula) {
  const auto sign = equals_sign(formula);
  if (sign == std::string::npos) return formula;
  return "(" + formula.substr(0, sign) + ") - (" + formula.substr(sign + 1) + ")";
}

std::string Formula::open(lua_State* l, Machine& m, const std::string& text) {
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

Vec3 Formula::operator()(double x, double y) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const Vec3 nothing{none, none, none};
  if (!problem_.empty()) return nothing;
  if (slopes_ > 0) {
    // Slopes of slopes divide by small numbers again and again.
    const double h = std::max(step, 1e-7 * std::abs(x)) * std::pow(10, std::max(0, slopes_ - 2));
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

std::string Plotting::open(lua_State* l, Machine& m, const std::string& name) {
  if (auto why = find_axes(m, name, space); !why.empty()) return why;
  if (!space.x.good() || !(space.size.x > 0)) return "its axes have no length: give x two different numbers";
  if (auto why = of.open(l, m, text_now(m, name + ".of")); !why.empty()) return why;
  of.step = 1e-5 * std::abs(space.x.high - space.x.low);
  from = number_now(m, name + ".from"), to = number_now(m, name + ".to");
  return "";
}

void Plotting::within_axis() {
  const double low = std::min(space.x.low, space.x.high), high = std::max(space.x.low, space.x.high);
  if (along_axis()) from = low, to = high;
  from = std::clamp(from, low, high), to = std::clamp(to, low, high);
}

Vec3 Plotting::half() const {
  if (space.kind != betwixt::Kind::axes || space.size.z > 0) return {1e300, 1e300, 1e300};
  return 0.5 * space.size;
}

std::vector<CurvePoint> Plotting::curve(Formula& f) {
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

}  // namespace betwixt::lua
