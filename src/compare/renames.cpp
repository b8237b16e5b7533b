// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/renames.h"

#include <algorithm>
#include <set>
#include <vector>

#include "editor/editor.h"
#include "syntax/tokens.h"

namespace betwixt {
namespace {

using ManyNames = std::set<std::string, std::less<>>;

// Returns the text with all of some names replaced by one that no object has.
std::string without_names(std::string_view text, const ManyNames& names) {
  std::string out;
  Lexer lexer(text);
  while (const auto token = lexer.next()) {
    std::string_view word = lexer.of(*token);
    if (token->kind == TokenKind::word) {
      const std::string_view name = word.substr(0, std::min(first_dot(word), word.size()));
      if (names.contains(name)) out += "?", word.remove_prefix(name.size());
    }
    out += word;
  }
  return out;
}

// What some objects are, apart from their names.
std::map<std::string, std::string> contents(const Facts& facts, const ManyNames& of) {
  std::map<std::string, std::string> all;
  for (const auto& [key, said] : facts.said) {
    if (!of.contains(key.object)) continue;
    all[key.object] += std::to_string(static_cast<int>(key.part)) + " " + key.about + " " +
                       (of.contains(key.layer) ? "?" : key.layer) + " " + std::to_string(key.time.flicks) + " " +
                       without_names(said, of) + "\n";
  }
  return all;
}

std::string last_part(const std::string& name) { return name.substr(name.rfind('/') + 1); }

}  // namespace

Renames renames_between(const Facts& old, const Facts& now) {
  const ManyNames before(old.objects.begin(), old.objects.end()), after(now.objects.begin(), now.objects.end());
  ManyNames gone, come;
  std::ranges::set_difference(before, after, std::inserter(gone, gone.end()));
  std::ranges::set_difference(after, before, std::inserter(come, come.end()));
  if (gone.empty() || come.empty()) return {};
  const auto was = contents(old, gone), is = contents(now, come);
  std::map<std::string_view, std::vector<std::string>> by_content;
  for (const std::string& name : now.objects)
    if (come.contains(name)) by_content[is.at(name)].push_back(name);
  Renames all;
  for (const std::string& name : old.objects) {
    if (!gone.contains(name)) continue;
    const auto like = by_content.find(was.at(name));
    if (like == by_content.end() || like->second.empty()) continue;
    // Among equals, one with the same last part (man/arm, guy/arm), otherwise the first.
    auto& names = like->second;
    auto found = std::ranges::find(names, last_part(name), last_part);
    if (found == names.end()) found = names.begin();
    all[name] = *found;
    names.erase(found);
  }
  Renames own;
  for (const auto& [name, other] : all) {
    bool follows = false;
    for (std::size_t slash = name.rfind('/'); slash != std::string::npos && slash > 0 && !follows;
         slash = name.rfind('/', slash - 1)) {
      const auto above = all.find(name.substr(0, slash));
      follows = above != all.end() && other == above->second + name.substr(slash);
    }
    if (!follows) own.emplace(name, other);
  }
  return own;
}

Document renamed(const Document& d, const Renames& names) {
  const Editor editor;
  Point at{d, {}, {}};
  for (const auto& [name, other] : names) {
    CommandResult result = editor.carry_out(at, "rename " + name + " " + other);
    if (result.done) at = std::move(result.after);
  }
  return at.document;
}

}  // namespace betwixt
