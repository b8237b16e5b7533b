// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The rows of a table for `betwixt render --each`, as texts with their places. The files are those of `data`.
#pragma once

#include <string>
#include <vector>

#include "betwixt/result.h"

namespace betwixt {

struct RowTable {
  struct Cell {
    std::string text;
    int line = 0, column = 0;  // where it begins; columns are counted in characters, from 1
  };
  std::string file;
  std::vector<Cell> columns;            // names
  std::vector<std::vector<Cell>> rows;  // each with a cell for each column
  Place place(const Cell& cell) const { return {file, cell.line, cell.column}; }
};

// Errors: file (unreadable, no UTF-8), syntax, name, range; with their places.
Result<RowTable> rows_of_table(const std::string& path);

}  // namespace betwixt
