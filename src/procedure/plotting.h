// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What the functions of the table `plot` of code share: formulas that are called from C, and the axes of a plot.
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "procedure/axes_library.h"
#include "procedure/coordinates.h"
#include "procedure/curve_sampling.h"

namespace betwixt::lua {

inline constexpr double beyond = std::numeric_limits<double>::infinity();
inline constexpr Vec3 lifted{beyond, beyond, beyond};

// A formula that is called from C. The function stays on the stack of Lua.
class Formula {
 public:
  // Returns why the formula cannot be used, or "".
  std::string open(lua_State*, Machine&, const std::string& text);
  bool equation() const { return equation_; }
  const std::string& problem() const { return problem_; }
  // Returns the result: a number as (number, NaN, 0), or a vector.
  Vec3 operator()(double x, double y = 0);
  double step = 1e-4;  // of slopes

 private:
  lua_State* state_ = nullptr;
  Machine* machine_ = nullptr;
  int index_ = 0, slopes_ = 0;
  bool equation_ = false;
  std::string problem_;
};

// What every function of the table begins with.
struct Plotting {
  AxesSpace space;
  Formula of;
  double from = 0, to = 1;

  // `name`: of the plot; "": of the object whose value it is.
  std::string open(lua_State*, Machine&, const std::string& name = "");
  bool along_axis() const { return from == to; }
  // Sets the range to that of the axis if none is given, and keeps it within the axis.
  void within_axis();
  Vec3 half() const;
  double tolerance() const { return std::max(space.size.x, space.size.y) / 9600; }  // a fifth of a pixel in 1920
  std::vector<CurvePoint> curve(Formula&);
};

template <int (*body)(lua_State*, Machine&)>
int plotted(lua_State* l) {
  charge(l, 200);
  luaL_checkstack(l, 20, "too deep");
  if (!Machine::of(l).call->questions) return luaL_error(l, "only code that computes a value can use it");
  const int results = guarded<body>(l);
  if (results > 0 && lua_type(l, -1) == LUA_TTABLE) charge(l, static_cast<double>(lua_rawlen(l, -1)));
  return results;
}

// field_library.cpp
int field_of(lua_State*, Machine&);
int streamlines_of(lua_State*, Machine&);
int surface_of(lua_State*, Machine&);

}  // namespace betwixt::lua
