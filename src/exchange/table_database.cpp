// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tables of SQLite databases. The database is opened in memory and only read.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <vector>

#include "base/names.h"
#include "base/utf8.h"
#include "exchange/table_text.h"

#ifndef __EMSCRIPTEN__
#include <sqlite3.h>

namespace betwixt {
namespace {

struct CloseDatabase {
  void operator()(sqlite3* db) const { sqlite3_close_v2(db); }
};
struct EndStatement {
  void operator()(sqlite3_stmt* s) const { sqlite3_finalize(s); }
};
using Database = std::unique_ptr<sqlite3, CloseDatabase>;
using Statement = std::unique_ptr<sqlite3_stmt, EndStatement>;

Error bad_database(const std::string& name, sqlite3* db) {
  return fail(ErrorCode::file, fmt::format("'{}' cannot be read as a database: {}", name, sqlite3_errmsg(db)));
}

Result<Statement> prepared(sqlite3* db, const std::string& sql, const std::string& name) {
  sqlite3_stmt* made = nullptr;
  const char* rest = nullptr;
  if (sqlite3_prepare_v2(db, sql.c_str(), static_cast<int>(sql.size()), &made, &rest) != SQLITE_OK)
    return bad_database(name, db);
  Statement statement(made);
  if (!made || !sqlite3_stmt_readonly(made) || (rest && *rest != '\0'))
    return fail(ErrorCode::file, "this is not one query", "as in inside=\"select city, people from cities\"");
  return statement;
}

std::string_view text_of(sqlite3_stmt* s, int column) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(s, column));
  return text ? std::string_view(text, static_cast<std::size_t>(sqlite3_column_bytes(s, column))) : std::string_view();
}

Result<std::string> rows_of(sqlite3* db, const std::string& sql, const std::string& name) {
  const auto statement = prepared(db, sql, name);
  if (!statement) return statement.error();
  sqlite3_stmt* const s = statement->get();
  const int columns = sqlite3_column_count(s);
  std::string out;
  for (int i = 0; i < columns; ++i) {
    if (i > 0) out += ',';
    add_quoted_cell(out, sqlite3_column_name(s, i));
  }
  out += '\n';
  int code;
  while ((code = sqlite3_step(s)) == SQLITE_ROW) {
    for (int i = 0; i < columns; ++i) {
      if (i > 0) out += ',';
      const int type = sqlite3_column_type(s, i);
      if (type == SQLITE_BLOB)
        return fail(ErrorCode::file,
                    fmt::format("'{}' has bytes in the column '{}', not text", name, sqlite3_column_name(s, i)));
      if (type == SQLITE_TEXT)
        add_quoted_cell(out, text_of(s, i));
      else
        out += text_of(s, i);
    }
    out += '\n';
  }
  if (code != SQLITE_DONE) return bad_database(name, db);
  return out;
}

Result<std::vector<std::string>> tables_in(sqlite3* db, const std::string& name) {
  const auto statement = prepared(
      db, "select name from sqlite_master where type in ('table', 'view') and name not like 'sqlite_%' order by name",
      name);
  if (!statement) return statement.error();
  std::vector<std::string> names;
  int code;
  while ((code = sqlite3_step(statement->get())) == SQLITE_ROW) names.emplace_back(text_of(statement->get(), 0));
  if (code != SQLITE_DONE) return bad_database(name, db);
  return names;
}

bool is_query(std::string_view s) {
  constexpr std::string_view word = "select ";
  return s.size() > word.size() && std::equal(word.begin(), word.end(), s.begin(), [](char a, char b) {
           return a == std::tolower(static_cast<unsigned char>(b));
         });
}

Result<std::string> query_for(sqlite3* db, const std::string& name, std::string_view inside) {
  if (is_query(inside)) return std::string(inside);
  const auto names = tables_in(db, name);
  if (!names) return names.error();
  const auto all = fmt::format("its tables are {}", fmt::join(*names, ", ")).substr(0, 400);
  if (names->empty()) return fail(ErrorCode::file, fmt::format("'{}' has no tables", name));
  if (inside.empty() && names->size() > 1)
    return fail(ErrorCode::name, fmt::format("'{}' has several tables", name),
                fmt::format("choose one, as in inside=\"{}\"; {}", names->front(), all));
  const std::string wanted = inside.empty() ? names->front() : std::string(inside);
  if (std::find(names->begin(), names->end(), wanted) == names->end())
    return fail(ErrorCode::name, fmt::format("'{}' has no table '{}'", name, first_characters(wanted, 40)), all);
  std::string sql = "select * from ";
  add_quoted_cell(sql, wanted);
  return sql;
}

}  // namespace

Result<std::string> table_of_database(std::string bytes, const std::string& name, std::string_view inside) {
  constexpr std::size_t header = 100, version_at = 18;
  if (bytes.size() < header || !bytes.starts_with("SQLite format 3"))
    return fail(ErrorCode::file, fmt::format("'{}' is no SQLite database", name));
  bytes[version_at] = bytes[version_at + 1] = 1;  // a database with a log beside it is read without the log
  sqlite3* opened = nullptr;
  const int code = sqlite3_open_v2(":memory:", &opened, SQLITE_OPEN_READWRITE, nullptr);
  const Database db(opened);
  if (code != SQLITE_OK) return bad_database(name, opened);
  auto* const data = reinterpret_cast<unsigned char*>(bytes.data());
  const auto size = static_cast<sqlite3_int64>(bytes.size());
  if (sqlite3_deserialize(opened, "main", data, size, size, SQLITE_DESERIALIZE_READONLY) != SQLITE_OK)
    return bad_database(name, opened);
  sqlite3_limit(opened, SQLITE_LIMIT_ATTACHED, 0);
  const auto sql = query_for(opened, name, inside);
  if (!sql) return sql.error();
  return rows_of(opened, *sql, name);
}

}  // namespace betwixt
#else
namespace betwixt {
Result<std::string> table_of_database(std::string, const std::string& name, std::string_view) {
  return fail(ErrorCode::machine, fmt::format("pages do not read databases such as '{}'", name),
              "write the table as .csv");
}
}  // namespace betwixt
#endif
