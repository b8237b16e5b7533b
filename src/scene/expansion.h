// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Scans display lists: the objects that they become at one time.
#pragma once

#include <set>

#include "scene/document.h"

namespace betwixt {

// How many objects a list becomes, and how deep they are nested.
struct ExpansionSize {
  std::size_t objects = 0;
  int depth = 0;
};
ExpansionSize expansion_size(const DisplayLists&, const std::string& main);

// An object that a list becomes.
struct ExpandedPart {
  Object object;  // without a name
  std::int32_t parent = -1;
  std::int32_t within = -1;  // whose name is the beginning of its own: the parent's, or that of the parent's parent
  std::string word;          // star-2
};
struct Expanded {
  std::vector<ExpandedPart> parts;            // parents before children; the camera, if any, last
  std::set<std::string, std::less<>> called;  // lists, whether they exist or not
};
Expanded expanded(const Scene&, const DisplayLists&, const std::string& main);

}  // namespace betwixt
