// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What commands on segments of tracks share.
#pragma once

#include "commands/command.h"

namespace betwixt {

// TARGET A..B: a part of the tracks that a pattern names.
struct Stretch {
  std::string_view word;
  Selected of;
  Segment segment;
  // Where the pattern names nothing the rest is still read, as if it were of positions.
  const FunctionSpec& spec() const;
  Type type() const { return of.component < 0 ? spec().type : component_type(spec().type); }
};
bool on_segment(Command&, Stretch&, Meant = Meant::any);

// Whether every component that a value changes has events there: one that has none would be left out without a word.
bool reaches(Command&, const Stretch&, const Target&, const Value& by, const char* changed);
// Of a function's track, or that of a component or of its velocity.
Type type_of_track(Type of_function, bool velocity, bool part);
// Where there are any in a segment, rows that keep the value of a function's track have it, or of that of a component
// or of its velocity.
void fill_in_kept(Track&, Segment, Type of_function, bool velocity, bool part);

// The description of a difference between two values of a function: any size, and for points a vector.
FunctionSpec difference_of(FunctionSpec);

// What belongs to a component, of a value for all of them.
Value part_of(const Value&, int component);

std::string plural(std::size_t n, const char* what);

}  // namespace betwixt
