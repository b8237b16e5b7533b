// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Names of the author's own: for many objects, and for functions that all objects have.
#include "base/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/cancellation.h"
#include "commands/command.h"
#include "commands/given_lets.h"
#include "commands/own_kinds.h"
#include "language/formula.h"
#include "language/table_formulas.h"
#include "scene/colors.h"

namespace betwixt {
namespace {

constexpr std::size_t most_in_list = 100'000, most_lets = 1'000'000;

bool alias(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::string_view name;
  if (!new_name(c, name, "name")) return false;
  if (!c.accept('=')) return c.fail_here(ErrorCode::syntax, "'=' is missing here");
  std::vector<std::string> elements;
  while (!c.at_line_end()) {
    const std::string_view e = c.word();
    if (e.empty() || (!is_pattern(e) && !is_name(e)))
      return c.fail_here(ErrorCode::syntax, "expected names or patterns here");
    if (const auto braces = expand_braces(e); !braces) return c.fail(braces.error(), e);
    elements.emplace_back(e);
  }
  s.aliases.edit()[std::string(name)] = std::move(elements);
  return true;
}

// Returns whether the brackets hold more than one formula.
bool begins_list(const Cursor& c) {
  Cursor ahead = c;
  Quantity q;
  return c.peek() == '(' && !(formula(ahead, q) && ahead.at_line_end());
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
                  "a name is a letter, then letters, digits and '_'");
  if (is_formula_word(name) || named_color(name))
    return c.fail(ErrorCode::name, fmt::format("'{}' already has a meaning in formulas", name), name);
  if (s.tables->contains(name)) return c.fail(ErrorCode::name, fmt::format("'data {}' already exists", name), name);
  const bool known = s.lets->contains(name);
  if (known && !again && !script.live)
    return c.fail(ErrorCode::name, fmt::format("'let {}' already exists", name), name,
                  fmt::format("to change its value from here on: let again {} = …", name));
  if (again && !known) return c.fail(ErrorCode::name, fmt::format("there is no 'let {}' above this line", name), name);
  if (s.lets->size() >= most_lets && !known)
    return c.fail(ErrorCode::range, fmt::format("a script can have at most {} lets", most_lets), name);
  if (!c.accept('=')) return c.fail_here(ErrorCode::syntax, "'=' is missing here");
  Let value;
  if (!let_value(k, value) || !finish(c)) return false;
  if (!again && !given_let(k, name, value)) return false;
  if (known && !again) script.respell_live({name.data(), 0}, "again ");
  s.lets.edit().insert_or_assign(std::string(name), value);
  return true;
}

bool define(Command& k) {
  auto& [s, c, time, layer, script] = k;
  if (defines_kind(c)) return define_kind(k);
  std::string_view name;
  if (!new_name(c, name, "function's name", "/")) return false;
  const auto built_in = built_in_functions();
  // What only videos have (`speed`, `time`) may be a function of the film's own: with a video, its own one is meant.
  const auto called = [&](const FunctionSpec& spec) { return spec.name == name && spec.kinds != bit(Kind::video); };
  if (name == "world" || name == "velocity" || s.defined->find(name) ||
      std::any_of(built_in.begin(), built_in.end(), called))
    return c.fail(ErrorCode::name, fmt::format("a function '{}' already exists", name), name);
  const std::string_view type = c.next_word();
  const TypeRow* row = find_type(type);
  if (!row) {
    const std::vector<std::string_view> words = type_words();
    const Hint hint = did_you_mean(type, words);
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
    return c.fail(ErrorCode::type, "the default of a function cannot be the shape of an object", type,
                  "leave out the default, and set it on each object");
  if (!finish(c)) return false;
  if (s.defined->size() >= OwnFunctions::most)
    return c.fail(ErrorCode::range, fmt::format("a film can define at most {} functions", OwnFunctions::most), name);
  s.defined.edit().push_back(std::move(spec));
  return true;
}

constexpr Verb names_rows[] = {
    {"alias", "alias NAME = ELEMENT …",
     "Gives several objects one name. Patterns in it are matched again each time you use the alias.",
     "alias toys = ball wheel*", Verb::makes_thing, alias, "NEW; =; OBJECT…"},
    {"let", "let NAME = FORMULA, or let NAME = (VALUE …), or let again NAME = …",
     "Names a number, time, length, angle, vector, color or text, or a list of these, for the formulas below. `let "
     "again` changes its value for the lines below.",
     "let beat = 12f\nlet turn_by = tau/6\nlet primes = (2 3 5 7)\nset ball.radius primes[2]", Verb::makes_let, let,
     "NEW; ="},
    {"define", "define NAME TYPE [VALUE] or define kind NAME like OBJECT [hidden] [of (OBJECTS)]",
     "A display function (property) of your own, which every object then has. TYPE: number, angle, vector, color, "
     "boolean, rotation, orientation, shape or text. VALUE is its default. `define kind` makes a kind of your own from "
     "a model, the OBJECT with everything below it. Objects of the kind follow later changes of the model. `hidden` "
     "hides the model, and `of` names existing objects that become objects of the kind.",
     "define heat number 20\ndefine kind toy like ball\ncreate copy1 toy position=(2 0 0)", Verb::makes_function,
     define, "NEW kind; TYPE; =; like"},
};

}  // namespace

bool let_value(Command& k, Let& out) {
  Cursor& c = k.cursor;
  c.space();
  if (c.at_line_end())
    return c.fail_here(ErrorCode::syntax, "a formula, a vector, a colour, a text or a list is missing here",
                       "as in let beat = 12f");
  LetItem one;
  const char* const start = c.at;
  if (LetList column; column_list(c, column)) {
    if (column.size() <= most_in_list) return out = std::move(column), true;
    return c.fail(ErrorCode::range, fmt::format("a list can have at most {} values", most_in_list), c.since(start));
  }
  if (c.error) return false;
  if (c.peek() == '[')
    return c.fail(ErrorCode::syntax, "a list has round brackets, and blanks between its values", {c.at, 1},
                  "as in let primes = (2 3 5 7)");
  if (!begins_list(c)) {
    if (!let_item(k, one)) return false;
    std::visit([&](auto& value) { out = std::move(value); }, one);
    return true;
  }
  LetList list;
  if (!c.open()) return false;
  for (c.space(); c.at < c.end && c.peek() != ')'; c.space()) {
    Cancellation::check();
    if (!let_item(k, one)) return false;
    list.push_back(std::move(one));
    if (list.size() > most_in_list)
      return c.fail(ErrorCode::range, fmt::format("a list can have at most {} values", most_in_list), c.since(start));
  }
  if (!c.close()) return false;
  if (list.empty()) return c.fail(ErrorCode::syntax, "a list must have at least one value", c.since(start));
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

// Returns whether a pair follows whose second number has a sign: (3 -1) in a list is a vector, not 2.
static bool signed_pair_follows(Cursor ahead) {
  double first = 0;
  if (!ahead.open() || !ahead.literal(first)) return false;
  const char* const behind = ahead.at;
  ahead.space();
  const bool sign = ahead.at + 1 < ahead.end && (*ahead.at == '-' || *ahead.at == '+');
  return ahead.at > behind && sign && ((ahead.at[1] >= '0' && ahead.at[1] <= '9') || ahead.at[1] == '.');
}

bool let_item(Command& k, LetItem& out) {
  Cursor& c = k.cursor;
  ValueReader reader = values(k);
  c.space();
  if (c.peek() == '(' && (reader.is_vector() || signed_pair_follows(c))) {
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

std::span<const Verb> names_verbs() { return names_rows; }

}  // namespace betwixt
