// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "commands/furnishing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "commands/furniture_rows.h"
#include "language/formula.h"
#include "language/table_formulas.h"
#include "language/values.h"
#include "procedure/lua.h"
#include "program/on_axes.h"
#include "scene/kinds.h"

namespace betwixt {
namespace {

constexpr std::size_t most_cells = 10'000;

// Takes the name of a list, or of a column of a table.
bool named_list(Cursor& c, LetList& out) {
  if (column_list(c, out)) return true;
  const std::string_view word = c.peek_word();
  const auto let = c.lets ? c.lets->find(word) : Lets::const_iterator();
  if (c.error || !c.lets || let == c.lets->end() || !std::holds_alternative<LetList>(let->second)) return false;
  c.at += word.size();
  return out = std::get<LetList>(let->second), true;
}

// Reads (item item …); with `nested` also ((item …) (item …)).
bool items(Command& k, std::vector<LetList>& rows, bool nested, bool* was_nested = nullptr) {
  Cursor& c = k.cursor;
  c.space();
  const char* const start = c.at;
  if (LetList list; named_list(c, list)) {
    if (list.size() > most_cells)
      return c.fail(ErrorCode::range, fmt::format("there can be at most {} values", most_cells), c.since(start));
    return rows.push_back(std::move(list)), true;
  }
  if (c.error) return false;
  if (c.peek() != '(') return c.fail_here(ErrorCode::syntax, "a list in brackets is missing here", "as in of=(3 1 4)");
  Cursor ahead = c;
  const bool several = nested && ahead.open() && (ahead.space(), ahead.peek() == '(');
  if (several && !c.open()) return false;
  if (was_nested) *was_nested = several;
  std::size_t count = 0;
  do {
    LetList row;
    if (!c.open()) return false;
    for (c.space(); c.at < c.end && c.peek() != ')'; c.space()) {
      LetItem one;
      if (!let_item(k, one)) return false;
      row.push_back(std::move(one));
      if (++count > most_cells)
        return c.fail(ErrorCode::range, fmt::format("there can be at most {} values", most_cells), c.since(start));
    }
    if (!c.close()) return false;
    rows.push_back(std::move(row));
    c.space();
  } while (several && c.at < c.end && c.peek() == '(');
  if (several && !c.close()) return false;
  if (count == 0) return c.fail(ErrorCode::syntax, "the list must have at least one value", c.since(start));
  return true;
}

// Fails with the place in the formula if it has an error.
bool formula_is_good(Command& k, const Object& o, std::string_view name, std::string_view about) {
  const auto f = find_built_in(o.kind, name);
  const Slot* slot = f ? o.find(*f) : nullptr;
  const auto* text = slot && slot->set ? std::get_if<Text>(&*slot->set) : nullptr;
  if (!text) return true;
  const std::string problem = formula_problem(**text);
  if (problem.empty()) return true;
  // The place: that of the word that the message names, or of the whole formula.
  const std::string_view line = k.script.source.text;
  std::string_view place = about;
  const std::string quoted = "\"" + **text + "\"";
  if (const auto at = line.find(quoted); !(*text)->empty() && at != std::string_view::npos) {
    place = line.substr(at + 1, (*text)->size());
    const auto near = problem.find("near '");
    const auto end = near == std::string::npos ? near : problem.find('\'', near + 6);
    if (end != std::string::npos)
      if (const auto in = place.rfind(problem.substr(near + 6, end - near - 6)); in != std::string_view::npos)
        place = place.substr(in, end - near - 6);
  }
  return k.cursor.fail(ErrorCode::syntax, fmt::format("the formula has an error: {}", problem), place);
}

// Returns the place in the text of `of` where a problem is, if it is in this line.
std::string_view place_of_problem(Command& k, const Furnishing& f, std::string_view otherwise) {
  if (f.problem_at == 0) return otherwise;
  const std::string_view line = k.script.source.text;
  const std::string text = f.text("of");
  const auto at = line.find("\"" + text + "\"");
  if (text.empty() || at == line.npos) return otherwise;
  return line.substr(at + static_cast<std::size_t>(f.problem_at), 1);
}

std::string hint_of_axes(const Scene& s) {
  std::string_view name;
  for (std::size_t i = 0; i < s.objects.size(); ++i)
    if (const Object& o = s.objects[i]; !o.removed && has_coordinates(o.kind)) name = o.name;
  return name.empty() ? "create axes first, then write on=NAME, as in on=ax" : fmt::format("write on={}", name);
}

}  // namespace

bool carry_out_lines(Command& k, const std::string& lines, std::string_view about) {
  for (const Diagnostic& d : carried_out(k, lines))
    if (d.severity == Severity::error) return k.cursor.fail(d.what.code, d.what.message, about, d.what.hint);
  return true;
}

bool all_or_none(Command& k, const std::string& lines, std::string_view about) {
  Rollback rollback(k.scene);
  if (!carry_out_lines(k, lines, about)) return false;
  return rollback.keep(), true;
}

bool lasting(Command& k, Time& length, std::string_view about) {
  Cursor& c = k.cursor;
  if (c.accept_word("for") && !c.lasting(length)) return false;
  if (length <= Time{}) return c.fail(ErrorCode::range, "the length must be greater than 0", about, "as in for 12f");
  return finish(c);
}

std::string write_metres(double v) { return write_number(std::round(v * 1e4) / 1e4); }

bool furniture(Command& k, Kind kind, std::string_view key, Furniture& out) {
  if (kind == Kind::sound) return said_parameter(k, key, out);
  const FurnitureRow* row = furniture_of(kind);
  Cursor& c = k.cursor;
  if (!row || row->takes == Takes::nothing) return false;
  if (key == "of") {
    out.of_at = key;
    return items(k, out.rows, row->takes != Takes::numbers, &out.nested);
  }
  if (key != "keys" || row->takes == Takes::cells) return false;
  std::vector<LetList> keys;
  if (!items(k, keys, false)) return false;
  for (const LetItem& one : keys[0])
    if (!std::holds_alternative<Text>(one))
      return c.fail(ErrorCode::type, "keys are texts in quotes", key, "as in keys=(\"Ann\" \"Bob\")");
  out.keys = std::move(keys[0]);
  return true;
}

std::string_view meant_at_create(Kind kind, std::string_view key) {
  return kind == Kind::scatter && key == "of" ? "points" : key;
}

bool furnish(Command& k, ObjectId id, const Furniture& said, std::string_view about) {
  const Object& o = k.scene.objects[id.index];
  const FurnitureRow* row = furniture_of(o.kind);
  if (!row) return true;
  if (const Slot* bare = o.find(fn::bare); bare && bare->set && bare->set == Value(true)) return true;
  for (const std::string_view formula : {"of", "base"})
    if (row->needs_axes && !formula_is_good(k, o, formula, about)) return false;
  if (row->needs_axes && !axes_of(k.scene, o))
    return k.cursor.fail(ErrorCode::syntax, fmt::format("{} needs axes", a_kind(o.kind)), about, hint_of_axes(k.scene));
  if (row->takes != Takes::nothing && said.rows.empty())
    return k.cursor.fail(ErrorCode::syntax, fmt::format("{} needs its values", a_kind(o.kind)), about,
                         row->takes == Takes::cells ? "as in of=((1 2) (3 4))" : "as in of=(3 1 4)");
  Furnishing to{k.scene, id, o.name, said, {}, {}, {}, 0};
  row->make(to);
  if (!to.problem.empty())
    return k.cursor.fail(ErrorCode::range, to.problem, place_of_problem(k, to, said.of_at.empty() ? about : said.of_at),
                         to.hint);
  if (!to.lines.empty() && !carry_out_lines(k, to.lines, about)) return false;
  // Whoever writes the film writes the pieces too.
  k.scene.objects.edit(id.index).slot(fn::bare).set = true;
  return true;
}

bool put_on_axes(Command& k, Object& o, ObjectId& parent, std::string_view about) {
  const Slot* slot = o.find(fn::on_axes);
  const auto* id = slot && slot->set ? std::get_if<ObjectId>(&*slot->set) : nullptr;
  if (!id || !*id) return true;
  const Object& axes = k.scene.objects[id->index];
  if (!has_coordinates(axes.kind))
    return k.cursor.fail(ErrorCode::type,
                         fmt::format("'{}' is {}, which has no coordinates", axes.name, a_kind(axes.kind)), about,
                         "on= takes axes, a number-line, polar-axes or a plane-grid");
  if (!parent) parent = *id;
  return true;
}

}  // namespace betwixt
