// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Filters: pure functions of time over a track. (twixt notes, G105)
#pragma once

#include <optional>

#include "betwixt/time.h"
#include "track/procedure.h"

namespace betwixt {

struct Filter {
  std::string name;
  std::shared_ptr<const Routine> code;           // null for a built-in filter
  Parameters parameters;                         // as the author gave them; the others have their defaults
  int component = -1;                            // of the function's value; -1: all
  std::optional<std::pair<Time, Time>> segment;  // both ends included; nullopt: always
  bool off = false;                              // kept, but it does not act
  friend bool operator==(const Filter&, const Filter&);
};

// A parameter of a built-in filter.
struct FilterParameter {
  std::string_view name;
  Type type;           // scalar; or vector: one number for each component, or a scalar for all of them
  double rest;         // the default
  double low, high;    // bounds; values beyond are clamped
  bool time = false;   // a length of time, in seconds
  bool value = false;  // in the unit of the filtered value: an angle for angles
};
struct FilterCall;  // a filter with its arguments
struct FilterSpec {
  std::string_view name;
  std::string_view sentence = {}, example = {};  // for help
  std::vector<FilterParameter> parameters;
  Value (*value)(const FilterCall&, Input&, double seconds) = nullptr;
  bool on_grid = false;      // looks at the points of a grid that does not move with the time
  bool any_type = false;     // takes values that are not numbers too
  bool orientations = true;  // takes orientations
};
const std::vector<FilterSpec>& built_in_filters();
const FilterSpec* find_filter(std::string_view name);
// Returns whether the filter has a meaning for values of the type. If not, it passes them through.
bool suits(const FilterSpec&, Type);

// Returns the filtered value at a time. Only procedures can fail.
Result<Value> apply(const Filter&, Input&, double seconds);

}  // namespace betwixt
