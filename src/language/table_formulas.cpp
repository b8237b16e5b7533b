// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "language/table_formulas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/names.h"
#include "base/utf8.h"
#include "language/formula.h"
#include "language/values.h"
#include "syntax/characters.h"
#include "syntax/words.h"

namespace betwixt {
namespace {

bool goes_on(char c) { return is_letter(c) || is_digit(c) || c == '_'; }
std::string_view word_here(const char* at, const char* end) {
  const char* p = at;
  while (p < end && goes_on(*p)) ++p;
  return {at, static_cast<std::size_t>(p - at)};
}

// A column as it is written.
struct Said {
  std::string_view table, column, whole;  // `table` may be "row"
  const Table* of = nullptr;
  std::size_t number = 0;
};

bool said_column(Cursor& c, Said& out) {
  const char* const start = c.at;
  out.table = word_here(c.at, c.end);
  c.at += out.table.size() + 1;
  out.column = word_here(c.at, c.end);
  c.at += out.column.size();
  out.whole = c.since(start);
  if (out.table == "row") {
    out.of = c.place.table;
    if (!out.of)
      return c.fail(ErrorCode::name, "there is no row here", out.whole,
                    "name the table in the pattern, as in create bar{pop} rectangle");
  } else {
    out.of = c.tables->find(out.table)->second.get();
  }
  if (const auto number = out.of->find(out.column)) return out.number = *number, true;
  Hint hint = did_you_mean(out.column, out.of->column_names());
  if (hint.empty()) {
    const auto names = out.of->column_names();
    const auto some = std::min<std::size_t>(names.size(), 12);
    hint = fmt::format("its columns are {}{}", fmt::join(names.begin(), names.begin() + static_cast<long>(some), " "),
                       names.size() > some ? " …" : "");
  }
  const std::string_view name = out.table == "row" ? "the table" : out.table;
  return c.fail(ErrorCode::name,
                out.column.empty()
                    ? "the name of a column is missing here"
                    : fmt::format("{} has no column '{}'",
                                  name == "the table" ? std::string(name) : fmt::format("'{}'", name), out.column),
                out.column.empty() ? out.whole : out.column, std::move(hint));
}

LetItem item(const TableColumn& column, std::size_t row) {
  if (column.of == TableColumn::Of::number) return Quantity{Quantity::Of::number, column.numbers[row], 0, false};
  return Text(std::string(column.cells[row]));
}

std::string place_in(const Table& t, std::size_t row) {
  return t.file.empty() ? fmt::format("line {} of the table", t.lines[row])
                        : fmt::format("line {} of '{}'", t.lines[row], t.file);
}

bool nothing_there(Cursor& c, const Said& said, std::size_t row) {
  if (c.place.skips && said.of == c.place.table && row == c.place.row) return c.cell_missing = true;
  return c.fail(ErrorCode::range, fmt::format("{} has no {}", place_in(*said.of, row), said.column), said.whole);
}

// Reads [3], which counts keys, or rows if the table has no key.
bool index_here(Cursor& c, const Said& said, std::size_t& row) {
  const std::size_t count = said.of->keys.empty() ? said.of->rows() : said.of->keys.size();
  const char* const start = c.at++;
  Quantity q;
  c.space();
  if (!formula(c, q)) return false;
  c.space();
  if (c.peek() != ']') return c.fail_here(ErrorCode::syntax, "a closing bracket ']' is missing here");
  ++c.at;
  if (q.of != Quantity::Of::number || !(q.value >= 1 && q.value <= static_cast<double>(count)) ||
      q.value != std::floor(q.value))
    return c.fail(ErrorCode::range,
                  fmt::format("'{}' has {} {}, counted from 1; there is no {}[{}]", said.table, count,
                              said.of->keys.empty() ? "rows" : "keys", said.whole, write_quantity(q)),
                  c.since(start));
  const auto number = static_cast<std::size_t>(q.value) - 1;
  return row = said.of->keys.empty() ? number : said.of->first[number], true;
}

// Returns whether the cell is what makes its column one of texts.
bool no_number(std::string_view cell) {
  Cursor c(cell);
  double ignored = 0;
  return !cell.empty() && !(c.literal(ignored) && c.at == c.end);
}

// Reports that the column is no numbers, with the first cell that is none.
bool text_column(Cursor& c, const Said& said) {
  const auto& cells = said.of->columns[said.number].cells;
  const auto word = std::find_if(cells.begin(), cells.end(), no_number);
  if (word == cells.end()) return c.fail(ErrorCode::type, fmt::format("'{}' is no number", said.whole), said.whole);
  const auto row = static_cast<std::size_t>(word - cells.begin());
  return c.fail(ErrorCode::type,
                fmt::format("'{}' is a column of texts: {} has '{}'", said.whole, place_in(*said.of, row),
                            first_characters(*word, 40)),
                said.whole);
}

enum class Gives : std::uint8_t { total, row };
struct ColumnFunction {
  std::string_view name;
  Gives gives;
  bool also_of_numbers;  // a function of plain numbers has the same name
  std::vector<double> (*of)(const Table&, std::size_t column, std::optional<std::size_t> over, std::size_t width);
};
template <class F>
std::vector<double> total(const Table& t, std::size_t column, double from, const F& f) {
  double out = from;
  std::size_t n = 0;
  for (const double v : t.columns[column].numbers)
    if (!std::isnan(v)) out = f(out, v), ++n;
  return {out, static_cast<double>(n)};
}
using Over = std::optional<std::size_t>;
constexpr ColumnFunction column_functions[] = {
    {"min", Gives::total, true,
     [](const Table& t, std::size_t column, Over, std::size_t) {
       return total(t, column, HUGE_VAL, [](double a, double b) { return std::min(a, b); });
     }},
    {"max", Gives::total, true,
     [](const Table& t, std::size_t column, Over, std::size_t) {
       return total(t, column, -HUGE_VAL, [](double a, double b) { return std::max(a, b); });
     }},
    {"sum", Gives::total, false,
     [](const Table& t, std::size_t column, Over, std::size_t) { return total(t, column, 0, std::plus<>()); }},
    {"mean", Gives::total, false,
     [](const Table& t, std::size_t column, Over, std::size_t) {
       const auto sum = total(t, column, 0, std::plus<>());
       return std::vector<double>{sum[0] / sum[1]};
     }},
    {"count", Gives::total, false,
     [](const Table& t, std::size_t column, Over, std::size_t) {
       double n = 0;
       for (std::size_t r = 0; r < t.rows(); ++r) n += t.columns[column].has(r);
       return std::vector<double>{n};
     }},
    {"rank", Gives::row, false,
     [](const Table& t, std::size_t column, Over over, std::size_t) { return tables::ranks(t, column, over); }},
    {"share", Gives::row, false,
     [](const Table& t, std::size_t column, Over over, std::size_t) { return tables::shares(t, column, over); }},
    {"cumulative", Gives::row, false,
     [](const Table& t, std::size_t column, Over over, std::size_t) { return tables::sums_until(t, column, over); }},
    {"change", Gives::row, false,
     [](const Table& t, std::size_t column, Over over, std::size_t) { return tables::changes(t, column, over); }},
    {"smooth", Gives::row, false,
     [](const Table& t, std::size_t column, Over over, std::size_t width) {
       return tables::smoothed(t, column, over, width);
     }},
};
const ColumnFunction* find_column_function(std::string_view name) {
  const auto* f = std::find_if(std::begin(column_functions), std::end(column_functions),
                               [&](const ColumnFunction& one) { return one.name == name; });
  return f == std::end(column_functions) ? nullptr : f;
}

}  // namespace

bool cell_begins(const Cursor& c, const char* at) {
  if (!c.tables || c.tables->empty()) return false;
  const std::string_view name = word_here(at, c.end);
  const char* const behind = name.data() + name.size();
  return !name.empty() && behind < c.end && *behind == '.' && (name == "row" || c.tables->contains(name));
}

bool cell(Cursor& c, LetItem& out) {
  Said said;
  if (!said_column(c, said)) return false;
  const TableColumn& column = said.of->columns[said.number];
  std::size_t row = c.place.row;
  if (c.peek() == '[') {
    if (!index_here(c, said, row)) return false;
  } else if (said.of != c.place.table) {
    return c.fail(ErrorCode::type, fmt::format("'{}' is a whole column", said.whole), said.whole,
                  fmt::format("{0}[1] is its first value, row.{1} that of each object of a pattern with {{{2}}}",
                              said.whole, said.column, said.table));
  }
  out = column.of == TableColumn::Of::number ? LetItem(Quantity{}) : LetItem(Text(std::string()));
  if (!column.has(row)) return nothing_there(c, said, row);
  return out = item(column, row), true;
}

bool is_number_cell(Cursor& c, const LetItem& item, std::string_view whole) {
  if (!std::holds_alternative<Text>(item)) return true;
  Cursor again = c;
  again.at = whole.data();
  Said said;
  return said_column(again, said) && text_column(c, said);
}

bool column_function_begins(const Cursor& c, std::string_view function) {
  if (!find_column_function(function) || c.peek() != '(') return false;
  Cursor ahead = c;
  ++ahead.at, ++ahead.depth;
  ahead.space();
  if (!cell_begins(ahead)) return false;
  const auto* f = find_column_function(function);
  if (!f->also_of_numbers) return true;
  Said said;  // max(pop.people) is that of the column, max(row.a row.b) that of two numbers
  return said_column(ahead, said) && said.table != "row" && (ahead.space(), ahead.peek() == ')');
}

bool column_function(Cursor& c, std::string_view function, Quantity& out) {
  const ColumnFunction& f = *find_column_function(function);
  if (!c.open()) return false;
  c.space();
  Said said;
  if (!said_column(c, said)) return false;
  c.space();
  double width = 3;
  if (f.name == "smooth" && c.peek() != ')' && !c.number(width)) return false;
  if (!c.close()) return false;
  const std::string_view about(function.data(), static_cast<std::size_t>(c.at - function.data()));
  if (!(width >= 1 && width <= 1e6) || width != std::floor(width))
    return c.fail(ErrorCode::range, "smooth needs a whole number of values, from 1", about,
                  "as in smooth(pop.people 5)");
  const Table& t = *said.of;
  if (t.columns[said.number].of == TableColumn::Of::text && f.name != "count") return text_column(c, said);
  if (f.gives == Gives::row && c.place.table != &t)
    return c.fail(ErrorCode::type, fmt::format("{} needs a row of '{}'", f.name, said.table), about,
                  "write it in fill, or in a command on a pattern that has the table in braces");
  const std::optional<std::size_t> over = c.place.table == &t && c.place.over ? c.place.over : t.over;
  const auto numbers = t.derived.get(fmt::format("{} {} {} {}", f.name, said.number, over ? *over + 1 : 0, width),
                                     [&] { return f.of(t, said.number, over, static_cast<std::size_t>(width)); });
  const double value = (*numbers)[f.gives == Gives::row ? c.place.row : 0];
  out = {Quantity::Of::number, std::isnan(value) ? 0 : value, 0, false};
  if (!std::isnan(value)) return true;
  if (f.gives == Gives::row && c.place.skips) return c.cell_missing = true;
  if (f.gives == Gives::row)
    return c.fail(ErrorCode::range, fmt::format("{} has no {}", place_in(t, c.place.row), about), about);
  return c.fail(ErrorCode::range, fmt::format("'{}' has no values", said.whole), said.whole);
}

bool column_list(Cursor& c, LetList& out) {
  c.space();
  if (!cell_begins(c) || word_here(c.at, c.end) == "row") return false;
  Cursor ahead = c;
  Said said;
  if (said_column(ahead, said) && (ahead.peek() == '[' || said.of == c.place.table)) return false;
  c.at = ahead.at;
  if (ahead.error) return c.error = ahead.error, c.where = ahead.where, false;
  const Table& t = *said.of;
  const TableColumn& column = t.columns[said.number];
  const std::size_t count = t.keys.empty() ? t.rows() : t.keys.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t row = t.keys.empty() ? i : t.first[i];
    if (!column.has(row))
      return c.fail(ErrorCode::range, fmt::format("{} has no {}", place_in(t, row), said.column), said.whole);
    out.push_back(item(column, row));
  }
  return true;
}

std::shared_ptr<const Table> first_table(const Tables& all, const char* at, const char* end) {
  std::shared_ptr<const Table> found;
  for (const char* const stop = line_end(at, end); at < stop && !found;) {
    const std::string_view word = word_here(at, stop);
    const char* const behind = at + word.size();
    if (!word.empty() && behind < stop && *behind == '.')
      if (const auto known = all.find(word); known != all.end()) found = known->second;
    at = std::max(behind, at + 1);
  }
  return found;
}

std::vector<std::string_view> column_function_words() {
  std::vector<std::string_view> words;
  for (const ColumnFunction& f : column_functions) words.push_back(f.name);
  return words;
}

}  // namespace betwixt
