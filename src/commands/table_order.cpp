// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <unordered_map>

#include "base/cancellation.h"
#include "base/names.h"
#include "base/utf8.h"
#include "commands/tables.h"
#include "exchange/table_file.h"
#include "language/values.h"

namespace betwixt {
namespace {

using Rows = std::vector<std::uint32_t>;

std::string in_file(const Table& t) { return t.file.empty() ? "the table" : fmt::format("'{}'", t.file); }

Result<std::size_t> column(const Table& t, const std::string& name) {
  if (const auto found = t.find(name)) return *found;
  Hint hint = did_you_mean(name, t.column_names());
  if (hint.empty()) hint = fmt::format("its columns are {}", fmt::join(t.column_names(), " ")).substr(0, 400);
  return fail(ErrorCode::name, fmt::format("{} has no column '{}'", in_file(t), name), std::move(hint));
}

template <class T>
bool fits(TableCondition::Is is, const T& a, const T& b) {
  using Is = TableCondition::Is;
  switch (is) {
    case Is::equal:
      return a == b;
    case Is::unequal:
      return !(a == b);
    case Is::less:
      return a < b;
    case Is::at_most:
      return !(b < a);
    case Is::more:
      return b < a;
    default:
      return !(a < b);
  }
}

// Keeps the rows that fit a condition. A row without a cell fits only `unequal`.
Status keep_fitting(const Table& t, const TableCondition& one, Rows& rows) {
  const auto number = column(t, one.column);
  if (!number) return number.error();
  const TableColumn& c = t.columns[*number];
  double wanted = 0;
  const bool read = c.of == TableColumn::Of::number ? read_cell_number(one.value, false, wanted)
                    : c.of == TableColumn::Of::date ? read_date(one.value, wanted)
                                                    : true;
  if (!read)
    return fail(ErrorCode::type,
                fmt::format("'{}' is a column of {}, so it cannot be compared with '{}'", c.name,
                            c.of == TableColumn::Of::date ? "dates" : "numbers", first_characters(one.value, 40)));
  std::erase_if(rows, [&](std::uint32_t r) {
    if (!c.has(r)) return one.is != TableCondition::Is::unequal;
    return c.of == TableColumn::Of::text ? !fits(one.is, c.cells[r], std::string_view(one.value))
                                         : !fits(one.is, c.numbers[r], wanted);
  });
  return Nothing{};
}

void sort_rows(const Table& t, std::size_t number, bool falling, Rows& rows) {
  const TableColumn& c = t.columns[number];
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    Cancellation::check();
    if (!c.has(a) || !c.has(b)) return c.has(a) && !c.has(b);  // rows without a cell are the last
    if (falling) std::swap(a, b);
    return c.of == TableColumn::Of::text ? natural_less(c.cells[a], c.cells[b]) : c.numbers[a] < c.numbers[b];
  };
  std::stable_sort(rows.begin(), rows.end(), before);
}

// Leaves only these rows in the table, in this order.
void take_rows(Table& t, const Rows& rows) {
  const auto take = [&](auto& of) {
    if (of.empty()) return;
    std::remove_reference_t<decltype(of)> out;
    out.reserve(rows.size());
    for (const std::uint32_t r : rows) out.push_back(of[r]);
    of = std::move(out);
  };
  take(t.lines);
  for (TableColumn& c : t.columns) take(c.numbers), take(c.cells);
}

// Finds the keys, as names: what cannot be in a name is left out, and a name that is taken gets a number.
Status find_keys(Table& t) {
  const TableColumn& c = t.columns[*t.key];
  std::unordered_map<std::string_view, std::uint32_t> of_text;
  std::unordered_map<double, std::uint32_t> of_number;
  std::set<std::string, std::less<>> taken;
  t.key_of.resize(t.rows());
  for (std::uint32_t r = 0; r < t.rows(); ++r) {
    if (r % 4096 == 0) Cancellation::check();
    if (!c.has(r))
      return fail(ErrorCode::file, fmt::format("line {} of {} has no {}", t.lines[r], in_file(t), c.name),
                  "every row needs a key");
    const auto next = static_cast<std::uint32_t>(t.keys.size());
    const bool number = c.of == TableColumn::Of::number;
    const std::uint32_t key = number ? of_number.try_emplace(c.numbers[r], next).first->second
                                     : of_text.try_emplace(c.cells[r], next).first->second;
    t.key_of[r] = key;
    if (key < next) continue;
    std::string name = key_word(number ? write_number(c.numbers[r]) : c.cells[r]);
    if (name.size() > 200) name.resize(200);
    if (name.empty()) name = std::to_string(next + 1);
    if (taken.contains(name)) {
      int again = 2;
      while (taken.contains(fmt::format("{}-{}", name, again))) ++again;
      name += fmt::format("-{}", again);
    }
    taken.insert(name);
    t.keys.push_back(std::move(name)), t.first.push_back(r);
  }
  return Nothing{};
}

void take_first_keys(Table& t, std::size_t count) {
  if (count >= t.keys.size()) return;
  Rows rows;
  for (std::uint32_t r = 0; r < t.rows(); ++r)
    if (t.key_of[r] < count) rows.push_back(r);
  std::vector<std::uint32_t> key_of;
  for (const std::uint32_t r : rows) key_of.push_back(t.key_of[r]);
  take_rows(t, rows);
  t.key_of = std::move(key_of), t.keys.resize(count), t.first.assign(count, 0);
  for (std::uint32_t r = static_cast<std::uint32_t>(t.rows()); r-- > 0;) t.first[t.key_of[r]] = r;
}

}  // namespace

