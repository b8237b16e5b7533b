// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/line_pieces.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "betwixt/language.h"
#include "commands/line_head.h"
#include "commands/list_rows.h"
#include "commands/verbs.h"
#include "editor/help.h"
#include "language/moments.h"
#include "scene/colors.h"
#include "scene/own_kinds.h"
#include "syntax/tokens.h"
#include "track/filter.h"
#include "track/twerpers.h"

namespace betwixt {
namespace {

// Calls f(at, length) for each comment, string and word of a line; updates the state to that of the line's end. In
// voice:"the square"#2 the string and what follows it are a time.
template <class F>
void each_part(std::string_view line, LineState& state, F&& f) {
  Lexer lexer(line, state);
  std::size_t moment = 0;  // where it goes on
  while (const auto t = lexer.next()) {
    const bool goes_on = moment == t->at && t->at > 0;
    const bool begins = t->kind == TokenKind::word && line[t->end() - 1] == ':' && line.substr(t->end(), 1) == "\"";
    if (begins || (goes_on && (t->kind == TokenKind::text || t->kind == TokenKind::word))) moment = t->end();
    if (t->kind == TokenKind::comment) f(t->at, t->size, Meaning::comment);
    if (t->kind == TokenKind::text) f(t->at, t->size, goes_on ? Meaning::time : Meaning::text);
    if (t->kind == TokenKind::word) f(t->at, t->size, goes_on && !begins ? Meaning::time : Meaning::name);
  }
  state = lexer.state();
}

bool is_option(std::string_view w) { return std::ranges::binary_search(option_words(), w); }
bool is_function(std::string_view w, const Scene& s) {
  const auto called = [&](const FunctionSpec& f) { return f.name == w; };
  return std::ranges::any_of(built_in_functions(), called) || s.defined->find(w);
}
bool is_twerper(std::string_view w, const Scene& s) { return find_twerper(w) || find_own_twerper(s, w); }
bool is_time(std::string_view w) {
  if (w.find(':') != std::string_view::npos) return true;
  const std::size_t unit = w.find_last_not_of("fstm") + 1;
  const std::string_view u = w.substr(unit);
  return unit > 0 && (is_digit(w[unit - 1]) || w[unit - 1] == '.') && (u == "f" || u == "s" || u == "t" || u == "ms");
}

// The position of a word in its line, and the words before it.
struct Reading {
  std::string_view line;
  const Scene& scene;
  bool row = false;
  std::size_t place = 0;  // the word's index, not counting `at TIME` and `on LAYER`
  std::string_view verb, before;
  bool time_due = false, layer_due = false;
  std::optional<Making> made = making(line);

