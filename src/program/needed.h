// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What it takes to know where one thing is: whoever asks for that asks nothing else, so that what has no part in it may
// look at it without going round in a circle.
#pragma once

#include <vector>

#include "program/compiled.h"

namespace betwixt {

// By node, at one time.
struct Needed {
  std::vector<bool> places;  // it is wanted where it is
  std::vector<bool> turns;   // and how it is turned and scaled
  std::vector<bool> aims;    // what it looks at or reaches for counts
  std::vector<bool> held;    // what holds it counts
  bool wants(const Schedule::LiveSource&) const;
};

// `turned`: of the whole matrix of a node; else of its place alone.
Needed needed(const Program::Compiled&, std::uint32_t node, bool turned, Time, Asking&);
// Whether a node is where its position says however it is turned and scaled.
bool turns_in_place(const Program::Compiled&, const Node&);

}  // namespace betwixt
