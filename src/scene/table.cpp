// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/cancellation.h"

namespace betwixt {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// The table's name in braces, and where the braces are.
struct BracedTable {
  std::size_t open = 0, close = 0;
  std::shared_ptr<const Table> table;
};
std::optional<BracedTable> braced_table(const Tables& all, std::string_view pattern, std::size_t from = 0) {
  for (std::size_t open; !all.empty() && (open = pattern.find('{', from)) != pattern.npos; from = open + 1) {
    const std::size_t close = pattern.find_first_of("{}", open + 1);
    if (close == pattern.npos || pattern[close] != '}') continue;
    const auto found = all.find(pattern.substr(open + 1, close - open - 1));
    if (found != all.end() && !found->second->keys.empty()) return BracedTable{open, close, found->second};
  }
  return std::nullopt;
}

using Rows = std::vector<std::uint32_t>;
double order_of(const Table& t, std::optional<std::size_t> over, std::uint32_t row) {
  return over && t.columns[*over].of != TableColumn::Of::text ? t.columns[*over].numbers[row] : 0;
}
// All rows with a number in the column, sorted by something, and then as they come.
template <class Before>
Rows sorted_rows(const Table& t, std::size_t column, const Before& before) {
  Rows rows;
  rows.reserve(t.rows());
  for (std::uint32_t r = 0; r < t.rows(); ++r)
    if (!std::isnan(t.columns[column].numbers[r])) rows.push_back(r);
  std::stable_sort(rows.begin(), rows.end(), [&](std::uint32_t a, std::uint32_t b) {
    Cancellation::check();
    return before(a, b);
  });
  return rows;
}
// Calls f(first, last) for each run of rows that belong together.
template <class Same, class F>
void each_run(const Rows& rows, const Same& same, const F& f) {
  for (auto first = rows.begin(); first != rows.end();) {
    auto last = first + 1;
    while (last != rows.end() && same(*first, *last)) ++last;
    f(first, last);
    first = last;
  }
}
// Calls f(first, last) for the rows of each time.
template <class F>
void each_time(const Table& t, std::size_t column, std::optional<std::size_t> over, const F& f) {
  const auto at = [&](std::uint32_t r) { return order_of(t, over, r); };
  each_run(
      sorted_rows(t, column, [&](auto a, auto b) { return at(a) < at(b); }),
      [&](auto a, auto b) { return at(a) == at(b); }, f);
}
// Calls f(first, last) for the rows of each key, in order of time.
template <class F>
void each_key(const Table& t, std::size_t column, std::optional<std::size_t> over, const F& f) {
  const auto key = [&](std::uint32_t r) { return t.key_of.empty() ? 0 : t.key_of[r]; };
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    return key(a) != key(b) ? key(a) < key(b) : order_of(t, over, a) < order_of(t, over, b);
  };
  each_run(
      sorted_rows(t, column, before), [&](auto a, auto b) { return key(a) == key(b); }, f);
}

}  // namespace

std::optional<std::size_t> Table::find(std::string_view column) const {
  const auto it = std::find_if(columns.begin(), columns.end(), [&](const auto& c) { return c.name == column; });
  return it == columns.end() ? std::nullopt : std::optional(static_cast<std::size_t>(it - columns.begin()));
}

std::vector<std::string_view> Table::column_names() const {
  std::vector<std::string_view> names;
  for (const TableColumn& c : columns) names.push_back(c.name);
  return names;
}

std::optional<std::size_t> Table::find_key(std::string_view name) const {
  const auto it = std::find(keys.begin(), keys.end(), name);
  return it == keys.end() ? std::nullopt : std::optional(static_cast<std::size_t>(it - keys.begin()));
}

std::size_t Table::bytes() const {
  std::size_t sum = text.size() + 4 * (lines.size() + key_of.size() + first.size());
  for (const TableColumn& c : columns) sum += 8 * c.numbers.size() + sizeof(std::string_view) * c.cells.size();
  for (const std::string& piece : pieces) sum += sizeof piece + piece.size();
  for (const std::string& name : keys) sum += sizeof name + name.size();
  return sum;
}

bool same_tables(const Tables& a, const Tables& b) {
  const auto same = [](const auto& x, const auto& y) {
    return x.first == y.first &&
           (x.second == y.second || (x.second->text == y.second->text && x.second->lines == y.second->lines &&
                                     x.second->keys == y.second->keys));
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

std::string with_keys(const Tables& all, std::string_view pattern) {
  std::string out(pattern);
  std::size_t from = 0;
  while (const auto braced = braced_table(all, out, from)) {
    std::string names;
    for (const std::string& key : braced->table->keys) names += (names.empty() ? "" : ",") + key;
    out.replace(braced->open + 1, braced->close - braced->open - 1, names);
    from = braced->open + names.size() + 2;
  }
  return out;
}

std::shared_ptr<const Table> table_of(const Tables& all, std::string_view pattern) {
  const auto braced = braced_table(all, pattern);
  return braced ? braced->table : nullptr;
}

namespace tables {

std::vector<double> ranks(const Table& t, std::size_t column, std::optional<std::size_t> over) {
  const auto& numbers = t.columns[column].numbers;
  std::vector<double> out(t.rows(), none);
  each_time(t, column, over, [&](auto first, auto last) {
    Rows rows(first, last);
    std::stable_sort(rows.begin(), rows.end(), [&](auto a, auto b) { return numbers[a] > numbers[b]; });
    for (std::size_t i = 0; i < rows.size(); ++i) out[rows[i]] = static_cast<double>(i + 1);
  });
  return out;
}

std::vector<double> shares(const Table& t, std::size_t column, std::optional<std::size_t> over) {
  const auto& numbers = t.columns[column].numbers;
  std::vector<double> out(t.rows(), none);
  each_time(t, column, over, [&](auto first, auto last) {
    double sum = 0;
    for (auto r = first; r != last; ++r) sum += numbers[*r];
    for (auto r = first; r != last && sum != 0; ++r) out[*r] = numbers[*r] / sum;
  });
  return out;
}

std::vector<double> sums_until(const Table& t, std::size_t column, std::optional<std::size_t> over) {
  std::vector<double> out(t.rows(), none);
  each_key(t, column, over, [&](auto first, auto last) {
    double sum = 0;
    for (auto r = first; r != last; ++r) out[*r] = sum += t.columns[column].numbers[*r];
  });
  return out;
}

std::vector<double> changes(const Table& t, std::size_t column, std::optional<std::size_t> over) {
  const auto& numbers = t.columns[column].numbers;
  std::vector<double> out(t.rows(), none);
  each_key(t, column, over, [&](auto first, auto last) {
    for (auto r = first + 1; r < last; ++r) out[*r] = numbers[*r] - numbers[*(r - 1)];
  });
  return out;
}

std::vector<double> smoothed(const Table& t, std::size_t column, std::optional<std::size_t> over, std::size_t width) {
  const auto& numbers = t.columns[column].numbers;
  std::vector<double> out(t.rows(), none);
  const auto before = static_cast<std::ptrdiff_t>((width - 1) / 2), behind = static_cast<std::ptrdiff_t>(width / 2);
  each_key(t, column, over, [&](auto first, auto last) {
    for (auto r = first; r != last; ++r) {
      const auto from = r - std::min(before, r - first), until = r + std::min(behind, last - 1 - r) + 1;
      double sum = 0;
      for (auto one = from; one != until; ++one) sum += numbers[*one];
      out[*r] = sum / static_cast<double>(until - from);
    }
  });
  return out;
}

}  // namespace tables

}  // namespace betwixt
