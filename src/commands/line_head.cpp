// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "commands/line_head.h"

#include "base/names.h"

namespace betwixt {
namespace {

constexpr std::size_t most_made = 10'000;

std::optional<NameKind> kind_made(const Verb& v) {
  if (v.flags & Verb::makes_thing) return NameKind::thing;
  if (v.flags & Verb::makes_let) return NameKind::let;
  if (v.flags & Verb::makes_function) return NameKind::function;
  if (v.flags & Verb::makes_procedure) return NameKind::procedure;
  return std::nullopt;
}

}  // namespace

LineHead line_head(std::string_view line) {
  LineHead head;
  head.row = indented(line);
  for (;;) {
    head.word = take_piece(line);
    head.verb = find_verb(head.word);
    if (!head.verb || !(head.verb->flags & Verb::prefix)) break;
    (head.verb->flags & Verb::timed ? head.layer : head.time) = take_piece(line);  // only `on LAYER` can follow a time
  }
  head.name = take_piece(line);
  head.rest = line;
  return head;
}

std::string_view kind_word(const LineHead& head) {
  const bool takes_kind = head.verb && has_word(words_at(head.verb->words, 1), "KIND");
  return takes_kind ? first_word(head.rest) : std::string_view();
}

Opens opens(const LineHead& head) {
  if (head.row || !head.alone()) return Opens::nothing;
  if (head.verb) return head.verb->flags & Verb::opens_sheet && !head.name.empty() ? Opens::list : Opens::nothing;
  const bool target =
      first_dot(head.word) != std::string_view::npos && !starts_like_time(head.word[0]) && head.word[0] != '"';
  return target && head.time.empty() && head.name.empty() ? Opens::sheet : Opens::nothing;
}

std::size_t opener_of(const ScriptText& text, std::size_t line) {
  std::size_t at = text.first_of(line);
  if (!indented(text.line(at))) return text.count();
  while (at > 0 && below_opener(text.line(at))) at = text.first_of(at - 1);
  return opens_sheet(text.line(at)) ? at : text.count();
}

std::optional<Making> making(std::string_view line) {
  const LineHead head = line_head(line);
  if (head.row || !head.verb) return std::nullopt;
  auto kind = kind_made(*head.verb);
  if (!kind) return std::nullopt;
  std::string_view word = head.name, rest = head.rest;
  if (word == "again" && kind == NameKind::let) word = take_piece(rest);  // let again NAME
  if (word == "kind" && kind == NameKind::function) {                     // define kind NAME like OBJECT
    std::string_view after = rest;
    const std::string_view name = take_piece(after);
    if (take_piece(after) == "like") kind = NameKind::kind, word = name;
  }
  word = between(word.data(), word_end(word.data(), word.data() + word.size()));  // x in x=1
  if (word.empty()) return std::nullopt;
  return Making{head.word, word, *kind};
}

std::vector<std::string_view> making_verbs() {
  std::vector<std::string_view> words;
  for (const Verb& v : verbs())
    if (kind_made(v)) words.push_back(v.word);
  return words;
}

std::vector<std::string> names_made(std::string_view line) {
  const LineHead head = line_head(line);
  if (head.verb && head.verb->flags & Verb::makes_parts && !head.name.empty()) return {std::string(head.name) + '/'};
  const auto made = making(line);
  if (!made) return {};
  auto names = expand_braces(made->word, most_made);
  return names ? *std::move(names) : std::vector<std::string>();
}

}  // namespace betwixt
