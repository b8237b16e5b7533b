// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Formulas: they stand wherever a number, an angle, a length or a time may. No blanks outside their own brackets, so
// that (1 -2) stays two numbers. Numbers, units, constants, functions (those of code, by the same names) and names that
// `let` gave.
#pragma once

#include <string>
#include <string_view>

#include "language/cursor.h"
#include "scene/quantity.h"

namespace betwixt {

// Whether one begins here that is more than a number with a unit: a name, a function, a bracket, a sign before these.
bool formula_begins(const Cursor&);
// Whether one goes on behind a number: an operator, and what it may be applied to.
bool formula_goes_on(const char* at, const char* end);
// Reads one. Errors: syntax; name (with a near miss); type (units that do not fit); range (not finite, nested deeper
// than 100).
bool formula(Cursor&, Quantity& out);

// Whether the line that begins there speaks of its place in a pattern: i, n, i1 … outside texts in quotes.
bool speaks_of_place(const char* at, const char* end);
// "did you mean 'beat'?", of what `let` gave; empty where nothing is near.
std::string near_name(const Cursor&, std::string_view word);
// Whether formulas know the word without a `let`.
bool is_formula_word(std::string_view);
std::string write_quantity(const Quantity&);  // reads back to the same
std::string write_let(const Let&);
// "an angle"
std::string_view to_string(Quantity::Of);

}  // namespace betwixt
