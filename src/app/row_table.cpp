// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/row_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/counted.h"
#include "base/files.h"
#include "base/utf8.h"
#include "language/lines.h"

namespace betwixt {
namespace {

constexpr std::size_t most_rows = 1'000'000, most_columns = 10'000;

Error wrong(const std::string& file, int line, int column, ErrorCode code, std::string message, std::string hint = {}) {
  Error e = fail(code, std::move(message), Hint(std::move(hint)));
  e.place = {file, line, column};
  return e;
}

// Tabs in a .tsv; otherwise commas, or semicolons if the first line has them and no comma, as spreadsheets write where
// the comma is the decimal point.
char separator_of(const std::string& path, std::string_view text) {
  if (ending(path) == "tsv" || ending(path) == "tab") return '\t';
  const std::string_view first = text.substr(0, text.find('\n'));
  return first.find(',') == first.npos && first.find(';') != first.npos ? ';' : ',';
}

class RowReader {
 public:
  RowReader(const std::string& file, std::string_view text, char separator)
      : file_(file), text_(text), separator_(separator) {}

  bool at_end() const { return at_ == text_.size(); }

  // Reads a record, which may have line ends in its quotes.
  Result<std::vector<RowTable::Cell>> record() {
    std::vector<RowTable::Cell> cells;
    for (;;) {
      RowTable::Cell cell{{}, line_, column_};
      if (Status s = peek() == '"' ? quoted(cell) : plain(cell); !s) return s.error();
      cells.push_back(std::move(cell));
      if (cells.size() > most_columns)
        return wrong(file_, line_, column_, ErrorCode::range,
                     fmt::format("a table can have at most {} columns", most_columns));
      if (at_end() || peek() != separator_) break;
      step();
    }
    if (peek() == '\r') step();
    if (!at_end()) step();  // the line end
    return cells;
  }

 private:
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void step() {
    const auto byte = static_cast<unsigned char>(text_[at_++]);
    if (byte == '\n')
      ++line_, column_ = 1;
    else if ((byte & 0xC0) != 0x80)
      ++column_;
  }
  bool at_line_end() const {
    return at_end() || peek() == '\n' || (peek() == '\r' && (at_ + 1 == text_.size() || text_[at_ + 1] == '\n'));
  }
  Status plain(RowTable::Cell& cell) {
    for (; !at_line_end() && peek() != separator_; step()) {
      if (peek() == '"')
        return wrong(file_, line_, column_, ErrorCode::syntax,
                     "a quote stands within a cell that does not begin with one",
                     "put the whole cell in quotes, and write this one twice");
      cell.text += peek();
    }
    return Nothing{};
  }
  Status quoted(RowTable::Cell& cell) {
    for (step();; step()) {
      if (at_end())
        return wrong(file_, cell.line, cell.column, ErrorCode::syntax, "the quotes of this cell are never closed");
      if (peek() == '"') {
        step();
        if (peek() != '"' || at_end()) break;
      }
      cell.text += peek();
    }
    if (at_line_end() || peek() == separator_) return Nothing{};
    return wrong(file_, line_, column_, ErrorCode::syntax, "there is more behind the quotes of this cell",
                 "a quote within a cell is written twice");
  }

  const std::string& file_;
  std::string_view text_;
  char separator_;
  std::size_t at_ = 0;
  int line_ = 1, column_ = 1;
};

Status check_names(const RowTable& table) {
  std::set<std::string> seen;
  for (const RowTable::Cell& c : table.columns) {
    if (c.text.empty()) return wrong(table.file, c.line, c.column, ErrorCode::name, "this column has no name");
    if (!seen.insert(c.text).second)
      return wrong(table.file, c.line, c.column, ErrorCode::name, fmt::format("two columns are called '{}'", c.text));
  }
  return Nothing{};
}

}  // namespace

Result<RowTable> rows_of_table(const std::string& path) {
  const Result<std::string> whole = read_whole(path);
  if (!whole) return whole.error();
  std::string_view text = *whole;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (const auto bad = unsound(text)) {
    Error e = bad->why;
    const auto before = text.substr(0, bad->at);
    const auto lines = std::count(before.begin(), before.end(), '\n');
    e.place = {path, static_cast<int>(lines) + 1,
               static_cast<int>(count_characters(before.substr(before.rfind('\n') + 1))) + 1};
    return e;
  }
  RowTable table;
  table.file = path;
  RowReader reader(table.file, text, separator_of(path, text));
  if (reader.at_end()) return wrong(path, 1, 1, ErrorCode::syntax, "the table is empty", "its first row has names");
  auto names = reader.record();
  if (!names) return names.error();
  table.columns = *std::move(names);
  if (Status s = check_names(table); !s) return s.error();
  while (!reader.at_end()) {
    auto row = reader.record();
    if (!row) return row.error();
    const RowTable::Cell& first = row->front();
    if (row->size() == 1 && first.text.empty() && table.columns.size() > 1) continue;  // an empty line
    if (row->size() != table.columns.size()) {
      const RowTable::Cell& at = row->size() > table.columns.size() ? (*row)[table.columns.size()] : row->back();
      return wrong(path, at.line, at.column, ErrorCode::syntax,
                   fmt::format("this row has {}, and the first row names {}", counted(row->size(), "cell"),
                               counted(table.columns.size(), "column")));
    }
    table.rows.push_back(*std::move(row));
    if (table.rows.size() > most_rows)
      return wrong(path, first.line, 1, ErrorCode::range, fmt::format("a table can have at most {} rows", most_rows));
  }
  return table;
}

}  // namespace betwixt
