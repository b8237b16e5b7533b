// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Fuzzes the readers of tables: texts with commas, semicolons or tabs, and JSON if the first byte is j.
#include <cstdint>
#include <string>

#include "exchange/table_file.h"
#include "exchange/table_text.h"
#include "fuzz.h"

using namespace betwixt;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const Slow slow;
  std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const bool json = data[0] == 'j';
  if (json) {
    auto made = table_of_json(text, "a.json", "");
    if (!made) {
      insist(!made.error().message.empty(), "an error has words", text);
      return slow.verdict();
    }
    text = *std::move(made);
  }
  const auto table = parse_table(text, json ? "a.json" : "a.csv");
  if (!table) {
    insist(!table.error().message.empty(), "an error has words", text);
    return slow.verdict();
  }
  for (const TableColumn& column : (*table)->columns) {
    insist(!column.name.empty() && column.name == column_word(column.name, 1), "a column has a name for formulas",
           text);
    const bool numbers = column.of != TableColumn::Of::text, cells = column.of != TableColumn::Of::number;
    insist(!numbers || column.numbers.size() == (*table)->rows(), "a column has a number for each row", text);
    insist(!cells || column.cells.size() == (*table)->rows(), "a column has a cell for each row", text);
  }
  return slow.verdict();
}
