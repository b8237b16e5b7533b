// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tables of data, and tracks made of them.
#include "commands/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/cancellation.h"
#include "base/counted.h"
#include "base/kept_results.h"
#include "base/names.h"
#include "commands/command.h"
#include "exchange/table_file.h"
#include "language/formula.h"
#include "language/table_formulas.h"
#include "scene/colors.h"
#include "scene/memory.h"

namespace betwixt {
namespace {

constexpr std::size_t most_tables = 1000, most_filled = 10'000'000;

bool name_of_table(Command& k, std::string_view& name) {
  auto& [s, c, time, layer, script] = k;
  name = c.next_word();
  if (name.empty()) return c.fail_here(ErrorCode::syntax, "a name is missing here", "as in data pop from \"pop.csv\"");
  const auto fits = [](char ch) { return std::isalnum(static_cast<unsigned char>(ch)) || ch == '_'; };
  if (!std::isalpha(static_cast<unsigned char>(name[0])) || name.size() > 100 ||
      !std::all_of(name.begin(), name.end(), fits))
    return c.fail(ErrorCode::syntax, fmt::format("'{}' cannot be a name in formulas", name.substr(0, 60)), name,
                  "a name is a letter, then letters, digits and '_'");
  if (is_formula_word(name) || named_color(name) || name == "row")
    return c.fail(ErrorCode::name, fmt::format("'{}' already has a meaning in formulas", name), name);
  if (s.lets->contains(name)) return c.fail(ErrorCode::name, fmt::format("'let {}' already exists", name), name);
  if (s.tables->contains(name) && !script.live)
    return c.fail(ErrorCode::name, fmt::format("'data {}' already exists", name), name);
  return s.tables->size() < most_tables ||
         c.fail(ErrorCode::range, fmt::format("a script can have at most {} tables", most_tables), name);
}

// Takes a name of a column.
std::string_view column_name(Cursor& c) {
  c.space();
  const char* const start = c.at;
  while (c.at < c.end && (is_letter(*c.at) || is_digit(*c.at) || *c.at == '_')) ++c.at;
  return c.since(start);
}

// Reads COLUMN OPERATOR VALUE, as in people>1000000.
bool condition(Cursor& c, TableCondition& out) {
  using Is = TableCondition::Is;
  static constexpr std::pair<std::string_view, Is> operators[] = {{"!=", Is::unequal},  {"<=", Is::at_most},
                                                                  {">=", Is::at_least}, {"<", Is::less},
                                                                  {">", Is::more},      {"=", Is::equal}};
  out.at = column_name(c);
  out.column = out.at;
  if (out.at.empty())
    return c.fail_here(ErrorCode::syntax, "the name of a column is missing here", "as in where people>1000");
  c.space();
  const auto* is = std::find_if(std::begin(operators), std::end(operators),
                                [&](const auto& one) { return between(c.at, c.end).starts_with(one.first); });
  if (is == std::end(operators))
    return c.fail_here(ErrorCode::syntax, "a comparison is missing here", "write =, !=, <, <=, > or >=");
  c.at += is->first.size(), out.is = is->second;
  c.space();
  if (c.peek() == '"') return c.text(out.value);
  const char* const start = c.at;
  while (c.at < c.end && *c.at != ' ' && *c.at != '\t' && *c.at != '\n' && *c.at != '\r') ++c.at;
  out.value = c.since(start);
  return !out.value.empty() || c.fail_here(ErrorCode::syntax, "a value is missing here");
}

// Reads key=COLUMN over=COLUMN sort=[-]COLUMN first=NUMBER inside="TABLE", where COLUMN OPERATOR VALUE.
bool order_of_table(Cursor& c, TableOrder& out, std::string& inside) {
  while (!c.at_line_end()) {
    if (c.accept_word("where")) {
      if (!condition(c, out.conditions.emplace_back())) return false;
      continue;
    }
    const std::string_view key = column_name(c);
    const auto known = {"key", "over", "sort", "first", "inside"};
    if (std::find(known.begin(), known.end(), key) == known.end())
      return no_choice(c, key.empty() ? c.next_word() : key, "expected key= over= sort= first= inside= or where here",
                       did_you_mean(key, {"key", "over", "sort", "first", "inside", "where"}));
    if (!c.accept('=')) return c.fail_here(ErrorCode::syntax, fmt::format("'=' is missing after {}", key));
    if (key == "inside") {
      c.space();
      if (!c.text(inside)) return false;
    } else if (key == "first") {
      long first = 0;
      if (!c.whole_number(1, 1'000'000'000, "the number of the first ones", first)) return false;
      out.first = static_cast<std::size_t>(first);
    } else {
      const bool falling = key == "sort" && c.accept('-');
      const std::string_view name = column_name(c);
      if (name.empty()) return c.fail_here(ErrorCode::syntax, "the name of a column is missing here");
      if (key == "key") out.key = out.key_at = name;
      if (key == "over") out.over = out.over_at = name;
      if (key == "sort") out.sort = out.sort_at = name, out.falling = falling;
    }
  }
  return true;
}

// Returns the piece of the words behind `data NAME` that a script says again, with another path.
std::string said_again(std::string_view words, std::string_view path_at, const std::string& path) {
  if (path_at.empty()) return std::string(words);
  const auto at = static_cast<std::size_t>(path_at.data() - words.data());
  return std::string(words.substr(0, at)) + write_text(path) + std::string(words.substr(at + path_at.size()));
}

// Moves the place in a table to the message, because the error is about the line of the script.
Error with_place_in_table(Error e) {
  const auto [file, line, column, length] = e.place;
  if (line > 0)
    e.message = fmt::format("line {}, column {} of {}: {}", line, column,
                            file.empty() ? "the table" : fmt::format("'{}'", file), e.message);
  return e;
}

bool data(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::string_view name;
  if (!name_of_table(k, name)) return false;
  c.space();
  const char* const words = c.at;
  const std::string_view way = c.next_word();
  if (way != "from" && way != "of")
    return no_choice(c, way, "from and a file, or of and a text, is missing here", "as in data pop from \"pop.csv\"");
  c.space();
  const char* const start = c.at;
  std::string text;
  if (!c.text(text)) return false;
  const std::string_view text_at = c.since(start);
  TableOrder order;
  std::string inside;
  if (!order_of_table(c, order, inside)) return false;
  std::filesystem::path where;
  const bool file = way == "from";
  if (file && !may_use(k, text, text_at, where)) return false;
  const std::string command = said_again(c.since(words), file ? text_at : std::string_view(), text);
  std::shared_ptr<const Table> table;
  if (const auto read = s.tables_read->find(command); read != s.tables_read->end()) {
    table = read->second;
  } else {
    std::string_view about;
    const auto make = [&]() -> Result<std::shared_ptr<const Table>> {
      const auto made = file ? read_table(where.string(), text, inside) : parse_table(text, "");
      if (!made) return made.error();
      (*made)->command = command;
      if (const Status done = put_in_order(**made, order, about); !done) return done.error();
      return std::shared_ptr<const Table>(*made);
    };
    const auto read_once = KeptResults::get("table", where.string() + '\0' + command, make);
    if (!read_once) return c.fail(with_place_in_table(read_once.error()), about.empty() ? text_at : about);
    table = *read_once;
    ContentBytes bytes;
    bytes.add(table);
    if (!has_room(k, bytes, text_at)) return false;
    s.tables_read.edit()[command] = table;
  }
  s.tables.edit()[std::string(name)] = std::move(table);
  return true;
}

// ---- fill

// The object that gets the rows of a key; without a key all rows.
struct Filled {
  Selected of;
  std::optional<std::size_t> key;
};

// Returns the part of a name that stands for the key: between the pieces of the pattern before and behind its * or {…}.
std::optional<std::size_t> key_in_name(const Table& t, std::string_view pattern, std::string_view name) {
  const std::size_t from = pattern.find_first_of("*?[{"), until = pattern.find_last_of("*?]}");
  if (from == pattern.npos || until == pattern.npos) return std::nullopt;
  const std::string_view before = pattern.substr(0, from), behind = pattern.substr(until + 1);
  if (name.size() < before.size() + behind.size() || !name.starts_with(before) || !name.ends_with(behind))
    return std::nullopt;
  return t.find_key(name.substr(before.size(), name.size() - before.size() - behind.size()));
}

// Finds the key of each object that the pattern names, and says which objects have none.
bool objects_of_keys(Command& k, const Table& t, const Selected& on, std::vector<Filled>& out) {
  const std::string_view pattern = on.text.substr(0, first_dot(on.text));
  std::vector<Target> none;
  std::unordered_map<std::uint32_t, std::size_t> known;
  for (const Target& target : on.targets) {
    Filled one{{{target}, on.spec, on.component, on.text, on.velocity}, {}};
    if (!t.key) {
      out.push_back(std::move(one));
      continue;
    }
    const std::string& name = k.scene.objects[target.object.index].name;
    one.key = key_in_name(t, pattern, name);
    if (!one.key && on.targets.size() == 1 && t.keys.size() == 1) one.key = 0;
    if (!one.key) {
      none.push_back(target);
    } else {
      out.push_back(std::move(one));
    }
  }
  if (!out.empty() && !none.empty()) say_left_out(k, none, on.text, "no key of the table has their names");
  if (!out.empty() || on.targets.empty()) return true;
  return k.cursor.fail(ErrorCode::name, fmt::format("no key of the table is in the names of '{}'", pattern), on.text,
                       fmt::format("write a * or {{TABLE}} for the key; the first key is {}", t.keys[0]));
}

// The times of rows: those of the column, stretched so that the first is at `from` and the last at `until`.
struct RowTimes {
  double low = 0, high = 0;
  Time from, until;
  bool seconds = false;  // the column counts the seconds of the film
  Time at(double v) const {
    if (seconds) return from_seconds(v);
    const double share = high > low ? (v - low) / (high - low) : 0;
    return from + Time{std::llround(share * static_cast<double>((until - from).flicks))};
  }
};

bool row_times(Command& k, const Table& t, std::size_t over, std::string_view about, RowTimes& out) {
  Cursor& c = k.cursor;
  const TableColumn& column = t.columns[over];
  out.low = HUGE_VAL, out.high = -HUGE_VAL;
  for (const double v : column.numbers)
    if (!std::isnan(v)) out.low = std::min(out.low, v), out.high = std::max(out.high, v);
  c.space();
  const char* const start = c.at;
  if (starts_like_time(c.peek()) || formula_begins(c)) {
    std::optional<Time> until;
    if (!time_or_segment(c, out.from, until)) return false;
    if (!until)
      return c.fail(ErrorCode::syntax, "expected a segment here, from the time of the first row to that of the last",
                    c.since(start), "as in 1f..480f");
    return out.until = *until, true;
  }
  out.seconds = true;
  if (column.of == TableColumn::Of::date)
    return c.fail(ErrorCode::syntax, "dates need a segment of the film", about,
                  fmt::format("as in over {} 1f..480f", column.name));
  return std::max(std::abs(out.low), std::abs(out.high)) < longest_seconds ||
         c.fail(ErrorCode::range, fmt::format("'{}' has times that are too far away", column.name), about);
}

// Returns the rows of each key that have a time, in order of time.
std::vector<std::vector<std::uint32_t>> rows_of_keys(const Table& t, std::size_t over) {
  std::vector<std::vector<std::uint32_t>> rows(std::max<std::size_t>(1, t.keys.size()));
  const auto& times = t.columns[over].numbers;
  for (std::uint32_t r = 0; r < t.rows(); ++r)
    if (!std::isnan(times[r])) rows[t.key ? t.key_of[r] : 0].push_back(r);
  for (auto& one : rows) std::stable_sort(one.begin(), one.end(), [&](auto a, auto b) { return times[a] < times[b]; });
  return rows;
}

bool once_each_time(Command& k, const Table& t, std::size_t over, const std::vector<std::uint32_t>& rows,
                    std::string_view about) {
  const auto& times = t.columns[over].numbers;
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (times[rows[i]] == times[rows[i - 1]])
      return k.cursor.fail(ErrorCode::file,
                           fmt::format("lines {} and {} of {} are for one {}{}", t.lines[rows[i - 1]], t.lines[rows[i]],
                                       t.file.empty() ? "the table" : fmt::format("'{}'", t.file), t.columns[over].name,
                                       t.key ? fmt::format(" of '{}'", t.keys[t.key_of[rows[i]]]) : std::string()),
                           about, t.key ? "" : "a table of several things needs key=COLUMN");
  return true;
}

struct Filling {
  Command& k;
  const Table& table;
  std::size_t over;
  const char* value_at;
  RowTimes times;
  Event way;  // the twerper of each event
  std::string_view about;
  std::size_t made = 0;

  // Adds an event for each row that has a value.
  bool rows(const Filled& one, const std::vector<std::uint32_t>& of) {
    Cursor& c = k.cursor;
    const Target& target = one.of.targets[0];
    for (const std::uint32_t r : of) {
      Cancellation::check();
      c.place.row = r, c.at = value_at, c.cell_missing = false;
      Event e = way;
      e.time = times.at(table.columns[over].numbers[r]);
      if (!values(k).value(*one.of.spec, one.of.component, e.value, target.function)) return false;
      if (c.cell_missing) continue;
      if (++made > most_filled)
        return c.fail(ErrorCode::range, fmt::format("fill can make at most {} events", most_filled), about);
      if (!put_row(k, one.of, std::move(e), about)) return false;
    }
    return true;
  }
};

bool fill(Command& k) {
  auto& [s, c, time, layer, script] = k;
  const char* const verb = script.verb;
  Selected on;
  if (!targets(k, c.next_word(), on) || !alike(k, on)) return false;
  if (!c.accept_word("from"))
    return c.fail_here(ErrorCode::syntax, "from and a value are missing here",
                       "as in fill bar*.size.x from pop.people over year 1f..480f");
  c.space();
  const char* const value_at = c.at;
  auto table = first_table(*s.tables, value_at, c.end);
  if (!table) table = table_of(*s.tables, on.text);
  if (!table)
    return c.fail_here(ErrorCode::name, "the value names no table",
                       s.tables->empty() ? "read one first, as in data pop from \"pop.csv\" key=city"
                                         : fmt::format("as in {}.{}", s.tables->begin()->first,
                                                       s.tables->begin()->second->columns.back().name));
  const PatternPlace before = c.place;
  struct Back {  // on every way out
    Cursor& c;
    const PatternPlace place;
    ~Back() { c.place = place, c.cell_missing = false; }
  } const back{c, before};
  c.place.table = table.get(), c.place.over = table->over, c.place.skips = true;
  // The rest of the line is read with the first row.
  Value first;
  if (!on.targets.empty() && !values(k).value(*on.spec, on.component, first, on.targets[0].function)) return false;
  const std::string_view about = c.since(value_at);
  if (on.targets.empty()) return pass_over(k, c.at);
  if (!c.accept_word("over"))
    return c.fail_here(ErrorCode::syntax, "over and the column of the times are missing here",
                       "as in over year 1f..480f");
  c.space();
  const char* const column_at = c.at;
  std::string_view column = column_name(c);
  if (c.peek() == '.') ++c.at, column = column_name(c);  // pop.year
  const std::string_view over_at = c.since(column_at);
  const auto over = table->find(column);
  if (!over)
    return c.fail(ErrorCode::name, fmt::format("the table has no column '{}'", column), over_at,
                  did_you_mean(column, table->column_names()));
  if (table->columns[*over].of == TableColumn::Of::text)
    return c.fail(no_times(*table, table->columns[*over], column), over_at);
  c.place.over = *over;
  Filling f{k, *table, *over, value_at, {}, {}, about};
  if (!row_times(k, *table, *over, over_at, f.times) || !betwixt::way(k, on, f.way) || !finish(c)) return false;
  const char* const end = c.at;
  std::vector<Filled> all;
  if (!objects_of_keys(k, *table, on, all)) return false;
  const auto rows = rows_of_keys(*table, *over);
  for (const auto& one : rows)
    if (!once_each_time(k, *table, *over, one, over_at)) return false;
  Rollback rollback(s);
  for (const Filled& one : all)
    if (!f.rows(one, rows[one.key.value_or(0)])) return false;
  rollback.keep();
  script.verb = verb;
  return c.at = end, true;
}

constexpr Verb tables_rows[] = {
    {"data",
     "data NAME from \"FILE\" or of \"TEXT\" [key=COLUMN] [over=COLUMN] [where COLUMN>VALUE] [sort=COLUMN] "
     "[first=NUMBER] [inside=\"TABLE\"]",
     "Reads a table: .csv, .tsv, .json or SQLite. `key` is the column that names the things: `create bar{NAME} …` "
     "makes "
     "an object for each. In formulas `row.COLUMN` is the cell of the object's first row, `NAME.COLUMN[2]` that of the "
     "second key. "
     "`where` keeps only some rows, `sort=-COLUMN` sorts from the largest, and `first` keeps the first keys. `inside` "
     "is "
     "a table of a database, or a query.",
     "data pop of \"city,people\\nBern,134000\\nChur,38000\" key=city\ncreate b{pop} box size=(1 row.people/1e5 1) "
     "position=(2*i 0 0)",
     Verb::makes_let, data, "NEW; from of; FILE; key= over= where sort= first= inside=…"},
    {"fill", "fill TARGET from VALUE over COLUMN [A..B] [TWERPER]",
     "Makes an event of each row of a table. VALUE names columns, as in pop.people/1000. The rows of each key go to "
     "the "
     "object that has the key in its name. COLUMN has the times: its first is at A and its last at B, or it counts the "
     "seconds of the film. A row with an empty cell makes no event.",
     "data pop of \"city,year,people\\nBern,1990,1\\nBern,2000,3\\nChur,1990,2\\nChur,2000,1\" key=city\ncreate "
     "bar{pop} box\n"
     "fill bar*.size.y from pop.people over year 1f..48f linear",
     Verb::layered, fill, "TARGET; from; COLUMN; over; COLUMN; NUMBER; WAY"},
};

}  // namespace

std::span<const Verb> tables_verbs() { return tables_rows; }

}  // namespace betwixt
