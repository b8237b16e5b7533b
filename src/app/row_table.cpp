// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/row_table.h"

#include <fmt/format.h>

#include <set>

#include "exchange/table_file.h"

namespace betwixt {
namespace {

constexpr std::size_t most_rows = 1'000'000;

Error wrong(const RowTable& table, const RowTable::Cell& cell, ErrorCode code, std::string message, Hint hint = {}) {
  Error e = fail(code, std::move(message), std::move(hint));
  e.place = table.place(cell);
  return e;
}

// Reads the cells of the next row, with their places. There are none at the end.
Result<std::vector<RowTable::Cell>> next_row(CellReader& reader) {
  std::vector<std::string_view> cells;
  if (const Status read = reader.row(cells); !read) return read.error();
  std::vector<RowTable::Cell> out;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Place at = reader.place(i);
    out.push_back({std::string(cells[i]), at.line, at.column});
  }
  return out;
}

Status check_names(const RowTable& table) {
  std::set<std::string> seen;
  for (const RowTable::Cell& c : table.columns) {
    if (c.text.empty()) return wrong(table, c, ErrorCode::name, "this column has no name");
    if (!seen.insert(c.text).second)
      return wrong(table, c, ErrorCode::name, fmt::format("two columns are called '{}'", c.text));
  }
  return Nothing{};
}

}  // namespace

Result<RowTable> rows_of_table(const std::string& path) {
  auto text = table_text(path, path, "");
  if (!text) return text.error();
  if (const Status sound = sound_table(*text, path); !sound) return sound.error();
  RowTable table;
  table.file = path;
  std::deque<std::string> pieces;
  CellReader reader(*text, path, pieces);
  auto names = next_row(reader);
  if (!names) return names.error();
  table.columns = *std::move(names);
  if (table.columns.empty())
    return wrong(table, {{}, 1, 1}, ErrorCode::syntax, "the table is empty", "its first row has names");
  if (Status s = check_names(table); !s) return s.error();
  while (reader.more()) {
    auto row = next_row(reader);
    if (!row) return row.error();
    if (row->empty()) break;
    if (const Status fits = as_many_cells(reader, row->size(), table.columns.size()); !fits) return fits.error();
    table.rows.push_back(*std::move(row));
    if (table.rows.size() > most_rows)
      return wrong(table, table.rows.back().front(), ErrorCode::range,
                   fmt::format("a table can have at most {} rows", most_rows));
  }
  return table;
}

}  // namespace betwixt
