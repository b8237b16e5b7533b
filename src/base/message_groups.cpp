// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "base/message_groups.h"

#include <fmt/format.h>

#include <algorithm>

namespace betwixt {
namespace {

// Returns the subject OBJECT.FUNCTION of a message, or "" if it has none.
std::string_view thing_of(std::string_view message) {
  const std::string_view first = message.substr(0, message.find_first_of(": "));
  return first.find('.') == std::string_view::npos || first.size() == message.size() ? std::string_view() : first;
}

// Returns the message without its subject and its code, which may differ for each object of a pattern.
std::string_view besides(std::string_view message) {
  constexpr std::string_view behind_code = "\" gives no value: ";
  const auto code = message.find(behind_code);
  return message.substr(code == std::string_view::npos ? thing_of(message).size() : code);
}

}  // namespace

std::size_t MessageGroups::add(std::string_view message, std::string_view where) {
  const std::string_view thing = thing_of(message);
  std::string key = fmt::format("{} {}", where, thing.empty() ? message : besides(message));
  const auto same = std::find_if(all_.begin(), all_.end(), [&](const Said& said) { return said.key == key; });
  const auto number = static_cast<std::size_t>(same - all_.begin());
  if (same == all_.end()) all_.push_back({std::string(message), std::move(key), {}});
  std::vector<std::string>& things = all_[number].things;
  if (std::find(things.begin(), things.end(), thing) == things.end()) things.emplace_back(thing);
  return number;
}

std::string MessageGroups::text(std::size_t number) const {
  constexpr std::size_t most = 4;
  const Said& said = all_[number];
  if (said.things.size() < 2) return said.first;
  const auto first = said.things.begin() + 1;
  const std::size_t others = said.things.size() - 1, named = std::min(others, most);
  const std::string names = fmt::format("{}", fmt::join(first, first + static_cast<std::ptrdiff_t>(named), ", "));
  return others == 1
             ? fmt::format("{}; likewise {}", said.first, names)
             : fmt::format("{}; likewise {} others: {}{}", said.first, others, names, others > most ? ", …" : "");
}

}  // namespace betwixt
