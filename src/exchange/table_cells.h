// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The cells of a text with commas, semicolons or tabs between them (RFC 4180), row by row.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/result.h"

namespace betwixt {

// Removes the byte order mark. Fails with the place if the text is not UTF-8. `name`: of the file; may be "".
Status sound_table(std::string& text, const std::string& name);

class CellReader {
 public:
  // `pieces` receives the cells that are not pieces of the text. `text` and `pieces` must outlive the cells.
  CellReader(std::string_view text, const std::string& name, std::deque<std::string>& pieces);

  bool more() const { return at_ < end_; }
  char separator() const { return separator_; }  // the one that the first line has most of
  // Reads the next row that is not empty; there may be none. Errors have the place: file (a quotation mark that is
  // never closed, or inside a cell), range (more than 10,000 cells).
  Status row(std::vector<std::string_view>& cells);
  // Of that row: its first line, from 1, and the place of a cell.
  std::size_t line() const { return row_line_; }
  Place place(std::size_t cell) const;

 private:
  Status cell(std::string_view& out);
  Status quoted(std::string_view& out);
  Error wrong(const char* at, std::string message, Hint hint = {}) const;

  const char* const end_;
  const char* at_;
  const std::string name_;
  std::deque<std::string>& pieces_;
  char separator_ = ',';
  std::size_t line_ = 1, row_line_ = 1;
  std::vector<std::uint32_t> starts_;  // of the row's cells, from the beginning of the row
  const char* row_ = at_;
};

}  // namespace betwixt
