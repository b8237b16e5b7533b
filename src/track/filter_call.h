// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A call of a filter, and the numbers that filters compute with. Included only by the files of filters.
#pragma once

#include <algorithm>
#include <cmath>

#include "track/filter.h"

namespace betwixt {

// A filter with its arguments or their defaults.
struct FilterCall {
  const Filter& filter;
  const FilterSpec& spec;

  Vec3 triple(std::string_view name) const {
    const auto is = [&](const auto& p) { return p.name == name; };
    const FilterParameter& p = *std::find_if(spec.parameters.begin(), spec.parameters.end(), is);
    const auto given = std::find_if(filter.parameters.rbegin(), filter.parameters.rend(),
                                    [&](const auto& pair) { return pair.first == name; });
    const Vec3 rest{p.rest, p.rest, p.rest};
    if (given == filter.parameters.rend()) return rest;
    Vec3 v = rest;
    if (const double* number = std::get_if<double>(&given->second)) v = {*number, *number, *number};
    if (const Vec3* three = std::get_if<Vec3>(&given->second)) v = *three;
    for (int i = 0; i < 3; ++i) v[i] = std::isnan(v[i]) ? p.rest : std::clamp(v[i], p.low, p.high);
    return v;
  }
  double number(std::string_view name) const { return triple(name).x; }
  // Returns the component of the whole value for the i-th one of this value.
  int component(int i) const { return std::clamp(filter.component < 0 ? i : filter.component, 0, 2); }
};

namespace filters {

// A value as numbers that can be added; empty if it has none.
struct Sample {
  double n[4] = {};
  int count = 0;
};
inline Value look(Input& input, double seconds) {
  return input.at(std::clamp(seconds, -longest_seconds, longest_seconds));
}
Sample numbers(const Value&);
// Returns the value of the same kind as `like` with these numbers. Colours are not below black.
Value value_of(const Value& like, const double* n);

// The filters that sample their track.
Value smooth(const FilterCall&, Input&, double seconds);
Value spring(const FilterCall&, Input&, double seconds);

}  // namespace filters
}  // namespace betwixt