Status put_in_order(Table& t, const TableOrder& order, std::string_view& about) {
  Rows rows(t.rows());
  std::iota(rows.begin(), rows.end(), 0u);
  const auto find = [&](const std::string& name, std::string_view at, std::optional<std::size_t>& out) -> Status {
    about = at;
    if (name.empty()) return Nothing{};
    const auto found = column(t, name);
    if (!found) return found.error();
    out = *found;
    return Nothing{};
  };
  for (const TableCondition& one : order.conditions) {
    about = one.at;
    if (const Status kept = keep_fitting(t, one, rows); !kept) return kept;
  }
  std::optional<std::size_t> sort;
  if (const Status found = find(order.sort, order.sort_at, sort); !found) return found;
  if (sort) sort_rows(t, *sort, order.falling, rows);
  if (const Status found = find(order.over, order.over_at, t.over); !found) return found;
  if (t.over && t.columns[*t.over].of == TableColumn::Of::text) return no_times(t, t.columns[*t.over], order.over);
  if (const Status found = find(order.key, order.key_at, t.key); !found) return found;
  if (!t.key && order.first > 0 && order.first < rows.size()) rows.resize(order.first);
  if (rows.size() < t.rows() || sort) take_rows(t, rows);
  about = {};
  if (t.rows() == 0) return fail(ErrorCode::range, fmt::format("no row of {} is left", in_file(t)));
  if (!t.key) return Nothing{};
  about = order.key_at;
  if (const Status found = find_keys(t); !found) return found;
  if (order.first > 0) take_first_keys(t, order.first);
  return Nothing{};
}

Error no_times(const Table& t, const TableColumn& column, std::string_view said) {
  Hint hint("times are numbers such as 1990, or dates such as 1990-07-31");
  double ignored = 0;
  const bool dates = std::any_of(column.cells.begin(), column.cells.end(),
                                 [&](std::string_view cell) { return read_date(cell, ignored); });
  for (std::size_t row = 0; row < t.rows(); ++row) {
    const std::string_view cell = column.cells[row];
    if (cell.empty() || (dates ? read_date(cell, ignored) : read_cell_number(cell, false, ignored))) continue;
    hint = Hint(fmt::format("'{}' in line {} is no {}", visible(first_characters(cell, 40)), t.lines[row],
                            dates ? "date; as in 1990-07-31" : "number and no date"));
    break;
  }
  return fail(ErrorCode::type, fmt::format("'{}' is a column of texts, not of times", said), std::move(hint));
}

}  // namespace betwixt
