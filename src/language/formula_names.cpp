// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The names in formulas: a command's place in its pattern (i, n), names with formulas in braces, and built-in words.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/counted.h"
#include "base/names.h"
#include "language/formula.h"
#include "language/formula_functions.h"
#include "language/moments.h"
#include "language/table_formulas.h"
#include "language/values.h"
#include "syntax/tokens.h"
#include "syntax/words.h"

namespace betwixt {

namespace {

using formulas::name_at;
using formulas::name_goes_on;
using formulas::number_begins;

// Returns whether the body of braces is one formula, such as {i} or {n-i+1}, and not a list.
bool formula_in_braces(std::string_view body) {
  return body.find(',') == body.npos && body.find("..") == body.npos &&
         speaks_of_place(body.data(), body.data() + body.size());
}

// Returns whether a word mentions a place. `at` and `end`: the text around it.
bool word_speaks_of_place(std::string_view word, const char* at, const char* end) {
  for (const char *part = word.data(), *stop = part + word.size(); part < stop; ++part) {
    if (!name_goes_on(*part)) continue;
    const char* const name = part;
    while (part + 1 < stop && name_goes_on(part[1])) ++part;
    const std::ptrdiff_t length = part + 1 - name;
    const char before = name > at ? name[-1] : ' ', behind = part + 1 < end ? part[1] : ' ';
    if (length == 3 && std::string_view(name, 3) == "row" && behind == '.' && before != '.') return true;
    if (length > 2 || (*name != 'i' && *name != 'n')) continue;
    if (length == 2 && (*name != 'i' || name[1] < '1' || name[1] > '4')) continue;
    // Two dots belong to a segment; a single one separates an object from its function.
    const bool one_before = before == '.' && !(name - at > 1 && name[-2] == '.');
    const bool one_behind = behind == '.' && !(end - part > 2 && part[2] == '.');
    if (!one_before && !one_behind && std::string_view(" \t\r\n,=([{+-*/%^.").find(before) != std::string_view::npos &&
        std::string_view(" \t\r\n,)]}+-*/%^.").find(behind) != std::string_view::npos)
      return true;
  }
  return false;
}

}  // namespace

bool one_name(Cursor& c, std::string_view word, std::string& out) {
  out = word;
  if (word.find('{') == word.npos) return true;
  // Formulas are replaced first, and then the lists are written out: rocket{i}-{1..3}.
  for (std::size_t open = 0; (open = out.find('{', open)) != out.npos;) {
    const std::size_t close = out.find('}', open);
    const std::string_view body = std::string_view(out).substr(open + 1, close == out.npos ? close : close - open - 1);
    if (close == out.npos || !formula_in_braces(body)) {
      ++open;
      continue;
    }
    const std::string kept(body);
    Cursor inner = c;
    inner.at = kept.data(), inner.end = kept.data() + kept.size();
    inner.error.reset();
    Quantity q;
    if (!formula(inner, q) || inner.at != inner.end)
      return c.fail(inner.error ? inner.error->code : ErrorCode::syntax,
                    inner.error ? inner.error->message : fmt::format("'{}' is not a formula", kept), word,
                    inner.error ? inner.error->hint : std::string());
    if (q.of != Quantity::Of::number || q.value != std::floor(q.value) || std::abs(q.value) > 1e15)
      return c.fail(q.of == Quantity::Of::number ? ErrorCode::range : ErrorCode::type,
                    fmt::format("{{{}}} in a name must be a whole number, not {}", kept, write_quantity(q)), word);
    out.replace(open, close - open + 1, write_number(q.value));
  }
  if (out.find('{') == out.npos) return true;
  const auto names = expand_braces(c.tables ? with_keys(*c.tables, out) : out);
  if (!names) return c.fail(names.error(), word);
  if (names->size() != c.place.n)
    return c.fail(ErrorCode::range,
                  fmt::format("'{}' makes {}, but the command applies to {}", word.substr(0, 60),
                              counted(names->size(), "name"), counted(c.place.n, "object")),
                  word, "write one name for all, or as many names as objects; {i} is the number of the object, from 1");
  out = (*names)[c.place.i - 1];
  return true;
}

bool writes_out_names(std::string_view text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  if (line.find('{') == line.npos) return false;
  Lexer lexer(line);
  while (const auto token = lexer.next()) {
    if (token->kind != TokenKind::word) continue;
    const std::string_view word = lexer.of(*token);
    if (word.find('{') != word.npos && first_dot(word) == word.npos) return true;
  }
  return false;
}

bool speaks_of_place(const char* at, const char* end) {
  return any_word(at, end, [&](std::string_view word) {
    const auto place = [](char c) { return c == 'i' || c == 'n'; };
    const bool may = std::any_of(word.begin(), word.end(), place) || word.find("row.") != word.npos;
    return may && word_speaks_of_place(word, at, end);
  });
}

bool single(const Let& let, LetItem& out) {
  if (const auto* q = std::get_if<Quantity>(&let)) return out = *q, true;
  if (const auto* v = std::get_if<Vec3>(&let)) return out = *v, true;
  if (const auto* c = std::get_if<Color>(&let)) return out = *c, true;
  if (const auto* t = std::get_if<Text>(&let)) return out = *t, true;
  return false;
}

bool formula_goes_on(const char* at, const char* end) {
  if (at >= end || std::string_view("+-*/%^").find(*at) == std::string_view::npos) return false;
  if (++at < end && at[-1] == '/' && *at == '/') ++at;
  while (at < end && (*at == '-' || *at == '+')) ++at;
  return at < end && (*at == '(' || is_letter(*at) || number_begins(at, end));
}

bool formula_begins(const Cursor& c) {
  const char* at = c.at;
  while (at < c.end && (*at == '-' || *at == '+')) ++at;
  if (at < c.end && *at == '(') return true;
  const std::string_view name = name_at(at, c.end);
  if (name.empty()) return false;
  if (cell_begins(c, at)) return true;
  const char* const behind = name.data() + name.size();
  return is_formula_word(name) || (c.lets && c.lets->contains(name)) || (behind < c.end && *behind == '(') ||
         formula_goes_on(behind, c.end) || moment_begins(c, at);
}

Hint near_name(const Cursor& c, std::string_view word) {
  std::vector<std::string_view> names;
  if (c.lets)
    for (const auto& let : *c.lets) names.push_back(let.first);
  return did_you_mean(word, names);
}

bool is_formula_word(std::string_view word) {
  const bool place =
      word == "i" || word == "n" || (word.size() == 2 && word[0] == 'i' && word[1] >= '1' && word[1] <= '9');
  return place || formulas::find_function(word) ||
         std::any_of(std::begin(formulas::constants), std::end(formulas::constants),
                     [&](const auto& c) { return c.first == word; });
}

}  // namespace betwixt
