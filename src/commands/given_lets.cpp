// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "commands/given_lets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "base/names.h"
#include "language/lines.h"

namespace betwixt {
namespace {

constexpr std::array<std::string_view, 4> quantities{"a number", "an angle", "a length", "a time"};

std::string_view type_said(const Let& value) {
  static constexpr std::array<std::string_view, 4> others{"a vector", "a colour", "a text", "a list"};
  if (const auto* q = std::get_if<Quantity>(&value)) return quantities[static_cast<std::size_t>(q->of)];
  return others[value.index() - 1];
}

std::string said(const GivenLet& given) {
  const std::string value = given.value.size() > 40 ? given.value.substr(0, 36) + "…" : given.value;
  return given.data ? fmt::format("{}:{}:{}: {} is '{}'", given.place.file, given.place.line, given.place.column,
                                  given.name, value)
                    : fmt::format("--let {}={}", given.name, value);
}

// Returns whether a cell is a value as it stands, and nothing to work out: 12, -0.5m, 24f, #ffcc00, gold, (1 2 3),
// rgb(1 0.5 0), hsv(30deg 1 1).
bool is_plain(std::string_view cell) {
  if (cell.starts_with("rgb(") || cell.starts_with("hsv(")) cell.remove_prefix(3);
  char before = ' ';
  std::string_view rest = cell;
  for (const char ch : cell) {
    rest.remove_prefix(1);
    const bool sign = ch == '+' || ch == '-';
    const bool begins = before == ' ' || before == ',' || before == '(' || before == 'e' || before == 'E';
    if (sign && !(begins && !rest.empty() && (std::isdigit(static_cast<unsigned char>(rest[0])) || rest[0] == '.')))
      return false;
    if (ch == '(' && std::isalnum(static_cast<unsigned char>(before))) return false;
    if (!sign && !std::isalnum(static_cast<unsigned char>(ch)) &&
        std::string_view(" .,#()%").find(ch) == std::string_view::npos)
      return false;
    before = ch;
  }
  return !cell.empty();
}

// A text needs no quotes; of a cell, quotes are part of the text.
bool text_of(Cursor& c, const GivenLet& given, Let& out) {
  std::string text = given.value;
  if (!given.data && c.peek() == '"') {
    if (!c.text(text)) return false;
    if (!c.at_line_end() || c.at != c.end) text = given.value;
  }
  if (const auto bad = unsound(text)) return c.fail(bad->why, {c.at, 0});
  return out = Text(std::move(text)), true;
}

bool value_of(Command& k, const GivenLet& given, const Let& own, Let& out) {
  Cursor& c = k.cursor;
  if (std::holds_alternative<Text>(own)) return text_of(c, given, out);
  if (given.data && !is_plain(given.value))
    return c.fail(ErrorCode::type, fmt::format("that is not {}", type_said(own)), {c.at, 0},
                  given.value.empty() ? "the cell is empty" : "cells of tables are values, not formulas");
  if (!let_value(k, out)) return false;
  if (!c.at_line_end() || c.at != c.end) return c.fail(ErrorCode::syntax, "there is more behind the value", {c.at, 0});
  if (type_said(own) == type_said(out)) return true;
  return c.fail(ErrorCode::type, fmt::format("that is {}, and the script has {}", type_said(out), type_said(own)),
                {c.at, 0});
}

}  // namespace

bool given_let(Command& k, std::string_view name, Let& value) {
  Script& script = k.script;
  const auto& all = script.options.lets;
  const auto given = std::find_if(all.begin(), all.end(), [&](const GivenLet& one) { return one.name == name; });
  if (given == all.end() || !script.whole) return true;
  script.lets_given.insert(given->name);
  Cursor c(given->value);
  c.rate = k.cursor.rate, c.ticks = k.cursor.ticks, c.lets = k.cursor.lets, c.place = k.cursor.place;
  Command inner{k.scene, c, {}, {}, script};
  Let out;
  if (!value_of(inner, *given, value, out)) {
    const Error why = c.error.value_or(fail(ErrorCode::type, "that is no value"));
    return k.cursor.fail(why.code, fmt::format("{}: {}", said(*given), why.message), name, Hint(why.hint));
  }
  k.cursor.frames_read |= c.frames_read, k.cursor.ticks_read |= c.ticks_read;
  return value = std::move(out), true;
}

void say_unknown_lets(const Scene& s, Script& script) {
  for (const GivenLet& given : script.options.lets) {
    if (given.data || script.lets_given.contains(given.name)) continue;
    std::vector<std::string_view> known;
    for (const auto& [name, value] : *s.lets) known.push_back(name);
    const Hint hint = did_you_mean(given.name, known);
    script.diagnostics.push_back(
        {Severity::error,
         fail(ErrorCode::name, fmt::format("{}: the script has no 'let {}'", said(given), given.name),
              !hint.empty() ? hint : Hint(known.empty() ? "it has no `let` at all" : "")),
         {},
         0});
  }
}

}  // namespace betwixt
