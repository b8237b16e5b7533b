// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares texts, and merges two changes of a text, line by line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace betwixt {

// Returns for each line of `a` the place of its equal in `b`, or -1: a longest common subsequence. If there are
// thousands of differences, the part with the rest of them has no equals.
std::vector<int> equal_lines(const std::vector<std::string_view>& a, const std::vector<std::string_view>& b);

// A run of lines in the three texts, each with its line ending.
struct LineRegion {
  std::vector<std::string_view> base, mine, theirs;
  bool conflict = false;  // both differ from the base and from each other
  // Of a region without a conflict: the lines that both changes together make.
  const std::vector<std::string_view>& merged() const { return mine == base ? theirs : mine; }
};
std::vector<LineRegion> regions_of(std::string_view base, std::string_view mine, std::string_view theirs);

// What replaces a conflict.
enum class InConflict : std::uint8_t {
  marks,        // both, between <<<<<<< and >>>>>>>
  mine,         // mine, and the comments that only theirs have
  mine_theirs,  // where both only add: mine, then theirs; otherwise as `mine`
  theirs_mine,
};
std::string text_of(const std::vector<LineRegion>&, InConflict);

}  // namespace betwixt
