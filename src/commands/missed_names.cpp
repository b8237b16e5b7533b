// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The names that a failed line would have made, and those that an error is about.
#include "base/utf8.h"
#include "commands/line_head.h"
#include "commands/own_kinds.h"
#include "commands/reader.h"

namespace betwixt {

std::vector<std::string> names_missed(const Scene& s, std::string_view line) {
  auto names = names_made(line);
  std::erase_if(names, [&](const std::string& name) {
    return s.names.find(name) || s.aliases->contains(name) || s.lets->contains(name) || s.tables->contains(name) ||
           s.parts->contains(name) || s.lists->contains(name) || s.defined->find(name) || find_procedure(s, name) ||
           s.kinds->find(name);
  });
  return names;
}

std::string_view name_missed(const Error& e) {
  return e.code == ErrorCode::name ? std::string_view(e.subject) : std::string_view();
}

bool unknown_command(const Error& e, std::string_view line) {
  const std::string_view word = first_word(line);
  return e.code == ErrorCode::name && e.hint.empty() && e.place.line > 0 && !word.empty() && !find_verb(word) &&
         static_cast<std::size_t>(e.place.column) == 1 + count_characters(between(line.data(), word.data())) &&
         static_cast<std::size_t>(e.place.length) == count_characters(word);
}

std::vector<std::string_view> with_those_above(std::string_view name) {
  std::vector<std::string_view> all;
  if (!name.empty()) all.push_back(name);
  for (std::size_t at = name.rfind('/'); at != name.npos && at > 0; at = name.rfind('/', at - 1))
    all.push_back(name.substr(0, at + 1)), all.push_back(name.substr(0, at));
  return all;
}

}  // namespace betwixt
