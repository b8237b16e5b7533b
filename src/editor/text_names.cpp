// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/text_names.h"

#include <algorithm>

#include "base/names.h"
#include "language/cursor.h"
#include "scene/document.h"
#include "scene/own_kinds.h"
#include "syntax/tokens.h"

namespace betwixt {
namespace {

constexpr std::size_t most_made = 10'000;  // names of one pattern that are expanded

bool of_word(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; }
bool of_function(char c) { return of_word(c) || c == '-'; }
bool of_path(char c) { return of_function(c) || c == '/'; }

// Returns the longest run of matching characters around a place.
template <class Belongs>
Span run_around(std::string_view line, std::size_t place, Belongs&& belongs) {
  std::size_t from = place, to = place;
  while (from > 0 && belongs(line[from - 1])) --from;
  while (to < line.size() && belongs(line[to])) ++to;
  return {from, to - from};
}
std::string_view part(std::string_view line, Span s) { return line.substr(s.at, s.size); }

// Returns the path up to the end of the part at the place.
Span path_around(std::string_view line, std::size_t place) {
  Span path = run_around(line, place, of_path);
  const std::size_t slash = line.find('/', place);
  if (slash < path.end()) path.size = slash - path.at;
  return path;
}

// Returns true if the place is in a string within the code that begins at `from`: 'so', or \"so\" if the code is in
// quotes itself.
bool in_quotes(std::string_view line, std::size_t from, std::size_t place) {
  char open = 0;
  for (; from < place; ++from)
    if (line[from] == open)
      open = 0;
    else if (open == 0 && (line[from] == '"' || line[from] == '\''))
      open = line[from];
  return open != 0;
}

// Returns true if the word is a value word of the function (or key) before it: shines=sun.
bool is_value_word(std::string_view line, std::size_t word_at, std::string_view word) {
  auto token = token_before(line, word_at);
  if (token && token->kind == TokenKind::sign) token = token_before(line, token->at);
  if (!token || token->kind != TokenKind::word) return false;
  const std::string_view name = part(line, run_around(line.substr(0, token->end()), token->end(), of_function));
  const auto has = [&](const FunctionSpec& f) {
    if (f.name != name) return false;
    const std::vector<std::string_view> words = choices(f);
    return std::ranges::find(words, word) != words.end();
  };
  return std::ranges::any_of(built_in_functions(), has);
}

// Returns the last character before a place that is not blank.
char before(std::string_view line, std::size_t place) {
  while (place > 0 && blank(line[place - 1])) --place;
  return place > 0 ? line[place - 1] : '\n';
}

// Returns true if the string that begins at a place is code: of a procedure, or after the sign of a computed value.
bool begins_code(const ScriptText& lines, std::size_t line, std::size_t place) {
  const LineHead head = line_head(lines.line(lines.first_of(line)));
  if (head.verb && head.verb->flags & Verb::makes_procedure) return true;
  const std::string_view there = lines.line(line);
  const auto token = token_before(there, place);
  return token && there[token->at] == '=' && token->at > 0 && blank(there[token->at - 1]);
}

}  // namespace

TextNames::TextNames(std::span<const FilmText> texts, const Document& film) : texts_(texts), film_(film) {
  for (std::size_t i = 0; i < texts.size(); ++i) find_made(i);
}

void TextNames::find_made(std::size_t text) {
  const ScriptText& lines = texts_[text].lines;
  for (std::size_t i = 0; i < lines.count(); ++i) {
    const std::string_view line = lines.line(i);
    const std::string_view said = without_indent(line);
    if (said.empty() || !of_word(said[0]) || lines.state_above(i).goes_on()) continue;
    const auto m = making(line);
    if (!m) continue;
    const auto place = [&](std::string_view w) { return static_cast<std::size_t>(w.data() - line.data()); };
    const Span word{lines.start(i) + place(m->word), m->word.size()};
    made_.push_back({{text, word}, m->kind, lines.start(i) + place(m->verb), m->verb.size(), is_pattern(m->word)});
    if (const auto names = expand_braces(m->word, most_made))
      for (const std::string& name : *names) by_name_[name].push_back(made_.size() - 1);
  }
}

bool TextNames::known(const std::string& name, NameKind kind) const {
  const Scene& s = film_.scene();
  if (kind == NameKind::thing && (s.names.find(name) || s.aliases->contains(name) || s.lists->contains(name)))
    return true;
  if (kind == NameKind::let && s.lets->contains(name)) return true;
  if (kind == NameKind::function && s.defined->find(name)) return true;
  if (kind == NameKind::procedure && find_procedure(s, name)) return true;
  if (kind == NameKind::kind && s.kinds->find(name)) return true;
  const auto found = by_name_.find(name);
  return found != by_name_.end() &&
         std::ranges::any_of(found->second, [&](std::size_t i) { return made_[i].kind == kind; });
}

std::optional<NameAt> TextNames::word_at(std::string_view line, std::size_t from, std::size_t place,
                                         const LinePiece& piece, std::optional<NameKind> must) const {
  const auto found = [&](Span s, NameKind kind) -> std::optional<NameAt> {
    std::string name(part(line, s));
    if (s.size == 0 || !of_word(name[0]) || (kind != must && !known(name, kind))) return std::nullopt;
    return NameAt{std::move(name), kind, {from + s.at, s.size}};
  };
  const std::string_view whole = line.substr(piece.at, piece.length);
  const bool named = must || piece.meaning == Meaning::name;
  // The beginning of a pattern may be a name: man in man/finger{1..5}.
  const Span path = path_around(line, place);
  const bool above = path.end() < line.size() && line[path.end()] == '/';
  if (named && above && is_pattern(whole) && path.at == piece.at)
    if (auto thing = found(path, NameKind::thing)) return thing;
  if (must && is_pattern(whole)) return NameAt{std::string(whole), *must, {from + piece.at, piece.length}, true};
  if (piece.meaning == Meaning::kind || must == NameKind::kind)
    return found(run_around(line, place, of_function), NameKind::kind);
  if (piece.meaning == Meaning::function || must == NameKind::function)
    return found(run_around(line, place, of_function), NameKind::function);
  if (must == NameKind::thing || (!must && named && !is_value_word(line, path.at, part(line, path))))
    if (auto thing = found(path, NameKind::thing)) return thing;
  if (!must || must == NameKind::let)
    if (auto let = found(run_around(line, place, of_word), NameKind::let)) return let;
  if (!must || must == NameKind::procedure)
    if (auto code = found(run_around(line, place, of_function), NameKind::procedure)) return code;
  if (piece.meaning == Meaning::name && is_pattern(whole) && !select(film_.scene(), whole).empty())
    return NameAt{std::string(whole), NameKind::thing, {from + piece.at, piece.length}, true};
  return std::nullopt;
}

// Strings that are code name objects in quotes, functions after a dot, and everything else by bare words. In other
// strings, such as motions, only objects after @ are names.
std::optional<NameAt> TextNames::in_text(const ScriptText& lines, std::size_t at, const LinePiece& piece,
                                         std::size_t place) const {
  const std::string_view line = lines.line(at);
  std::size_t opened = at, opens = piece.at;
  if (piece.at == 0 && lines.state_above(at).text) {
    while (opened > 0 && lines.state_above(opened).text) --opened;
    opens = lines.tokens(opened).back().at;
  }
  const auto found = [&](Span s, NameKind kind) -> std::optional<NameAt> {
    std::string name(part(line, s));
    if (s.size == 0 || s.at < piece.at || s.end() > piece.at + piece.length || !known(name, kind)) return std::nullopt;
    return NameAt{std::move(name), kind, {lines.start(at) + s.at, s.size}};
  };
  const Span path = path_around(line, place);
  const char left = path.at > 0 ? line[path.at - 1] : '\n';
  if (before(line, path.at) == '@') return found(path, NameKind::thing);
  if (!begins_code(lines, opened, opens)) return std::nullopt;
  if ((left == '"' && path.at != piece.at + 1) || left == '\'') return found(path, NameKind::thing);
  const Span word = run_around(line, place, of_function);
  if (word.at > 0 && line[word.at - 1] == '.') return found(word, NameKind::function);
  const std::size_t code = opened == at ? opens + quotes_of(line.substr(opens)) : 0;
  if (in_quotes(line, code, path.at)) return std::nullopt;
  const Span bare = run_around(line, place, of_word);
  if (auto let = found(bare, NameKind::let)) return let;
  return found(bare, NameKind::procedure);
}

std::optional<NameAt> TextNames::at(std::size_t text, std::size_t place) const {
  const ScriptText& lines = texts_[text].lines;
  const std::size_t number = lines.line_of(place), from = lines.start(number);
  const std::string_view line = lines.line(number);
  const std::size_t in_line = place - from;
  if (in_line > line.size()) return std::nullopt;
  LineState state = lines.state_above(number);
  const auto given = state.goes_on() ? std::nullopt : making(line);
  std::optional<LinePiece> piece;
  for (const LinePiece& p : line_pieces(line, state, film_, is_row(lines, number)))
    if (p.at <= in_line && in_line <= p.at + p.length) piece = p;  // where two tokens meet, the second
  if (!piece || piece->meaning == Meaning::comment) return std::nullopt;
  if (piece->meaning == Meaning::text) return in_text(lines, number, *piece, in_line);
  std::optional<NameKind> must;
  if (given && given->word.data() == line.data() + piece->at) must = given->kind;
  return word_at(line, from, in_line, *piece, must);
}

std::vector<TextSpan> TextNames::made(const NameAt& asked) const {
  std::vector<std::string> names{asked.name};
  if (asked.pattern) {
    if (const auto all = expand_braces(asked.name, most_made)) names = *all;
    std::erase_if(names, [&](const std::string& name) { return !by_name_.contains(name); });
    for (const ObjectId id : select(film_.scene(), asked.name)) names.push_back(film_.name(id));
  }
  std::vector<TextSpan> all;
  for (std::string name : names) {
    auto found = by_name_.find(name);
    while (asked.kind == NameKind::thing && found == by_name_.end() && name.find('/') != std::string::npos)
      name.resize(name.rfind('/')), found = by_name_.find(name);
    if (found == by_name_.end()) continue;
    for (const std::size_t i : found->second)
      if (made_[i].kind == asked.kind && std::ranges::find(all, made_[i].word) == all.end())
        all.push_back(made_[i].word);
  }
  return all;
}

std::vector<TextSpan> TextNames::uses(const NameAt& asked) const {
  std::vector<TextSpan> all;
  const std::string& name = asked.name;
  const auto edge = [&](char c) { return asked.kind == NameKind::let ? !of_word(c) : !of_function(c); };
  for (std::size_t t = 0; t < texts_.size(); ++t) {
    const std::string& text = texts_[t].lines.text();
    for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos; at += name.size()) {
      const std::size_t end = at + name.size();
      if ((at > 0 && !edge(text[at - 1])) || (end < text.size() && !edge(text[end]))) continue;
      const auto there = this->at(t, end - 1);  // its end distinguishes man/arm from man
      if (there && there->kind == asked.kind && there->name == name && there->pattern == asked.pattern &&
          there->span.at == at)
        all.push_back({t, there->span});
    }
  }
  return all;
}

}  // namespace betwixt
