// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/table_file.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>

#include "base/cancellation.h"
#include "base/counted.h"
#include "base/files.h"
#include "base/names.h"
#include "base/utf8.h"
#include "exchange/table_text.h"

namespace betwixt {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::string shown_name(const std::string& name) { return name.empty() ? "the table" : fmt::format("'{}'", name); }
Error at_place(Place place, std::string message, Hint hint = {}) {
  Error e = fail(ErrorCode::file, std::move(message), std::move(hint));
  e.place = std::move(place);
  return e;
}

bool digits(std::string_view s, std::size_t least, std::size_t most, int& out) {
  if (s.size() < least || s.size() > most) return false;
  out = 0;
  for (const char c : s) {
    if (c < '0' || c > '9') return false;
    out = 10 * out + (c - '0');
  }
  return true;
}

// Days since 1970 of a day of the Gregorian calendar; the algorithm counts years from March.
double days_since_1970(int year, int month, int day) {
  year -= month <= 2;
  const int era = (year >= 0 ? year : year - 399) / 400;
  const int of_era = year - era * 400;
  const int of_year = (153 * (month + (month > 2 ? -3 : 9)) + 2) / 5 + day - 1;
  return era * 146097.0 + of_era * 365 + of_era / 4 - of_era / 100 + of_year - 719468;
}

bool means_nothing(std::string_view s) {
  constexpr std::array<std::string_view, 9> words{"", "NA", "N/A", "n/a", "NaN", "nan", "null", "NULL", "-"};
  return std::find(words.begin(), words.end(), s) != words.end();
}

// Finds the type of a column by all its cells, and reads them.
void settle(TableColumn& column, bool comma) {
  auto& numbers = column.numbers;
  auto& cells = column.cells;
  const auto all = [&](const auto& read) {
    numbers.assign(cells.size(), none);
    bool any = false;
    for (std::size_t r = 0; r < cells.size(); ++r) {
      if (means_nothing(cells[r])) continue;
      if (!read(cells[r], numbers[r])) return false;
      any = true;
    }
    return any;
  };
  Cancellation::check();
  if (all([&](std::string_view s, double& out) { return read_cell_number(s, comma, out); })) {
    column.of = TableColumn::Of::number;
    cells = {};
  } else if (all(read_date)) {
    column.of = TableColumn::Of::date;
  } else {
    column.of = TableColumn::Of::text;
    numbers = {};
  }
}

Status name_columns(Table& t, const std::vector<std::string_view>& titles, const CellReader& reader) {
  std::set<std::string> taken;
  for (std::size_t i = 0; i < titles.size(); ++i) {
    TableColumn column;
    column.name = column_word(titles[i], i + 1);
    if (!taken.insert(column.name).second)
      return at_place(reader.place(i), fmt::format("there are two columns '{}'", column.name),
                      "give each column a name of its own");
    t.columns.push_back(std::move(column));
  }
  return Nothing{};
}

}  // namespace

std::string column_word(std::string_view title, std::size_t place) {
  std::string out, apart(title);
  const auto sign = [](char c) { return static_cast<unsigned char>(c) < 128 && !std::isalnum(c) && c != '_'; };
  std::replace_if(apart.begin(), apart.end(), sign, ' ');
  for (const char c : key_word(apart)) {
    const bool fits = std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    if (fits || (!out.empty() && out.back() != '_')) out += fits ? c : '_';
  }
  if (!out.empty() && !std::isalpha(static_cast<unsigned char>(out[0]))) out.insert(0, "c");
  if (out.size() > 60) out.resize(60);
  while (out.ends_with('_')) out.pop_back();
  return out.empty() ? fmt::format("column{}", place) : out;
}

bool read_date(std::string_view s, double& days) {
  int year = 0, month = 0, day = 1, hour = 0, minute = 0, second = 0;
  if (s.size() < 7 || s[4] != '-' || !digits(s.substr(0, 4), 4, 4, year) || !digits(s.substr(5, 2), 2, 2, month))
    return false;
  if (s.size() > 7 && (s.size() < 10 || s[7] != '-' || !digits(s.substr(8, 2), 2, 2, day))) return false;
  if (s.size() > 10) {
    if (s.ends_with('Z')) s.remove_suffix(1);
    const std::string_view clock = s.substr(11);
    if ((s[10] != 'T' && s[10] != ' ') || clock.size() < 5 || clock[2] != ':' ||
        !digits(clock.substr(0, 2), 2, 2, hour) || !digits(clock.substr(3, 2), 2, 2, minute))
      return false;
    if (clock.size() > 5 && (clock[5] != ':' || !digits(clock.substr(6, 2), 2, 2, second))) return false;
    if (clock.size() > 8 && clock[8] != '.') return false;
  }
  if (month < 1 || month > 12 || day < 1 || day > 31 || hour > 24 || minute > 59 || second > 60) return false;
  return days = days_since_1970(year, month, day) + (hour * 3600 + minute * 60 + second) / 86400.0, true;
}

