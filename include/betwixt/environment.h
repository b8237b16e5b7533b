// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Environments: the events on them, and which objects are in them. Read the matrices that they amount to from a
// Program (Query).
//
// Times are whole ticks of the document (Document::ticks). Column vectors. Views are valid as in betwixt/object.h.
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
  // The rest is for `animate`:
  const Mat4* motion = nullptr;  // M, which multiplies A at each update
  std::int64_t interval = 1;     // ticks from one update to the next, at first
  std::int64_t change = 0;       // ticks by which the interval grows every `period` ticks; below 0 it shrinks
  std::int64_t period = 1, ceiling = 30;
  bool keep_phase = false;                  // the first update comes when the next one of the old motion was due
  std::optional<std::int64_t> from, until;  // ticks after the event at which it starts and halts
};
// Calls f for each event, by tick, those of one tick in the order of the script. Does nothing if the object is no
// environment.
void each_environment_event(const Document&, ObjectId, const std::function<void(const EnvironmentEventView&)>& f);

// The environments that an object is in, or that drive it, from `from` to just before `until`, the outermost first. An
// object for which the script sets none has no spans.
struct EnvironmentSpan {
  Time from = earliest_time, until = latest_time;
  std::vector<ObjectId> environments;
};
std::vector<EnvironmentSpan> surrounding(const Document&, ObjectId);  // move the object and everything attached to it
std::vector<EnvironmentSpan> driving(const Document&, ObjectId);      // move the object in its own space

}  // namespace betwixt
