// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Names of the author's own: for many objects, and for functions that all objects have.
#include "base/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/still_wanted.h"
#include "commands/command.h"
#include "language/formula.h"
#include "scene/colors.h"

namespace betwixt {
namespace {

constexpr std::size_t most_in_list = 100'000;

bool alias(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::string_view name;
  if (!new_name(c, name, "name")) return false;
  if (!c.accept('=')) return c.fail_here(ErrorCode::syntax, "'=' is missing here");
  std::vector<std::string> elements;
  while (!c.at_line_end()) {
    const std::string_view e = c.word();
    if (e.empty() || (!is_pattern(e) && !is_name(e)))
      return c.fail_here(ErrorCode::syntax, "names and patterns are wanted here");
    if (const auto braces = expand_braces(e); !braces) return c.fail(braces.error().code, braces.error().message, e);
    elements.emplace_back(e);
  }
  s.aliases.edit()[std::string(name)] = std::move(elements);
  return true;
}

// Reads a number, an angle, a length, a time, a vector, a pair, a colour or a text.
bool let_item(Command& k, LetItem& out) {
  Cursor& c = k.cursor;
  ValueReader reader = values(k);
  c.space();
  if (c.peek() == '(' && reader.is_vector()) {
    Vec3 v;
    if (!reader.point(v)) return false;
    return out = v, true;
  }
  if (c.peek() == '"') {
    std::string text;
    return c.text(text) && (out = Text(std::move(text)), true);
  }
  if (const auto known = let_here(c)) return out = *known, true;
  if (c.error) return false;
  const std::string_view word = c.peek_word();
  const bool color_begins = word == "rgb" || word == "hsv";
  if (!color_begins && (c.peek() == '(' || reader.looks_like_number() || formula_begins(c))) {
    Quantity q;
    if (!formula(c, q)) return false;
    return out = q, true;
  }
  Color color;
  if (!reader.color(color)) return false;
  return out = color, true;
}

// Returns whether the brackets hold more than one formula.
bool begins_list(const Cursor& c) {
  Cursor ahead = c;
  Quantity q;
  return c.peek() == '(' && !(formula(ahead, q) && ahead.at_line_end());
}

// Reads one such value, or several in brackets: two or three plain numbers are a vector, all other values are a list.
bool let_value(Command& k, Let& out) {
  Cursor& c = k.cursor;
  c.space();
  if (c.at_line_end())
    return c.fail_here(ErrorCode::syntax, "a formula, a vector, a colour, a text or a list is missing here",
                       "as in let beat = 12f");
  LetItem one;
  const char* const start = c.at;
  if (!begins_list(c)) {
    if (!let_item(k, one)) return false;
    std::visit([&](auto& value) { out = std::move(value); }, one);
    return true;
  }
  LetList list;
  if (!c.open()) return false;
  for (c.space(); c.at < c.end && c.peek() != ')'; c.space()) {
    StillWanted::ask();
    if (!let_item(k, one)) return false;
    list.push_back(std::move(one));
    if (list.size() > most_in_list)
      return c.fail(ErrorCode::range, fmt::format("a list has at most {} values", most_in_list), c.since(start));
  }
  if (!c.close()) return false;
  if (list.empty()) return c.fail(ErrorCode::syntax, "a list has at least one value", c.since(start));
  const auto plain = [](const LetItem& item) {
    const auto* q = std::get_if<Quantity>(&item);
    return q && q->of == Quantity::Of::number;
  };
  if ((list.size() != 2 && list.size() != 3) || !std::all_of(list.begin(), list.end(), plain))
    return out = std::move(list), true;
  Vec3 v;
  for (std::size_t i = 0; i < list.size(); ++i) v[static_cast<int>(i)] = std::get<Quantity>(list[i]).value;
  return out = v, true;
}

bool let(Command& k) {
  auto& [s, c, time, layer, script] = k;
  const bool again = c.accept_word("again");
  const std::string_view name = c.next_word();
  const auto fits = [](char ch) { return std::isalnum(static_cast<unsigned char>(ch)) || ch == '_'; };
  if (name.empty()) return c.fail_here(ErrorCode::syntax, "a name is missing here");
  if (!std::isalpha(static_cast<unsigned char>(name[0])) || name.size() > 100 ||
      !std::all_of(name.begin(), name.end(), fits))
    return c.fail(ErrorCode::syntax, fmt::format("'{}' cannot be a name in formulas", name.substr(0, 60)), name,
                  "a letter, then letters, digits and '_'");
  if (is_formula_word(name) || named_color(name))
    return c.fail(ErrorCode::name, fmt::format("'{}' has a meaning in formulas already", name), name);
  const bool known = s.lets->contains(name);
  if (known && !again && !script.live)
    return c.fail(ErrorCode::name, fmt::format("there is a 'let {}' already", name), name,
                  fmt::format("let again {} = … changes what it stands for from there on", name));
  if (again && !known)
    return c.fail(ErrorCode::name, fmt::format("there is no 'let {}' above that could change", name), name);
  if (s.lets->size() >= 100'000 && !s.lets->contains(name))
    return c.fail(ErrorCode::range, "no more than 100000 names can be given", name);
  if (!c.accept('=')) return c.fail_here(ErrorCode::syntax, "'=' is missing here");
  Let value;
  if (!let_value(k, value) || !finish(c)) return false;
  if (known && !again) script.respell_live({name.data(), 0}, "again ");
  s.lets.edit().insert_or_assign(std::string(name), value);
  return true;
}

bool define(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::string_view name;
  if (!new_name(c, name, "function's name", "/")) return false;
  const auto called = [&](const FunctionSpec& spec) { return spec.name == name; };
  const bool built_in = std::any_of(kinds().begin(), kinds().end(),
                                    [&](const KindRow& row) { return find_built_in(row.kind, name).has_value(); });
  if (built_in || std::any_of(s.defined->begin(), s.defined->end(), called))
    return c.fail(ErrorCode::name, fmt::format("there is a function '{}' already", name), name);
  if (name == "world" || name == "velocity")
    return c.fail(ErrorCode::name, fmt::format("there is a function '{}' already", name), name);
  const std::string_view type = c.next_word();
  const TypeRow* row = find_type(type);
  if (!row) {
    const std::vector<std::string_view> words = type_words();
    const std::string hint = did_you_mean(type, words);
    return c.fail(ErrorCode::name,
                  type.empty() ? "a type is missing here" : fmt::format("there is no type '{}'", type.substr(0, 40)),
                  type.empty() ? std::string_view(c.at, 0) : type,
                  hint.empty() ? fmt::format("types are {}", fmt::join(words, " ")) : hint);
  }
  FunctionSpec spec{.name = std::string(name), .type = row->type, .rest = row->example(), .kinds = 0xffffffff};
  c.space();
  if (c.peek() == '=') {
    Selected of;
    of.spec = &spec;
    if (!computed(k, of, spec.rest)) return false;
  } else if (!c.at_line_end() && !values(k).value(spec, -1, spec.rest)) {
    return false;
  }
  if (spec.type == Type::shape && std::holds_alternative<ObjectId>(spec.rest) && !(spec.rest == Value(ObjectId{})))
    return c.fail(ErrorCode::type, "what every object has cannot begin as one object's shape", type,
                  "leave it out, and set it");
  if (!finish(c)) return false;
  if (s.defined->size() >= 10000) return c.fail(ErrorCode::range, "no more than 10000 functions can be defined", name);
  s.defined.edit().push_back(std::move(spec));
  return true;
}

constexpr Verb names_rows[] = {
    {"alias", "alias NAME = ELEMENT …", "A name for many objects; patterns inside are read at each use.",
     "alias toys = ball wheel*", 0, alias},
    {"let", "let NAME = FORMULA, or let NAME = (VALUE …), or let again NAME = …",
     "A number, time, length, angle, vector, colour or text, or a list of such, that formulas know by name from there "
     "on.",
     "let beat = 12f\nlet turn_by = tau/6\nlet primes = (2 3 5 7)\nset ball.radius primes[2]", 0, let},
    {"define", "define NAME TYPE [default]", "A function of your own that every object has.", "define heat number 20",
     0, define},
};

}  // namespace

std::span<const Verb> names_verbs() { return names_rows; }

}  // namespace betwixt
