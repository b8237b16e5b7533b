// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Filters: pure functions through time on a track. (twixt notes, G105; R-T16)
#pragma once

#include <optional>

#include "betwixt/time.h"
#include "track/procedure.h"

namespace betwixt {

struct Filter {
  std::string name;
  std::shared_ptr<const Routine> code;           // null: a built-in one
  Parameters parameters;                         // as the author gave them; what is left out has its default
  int component = -1;                            // of the function's value; -1: the whole
  std::optional<std::pair<Time, Time>> segment;  // both ends included; none: always
  friend bool operator==(const Filter&, const Filter&);
};

// A built-in filter and what can be said to it.
struct FilterParameter {
  std::string_view name;
  Type type;           // scalar; vector: one for each component, or a scalar for all of them
  double rest;         // what it is when nothing is said
  double low, high;    // what is beyond counts as the nearest that is not
  bool time = false;   // a length of time, in seconds
  bool value = false;  // of what the filter stands on: of angles an angle
};
struct FilterCall;  // a filter and what it was told
struct FilterSpec {
  std::string_view name;
  std::string_view sentence = {}, example = {};  // for help
  std::vector<FilterParameter> parameters;
  Value (*value)(const FilterCall&, Input&, double seconds) = nullptr;
  bool any_type = false;     // works on values that are not numbers too
  bool orientations = true;  // means something for orientations
};
const std::vector<FilterSpec>& built_in_filters();
const FilterSpec* find_filter(std::string_view name);
// Whether the filter means something for values of the type. Where it does not, it passes them through.
bool suits(const FilterSpec&, Type);

// The filtered value at a time. Errors come from procedures only.
Result<Value> apply(const Filter&, Input&, double seconds);

}  // namespace betwixt
