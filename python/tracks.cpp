// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "tracks.h"

#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <vector>

#include "betwixt/language.h"
#include "betwixt/object.h"
#include "betwixt/track.h"
#include "errors.h"
#include "says.h"
#include "times.h"
#include "values.h"

namespace betwixt::python {
namespace {

// Views of tracks and events. Each keeps its document alive.
struct TrackOf {
  Document document;
  TrackView view;
};
struct EventOf {
  Document document;
  Target target;
  EventView view;
};

std::vector<TrackOf> tracks_of(const Document& document, const std::string& pattern) {
  std::vector<TrackOf> made;
  const auto add = [&](const std::vector<TrackView>& all) {
    for (const TrackView& t : all) made.push_back({document, t});
  };
  if (pattern.empty())
    for (const ObjectId id : objects(document)) add(tracks(document, id));
  else if (const auto named = objects(document, pattern); !named.empty())
    for (const ObjectId id : named) add(tracks(document, id));
  else if (const auto found = find_targets(pattern, document); found)
    for (const Target& t : *found) add(tracks(document, t));
  else
    raise(found.error(), pattern);
  return made;
}

std::vector<EventOf> events_of(const TrackOf& t) {
  std::vector<EventOf> made;
  each_event(t.document, t.view.target, earliest_time, latest_time, [&](const EventView& e) {
    made.push_back({t.document, t.view.target, e});
  });
  return made;
}

py::object value_or_none(const Value* v, const EventOf& e) {
  return v ? to_python(*v, e.target, e.document) : py::none();
}

double length_of(Time t, const Document& document) { return t.seconds() * document.rate().per_second(); }

py::object length_or_none(const std::optional<Time>& t, const Document& document) {
  return t ? py::object(py::float_(length_of(*t, document))) : py::none();
}

std::string_view word_of(EventView::What what) {
  static constexpr std::string_view words[] = {"value", "keep", "release"};
  return words[static_cast<std::size_t>(what)];
}

}  // namespace

void bind_tracks(py::module_& m, py::class_<Film>& film) {
  py::class_<EventOf>(m, "Event", "A keyframe: a value at a time, and the twerper to the next one.")
      .def_property_readonly(
          "time", [](const EventOf& e) { return frame_of(e.view.time, e.document); }, "Its frame.")
      .def_property_readonly(
          "seconds", [](const EventOf& e) { return e.view.time.seconds(); }, "The same in seconds since the beginning.")
      .def_property_readonly(
          "what", [](const EventOf& e) { return word_of(e.view.what); },
          "\"value\"; \"keep\": only the twerper changes; \"release\": a velocity no longer reigns.")
      .def_property_readonly(
          "value", [](const EventOf& e) { return value_or_none(e.view.value, e); },
          "The value; None for an event without one.")
      .def_property_readonly(
          "before", [](const EventOf& e) { return value_or_none(e.view.cut_from, e); },
          "The value before the jump of a cut; None for other events.")
      .def_property_readonly(
          "twerper", [](const EventOf& e) { return e.view.twerper; },
          "The twerper to the next event; empty if none is given.")
      .def_property_readonly(
          "arguments", [](const EventOf& e) { return e.view.arguments; }, "The arguments of its twerper: numbers.")
      .def_property_readonly(
          "stops", [](const EventOf& e) { return std::vector(e.view.stops.begin(), e.view.stops.end()); },
          "The stops of its twerper, if it has any.")
      .def_property_readonly(
          "ease_out", [](const EventOf& e) { return length_of(e.view.ease_out, e.document); },
          "The ease on leaving it, in frames.")
      .def_property_readonly(
          "ease_in", [](const EventOf& e) { return length_of(e.view.ease_in, e.document); },
          "The ease on arriving at it, in frames.")
      .def_property_readonly(
          "tangent_in", [](const EventOf& e) { return value_or_none(e.view.tangent_in, e); },
          "The tangent-in, per second; None if it is not given.")
      .def_property_readonly(
          "tangent_out", [](const EventOf& e) { return value_or_none(e.view.tangent_out, e); },
          "The tangent-out, per second; None if it is not given.")
      .def_property_readonly(
          "handle_in", [](const EventOf& e) { return length_or_none(e.view.handle_in, e.document); },
          "The length of the handle before it, in frames; None if it is not given.")
      .def_property_readonly(
          "handle_out", [](const EventOf& e) { return length_or_none(e.view.handle_out, e.document); },
          "The length of the handle after it, in frames; None if it is not given.")
      .def(
          "__repr__",
          [](const EventOf& e) {
            return py::str("<Event {}: {}>")
                .format(format_time(e.view.time, e.document), value_or_none(e.view.value, e));
          },
          says("Its time and value."));
  py::class_<TrackOf>(m, "Track", "The events of one display function.")
      .def_property_readonly(
          "name", [](const TrackOf& t) { return t.document.name(t.view.target); },
          "Its target, such as \"ball.position\".")
      .def_property_readonly(
          "object", [](const TrackOf& t) { return name_of(t.view.target.object, t.document); },
          "The name of the object.")
      .def_property_readonly(
          "velocity", [](const TrackOf& t) { return t.view.target.velocity; }, "Whether it is a velocity track.")
      .def_property_readonly(
          "layer",
          [](const TrackOf& t) -> py::object {
            if (!t.view.target.layer) return py::none();
            return name_of(t.view.target.layer, t.document);
          },
          "Its layer; None for the object's own track.")
      .def_property_readonly(
          "twerper", [](const TrackOf& t) { return t.view.twerper; },
          "The twerper of the whole track; empty if each event has its own.")
      .def_property_readonly(
          "unsaid", [](const TrackOf& t) { return t.view.default_twerper; },
          "The default twerper of the display function.")
      .def_property_readonly(
          "before", [](const TrackOf& t) { return t.view.extrapolation_before; },
          "The extrapolation before the first event, a word of `extend`.")
      .def_property_readonly(
          "after", [](const TrackOf& t) { return t.view.extrapolation_after; },
          "The extrapolation after the last event, a word of `extend`.")
      .def_property_readonly("events", events_of, "Its events, in the order of time.")
      .def(
          "__len__", [](const TrackOf& t) { return t.view.event_count; }, says("How many events it has."))
      .def(
          "__repr__",
          [](const TrackOf& t) {
            return "<Track " + t.document.name(t.view.target) + " of " + std::to_string(t.view.event_count) +
                   " events>";
          },
          says("Its name, and how many events it has."));
  film.def(
      "tracks",
      [](const Film& f, const std::string& pattern) {
        return tracks_of(unlocked([&] { return f.document(); }), pattern);
      },
      py::arg("pattern") = "",
      says("Returns the tracks of the objects or functions that a pattern names; without a pattern, all."));
}

}  // namespace betwixt::python
