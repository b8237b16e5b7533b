// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The tracks of a document and the events on them, for programs that show or translate them.
//
// A target says which track: the whole of a function or, where its components have tracks of their own, one of these;
// beside it the track of its velocity; on a layer the same again. What views point to belongs to the document, and
// stays as it is for as long as that or any copy of it lives. Where there is no such track all answers are empty.
// Values are as the author wrote them: metres, radians, colours sRGB, places in the space of what the object hangs on;
// velocities and tangents are per second.
//
// Room: scene
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "betwixt/document.h"

namespace betwixt {

// An event: a value at a time, and how to go on from there.
struct EventView {
  enum class What : std::uint8_t {
    value,
    keep,    // changes how to go on, not where: the value is what the track would have here without it
    release  // of a velocity: its reign ends
  };
  Time time;
  What what = What::value;
  const Value* value = nullptr;  // null: keep, release
  std::string_view twerper;      // "linear", the name of one of the author's; empty: nothing was said
  std::array<double, 4> arguments{0.25, 0.1, 0.25,
                                  1};            // in brackets behind it; of "bezier" x1 y1 x2 y2, as CSS counts them
  std::span<const std::array<double, 2>> stops;  // of "linear": how far in time, in hundredths, and in value
  Time ease_out, ease_in;                        // how long it takes to leave and to arrive; 0: at once
  const Value* before = nullptr;  // a cut: what the track comes to; `value` is what it goes on from. Null: the same
  const Value *tangent_in = nullptr, *tangent_out = nullptr;  // of "hermite"; null: none was given
  // Of "fcurve": how far in time its handles are; the tangents are then the way there in value. None: none was given.
  std::optional<Time> handle_in, handle_out;
};

struct TrackView {
  Target target;
  std::size_t events = 0;
  Time first, last;  // of its events, where there are any
  // The one twerper of the whole track, whatever its events say; empty: each event's own.
  std::string_view twerper;
  std::array<double, 4> arguments{0.25, 0.1, 0.25, 1};  // of that
  std::span<const std::array<double, 2>> stops;
  std::string_view unsaid;         // what it is where neither the track nor the event has said one: "smooth"
  std::string_view before, after;  // the extrapolation: "hold", "linear", "cycle", "bounce"
  bool srgb = false;               // colours blend as the numbers are written, not as light
};
// Of an object: all that have events, and those that a whole track's word was said for. In the order of its functions;
// of each the object's own before those on layers, values before velocities, components in order.
std::vector<TrackView> tracks(const Document&, ObjectId);
// Those that say what a target has: its own, that of the whole it is a component of, or those of its components.
std::vector<TrackView> tracks(const Document&, const Target&);
// What a layer holds, object by object.
std::vector<TrackView> tracks_on(const Document&, ObjectId layer);
// None where there is no such track: of components while the whole has one, of the whole while they have.
std::optional<TrackView> track(const Document&, const Target&);
// What the function was set to, on a layer what was set there; null: nothing.
const Value* value_set(const Document&, const Target&);

// f(event) for all with from <= time <= to, in order; finding the first one takes no longer on a long track. The view
// is f's for the length of the call; what it points to stays.
void each_event(const Document&, const Target&, Time from, Time to, const std::function<void(const EventView&)>& f);
// When the first event at or after a time is, and the last one before it: as fast on a long track.
std::optional<Time> next_event(const Document&, const Target&, Time from);
std::optional<Time> event_before(const Document&, const Target&, Time);
// All of them, for tracks that are not long.
std::vector<EventView> events(const Document&, const Target&);

// A filter on a function. The first one sees the track, each next one what the one before made of it.
struct FilterView {
  std::string_view name;
  bool own = false;                                           // the author's or a plug-in's, not a built-in one
  std::span<const std::pair<std::string, Value>> parameters;  // as given; what is left out has its default
  int component = -1;                                         // of the value that it works on; -1: all
  std::optional<std::pair<Time, Time>> segment;               // when it works, both ends included; none: always
};
// Of the function that a target is of, or is a component of, on its layer or on none.
std::vector<FilterView> filters(const Document&, const Target&);

// Code that computes values, or that has a name.
struct ProcedureView {
  std::string_view name;      // empty: it stands in the place of a value
  std::string_view role;      // "value", "twerper", "filter", "command"
  std::string_view language;  // "lua", "plug-in"
  std::string_view source;    // as the author wrote it; a plug-in's path
};
std::vector<ProcedureView> procedures(const Document&);  // those with names
ProcedureView procedure(const Procedure&);               // valid as long as the procedure

}  // namespace betwixt
