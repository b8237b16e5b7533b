// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tables of data (`data`): rows of a file with typed columns, as the formulas and `fill` read them. A table never
// changes, so documents share it.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace betwixt {

// A column: numbers if all its cells are numbers, dates if all are dates (2026-11-28, 2026-11, 2026-11-28T20:15), else
// texts. An empty cell has no value.
struct TableColumn {
  enum class Of : std::uint8_t { number, date, text };
  std::string name;  // as formulas write it
  Of of = Of::number;
  std::vector<double> numbers;          // of numbers, and of dates as days since 1970; NaN where there is none
  std::vector<std::string_view> cells;  // of texts and dates; "" where there is none
  bool has(std::size_t row) const { return of == Of::text ? !cells[row].empty() : numbers[row] == numbers[row]; }
};

// Columns that were worked out from others, such as ranks, by how they are asked for. A row without a value has NaN.
class DerivedColumns {
 public:
  using Numbers = std::shared_ptr<const std::vector<double>>;
  template <class Make>
  Numbers get(const std::string& name, const Make& make) const {
    const std::scoped_lock lock(mutex_);
    Numbers& there = made_[name];
    if (!there) there = std::make_shared<const std::vector<double>>(make());
    return there;
  }

 private:
  mutable std::mutex mutex_;
  mutable std::map<std::string, Numbers> made_;
};

struct Table {
  std::string file;     // for messages; "" for a table that the script itself holds
  std::string command;  // what follows `data NAME`, with the path from the first script's folder
  std::vector<TableColumn> columns;
  std::vector<std::uint32_t> lines;      // of the file, for each row
  std::optional<std::size_t> key, over;  // the columns that name the things, and the times
  // The keys in order of appearance, as names of objects; for each row the number of its key; for each key its first
  // row. A table without a key has none of these.
  std::vector<std::string> keys;
  std::vector<std::uint32_t> key_of, first;
  DerivedColumns derived;
  // What the cells are pieces of.
  std::string text;
  std::deque<std::string> pieces;

  std::size_t rows() const { return lines.size(); }
  std::optional<std::size_t> find(std::string_view column) const;
  std::vector<std::string_view> column_names() const;
  std::optional<std::size_t> find_key(std::string_view name) const;
  std::size_t bytes() const;
};
using Tables = std::map<std::string, std::shared_ptr<const Table>, std::less<>>;

// Returns whether the tables have the same names and the same content.
bool same_tables(const Tables&, const Tables&);
// Returns the pattern with the keys of tables in place of their names in braces: bar{pop} is bar{London,Paris}.
std::string with_keys(const Tables&, std::string_view pattern);
// The table that a pattern names in braces; nullptr if it names none.
std::shared_ptr<const Table> table_of(const Tables&, std::string_view pattern);

// A row of a derived column: of all rows with the same time (`over`), or of all rows with the same key in order of
// time. Rows without a number count for nothing and get NaN.
namespace tables {
std::vector<double> ranks(const Table&, std::size_t column, std::optional<std::size_t> over);  // 1 is the largest
std::vector<double> shares(const Table&, std::size_t column, std::optional<std::size_t> over);
std::vector<double> sums_until(const Table&, std::size_t column, std::optional<std::size_t> over);
std::vector<double> changes(const Table&, std::size_t column, std::optional<std::size_t> over);
// The mean of `width` values in a row, the row's own in the middle.
std::vector<double> smoothed(const Table&, std::size_t column, std::optional<std::size_t> over, std::size_t width);
}  // namespace tables

}  // namespace betwixt
