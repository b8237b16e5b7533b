// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/each_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

#include "base/names.h"
#include "base/utf8.h"

namespace betwixt {
namespace {

constexpr std::size_t most_bytes = 200;  // file systems take 255

// A piece of the pattern: a text, or a column.
struct NamePiece {
  std::string text;
  std::optional<std::size_t> column;
  bool number = false;  // of the row
};

Error at_header(const RowTable& table, std::string message, Hint hint) {
  Error e = fail(ErrorCode::name, std::move(message), std::move(hint));
  e.place = table.place(table.columns.front());
  return e;
}

std::vector<std::string_view> names_of(const RowTable& table) {
  std::vector<std::string_view> all;
  for (const RowTable::Cell& c : table.columns) all.push_back(c.text);
  return all;
}

Result<std::vector<NamePiece>> pieces_of(const RowTable& table, const std::string& pattern) {
  std::vector<NamePiece> all;
  bool any = false;
  for (std::size_t at = 0; at < pattern.size();) {
    const std::size_t open = std::min(pattern.find('{', at), pattern.size());
    if (open > at) all.push_back({pattern.substr(at, open - at), {}});
    if (open == pattern.size()) break;
    const std::size_t close = pattern.find('}', open);
    if (close == pattern.npos)
      return fail(ErrorCode::syntax, "-o: a '{' is never closed", "as in -o \"out/{name}.mp4\"");
    const std::string name = pattern.substr(open + 1, close - open - 1);
    const auto column = std::find_if(table.columns.begin(), table.columns.end(),
                                     [&](const RowTable::Cell& c) { return c.text == name; });
    if (column != table.columns.end())
      all.push_back({{}, static_cast<std::size_t>(column - table.columns.begin())});
    else if (name == "row")
      all.push_back({{}, {}, true});
    else
      return at_header(table, fmt::format("there is no column '{}', which -o names", name),
                       did_you_mean(name, names_of(table)));
    any = true, at = close + 1;
  }
  if (!any)
    return fail(ErrorCode::name, "-o has no column, so all films would have one name", "as in -o \"out/{name}.mp4\"");
  return all;
}

// Returns a cell as a part of a file name that every system takes.
std::string safe(std::string_view cell) {
  std::string out;
  for (const char ch : cell) {
    const bool bad = static_cast<unsigned char>(ch) < 32 || ch == 127 ||
                     std::string_view("/\\:*?\"<>|").find(ch) != std::string_view::npos;
    out += bad ? '-' : ch;
  }
  while (!out.empty() && (out.front() == ' ' || out.front() == '.')) out.erase(0, 1);
  while (out.size() > most_bytes || (!out.empty() && (out.back() == ' ' || out.back() == '.'))) {
    while (!out.empty() && (static_cast<unsigned char>(out.back()) & 0xC0) == 0x80) out.pop_back();
    if (!out.empty()) out.pop_back();
  }
  return out;
}

// Some file systems do not tell capitals from small letters.
std::string folded(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char ch) { return std::tolower(ch); });
  return name;
}

}  // namespace

Result<std::vector<std::size_t>> columns_for(const RowTable& table, const std::set<std::string>& lets,
                                             const std::string& script) {
  std::vector<std::size_t> used;
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    if (lets.contains(table.columns[c].text)) used.push_back(c);
  if (!used.empty()) return used;
  const std::vector<std::string_view> known(lets.begin(), lets.end());
  Hint hint("write `let NAME = VALUE` for a column, with a value for the film without a table");
  for (const RowTable::Cell& c : table.columns)
    if (const Hint near = did_you_mean(c.text, known); !near.empty()) hint = near;
  return at_header(
      table, fmt::format("no column has the name of a 'let' of {}, so all films would be the same", script), hint);
}

Result<std::vector<std::string>> film_names(const RowTable& table, const std::string& pattern) {
  const auto pieces = pieces_of(table, pattern);
  if (!pieces) return pieces.error();
  std::vector<std::string> names;
  std::map<std::string, std::size_t> seen;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    std::string name;
    for (const NamePiece& piece : *pieces) {
      const std::string part = piece.number   ? std::to_string(row + 1)
                               : piece.column ? safe(table.rows[row][*piece.column].text)
                                              : piece.text;
      if (piece.column && part.empty()) {
        Error e = fail(ErrorCode::name, "the film has no name: this cell is empty");
        e.place = table.place(table.rows[row][*piece.column]);
        return e;
      }
      name += part;
    }
    if (const auto [there, fresh] = seen.emplace(folded(name), row); !fresh) {
      Error e = fail(ErrorCode::name,
                     fmt::format("two films would have the name {}: this row's and that of line {}", name,
                                 table.rows[there->second].front().line),
                     "take another column into the name, or the number of the row: {row}");
      e.place = table.place(table.rows[row].front());
      return e;
    }
    names.push_back(std::move(name));
  }
  return names;
}

}  // namespace betwixt
