// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Procedures, twerpers, filters and commands that the author writes in Lua.
//
// All code has: numbers, booleans, texts, lists; vec(x, y[, z]), rgb(r, g, b), hsv(h, s, v), euler(x, y, z),
// quat(w, x, y, z), axis(x, y, z, angle) with arithmetic; length dot cross normalize; the functions of math with and
// without "math."; tau pi noise random clamp mix smoothstep; string and table without patterns.
//   value    t, rate, frame, self, ... (its arguments), value(name [, time]), touching(name [, name] [, time]), and
//            every named procedure as a function
//   twerper  u; returns a number
//   filter   t, rate, frame, input([time]), and each parameter by its name, dashes written as underscores
//   command  args and ..., run("line"), value(name, time), objects(pattern)
// A source is an expression, or a chunk that returns a value. If the value is a function, it is called with the
// arguments, u, t, or the words.
//
// A procedure is pure: it keeps nothing from call to call, sees nothing outside, and does not depend on earlier calls.
// It is stopped after 1,000,000 steps, when it holds more than 16 MB, or when it has allocated more than 64 MB. (Lua
// leaves one result undefined: the length # of a list with holes.)
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "track/procedure.h"

namespace betwixt {

Result<std::shared_ptr<const Routine>> make_lua(Role role, std::string source);

// Returns whether the name already has a meaning in every procedure, which would hide a procedure of that name.
bool known_to_lua(std::string_view name);

// Returns why a formula of a plot cannot be used, or "". "x^2 = y" is an equation.
std::string formula_problem(const std::string& formula);

}  // namespace betwixt
