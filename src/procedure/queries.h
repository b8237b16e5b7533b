// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Functions by which code asks the program that runs it: values, places, contacts, the input of a filter, other code.
#pragma once

#include <lua.hpp>

namespace betwixt::lua {

extern const luaL_Reg query_functions[];
// Finds a name that is in no table: the frame rate, the number of the frame, a named procedure, or nil.
int find_global(lua_State*);

}  // namespace betwixt::lua
