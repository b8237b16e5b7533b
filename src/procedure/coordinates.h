// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What the functions of axes, plots and charts share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "procedure/machine.h"
#include "scene/axes.h"

namespace betwixt::lua {

// Finds the axes that the first argument names. "": those of the object whose value it is. Returns why not, or "".
std::string find_axes(lua_State*, Machine&, AxesSpace&);
std::string find_axes(Machine&, std::string_view name, AxesSpace&);
// Reads a target now. A target that cannot be read is nullopt, 0 or "".
std::optional<Value> value_now(Machine&, const std::string& target);
double number_now(Machine&, const std::string& target);  // on is 1
std::string text_now(Machine&, const std::string& target);
// Returns the transform of an object to the world; "": of the object whose value it is.
std::optional<Mat4> world_of(Machine&, const std::string& name);
// Moves points of the world into the space of an object, which may be below another one. Points that break a line stay.
void into_space(Machine&, const std::string& name, std::vector<Vec3>& points);
void push_place(lua_State*, Vec3);
void push_points(lua_State*, const std::vector<Vec3>&);

// Code that is compiled, with its number for Machine::push_code.
struct CompiledFormula {
  std::uint64_t serial = 0;
  std::string code;
};
Result<CompiledFormula> compiled_chunk(const std::string& source);

// Returns the difference of the two sides of an equation, and any other formula as it is.
std::string as_difference(const std::string& formula);
// Pushes a formula as a function of x and y, which knows t and all names of code. Returns why it cannot, or "".
std::string push_formula(lua_State*, Machine&, const std::string& formula);

// A function that a piece of a chart, a block of code or a connection calls; it costs 60 steps.
template <int (*body)(lua_State*, Machine&)>
int of_piece(lua_State* l) {
  charge(l, 60);
  return guarded<body>(l);
}

}  // namespace betwixt::lua
