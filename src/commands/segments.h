// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Helpers of the commands on segments of tracks.
#pragma once

#include <functional>

#include "commands/command.h"

namespace betwixt {

// TARGET A..B: a part of the tracks that a pattern names.
struct Stretch {
  std::string_view word;
  Selected of;
  Segment segment;
  // If the pattern names nothing, returns the spec of a position, so that the rest can still be read.
  const FunctionSpec& spec() const;
  Type type() const { return of.component < 0 ? spec().type : component_type(spec().type); }
};
bool on_segment(Command&, Stretch&, Meant = Meant::any);

// Runs f(track, type, component, target) on all tracks of all targets, or on none. With `along` it also runs on the
// velocity beside each track. operate_and_say() also reports changed durations of motions.
using Work = std::function<Result<Changed>(Track&, Type, int component, const Target&)>;
bool operate(Command&, const Stretch&, const Work&, bool along = true);
bool operate_and_say(Command&, const Stretch&, const Work&, bool along = true);

// Fails unless every component that the value changes has events there; otherwise a component without events would be
// left out silently.
bool reaches(Command&, const Stretch&, const Target&, const Value& by, const char* changed);
// Returns the type of the values on a function's track, or on the track of a component or of its velocity.
Type type_of_track(Type of_function, bool velocity, bool part);
// Replaces kept values in a segment by the actual ones, on a function's track or that of a component or of its
// velocity.
void fill_in_kept(Track&, Segment, Type of_function, bool velocity, bool part);

// Returns the spec of a difference between two values of the function: of any size, and a vector for points.
FunctionSpec difference_of(FunctionSpec);

// Returns the part of a whole value that belongs to the component.
Value part_of(const Value&, int component);

}  // namespace betwixt
