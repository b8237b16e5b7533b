// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The tables `axes`, `plot`, `chart`, `block`, `link` and `mark` of code: these functions compute the pieces of axes,
// plots, charts, blocks of code and connections.
#pragma once

#include <lua.hpp>

namespace betwixt::lua {

extern const luaL_Reg axes_functions[];
extern const luaL_Reg plot_functions[];
extern const luaL_Reg chart_functions[];
extern const luaL_Reg code_functions[];
extern const luaL_Reg link_functions[];
extern const luaL_Reg mark_functions[];

}  // namespace betwixt::lua
