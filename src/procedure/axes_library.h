// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The tables `axes` and `plot` of code: the pieces of axes, plots and charts are computed by these functions.
#pragma once

#include <lua.hpp>

namespace betwixt::lua {

extern const luaL_Reg axes_functions[];
extern const luaL_Reg plot_functions[];
extern const luaL_Reg chart_functions[];

}  // namespace betwixt::lua
