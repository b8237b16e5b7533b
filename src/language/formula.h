// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Formulas are allowed wherever a number, an angle, a length or a time is. They have no blanks outside their own
// brackets, so that (1 -2) stays two numbers. They consist of numbers, units, constants, functions (with the same names
// as in code) and names made by `let`.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "language/cursor.h"
#include "scene/quantity.h"

namespace betwixt {

// Returns whether a formula that is more than a number with a unit begins here: a name, a function, a bracket, or a
// sign before these.
bool formula_begins(const Cursor&);
// Returns whether a formula continues after a number: with an operator and an operand.
bool formula_goes_on(const char* at, const char* end);
// Reads a formula. Errors: syntax; name (with a similar name as hint); type (incompatible units); range (not finite, or
// nested deeper than 100).
bool formula(Cursor&, Quantity& out);

// Takes a name made by `let`, with an index for a list, r[i], and returns its value. Returns nullopt and takes nothing
// if there is no such name, if its value is a list, or if a formula continues (v.x, 2*v). A wrong index is an error of
// the cursor.
std::optional<LetItem> let_here(Cursor&);
// Reads a word that names one thing: plain; with a formula of the command's place in braces, rocket{i}; or with a list
// in braces that pairs with the command's pattern, {1..59}. Errors: syntax, name, type, range.
bool one_name(Cursor&, std::string_view word, std::string& out);

// Returns whether the line that begins there mentions its place in a pattern: i, n, i1 … outside quoted texts.
bool speaks_of_place(const char* at, const char* end);
// Returns "did you mean 'beat'?" for names made by `let`, or "" if none is similar.
Hint near_name(const Cursor&, std::string_view word);
// Returns whether the line has braces outside texts and targets. The names that they list pair with those of the
// pattern.
bool writes_out_names(std::string_view line);
// Returns whether the word is built into formulas.
bool is_formula_word(std::string_view);
// Sets `out` to the value of the name. Returns false if it is a list.
bool single(const Let&, LetItem& out);
std::string write_quantity(const Quantity&);  // reads back to the same value
std::string write_let(const LetItem&);
std::string write_let(const Let&);
// Returns a phrase such as "an angle".
std::string_view to_string(Quantity::Of);

}  // namespace betwixt
