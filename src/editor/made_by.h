// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What makes the value of a function at a time, in words; and the line that a hand says to change it there.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "betwixt/document.h"

namespace betwixt {

struct MadeBy {
  bool said = false;        // somebody has said something; else it is at rest
  bool events = false;      // there are any, of the whole or of its components
  bool event_here = false;  // … at this very time
  std::string code;         // the author's, where that is what computes it; else empty
  std::string words;        // "between 1f and 24f, filter noise"; empty: at rest
};
// Of a whole function of an object.
MadeBy made_by(const Document&, const Target&, Time);

// The events of a function that are nearest to a time, before and behind it; of the whole or of any component.
std::pair<std::optional<Time>, std::optional<Time>> events_beside(const Document&, const Target&, Time);
// Whether each of its components has a track of its own.
bool in_components(const Document&, const Target&);
// How a new event of a hand's goes on, with a blank before it: " auto" where the track would go smoothly, which may be
// far beyond its events; as the event before it does, where that says a plain word; "": nothing need be said.
std::string way_of_new_event(const Document&, const Target&, Time);
// "at 24f ball.radius 2 auto" where the function has events, else "set ball.radius 2".
std::string line_that_sets(const Document&, const Target&, Time, const std::string& value);
// "couple ball to hand keep-world", with a time behind the film's first frame, and where it hangs by time.
std::string line_that_holds(const Document&, ObjectId, Time, const Attachment&);

}  // namespace betwixt
