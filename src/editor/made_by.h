// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Describes what computes the value of a function at a time, and returns the line that changes it there.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "betwixt/document.h"

namespace betwixt {

// Something that takes part in a value.
struct ValueSource {
  enum class What : std::uint8_t { event_here, between, since, before, set, code, velocity, layer, filter };
  What what;
  std::string name = {}, until = {};  // of a layer or filter; of events the time, and the second one of `between`
  friend bool operator==(const ValueSource&, const ValueSource&) = default;
};
struct MadeBy {
  bool said = false;                 // if false, it has its rest value
  bool events = false;               // it has any, on the whole or on its components
  bool event_here = false;           // … at this time
  std::string code;                  // the author's code if it computes the value, or ""
  std::vector<ValueSource> sources;  // the track first; empty at rest
};
// The target must be a whole function of an object.
MadeBy made_by(const Document&, const Target&, Time);

// Returns the events of a function, or of any of its components, nearest to a time: the one before and the one after.
std::pair<std::optional<Time>, std::optional<Time>> events_beside(const Document&, const Target&, Time);
// Returns true if a component has a track of its own.
bool in_components(const Document&, const Target&);
// Returns the twerper word for a new event, with a blank before it: that of the event before, if it is a plain word;
// otherwise " auto" if the default is smooth, as a smooth curve can overshoot its events far; "" if none is needed.
std::string way_of_new_event(const Document&, const Target&, Time);
// Returns "at 24f ball.radius 2 auto". An event that is there keeps its twerper, its eases and its cut.
std::string line_of_event(const Document&, const Target&, Time, const std::string& value);
// Returns such a line, "at 24f ball.radius 2 auto", if the function has events, "set ball.radius 2" otherwise.
std::string line_that_sets(const Document&, const Target&, Time, const std::string& value);
// Returns a line such as "couple ball to hand keep-world". It has `at TIME` after the film's first frame, for `letgo`,
// and if the object has attachment events.
std::string line_that_holds(const Document&, ObjectId, Time, const Attachment&);

}  // namespace betwixt
