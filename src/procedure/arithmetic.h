// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What code works with: vectors, colours and orientations, noise, mixing.
#pragma once

#include <lua.hpp>

namespace betwixt::lua {

extern const luaL_Reg arithmetic_functions[];

}  // namespace betwixt::lua
