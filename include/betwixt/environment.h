// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Environments (transforms that are applied again and again): their events, and the objects that are in them. To get
// their matrices, read a Query from a Program.
//
// Times are whole ticks of the document (Document::ticks). Matrices are for column vectors. A view points into the
// document; it is valid as long as the document or a copy of it exists.
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
  // The rest is only for "animate":
  const Mat4* motion = nullptr;  // M, which multiplies A at each update
  std::int64_t interval = 1;     // ticks from one update to the next, at first
  std::int64_t change = 0;       // ticks that are added to the interval every `period` ticks; may be negative
  std::int64_t period = 1, ceiling = 30;
  bool keep_phase = false;                  // the first update comes when the old motion would have had its next one
  std::optional<std::int64_t> from, until;  // ticks after the event at which it starts and halts
};
// Calls f for each event, in order of ticks, and for one tick in the order of the script. Does nothing if the object is
// not an environment.
void each_environment_event(const Document&, ObjectId, const std::function<void(const EnvironmentEventView&)>& f);

// The environments that an object is in, or that drive it, from `from` to just before `until`; the outermost is first.
// An object without environments has no spans.
struct EnvironmentSpan {
  Time from = earliest_time, until = latest_time;
  std::vector<ObjectId> environments;
};
std::vector<EnvironmentSpan> surrounding(const Document&, ObjectId);  // move the object and everything attached to it
std::vector<EnvironmentSpan> driving(const Document&, ObjectId);      // move the object in its own space

}  // namespace betwixt
