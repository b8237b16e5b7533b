// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The curves of objects as data, the handles at their events, and the script lines that a drag of them writes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/track.h"
#include "studio/timeline/event_lines.h"

namespace betwixt::studio {

// One curve: one number of a target's value.
struct CurveLine {
  Target target;     // the track; for a function without events, the whole function
  int part = 0;      // index of the number in the value
  int color = 0;     // 0 x, 1 y, 2 z, 3 other
  int shade = 0;     // counts the functions with curves before its own
  std::string name;  // "position.x"
  Type type = Type::scalar;
  bool degrees = false, steps = false, swatch = false;
  bool tracked = false;  // has events
  friend bool operator==(const CurveLine&, const CurveLine&) = default;
};
// Returns the curves in the order of the functions. A colour has one curve for its three numbers.
std::vector<CurveLine> curve_lines(const Document&, const std::vector<ObjectId>&);
// Returns the number of a value that the curve draws, or nullopt if the value has none.
std::optional<double> shown(const CurveLine&, const Value&);
// Returns the value with this number replaced.
Value with_shown(const CurveLine&, const Value&, double number);

// An overshoot: the curve moves far away from two events with similar values. swing() returns nullopt if there is none.
struct LineSwing {
  Time at;
  double value = 0;
  std::string words;  // the warning
};
std::optional<LineSwing> swing(const Document&, const CurveLine&);

// Returns the twerper after an event: the track's, the event's, or the default.
std::string_view twerper_of(const TrackView&, const EventView&);

// A point or handle that the user can drag.
struct Handle {
  enum class What {
    point,
    handle_in,
    handle_out,
    tangent_in,
    tangent_out,
    bezier_start,
    bezier_end,
    ease_in,
    ease_out
  };
  What what = What::point;
  EventAt event;
  Time time;         // its own place
  double value = 0;  // in the curve's units
  Time from;         // the point that it belongs to
  double base = 0;
  friend bool operator==(const Handle&, const Handle&) = default;
};
std::vector<Handle> handles(const Document&, const CurveLine&, Time event);
// Returns whether the two handles of an event (fcurve) make one line.
bool has_aligned_handles(const CurveLine&, const Event&);
// Returns the lines that move a handle. `both`: also changes the tangent on the other side, or turns the other handle
// if the two make one line.
Lines handle_lines(const Document&, const CurveLine&, const Handle&, Time, double value, bool both);
// Returns the lines that move the selected points: all of them in time, those of this curve in value.
Lines point_lines(const Document&, const CurveLine&, const std::vector<EventAt>&, Time by, double more);

}  // namespace betwixt::studio
