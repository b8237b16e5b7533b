// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt algebra --symbols: the matrix of a motion in symbols.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/algebra.h"
#include "app/command.h"
#include "base/json.h"
#include "betwixt/symbols.h"

namespace betwixt::algebra_command {
namespace {

using Row = std::vector<std::string>;

// Returns the rows of the matrix, in the plane or in space.
std::vector<Row> rows_of(const Symbols& symbols, bool planar) {
  std::vector<Row> rows;
  const std::size_t count = planar ? 2 : 3;
  for (std::size_t r = 0; r < count; ++r) {
    rows.emplace_back();
    for (std::size_t c = 0; c < 4; ++c)
      if (!planar || c != 2) rows.back().push_back(to_string(symbols.sums[4 * r + c], symbols));
  }
  return rows;
}

template <class Range, class Write>
std::string json_array(const Range& range, Write write) {
  std::string out = "[";
  for (const auto& x : range) out += (out.size() > 1 ? "," : "") + write(x);
  return out + "]";
}

void print_json(const Motion& motion, const Symbols& symbols, const std::vector<Row>& rows) {
  const auto letter = [&](const Symbol& s) {
    return fmt::format("{{\"name\":{},\"factor\":{},\"means\":{}}}", json_text(s.name), s.factor + 1,
                       json_text(meaning_of(s, motion)));
  };
  fmt::print(
      "{{\"motion\":{},\"matrix\":{},\"letters\":{}}}\n", json_text(to_string(motion)),
      json_array(rows, [](const Row& row) { return json_array(row, [](const auto& s) { return json_text(s); }); }),
      json_array(symbols.letters, letter));
}

void print_text(const Motion& motion, const Symbols& symbols, const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows[0].size());
  for (const Row& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c) line += fmt::format("  {:<{}}", row[c], widths[c]);
    line.erase(line.find_last_not_of(' ') + 1);
    fmt::print("{}\n", line);
  }
  const char* before = "\n";
  for (const Symbol& s : symbols.letters)
    fmt::print("{}  {} = {}\n", std::exchange(before, ""), s.name, meaning_of(s, motion));
}

}  // namespace

int show_symbols(const Call& call, const Asked& asked) {
  const auto symbols = in_symbols(asked.motion);
  if (!symbols) return complain(symbols.error(), wrong_input);
  const std::vector<Row> rows = rows_of(*symbols, is_planar(asked.motion));
  (call.json ? print_json : print_text)(asked.motion, *symbols, rows);
  return all_done;
}

}  // namespace betwixt::algebra_command
