// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The lines of a part, for one object: the names that they make are put below it.
#include <algorithm>
#include <optional>
#include <set>

#include "base/names.h"
#include "commands/line_head.h"
#include "commands/parts.h"
#include "syntax/tokens.h"

namespace betwixt {
namespace {

using Names = std::set<std::string, std::less<>>;

Names names_in(std::string_view lines) {
  Names names;
  for (const char *at = lines.data(), *end = at + lines.size(); at < end;) {
    const LogicalLine one = logical_line(between(at, end));
    const std::string_view line = without_indent(between(at, one.end));
    if (const auto made = making(line); made && made->kind == NameKind::thing)
      for (std::string& name : names_made(line)) names.insert(std::move(name));
    at = one.next(end);
  }
  return names;
}

// Returns whether a name or a pattern means objects of the part.
bool means_own(const Names& own, std::string_view name) {
  const auto one = [&](std::string_view word) {
    const std::string_view first = word.substr(0, word.find('/'));
    return own.contains(word) || own.contains(first) ||
           (is_pattern(word) &&
            std::any_of(own.begin(), own.end(), [&](const std::string& known) { return matches(word, known); }));
  };
  if (name.find('{') == name.npos) return one(name);
  const auto all = expand_braces(name, 10'000);
  return all && std::any_of(all->begin(), all->end(), one);
}

class Renaming {
 public:
  Renaming(const Part& part, const std::string& self) : own_(names_in(part.lines)), self_(self) {
    for (const PartParameter& p : part.parameters) parameters_.insert(p.name);
  }

  std::string line(std::string_view text) const {
    std::string out;
    Lexer lexer(text);
    std::string_view verb, before;
    std::size_t words = 0;
    bool skip = false;  // the piece behind at or on
    for (auto token = lexer.next(); token; token = lexer.next()) {
      const std::string_view piece = lexer.of(*token);
      if (token->kind == TokenKind::word) {
        const std::string_view rest = text.substr(token->end());
        const bool key = rest.starts_with('=') && words > 0;
        const bool kind = verb == "create" && words == 2 && before != "like";
        const bool is_verb = words == 0 && first_dot(piece) == piece.npos;
        const bool value = words > 1 && parameters_.contains(piece);  // also if an object has the same name
        out += key || kind || is_verb || value ? std::string(piece) : word(piece);
        // `at TIME` and `on LAYER` come before the verb.
        if (is_verb && (piece == "at" || piece == "on"))
          words = 0, verb = {}, skip = true;
        else if (skip)
          skip = false;
        else if (++words == 1)
          verb = piece;
        before = piece;
      } else if (token->kind == TokenKind::text) {
        out += quoted(piece);
        if (skip) skip = false;
      } else {
        out += piece;
      }
    }
    return out;
  }

 private:
  std::string word(std::string_view w) const {
    const std::size_t dot = first_dot(w);
    const std::string_view name = w.substr(0, dot), rest = dot == w.npos ? std::string_view() : w.substr(dot);
    if (name == "self" || name.starts_with("self/")) return self_ + std::string(w.substr(4));
    return means_own(own_, name) ? self_ + "/" + std::string(name) + std::string(rest) : std::string(w);
  }
  std::string quoted(std::string_view text) const {
    std::string out(text);
    for (std::size_t at = out.find("self"); at != out.npos; at = out.find("self", at)) {
      const char behind = at + 4 < out.size() ? out[at + 4] : ' ', front = at > 0 ? out[at - 1] : ' ';
      const bool meant = (front == '\'' || front == '"') && (behind == '/' || behind == '.' || behind == '\'');
      if (meant) out.replace(at, 4, self_);
      at += meant ? self_.size() : 4;
    }
    return out;
  }

  const Names own_;
  Names parameters_;
  const std::string& self_;
};

}  // namespace

std::string lines_for(const Part& part, const std::string& self) {
  const Renaming renaming(part, self);
  const std::string& lines = part.lines;
  std::string out;
  std::optional<std::size_t> margin;  // the indentation of the commands
  for (const char *at = lines.data(), *end = at + lines.size(); at < end;) {
    const LogicalLine one = logical_line(between(at, end));
    const std::string_view line = between(at, one.end);
    const std::size_t indent = static_cast<std::size_t>(without_indent(line).data() - line.data());
    if (!margin && !empty_line(line)) margin = indent;
    out += renaming.line(line.substr(std::min(indent, margin.value_or(indent)))) + '\n';
    at = one.next(end);
  }
  return out;
}

}  // namespace betwixt
