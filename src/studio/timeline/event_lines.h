// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Edits of events as script lines: few lines, in an order in which no event overwrites another.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/program.h"
#include "studio/shell/workspace.h"

namespace betwixt {
struct Event;
}

namespace betwixt::studio {

using Lines = std::vector<std::string>;

struct TargetOrder {
  bool operator()(const Target&, const Target&) const;
};
// Events of one track, in time order.
struct Picked {
  Target target;
  std::vector<Time> times;
};
std::vector<Picked> by_track(std::vector<EventAt>);
// Tests whether events are in a large selection.
class PickedTimes {
 public:
  PickedTimes() = default;
  explicit PickedTimes(const std::vector<EventAt>&);
  bool any(const Target&, Time from, Time to) const;
  bool has(const EventAt& e) const { return any(e.target, e.time, e.time); }
  const std::map<Target, std::vector<Time>, TargetOrder>& tracks() const { return of_; }

 private:
  std::map<Target, std::vector<Time>, TargetOrder> of_;
};
// Returns the times of the first and the last event.
std::pair<Time, Time> span(const std::vector<EventAt>&);

// `move`: shifts each event by the same time.
Lines move_lines(const Document&, const std::vector<EventAt>&, Time by);
// `stretch`: maps the time span `from` to the span `to`.
Lines stretch_lines(const Document&, const std::vector<EventAt>&, std::pair<Time, Time> from, std::pair<Time, Time> to);
// Gives each event another time: clears the events and writes them again. Events of motions stay.
Lines retime_lines(const Document&, const std::vector<EventAt>&, const std::function<Time(Time)>& when);
Lines reverse_lines(const Document&, const std::vector<EventAt>&);
Lines clear_lines(const Document&, const std::vector<EventAt>&);
// `copy`: the first event comes at `to`. The source may be an earlier state of the document. `onto` gets the events if
// they all belong to one object; without it each event stays on its own object.
Lines copy_lines(const Document&, const Document& source, const std::vector<EventAt>&, Time to, ObjectId onto = {});
// Sets the twerper after each event; "": the default.
Lines twerper_lines(const Document&, const std::vector<EventAt>&, std::string_view twerper);

// Returns an event as a line: "on sway at 24f ball.position (1 2 3) smooth".
std::string event_line(const Document&, const Target&, const Event&);
const Event* find_event(const Document&, const EventAt&);
// Return the words for a target in a line: "on sway ", "ball.position".
std::string layer_words(const Document&, const Target&);

// Returns a document in which some objects have only their tracks: no filters, layers, velocities or obstacles. With
// `of_layer`, that layer's tracks replace the objects' own ones; read them by targets without the layer.
Document bare_tracks(const Document&, const std::vector<ObjectId>&, ObjectId of_layer = {});

}  // namespace betwixt::studio
