// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Basic functions for code: vectors, colours, orientations, noise, mixing.
#pragma once

#include <lua.hpp>

namespace betwixt::lua {

extern const luaL_Reg arithmetic_functions[];

}  // namespace betwixt::lua
