// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The state that a stepped procedure passes from one step to the next: a value, or a table of states.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "betwixt/value.h"

namespace betwixt {

struct State {
  struct Entry;
  using Key = std::variant<std::int64_t, std::string>;
  using Table = std::vector<Entry>;  // sorted: whole numbers before texts

  // Nothing (before the first step), a whole number, a value, or a table. A `double` in Value is a number that may be
  // between two steps; a whole number holds until the next step.
  std::variant<std::monostate, std::int64_t, Value, Table> is;
};
struct State::Entry {
  Key key;
  State state;
};

// Returns about how many bytes the state takes.
std::size_t bytes_of(const State&);

}  // namespace betwixt
