// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Procedures, twerpers, filters and commands that the author writes in Lua.
//
// What every one has: numbers, booleans, texts, lists; vec(x, y[, z]), rgb(r, g, b), hsv(h, s, v), euler(x, y, z),
// quat(w, x, y, z), axis(x, y, z, angle) with arithmetic; length dot cross normalize; the functions of math with and
// without "math."; tau pi noise random clamp mix smoothstep; string and table without patterns.
//   value    t, rate, frame, self, ... (what it is called with), value(name [, time]), touching(name [, name] [,
//   time]), and every
//            named procedure as a function
//   twerper  u; gives a number
//   filter   t, rate, frame, input([time]), and each parameter by its name, dashes written as underscores
//   command  args and ..., run("line"), value(name, time), objects(pattern)
// A source is an expression, or a chunk that returns; where what it gives is a function, that is called (with
// the arguments or t; u; t; the words).
//
// Nothing survives a call, nothing outside is seen, and nothing depends on what ran before: a procedure is pure. It is
// stopped after 1,000,000 steps, when it holds more than 16 MB or has asked for more than 64 MB. (One thing is not
// fixed by Lua: the length # of a list with holes.)
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "track/procedure.h"

namespace betwixt {

Result<std::shared_ptr<const Routine>> make_lua(Role role, std::string source);

// A name that means something in every procedure already, so that no procedure's name is heard there.
bool known_to_lua(std::string_view name);

}  // namespace betwixt