bool read_cell_number(std::string_view s, bool comma, double& out) {
  if (s.empty()) return false;
  if (s[0] == '+') s.remove_prefix(1);
  const auto whole = [&](std::string_view text) {
    const auto r = fast_float::from_chars(text.data(), text.data() + text.size(), out);
    return r.ec == std::errc{} && r.ptr == text.data() + text.size() && std::isfinite(out);
  };
  if (whole(s)) return true;
  if (s.find(',') == s.npos || s.size() > 60) return false;
  std::string plain(s);
  if (comma) {
    std::erase(plain, '.');
    if (std::count(plain.begin(), plain.end(), ',') != 1) return false;
    std::replace(plain.begin(), plain.end(), ',', '.');
    return whole(plain);
  }
  const std::size_t point = std::min(s.find('.'), s.size()), first = s[0] == '-';
  for (std::size_t i = first; i < s.size(); ++i) {  // groups of three digits
    const bool place = i < point && (point - i) % 4 == 0 && i > first;
    if ((s[i] == ',') != place) return false;
  }
  std::erase(plain, ',');
  return whole(plain);
}

Result<std::shared_ptr<Table>> parse_table(std::string text, const std::string& name) {
  if (const Status sound = sound_table(text, name); !sound) return sound.error();
  const auto out = std::make_shared<Table>();
  Table& t = *out;
  t.file = name, t.text = std::move(text);
  CellReader reader(t.text, name, t.pieces);
  std::vector<std::string_view> cells;
  if (const Status read = reader.row(cells); !read) return read.error();
  if (cells.empty())
    return fail(ErrorCode::file, fmt::format("{} is empty", shown_name(name)),
                "its first line has the names of the columns");
  if (const Status named = name_columns(t, cells, reader); !named) return named.error();
  const auto rows = static_cast<std::size_t>(std::count(t.text.begin(), t.text.end(), '\n')) + 1;
  if (rows > most_table_rows || rows * t.columns.size() > 4 * most_table_rows)
    return fail(ErrorCode::range, fmt::format("{} has more than {} rows or {} cells", shown_name(name), most_table_rows,
                                              4 * most_table_rows));
  for (TableColumn& c : t.columns) c.cells.reserve(rows);
  t.lines.reserve(rows);
  while (reader.more()) {
    if (t.lines.size() % 4096 == 0) Cancellation::check();
    if (const Status read = reader.row(cells); !read) return read.error();
    if (cells.empty()) break;
    if (const Status fits = as_many_cells(reader, cells.size(), t.columns.size()); !fits) return fits.error();
    for (std::size_t i = 0; i < cells.size(); ++i) t.columns[i].cells.push_back(cells[i]);
    t.lines.push_back(static_cast<std::uint32_t>(reader.line()));
  }
  if (t.lines.empty())
    return fail(ErrorCode::file, fmt::format("{} has no rows below its first line", shown_name(name)));
  for (TableColumn& c : t.columns) settle(c, reader.separator() == ';');
  return out;
}

Result<std::shared_ptr<const TableText>> parse_table_text(const std::string& path, FileSource& files,
                                                          std::string_view inside) {
  auto bytes = files.read(path);
  if (!bytes) return bytes.error();
  const std::string name = path.substr(path.rfind('/') + 1);
  auto text =
      ending(path) == "json" ? table_of_json(*bytes, name, inside) : table_of_database(*std::move(bytes), name, inside);
  if (!text) return text.error();
  return std::make_shared<const TableText>(TableText{*std::move(text)});
}

Result<std::string> table_text(const std::string& path, const std::string& name, const std::string& inside) {
  const std::string kind = ending(path);
  if (kind == "json" || kind == "db" || kind == "sqlite" || kind == "sqlite3") {
    const auto text = parsed_table(path, inside);
    if (!text) return text.error();
    return (*text)->text;
  }
  if (!inside.empty()) return fail(ErrorCode::file, fmt::format("'{}' is one table, so it has none inside", name));
  FileContents in = read_contents(path, {});
  if (in.problem == ReadProblem::missing) return no_file(name);
  if (in.problem == ReadProblem::folder) return fail(ErrorCode::file, fmt::format("'{}' is a folder", name));
  if (in.problem != ReadProblem::none) return fail(ErrorCode::file, fmt::format("'{}' cannot be read", name));
  return std::move(in.text);
}

Status as_many_cells(const CellReader& reader, std::size_t cells, std::size_t columns) {
  if (cells == columns) return Nothing{};
  return at_place(reader.place(std::min(cells - 1, columns)),
                  fmt::format("this row has {}, but there are {}", counted(cells, "cell"), counted(columns, "column")),
                  "a cell with a comma in it needs quotation marks");
}

Result<std::shared_ptr<Table>> read_table(const std::string& path, const std::string& name, const std::string& inside) {
  auto text = table_text(path, name, inside);
  if (!text) return text.error();
  return parse_table(*std::move(text), name);
}

}  // namespace betwixt
