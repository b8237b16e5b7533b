// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "base/message_groups.h"

#include <fmt/format.h>

#include <algorithm>

namespace betwixt {
std::size_t MessageGroups::add(const Problem& p, const std::string& where) {
  const auto same = std::find_if(all_.begin(), all_.end(), [&](const Said& said) {
    Problem other = said.first;
    other.subject = p.subject;
    if (p.what == Problem::procedure) other.name = p.name;
    return said.where == where && other == p;
  });
  const auto number = static_cast<std::size_t>(same - all_.begin());
  if (same == all_.end()) all_.push_back({p, where, {}});
  std::vector<std::string>& subjects = all_[number].subjects;
  if (std::find(subjects.begin(), subjects.end(), p.subject) == subjects.end()) subjects.push_back(p.subject);
  return number;
}

std::string MessageGroups::text(std::size_t number) const {
  constexpr std::size_t most = 4;
  const Said& said = all_[number];
  std::string text = to_string(said.first);
  if (said.subjects.size() < 2) return text;
  const auto first = said.subjects.begin() + 1;
  const std::size_t others = said.subjects.size() - 1, named = std::min(others, most);
  const std::string names = fmt::format("{}", fmt::join(first, first + static_cast<std::ptrdiff_t>(named), ", "));
  return others == 1 ? fmt::format("{}; likewise {}", text, names)
                     : fmt::format("{}; likewise {} others: {}{}", text, others, names, others > most ? ", …" : "");
}

}  // namespace betwixt
