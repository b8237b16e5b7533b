// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Cells and columns of tables in formulas: row.people, pop.people, pop.people[3], sum(pop.people), rank(pop.people).
#pragma once

#include <optional>
#include <string_view>

#include "language/cursor.h"
#include "scene/quantity.h"

namespace betwixt {

// Returns whether a cell or a column begins here: `row.` or the name of a table and a dot.
bool cell_begins(const Cursor&, const char* at);
inline bool cell_begins(const Cursor& c) { return cell_begins(c, c.at); }
// Reads it. If the cell of the place's row is empty, sets Cursor::cell_missing and reads 0 or "".
// Errors: name (no such column), type (a whole column), range (a wrong index, or an empty cell of another row).
bool cell(Cursor&, LetItem& out);
// Fails if the cell is a text. `said`: the cell in the line.
bool is_number_cell(Cursor&, const LetItem&, std::string_view said);
// Returns whether the function takes a column, and one follows: rank(pop.people). The cursor is behind the name.
bool column_function_begins(const Cursor&, std::string_view function);
bool column_function(Cursor&, std::string_view function, Quantity& out);
// Reads a whole column as a list: the cell of each key's first row, or of each row if the table has no key.
// Returns false without an error, and takes nothing, if no column is here.
bool column_list(Cursor&, LetList& out);
// Returns the table that a formula names first; nullptr if it names none.
std::shared_ptr<const Table> first_table(const Tables&, const char* at, const char* end);
// The words of the functions that only columns have.
std::vector<std::string_view> column_function_words();

}  // namespace betwixt
