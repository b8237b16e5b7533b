// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Short functions that make events and tracks.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "track/track.h"

namespace betwixt {

inline Event event(double seconds, Value v, Twerper twerper = Twerper::unset) {
  Event e;
  e.time = from_seconds(seconds);
  e.value = std::move(v);
  e.twerper = twerper;
  return e;
}
inline Track track(std::vector<Event> events) {
  Track t;
  for (Event& e : events) t.events.put(std::move(e));
  return t;
}

}  // namespace betwixt
