// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/table_cells.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/utf8.h"

namespace betwixt {
namespace {

constexpr std::size_t most_cells_in_row = 10'000;

// Returns the place behind a text that begins at a line.
Place place_behind(std::string_view before, std::size_t line, const std::string& name) {
  const std::size_t start = before.rfind('\n');
  return {name, static_cast<int>(line) + static_cast<int>(std::count(before.begin(), before.end(), '\n')),
          static_cast<int>(count_characters(before.substr(start == before.npos ? 0 : start + 1))) + 1};
}

std::string_view without_blanks(std::string_view s) {
  while (!s.empty() && (s.front() == ' ' || s.front() == '\t')) s.remove_prefix(1);
  while (!s.empty() && (s.back() == ' ' || s.back() == '\t')) s.remove_suffix(1);
  return s;
}

}  // namespace

Status sound_table(std::string& text, const std::string& name) {
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  const auto wrong = [&](std::size_t at, std::string message, Hint hint = {}) {
    Error e = fail(ErrorCode::file, std::move(message), std::move(hint));
    e.place = place_behind(std::string_view(text).substr(0, at), 1, name);
    return e;
  };
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    return wrong(0, "this is UTF-16, not UTF-8", "save it as UTF-8");
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '\0') return wrong(i, "a zero byte: this is no table");
    const std::size_t n = static_cast<unsigned char>(text[i]) < 0x80 ? 1 : character_length(text, i);
    if (n == 0) return wrong(i, "this is not UTF-8", "save it as UTF-8; it may be in Latin-1 or Windows-1252 now");
    i += n;
  }
  return Nothing{};
}

CellReader::CellReader(std::string_view text, const std::string& name, std::deque<std::string>& pieces)
    : end_(text.data() + text.size()), at_(text.data()), name_(name), pieces_(pieces) {
  const std::string_view first = text.substr(0, text.find_first_of("\r\n"));
  for (const char c : {';', '\t'})
    if (std::count(first.begin(), first.end(), c) > std::count(first.begin(), first.end(), separator_)) separator_ = c;
}

Error CellReader::wrong(const char* at, std::string message, Hint hint) const {
  Error e = fail(ErrorCode::file, std::move(message), std::move(hint));
  e.place = place_behind({row_, static_cast<std::size_t>(at - row_)}, row_line_, name_);
  return e;
}

Place CellReader::place(std::size_t cell) const { return place_behind({row_, starts_[cell]}, row_line_, name_); }

Status CellReader::row(std::vector<std::string_view>& cells) {
  do {
    cells.clear(), starts_.clear();
    row_ = at_, row_line_ = line_;
    for (bool ends = false; !ends;) {
      starts_.push_back(static_cast<std::uint32_t>(at_ - row_));
      if (cells.size() == most_cells_in_row) {
        Error e = wrong(at_, fmt::format("a table can have at most {} columns", most_cells_in_row));
        e.code = ErrorCode::range;
        return e;
      }
      if (const Status read = cell(cells.emplace_back()); !read) return read;
      ends = at_ == end_ || *at_ != separator_;
      if (at_ == end_) break;
      if (ends && *at_ == '\r' && at_ + 1 < end_ && at_[1] == '\n') ++at_;
      line_ += ends;
      ++at_;
    }
  } while (cells.size() == 1 && cells[0].empty() && more());
  if (cells.size() == 1 && cells[0].empty()) cells.clear();
  return Nothing{};
}

Status CellReader::cell(std::string_view& out) {
  if (at_ < end_ && *at_ == '"') return quoted(out);
  const char* const start = at_;
  for (; at_ < end_ && *at_ != separator_ && *at_ != '\n' && *at_ != '\r'; ++at_)
    if (*at_ == '"')
      return wrong(at_, "a quotation mark in a cell that does not begin with one",
                   "put the whole cell in quotation marks, and write this one twice");
  out = without_blanks({start, static_cast<std::size_t>(at_ - start)});
  return Nothing{};
}

// "He said ""no"""
Status CellReader::quoted(std::string_view& out) {
  const char *const opened = at_, *const start = ++at_, *copied = start;
  std::string* piece = nullptr;
  for (;; ++at_) {
    if (at_ == end_) return wrong(opened, "this quotation mark is never closed");
    line_ += *at_ == '\n';
    if (*at_ != '"') continue;
    if (at_ + 1 == end_ || at_[1] != '"') break;
    if (!piece) piece = &pieces_.emplace_back();
    piece->append(copied, ++at_), copied = at_ + 1;  // one of the two
  }
  out = {start, static_cast<std::size_t>(at_ - start)};
  if (piece) out = piece->append(copied, at_);
  ++at_;
  while (at_ < end_ && *at_ == ' ') ++at_;
  if (at_ == end_ || *at_ == separator_ || *at_ == '\n' || *at_ == '\r') return Nothing{};
  return wrong(at_, "there is more behind the closing quotation mark of this cell",
               "inside quotation marks, write \"\" for one \"");
}

}  // namespace betwixt
