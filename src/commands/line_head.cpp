// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "commands/line_head.h"

#include <algorithm>

#include "base/names.h"

namespace betwixt {
namespace {

constexpr std::size_t most_made = 10'000;

std::optional<NameKind> kind_made(const Verb& v) {
  if (v.flags & Verb::makes_thing) return NameKind::thing;
  if (v.flags & Verb::makes_let) return NameKind::let;
  if (v.flags & Verb::makes_function) return NameKind::function;
  if (v.flags & Verb::makes_procedure) return NameKind::procedure;
  if (v.flags & Verb::makes_kind) return NameKind::kind;
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
  if (!head.alone()) return Opens::nothing;
  if (head.verb) return head.verb->flags & Verb::opens_sheet && !head.name.empty() ? Opens::list : Opens::nothing;
  // A single word: neither "ler(0.5)" nor "=o.x" opens a sheet, however they are spaced.
  const char* const end = head.word.data() + head.word.size();
  const bool target = first_dot(head.word) != std::string_view::npos && !starts_like_time(head.word[0]) &&
                      word_end(head.word.data(), end) == end;
  return target && head.time.empty() && head.name.empty() ? Opens::sheet : Opens::nothing;
}

bool opens_block(const LineHead& head) { return head.verb && head.verb->flags & Verb::opens_block; }

namespace {

// Returns the line and those that it may be below: the nearest one above that is indented less, and so on. The
// outermost comes first.
std::vector<std::size_t> those_above(const ScriptText& text, std::size_t line) {
  std::vector<std::size_t> chain{text.first_of(line)};
  std::size_t least = indentation(text.line(chain[0]));
  for (std::size_t at = chain[0]; at > 0 && least > 0;) {
    at = text.first_of(at - 1);
    const std::string_view there = text.line(at);
    if (indentation(there) >= least || empty_line(there)) continue;
    least = indentation(there);
    chain.push_back(at);
  }
  std::reverse(chain.begin(), chain.end());
  return chain;
}

}  // namespace

std::size_t opener_of(const ScriptText& text, std::size_t line) {
  const std::vector<std::size_t> chain = those_above(text, line);
  for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    if (opens_sheet(text.line(chain[i]))) return chain[i];
  return text.count();
}

std::size_t block_of(const ScriptText& text, std::size_t line) {
  const std::vector<std::size_t> chain = those_above(text, line);
  std::size_t found = text.count();
  for (std::size_t i = 0; i + 1 < chain.size() && !opens_sheet(text.line(chain[i])); ++i)
    if (opens_block(text.line(chain[i]))) found = chain[i];
  return found;
}

bool Indentation::row(std::string_view line) {
  const std::size_t here = indentation(line);
  pending_ = 0;
  while (!blocks_.empty()) {
    Open& inner = blocks_.back();
    if (!inner.indent && here > inner.outer) inner.indent = here;
    if (inner.indent && here >= *inner.indent) break;
    blocks_.pop_back();
  }
  const std::size_t margin = blocks_.empty() ? 0 : *blocks_.back().indent;
  if (sheet_ != Opens::nothing && here > margin) return true;
  const LineHead head = line_head(line);
  sheet_ = opens(head);
  if (opens_block(head)) blocks_.push_back({here, {}, std::string(line)}), pending_ = 1;
  return false;
}

std::optional<Making> making(std::string_view line) {
  const LineHead head = line_head(line);
  if (!head.verb) return std::nullopt;
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
