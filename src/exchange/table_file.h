// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tables from texts with commas, semicolons or tabs between the cells (RFC 4180), and from the files that other
// programs write.
#pragma once

#include <memory>
#include <string>

#include "betwixt/result.h"
#include "exchange/table_cells.h"
#include "scene/table.h"

namespace betwixt {

struct TableText;  // exchange/table_text.h

inline constexpr std::size_t most_table_rows = 50'000'000;

// Returns the text of a table in a file; see read_table().
Result<std::string> table_text(const std::string& path, const std::string& name, const std::string& inside);
// Fails, with the place, unless a row has as many cells as there are columns.
Status as_many_cells(const CellReader&, std::size_t cells, std::size_t columns);

// Reads a text whose first row has the names of the columns. The cells are separated by the character that its first
// line has most of: a comma, a semicolon or a tab. `name` is that of the file, for messages.
// Errors: file (no UTF-8, ragged rows, a quotation mark that is not closed, two columns of one name), range (too
// large); most with the place in the table.
Result<std::shared_ptr<Table>> parse_table(std::string text, const std::string& name);
// Reads a file: .csv .tsv .txt, .json (a list of objects, or an object of lists), .sqlite .db (see `inside`).
// `inside`: the name of a table of a database, or a query that begins with `select`; "" for its only table.
// Errors: those, and file (missing or unreadable).
Result<std::shared_ptr<Table>> read_table(const std::string& path, const std::string& name, const std::string& inside);

// Reads it in a process of its own: it was not written by us. (foreign.cpp)
Result<std::shared_ptr<const TableText>> parsed_table(const std::string& path, const std::string& inside);

// Returns a column's name as formulas write it: letters, digits and _. `place` counts from 1.
std::string column_word(std::string_view title, std::size_t place);
// Reads a date such as 2026-11-28, 2026-11 or 2026-11-28T20:15:30, as days since 1970.
bool read_date(std::string_view, double& days);
// Reads a cell that is a number, such as 12, -1.5e3 or 1,234,567; with `comma`, 3,5 is three and a half.
bool read_cell_number(std::string_view, bool comma, double& out);

}  // namespace betwixt
