// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Formulas: they stand wherever a number, an angle, a length or a time may. No blanks outside their own brackets, so
// that (1 -2) stays two numbers. Numbers, units, constants, functions (those of code, by the same names) and names that
// `let` gave.
#pragma once

#include <optional>
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

// What the name that stands here means, where `let` gave it: its value, or with an index behind it that one of a list,
// r[i]. It is taken then. None: no such name stands here, what it means is a list or goes on (v.x, 2*v), or the index
// is wrong, which is the cursor's error then.
std::optional<LetItem> let_here(Cursor&);
// A word that names one thing: as it stands, or with braces that say which one it is for the place that the command is
// about, rocket{i}, or that are gone through together with its pattern, {1..59}. Errors: syntax, name, type, range.
bool one_name(Cursor&, std::string_view word, std::string& out);

// Whether the line that begins there speaks of its place in a pattern: i, n, i1 … outside texts in quotes.
bool speaks_of_place(const char* at, const char* end);
// "did you mean 'beat'?", of what `let` gave; empty where nothing is near.
std::string near_name(const Cursor&, std::string_view word);
// Whether braces stand on the line outside texts and targets: what they write out goes one for one with the pattern.
bool writes_out_names(std::string_view line);
// Whether formulas know the word without a `let`.
bool is_formula_word(std::string_view);
std::string write_quantity(const Quantity&);  // reads back to the same
std::string write_let(const LetItem&);
std::string write_let(const Let&);
// "an angle"
std::string_view to_string(Quantity::Of);

}  // namespace betwixt
