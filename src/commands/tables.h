// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What `data` says of a table besides its file, and how a table is put in that order.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "betwixt/result.h"
#include "scene/table.h"

namespace betwixt {

// A condition: where people>1000000.
struct TableCondition {
  enum class Is : std::uint8_t { equal, unequal, less, at_most, more, at_least } is = Is::equal;
  std::string column, value;
  std::string_view at;  // of the column, in the line
};
struct TableOrder {
  std::string key, over, sort;
  bool falling = false;   // sort=-people
  std::size_t first = 0;  // the number of keys, or of rows without a key; 0: all
  std::string_view key_at, over_at, sort_at;
  std::vector<TableCondition> conditions;
};

// Chooses and sorts the rows, and finds the keys. `about` receives the piece of the line that an error is about.
// Errors: name (no such column), type (texts as times), file (a key without a cell; two rows for a key and a time).
Status put_in_order(Table&, const TableOrder&, std::string_view& about);
// Returns the error that a column has no times, with the first cell that is none.
Error no_times(const Table&, const TableColumn&, std::string_view said);

}  // namespace betwixt
