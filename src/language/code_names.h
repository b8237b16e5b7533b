// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What code in a script may call by name: what `let` gave, and its place in a pattern.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/quantity.h"

namespace betwixt {

// The names that Lua code uses and nowhere makes itself (local, for, a function's own), each once, in their order.
std::vector<std::string_view> free_names(std::string_view code);
// Whether code on the line that begins there, = "…", speaks of its place in a pattern: i, n, i1 …
bool code_speaks_of_place(const char* at, const char* end);
// What i, n, i1 … are; 0 where the word is none of these, or counts a range that is not there.
std::size_t place_of(std::string_view word, const PatternPlace&);
// A value as code writes it: angles in radians, lengths in metres, times in seconds. Empty for a time that counts
// frames, which is another for a moment than for a length.
std::string write_code(const Let&);

}  // namespace betwixt
