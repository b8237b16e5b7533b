// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Display lists scanned: what objects they become at one time.
#pragma once

#include <set>

#include "scene/document.h"

namespace betwixt {

// How many objects a list becomes, and how deep they stand in one another.
struct ExpansionSize {
  std::size_t objects = 0;
  int depth = 0;
};
ExpansionSize expansion_size(const DisplayLists&, const std::string& main);

// An object that a list becomes.
struct ExpandedPart {
  Object object;  // without a name
  std::int32_t parent = -1;
  std::int32_t within = -1;  // whose name stands before its own: the parent's, or that of what holds the parent
  std::string word;          // star-2
};
struct Expanded {
  std::vector<ExpandedPart> parts;            // what holds others before them; the camera, if any, last
  std::set<std::string, std::less<>> called;  // lists, whether they are there or not
};
Expanded expanded(const Scene&, const DisplayLists&, const std::string& main);

}  // namespace betwixt
