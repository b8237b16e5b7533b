// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What there is to draw of objects as curves, and what hands take hold of at their events.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/track.h"
#include "studio/event_lines.h"

namespace betwixt::studio {

// One number of what a target has.
struct CurveLine {
  Target target;     // its track; of a function without events the whole
  int part = 0;      // which number of its values
  int color = 0;     // 0 x, 1 y, 2 z, 3: another
  std::string name;  // "position.x"
  Type type = Type::scalar;
  bool degrees = false, steps = false, swatch = false;
  bool tracked = false;  // it has events
  friend bool operator==(const CurveLine&, const CurveLine&) = default;
};
// In the order of functions; of colours one, for all three numbers.
std::vector<CurveLine> curve_lines(const Document&, const std::vector<ObjectId>&);
// A value's number as the line shows it; none where it has none.
std::optional<double> shown(const CurveLine&, const Value&);
// The same value with another number there.
Value with_shown(const CurveLine&, const Value&, double number);

// Where a line swings far away from two events that are alike, as the line shows it; none where it does not.
struct LineSwing {
  Time at;
  double value = 0;
  std::string words;  // what to say about it
};
std::optional<LineSwing> swing(const Document&, const CurveLine&);

// How an event goes on, whoever says it: the track, the event, or nobody.
std::string_view twerper_of(const TrackView&, const EventView&);

// What can be taken hold of.
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
  Time time;         // where it is
  double value = 0;  // as shown
  Time from;         // what it is fastened to
  double base = 0;
  friend bool operator==(const Handle&, const Handle&) = default;
};
std::vector<Handle> handles(const Document&, const CurveLine&, Time event);
// What it says when a handle is put elsewhere. `both`: a tangent's other side goes along.
Lines handle_lines(const Document&, const CurveLine&, const Handle&, Time, double value, bool both);
// The points of a track that are selected are moved: in time all that are selected, in value those of this line.
Lines point_lines(const Document&, const CurveLine&, const std::vector<EventAt>&, Time by, double more);

}  // namespace betwixt::studio
