// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Which objects speak of which, so that who changes one thing after the other need not look at all of them each time.
// It is found out once, and then again of objects that have changed. What it says may be more than there is: a value
// that was taken out is still known here. So each that it names is to be looked at, and no others are.
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
  void follow(const Scene&);  // the same scene as before, which may have changed
  // Those whose attachments, layers or ways along lines are of one of these, or that speak of one or of what is below
  // it by its name, in texts of code too; in the order of creation.
  std::vector<std::uint32_t> of(const Scene&, const std::vector<ObjectId>&) const;
  // Those that are named below it.
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

// The numbers of all there are: those that a few questions are asked about.
std::vector<std::uint32_t> all_of(const Objects&);

}  // namespace betwixt
