// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The tracks of a document and the events (keyframes) on them, for programs that show or translate them.
//
// A target names a track. Either a whole display function has one, or each of its components has its own. Beside each
// track there may be one for its velocity, and layers have tracks of their own. A view points into the
// document and is valid as long as the document or a copy of it lives. For a track that does not exist all results are
// empty. Values are as the author wrote them: metres, radians, colours sRGB, positions in the space of the parent.
// Velocities and tangents are per second.
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

// An event (keyframe): a value at a time, and how the track continues from there. Its twerper is the interpolation
// (easing) from this event to the next.
struct EventView {
  enum class What : std::uint8_t {
    value,
    keep,    // changes the twerper only; the value is that of the track without this event
    release  // of a velocity: the track takes over again
  };
  Time time;
  What what = What::value;
  const Value* value = nullptr;  // null for keep and release
  std::string_view twerper;      // "linear" or another name, possibly the author's own; "" if the event has none
  // Of the twerper. "bezier": x1 y1 x2 y2 as in CSS. "steps": how many, and where they jump: 0 end, 1 start, 2 neither,
  // 3 both.
  std::array<double, 4> arguments{0.25, 0.1, 0.25, 1};
  std::span<const std::array<double, 2>> stops;  // of "linear": time in percent, and share of the way (1: all of it)
  // ease_out: how long the track is slow after this event; ease_in: how long it is slow before it; 0: not at all. (The
  // twerpers "ease-in" and "ease-out" are the other way around, as in CSS: "ease-in" begins slowly.)
  Time ease_out, ease_in;
  // Of a cut: the value at which the track arrives; it continues from `value`. Null if there is no cut.
  const Value* cut_from = nullptr;
  const Value *tangent_in = nullptr, *tangent_out = nullptr;  // of "hermite": per second; null if not given
  // Of "fcurve": the length of each handle in time; nullopt if not given. tangent_in and tangent_out are then no slopes
  // but the difference of value from the event to the end of the handle.
  std::optional<Time> handle_in, handle_out;
};

struct TrackView {
  Target target;
  std::size_t event_count = 0;
  Time first, last;  // of its events, if it has any
  // The twerper of the whole track, which overrides those of the events; "" if it has none.
  std::string_view twerper;
  std::array<double, 4> arguments{0.25, 0.1, 0.25, 1};  // of this twerper
  std::span<const std::array<double, 2>> stops;
  std::string_view default_twerper;                            // for events without one: "smooth", "slerp", "linear"…
  std::string_view extrapolation_before, extrapolation_after;  // "hold", "linear", "cycle", "bounce"
  bool srgb = false;  // whether colours blend in sRGB numbers and not in linear light
};
// Returns the tracks of an object, except those without events, without a twerper of their own and without
// extrapolation. The order is that of its functions. Within a function the object's own tracks come before those on
// layers, values before velocities, and components in order.
std::vector<TrackView> tracks(const Document&, ObjectId);
// Returns the tracks of a target: its own, that of the whole if it is a component, or its components'. Its velocity
// tracks and those on layers are targets of their own.
std::vector<TrackView> tracks(const Document&, const Target&);
// Returns the tracks on a layer, object by object.
std::vector<TrackView> tracks_on(const Document&, ObjectId layer);
// Returns one track, or std::nullopt if there is none. When components have tracks of their own, the whole has none,
// and the other way around.
std::optional<TrackView> track(const Document&, const Target&);
// Returns the value that was set (on a layer: set there), or null if there is none.
const Value* value_set(const Document&, const Target&);

// Calls f for each event with from <= time <= to, in order. Finds the first event in logarithmic time. The view is
// valid during the call, its pointers as long as the document.
void each_event(const Document&, const Target&, Time from, Time to, const std::function<void(const EventView&)>& f);
// Return the time of the first event at or after a time, and of the last one before it; std::nullopt if there is none.
// In logarithmic time.
std::optional<Time> next_event(const Document&, const Target&, Time from);
std::optional<Time> event_before(const Document&, const Target&, Time);
// Returns all events. Use it for tracks that are not long.
std::vector<EventView> events(const Document&, const Target&);

// A filter on a function. The first filter gets the track, each further one the result of the one before.
struct FilterView {
  std::string_view name;
  bool custom = false;                                        // the author's or a plug-in's, not built-in
  std::span<const std::pair<std::string, Value>> parameters;  // the given ones; the others have their defaults
  int component = -1;                                         // the component that it changes; -1: all
  std::optional<std::pair<Time, Time>> segment;               // when it acts, both ends included; nullopt: always
};
// Returns the filters on the function of a target, also those of other components; on its layer, if it has one.
std::vector<FilterView> filters(const Document&, const Target&);

// Code of the author: it stands in the place of a value and computes it, or it is a procedure, which has a name.
struct ProcedureView {
  std::string_view name;      // "" if it is in the place of a value
  std::string_view role;      // "value", "twerper", "filter", "command"
  std::string_view language;  // "lua", "plug-in"
  std::string_view source;    // as written; for a plug-in, its path
};
std::vector<ProcedureView> procedures(const Document&);  // the ones with names
ProcedureView procedure(const Procedure&);               // valid as long as its argument

}  // namespace betwixt
