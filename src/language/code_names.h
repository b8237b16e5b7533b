// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The names that code in a script may use: names made by `let`, and the code's place in a pattern.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/quantity.h"

namespace betwixt {

// Returns the names that Lua code uses but does not define (as local, by for, or as a parameter), each once, in order.
std::vector<std::string_view> free_names(std::string_view code);
// Returns a formula with the values of names instead of the names, except those that formulas themselves or code have.
std::string with_values(const std::string& formula, const Lets*, const PatternPlace&);
// Returns the quoted texts of Lua code, as they are written.
std::vector<std::string> quoted_texts(std::string_view code);
// Returns whether code on the line that begins there, = "…", mentions its place in a pattern: i, n, i1 …; or the
// formula of a plot does, p*.of "…", which a row of a sheet has without its name.
bool code_speaks_of_place(const char* at, const char* end, bool formula = false);
// Returns the value of i, n, i1 …, or 0 if the word is none of these or counts a range that does not exist.
std::size_t place_of(std::string_view word, const PatternPlace&);
// Writes a value as code: angles in radians, lengths in metres, times in seconds. Returns "" for a time in frames,
// whose meaning differs between a moment and a duration.
std::string write_code(const Let&);

}  // namespace betwixt