  Meaning number(std::string_view w) const {
    if (w[0] == '#') return Meaning::color;
    return is_time(w) ? Meaning::time : Meaning::number;
  }
  // Returns Meaning::name for unknown words.
  Meaning word(std::string_view w, bool key) const {
    if (key) return is_function(w, scene) ? Meaning::function : Meaning::option;
    if (place == 0 && !row) {
      const NamedProcedure* own = find_procedure(scene, w);
      return find_verb(w) || (own && own->role == Role::command) ? Meaning::verb : Meaning::name;
    }
    if (place == 0 && std::ranges::any_of(list_rows(), [&](const ListRow& r) { return r.word == w; }))
      return Meaning::verb;
    const Verb* const known = find_verb(verb);
    const std::string_view here = known && place > 0 ? words_at(known->words, place - 1) : std::string_view();
    if (has_word(here, "KIND") && (find_kind(w) || scene.kinds->find(w))) return Meaning::kind;
    if (made && w.data() == made->word.data() && made->kind == NameKind::function) return Meaning::function;
    if (made && w.data() == made->word.data() && made->kind == NameKind::kind) return Meaning::kind;
    if (has_word(here, "FILTER") && find_filter(w)) return Meaning::twerper;
    if (row && find_verb(w)) return Meaning::verb;  // as in `attach to hand`
    if (is_option(w)) return Meaning::option;
    if (is_twerper(w, scene)) return Meaning::twerper;
    if (named_color(w)) return Meaning::color;
    return has_word(here, w) ? Meaning::option : Meaning::name;
  }
};

}  // namespace

const std::vector<std::string_view>& option_words() {
  static const std::vector<std::string_view> all = [] {
    std::vector<std::string_view> words{"to",    "on",   "by",      "from", "until",  "into",  "times",
                                        "shift", "like", "through", "in",   "before", "after", "next-to"};
    for (const HelpEntry& e : help_entries())
      if (e.group == HelpGroup::option && !find_twerper(e.word)) words.push_back(e.word);
    std::ranges::sort(words);
    return words;
  }();
  return all;
}

std::vector<LinePiece> line_pieces(std::string_view line, LineState& state, const Document& d, bool row) {
  std::vector<LinePiece> all;
  Reading r{line, d.scene(), row || state.goes_on(), state.goes_on() ? std::size_t{9} : 0, {}, {}};
  const auto put = [&](std::size_t at, std::size_t length, Meaning m) {
    if (length > 0) all.push_back({at, length, m});
  };
  each_part(line, state, [&](std::size_t at, std::size_t length, Meaning m) {
    const std::string_view w = line.substr(at, length);
    if (m != Meaning::name) return put(at, length, m);
    if (w.back() == ':' && line.substr(at + length, 1) == "\"") {  // voice:"the square"
      if (!std::exchange(r.time_due, false) && !(r.row && r.place == 0)) ++r.place;
      const std::size_t dots = w.rfind(".."), name = dots == std::string_view::npos ? 0 : dots + 2;
      put(at, name, Meaning::time), put(at + name, length - name - 1, Meaning::name);
      return;
    }
    const bool key = at + length < line.size() && line[at + length] == '=';
    if (std::exchange(r.time_due, false)) return put(at, length, Meaning::time);
    if (starts_like_time(w[0]) || w[0] == '#') {
      if (!(r.row && r.place == 0)) ++r.place;
      return put(at, length, r.number(w));
    }
    if (std::exchange(r.layer_due, false)) return put(at, length, Meaning::name);
    const Verb* const verb = r.place == 0 && !r.row ? find_verb(w) : nullptr;
    if (verb && verb->flags & Verb::prefix) {
      (verb->flags & Verb::timed ? r.layer_due : r.time_due) = true;
      return put(at, length, Meaning::verb);
    }
    const std::size_t dot = first_dot(w);
    if (dot != std::string_view::npos && dot > 0) {  // it is a target
      put(at, dot, Meaning::name), put(at + dot + 1, length - dot - 1, Meaning::function);
    } else {
      const Meaning meant = r.word(w, key);
      if (meant != Meaning::name || is_letter(w[0]) || w[0] == '*' || w[0] == '{') put(at, length, meant);
    }
    if (r.place == 0) r.verb = w;
    ++r.place;
  });
  return all;
}

std::optional<NumberAt> number_at(std::string_view line, std::size_t place) {
  const auto part = [&](std::size_t i) { return i < line.size() && (is_digit(line[i]) || line[i] == '.'); };
  const auto inside = [&](std::size_t i) {
    return part(i) && !(line[i] == '.' && (line.substr(i, 2) == ".." || (i > 0 && line[i - 1] == '.')));
  };
  if (place > line.size()) return std::nullopt;
  std::size_t from = place;
  // From a unit, step back to its number.
  while (from > 0 && !inside(from) && from < line.size() && is_letter(line[from]) && is_letter(line[from - 1])) --from;
  if (from < line.size() && line[from] == '-' && inside(from + 1)) ++from;
  if (from > 0 && !inside(from)) --from;
  if (!inside(from)) return std::nullopt;
  std::size_t to = from;
  while (from > 0 && inside(from - 1)) --from;
  while (inside(to)) ++to;
  const char before = from > 0 ? line[from - 1] : ' ';
  if (is_letter(before) || before == '_' || before == '/' || before == '#' || before == '{')
    return std::nullopt;  // a name
  if (before == '-') {
    const char further = from > 1 ? line[from - 2] : ' ';
    if (is_letter(further) || further == '_') return std::nullopt;
    if (!is_digit(further) && further != ')') --from;  // else it is taken away from something
  }
  if (line.substr(from, to - from).find_first_of("0123456789") == std::string_view::npos) return std::nullopt;
  return NumberAt{from, to - from};
}

std::string stepped(std::string_view number, int steps, bool finer) {
  double value = 0;
  const auto read = std::from_chars(number.data(), number.data() + number.size(), value);
  if (read.ec != std::errc()) return std::string(number);
  const std::size_t point = number.find('.');
  const std::size_t behind = (point == std::string_view::npos ? 0 : number.size() - point - 1) + (finer ? 1 : 0);
  const int digits = static_cast<int>(std::min<std::size_t>(behind, 15));
  std::string text = fmt::format("{:.{}f}", value + steps * std::pow(10.0, -digits), digits);
  if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

std::optional<Time> time_at(std::string_view line, std::size_t place, const Document& d) {
  std::optional<Time> found;
  LineState state;
  each_part(line, state, [&](std::size_t at, std::size_t length, Meaning m) {
    if (m != Meaning::name || place < at) return;
    std::string_view w = line.substr(at, length);
    if (const std::size_t moment = moment_length(line.substr(at)); moment > 0 && place <= at + moment) {
      if (const Result<Time> t = parse_time(line.substr(at, moment), d)) found = *t;
      return;
    }
    if (place > at + length) return;
    const std::size_t dots = w.find("..");
    if (dots != std::string_view::npos) w = place - at <= dots ? w.substr(0, dots) : w.substr(dots + 2);
    if (w.empty() || w[0] == '+' || !is_time(w)) return;
    if (const Result<Time> t = parse_time(w, d)) found = *t;
  });
  return found;
}

}  // namespace betwixt
