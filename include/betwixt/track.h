// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The tracks of a document and the events (keyframes) on them. Use this header to show tracks, or to convert them to
// another format. A target names a track. A display function (a property that can be animated, such as position) has
// either one track, or one for each component. Each track may have another one for its velocity, and layers have tracks
// of their own. EventView, TrackView, FilterView and ProcedureView point into the document; they are valid as long as
// the document or a copy of it exists. For a track that does not exist all results are empty. Values are those of the
// events: velocities, filters and layers have not changed them yet. Lengths are in metres, angles in radians, colours
// are sRGB, and positions are in the space of the parent. Velocities and tangents are per second.
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
    release  // on a velocity track: from here on the value track is in force again
  };
  Time time;
  What what = What::value;
  const Value* value = nullptr;  // null for keep and release
  std::string_view twerper;      // "linear" or another name, possibly the author's own; "" if the event has none
  // The arguments of the twerper. "bezier": x1 y1 x2 y2 as in CSS. "steps": how many, and where they jump: 0 end, 1
  // start, 2 neither, 3 both.
  std::array<double, 4> arguments{0.25, 0.1, 0.25, 1};
  // The stops of "linear". Each has a time in percent, and the share of the way between the two values (1: all of it).
  std::span<const std::array<double, 2>> stops;
  // How long the track moves slowly after this event (ease_out) and before this event (ease_in); 0: not at all. Do not
  // confuse them with the twerpers "ease-in" and "ease-out" of CSS: the twerper "ease-in" is slow after its event.
  Time ease_out, ease_in;
  // A cut is a jump at this event: the track arrives at `cut_from` and continues from `value`. Null if there is no cut.
  const Value* cut_from = nullptr;
  const Value *tangent_in = nullptr, *tangent_out = nullptr;  // of "hermite": per second; null if not given
  // For "fcurve": the length of each handle in time; nullopt if not given. With "fcurve", tangent_in and tangent_out
  // are not slopes: each is the value at the end of its handle minus the value of the event.
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
// Returns the tracks of an object that have events, a twerper or an extrapolation. They have the order of `functions`
// (object.h). The tracks of a function are sorted by layer (the object's own first), then values before velocities,
// then by component.
std::vector<TrackView> tracks(const Document&, ObjectId);
// Returns the tracks that give a target its value. If the target has its own track, returns only that track. If not:
// for a component, returns the track of the whole; for a whole, returns the tracks of its components. Velocity tracks
// and tracks on layers are not included: each has a target of its own.
std::vector<TrackView> tracks(const Document&, const Target&);
// The events of a track as columns of numbers.
struct TrackNumbers {
  std::vector<Time> times;
  std::size_t width = 1;        // numbers for each time: 1, or 2 or 3 for a pair, a vector, a colour or angles
  std::vector<double> numbers;  // in metres, radians, or sRGB from 0 to 1
};
// Returns the events of one track as numbers, without those that have no value. `target` is as in find_targets. Errors:
// name (no such track), type (its values are not numbers, or its components have tracks of their own).
Result<TrackNumbers> track_numbers(const Document&, std::string_view target);
// Returns the tracks on a layer, object by object.
std::vector<TrackView> tracks_on(const Document&, ObjectId layer);
// Returns one track, or std::nullopt if there is none. When components have tracks of their own, the whole has none,
// and the other way around.
std::optional<TrackView> track(const Document&, const Target&);
// Returns the value that the command `set` gave the target, or null if there is none. For a target on a layer, returns
// the value that was set on that layer.
const Value* value_set(const Document&, const Target&);

// Calls f for each event with from <= time <= to, in order. Finds the first event in logarithmic time. The EventView is
// valid only during the call of f; what its members point to is valid as long as the document.
void each_event(const Document&, const Target&, Time from, Time to, const std::function<void(const EventView&)>& f);
// next_event returns the time of the first event at or after `from`. event_before returns the time of the last event
// before the given time. Both return std::nullopt if there is no such event, and take logarithmic time.
std::optional<Time> next_event(const Document&, const Target&, Time from);
std::optional<Time> event_before(const Document&, const Target&, Time);
// Returns all events. Use it for tracks that are not long.
std::vector<EventView> events(const Document&, const Target&);

// A filter on a function. The first filter takes the values of the track. Each further filter takes the result of the
// previous filter.
struct FilterView {
  std::string_view name;
  bool custom = false;                                        // the author's or a plug-in's, not built-in
  std::span<const std::pair<std::string, Value>> parameters;  // the given ones; the others have their defaults
  int component = -1;                                         // the component that it changes; -1: all
  std::optional<std::pair<Time, Time>> segment;               // when it acts, both ends included; nullopt: always
  bool off = false;                                           // it is kept, but does not act
};
// Returns all filters on the function of a target, also those that change only one component. For a target on a layer,
// returns the filters on that layer instead.
std::vector<FilterView> filters(const Document&, const Target&);

// The author's code. Code without a name stands in the place of a value and computes that value. Code with a name is a
// procedure.
struct ProcedureView {
  std::string_view name;      // "" if it replaces a value
  std::string_view role;      // "value", "twerper", "filter", "command", "steps", "tween"
  std::string_view language;  // "lua", "plug-in"
  std::string_view source;    // as written; for a plug-in, its path
};
std::vector<ProcedureView> procedures(const Document&);  // the ones with names
ProcedureView procedure(const Procedure&);               // valid as long as its argument

}  // namespace betwixt
