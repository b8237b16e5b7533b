// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tables in files of other programs, as text with commas. This runs in the parser process.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "betwixt/result.h"
#include "exchange/file_source.h"

namespace betwixt {

struct TableText {
  std::string text;  // as parse_table() reads it
};

// Adds a cell in quotation marks.
inline void add_quoted_cell(std::string& out, std::string_view text) {
  out += '"';
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  out += '"';
}

// Reads .json, .sqlite, .sqlite3 and .db. `inside`: see read_table().
// Errors: file, name (nothing inside has this name), range (too large).
Result<std::shared_ptr<const TableText>> parse_table_text(const std::string& path, FileSource&,
                                                          std::string_view inside);
Result<std::string> table_of_json(const std::string& bytes, const std::string& name, std::string_view inside);
Result<std::string> table_of_database(std::string bytes, const std::string& name, std::string_view inside);

}  // namespace betwixt
