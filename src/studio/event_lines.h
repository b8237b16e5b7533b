// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What hands do to events, in lines of the language: as few as say it, and in an order in which none lets one event
// run over another.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/program.h"
#include "studio/desk.h"

namespace betwixt {
struct Event;
}

namespace betwixt::studio {

using Lines = std::vector<std::string>;

struct TargetOrder {
  bool operator()(const Target&, const Target&) const;
};
// Events of one track, in the order of time.
struct Picked {
  Target target;
  std::vector<Time> times;
};
std::vector<Picked> by_track(std::vector<EventAt>);
// Whether events are among many that are picked.
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
// From the first of them to the last.
std::pair<Time, Time> span(const std::vector<EventAt>&);

// `move`: each by so much.
Lines move_lines(const Document&, const std::vector<EventAt>&, Time by);
// `stretch`: what lies between two times lies between two others then.
Lines stretch_lines(const Document&, const std::vector<EventAt>&, std::pair<Time, Time> from, std::pair<Time, Time> to);
Lines reverse_lines(const Document&, const std::vector<EventAt>&);
Lines clear_lines(const Document&, const std::vector<EventAt>&);
// `copy`, of events of a document that may be an earlier one: the first of them comes at `to`. `onto`: the object that
// gets them where they are all of another one; none: each its own.
Lines copy_lines(const Document&, const Document& source, const std::vector<EventAt>&, Time to, ObjectId onto = {});
// Each goes on with this twerper; "": with what goes without saying.
Lines twerper_lines(const Document&, const std::vector<EventAt>&, std::string_view twerper);
// An event each, with the value that its track has there.
Lines insert_lines(const Document&, const Program& before, const std::vector<Target>&, Time);

// An event as a line: "on sway at 24f ball.position (1 2 3) smooth".
std::string event_line(const Document&, const Target&, const Event&);
const Event* find_event(const Document&, const EventAt&);
// What stands before and between in lines about a target: "on sway ", "ball.position".
std::string layer_words(const Document&, const Target&);

// The tracks of some objects alone, as if nothing were laid over them: no filters, layers, velocities. What a layer
// holds for a function is asked for by the target without the layer, where `of_layer` is that layer.
Document bare_tracks(const Document&, const std::vector<ObjectId>&, ObjectId of_layer = {});

}  // namespace betwixt::studio
