// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What the transform of one object depends on. A query for it evaluates nothing else, so that unrelated values can read
// it without a cycle.
#pragma once

#include <span>
#include <vector>

#include "program/compiled.h"

namespace betwixt {

// Flags by node, at one time.
struct Needed {
  std::vector<bool> places;  // its position is needed
  std::vector<bool> turns;   // its rotation and scale too
  std::vector<bool> aims;    // its look-at or reach target is needed
  std::vector<bool> held;    // its parent is needed
  bool wants(const Schedule::LiveSource&) const;
};

// Returns the needs of the nodes' whole matrices, or of their positions alone if not `turned`.
Needed needed(const Program::Compiled&, std::span<const std::uint32_t> nodes, bool turned, Time, Asking&);
// Returns true if a node's rotation and scale do not affect its position.
bool turns_in_place(const CompiledFilm&, const Node&);

}  // namespace betwixt
