// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "base/json.h"
#include "base/names.h"
#include "base/utf8.h"
#include "exchange/table_text.h"

namespace betwixt {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::size_t deepest_json = 64;

Error bad_json(const std::string& name, std::string what, Hint hint = {}) {
  return fail(ErrorCode::file, fmt::format("'{}' {}", name, what), std::move(hint));
}

void add_cell(std::string& out, const Json& value) {
  if (value.is_null()) return;
  if (value.is_number()) {
    out += value.dump();
    return;
  }
  add_quoted_cell(out, value.is_string() ? value.get<std::string>() : value.dump());
}

std::string add_row(const std::vector<const Json*>& cells) {
  static const Json nothing;
  std::string out;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) out += ',';
    add_cell(out, cells[i] ? *cells[i] : nothing);
  }
  return out + '\n';
}

// [{"city": "Bern", "people": 134000}, …]
Result<std::string> of_objects(const Json& rows, const std::string& name) {
  std::vector<Json> titles;
  std::unordered_map<std::string, std::size_t> place;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (!rows[r].is_object())
      return bad_json(name, fmt::format("has an entry {} that is no object, unlike the first", r + 1));
    for (const auto& [key, value] : rows[r].items())
      if (place.try_emplace(key, titles.size()).second) titles.emplace_back(key);
  }
  std::vector<const Json*> cells;
  for (const Json& title : titles) cells.push_back(&title);
  std::string out = add_row(cells);
  for (const Json& row : rows) {
    cells.assign(titles.size(), nullptr);
    for (const auto& [key, value] : row.items()) cells[place.at(key)] = &value;
    out += add_row(cells);
  }
  return out;
}

// {"city": ["Bern", …], "people": [134000, …]}
Result<std::string> of_lists(const Json& columns, const std::string& name) {
  std::vector<Json> titles;
  std::vector<const Json*> cells;
  const std::size_t rows = columns.begin()->size();
  for (const auto& [key, list] : columns.items()) {
    if (list.size() != rows)
      return bad_json(
          name, fmt::format("has {} values of '{}', but {} of '{}'", list.size(), key, rows, columns.begin().key()));
    titles.emplace_back(key);
  }
  for (const Json& title : titles) cells.push_back(&title);
  std::string out = add_row(cells);
  for (std::size_t r = 0; r < rows; ++r) {
    cells.clear();
    for (const auto& [key, list] : columns.items()) cells.push_back(&list[r]);
    out += add_row(cells);
  }
  return out;
}

// [["city", "people"], ["Bern", 134000], …]
Result<std::string> of_rows(const Json& rows, const std::string& name) {
  std::string out;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (!rows[r].is_array() || rows[r].size() != rows[0].size())
      return bad_json(name, fmt::format("has a row {} that is not as long as the first", r + 1));
    std::vector<const Json*> cells;
    for (const Json& value : rows[r]) cells.push_back(&value);
    out += add_row(cells);
  }
  return out;
}

bool has_rows(const Json& value) {
  return value.is_array() && !value.empty() && (value[0].is_object() || value[0].is_array());
}

// Returns the table in an object: the one with this name, or the only list of rows.
Result<const Json*> inside_of(const Json& all, const std::string& name, std::string_view inside) {
  const Json* found = &all;
  if (!inside.empty()) {
    const auto at = all.is_object() ? all.find(std::string(inside)) : all.end();
    if (at != all.end()) return &*at;
    std::vector<std::string_view> names;
    if (all.is_object())
      for (auto one = all.begin(); one != all.end(); ++one) names.push_back(one.key());
    Error e = fail(ErrorCode::name, fmt::format("'{}' has nothing named '{}'", name, first_characters(inside, 40)));
    set_hint(e, did_you_mean(inside, names));
    return e;
  }
  if (all.is_object())
    for (const Json& value : all)
      if (has_rows(value)) {
        if (found != &all) return bad_json(name, "has several tables", "choose one, as in inside=\"cities\"");
        found = &value;
      }
  return found;
}

}  // namespace

Result<std::string> table_of_json(const std::string& bytes, const std::string& name, std::string_view inside) {
  if (json_depth(bytes) > deepest_json) return bad_json(name, "is nested too deep for a table");
  Json all;
  try {
    all = Json::parse(bytes);
  } catch (const Json::parse_error& e) {
    const auto at = std::min<std::size_t>(e.byte > 0 ? e.byte - 1 : 0, bytes.size());
    const auto end = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    const auto line = std::count(bytes.begin(), end, '\n') + 1;
    const std::size_t start = at == 0 ? std::string::npos : bytes.rfind('\n', at - 1);
    const std::size_t column = at - (start == std::string::npos ? 0 : start + 1) + 1;
    return fail(ErrorCode::file, fmt::format("line {}, column {} of '{}' is no JSON", line, column, name));
  } catch (const Json::out_of_range&) {
    return bad_json(name, "has a number that is too large", "a number is at most 1.7e308");
  }
  const auto found = inside_of(all, name, inside);
  if (!found) return found.error();
  const Json& table = **found;
  if (table.is_array() && !table.empty() && table[0].is_object()) return of_objects(table, name);
  if (table.is_array() && !table.empty() && table[0].is_array()) return of_rows(table, name);
  const bool lists = table.is_object() && !table.empty() &&
                     std::all_of(table.begin(), table.end(), [](const Json& one) { return one.is_array(); });
  if (lists) return of_lists(table, name);
  return bad_json(name, "is no table", "a table is a list of objects, or an object of lists");
}

}  // namespace betwixt
