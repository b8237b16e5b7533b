// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Environments: what was said to them, and who is in them. What they make of it, their matrices, is a Program's
// (Query).
//
// Times are whole ticks of the document (Document::ticks); column vectors. Views as in betwixt/object.h.
//
// Room: scene
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "betwixt/document.h"

namespace betwixt {

struct EnvironmentEventView {
  std::int64_t tick = 0;
  std::string_view what;  // "animate", "halt", "kill", "cancel"
  // Of animate:
  const Mat4* motion = nullptr;  // M, by which A is multiplied at each update
  std::int64_t interval = 1;     // from one update to the next, at first
  std::int64_t change = 0;       // what it grows by every `period` ticks; below 0: faster
  std::int64_t period = 1, ceiling = 30;
  bool keep_phase = false;                  // the first update is when the old motion's next one was due
  std::optional<std::int64_t> from, until;  // it starts, and halts, so long after the event
};
// In the order in which they count: by tick, of one tick as they were said. Of what is no environment none.
void each_environment_event(const Document&, ObjectId, const std::function<void(const EnvironmentEventView&)>& f);

// What an object is in, or what drives it, from `from` to just before `until`; the outermost first. Where nothing was
// ever said there is none.
struct EnvironmentSpan {
  Time from = from_the_beginning, until = for_good;
  std::vector<ObjectId> environments;
};
std::vector<EnvironmentSpan> surrounding(const Document&, ObjectId);  // they move it and all that hangs on it
std::vector<EnvironmentSpan> driving(const Document&, ObjectId);      // they move it in its own space

}  // namespace betwixt
