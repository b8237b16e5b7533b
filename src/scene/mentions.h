// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Which objects refer to which, so that a sequence of changes need not search all objects each time. It is computed
// once, and again only for objects that have changed. It may have too many entries, since it remembers removed values:
// check each object that it names; no others need to be checked.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "scene/document.h"

namespace betwixt {

class Mentions {
 public:
  void follow(const Scene&);  // updates it to the same scene, which may have changed
  // Returns, in order of creation, the objects whose attachments, layers or paths refer to one of these, or that refer
  // to one, or to a name below it, in texts of code.
  std::vector<std::uint32_t> of(const Scene&, const std::vector<ObjectId>&) const;
  // Returns the objects named below it.
  std::vector<std::uint32_t> below(std::string_view name) const;

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view s) const { return std::hash<std::string_view>{}(s); }
  };
  using Speakers = std::unordered_set<std::uint32_t>;
  using ByName = std::unordered_map<std::string, Speakers, Hash, std::equal_to<>>;

  void look_at(const Object&, std::uint32_t number);
  void look_at(const Value&, std::uint32_t number);
  void name(std::string_view, std::uint32_t number);
  static void add_above(ByName&, std::string_view name, std::uint32_t number);

  Objects seen_;
  std::unordered_map<std::uint32_t, Speakers> by_number_;
  ByName by_name_, below_;
};

// Returns the numbers of all existing objects.
std::vector<std::uint32_t> all_of(const Objects&);

}  // namespace betwixt
