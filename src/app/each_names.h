// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The names of the films of a table, and the columns that a script uses.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "app/row_table.h"

namespace betwixt {

// Returns the columns that have the names of lets. Errors: name, if there are none.
Result<std::vector<std::size_t>> columns_for(const RowTable&, const std::set<std::string>& lets,
                                             const std::string& script);
// Returns the name of each row's film: `pattern` with the cells in place of {COLUMN}, and the number of the row in
// place of {row}. Errors (with their places): name (an unknown column, two films of one name, an empty name).
Result<std::vector<std::string>> film_names(const RowTable&, const std::string& pattern);

}  // namespace betwixt
