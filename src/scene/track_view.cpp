// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/track.h"
#include "scene/document.h"
#include "track/procedure.h"

namespace betwixt {
namespace {

// Returns the slot of a target's function, its own or on a layer, or null if it has none.
const Slot* slot_of(const Document& d, const Target& t) {
  const Object* o = find_object(d.scene(), t.object);
  return o ? o->find(t.function, t.layer) : nullptr;
}

const Track* track_of(const Slot& slot, const Target& t) {
  const Strand& strand = t.velocity ? slot.velocity : slot;
  if (t.component < 0) return strand.components.empty() ? &*strand.track : nullptr;
  const auto i = static_cast<std::size_t>(t.component);
  return i < strand.components.size() ? &*strand.components[i] : nullptr;
}

const Track* track_of(const Document& d, const Target& t) {
  const Slot* slot = slot_of(d, t);
  return slot ? track_of(*slot, t) : nullptr;
}

std::string_view said(const Scene& s, Twerper t) {
  if (t == Twerper::unset) return {};
  if (!is_own(t)) return name_of(t);
  return (*s.procedures)[static_cast<std::size_t>(t) - first_own_twerper].name;
}

template <class T>
bool all_values(const Track& track) {
  bool all = true;
  track.events.each([&](const Event& e) { all = all && (e.keep || e.release || std::holds_alternative<T>(e.value)); });
  return all;
}

// Returns the default twerper of a track; for rotations and aims it depends on the values.
Twerper unsaid(const Target& t, Type type, const Track& track) {
  if (t.velocity) return Twerper::smooth;
  if (t.component >= 0) return row_of(component_track_type(type)).twerper;
  if (type == Type::motion) return Twerper::linear;
  if (row_of(type).changes == Changes::by_turning && !all_values<Angles>(track)) return Twerper::slerp;
  if (type == Type::aim && all_values<Vec3>(track)) return Twerper::smooth;
  return row_of(type).twerper;
}

std::span<const Stop> stops_of(const TwerperArguments& a) { return a.stops ? *a.stops : std::span<const Stop>{}; }

TrackView view_of(const Scene& s, const Target& t, const Track& track) {
  const auto extrapolation = [](Extrapolation e) { return extrapolation_names[static_cast<std::size_t>(e)]; };
  TrackView view{t,
                 track.events.size(),
                 {},
                 {},
                 said(s, track.global),
                 track.arguments,
                 stops_of(track.arguments),
                 said(s, unsaid(t, spec_of(s, t.function).type, track)),
                 extrapolation(track.before),
                 extrapolation(track.after),
                 track.srgb};
  if (view.event_count > 0) view.first = track.events.front().time, view.last = track.events.back().time;
  return view;
}

EventView view_of(const Scene& s, const Event& e) {
  const auto maybe = [](const std::optional<Value>& v) { return v ? &*v : nullptr; };
  EventView view;
  view.time = e.time;
  view.what = e.release ? EventView::What::release : e.keep ? EventView::What::keep : EventView::What::value;
  if (view.what == EventView::What::value) view.value = &e.value;
  view.twerper = said(s, e.twerper);
  if (!e.detail) return view;
  view.arguments = e.detail->arguments, view.stops = stops_of(e.detail->arguments);
  view.handle_in = e.detail->handle_in, view.handle_out = e.detail->handle_out;
  view.ease_out = e.detail->ease_out, view.ease_in = e.detail->ease_in;
  view.cut_from = maybe(e.detail->before);
  view.tangent_in = maybe(e.detail->tangent_in), view.tangent_out = maybe(e.detail->tangent_out);
  return view;
}

// Adds all tracks of one slot that have any content.

void add_tracks(const Scene& s, ObjectId object, const Slot& slot, std::vector<TrackView>& out) {
  Target t(object, slot.function);
  t.layer = slot.layer;
  for (const bool velocity : {false, true}) {
    t.velocity = velocity;
    const auto parts = static_cast<int>((velocity ? slot.velocity : slot).components.size());
    for (t.component = parts > 0 ? 0 : -1; t.component < parts || t.component < 0; ++t.component) {
      const Track& track = *track_of(slot, t);
      if (track != Track{}) out.push_back(view_of(s, t, track));
      if (parts == 0) break;
    }
  }
}

ProcedureView procedure_view(std::string_view name, Role role, const Routine& code) {
  return {name, role_names[static_cast<std::size_t>(role)], code.language, code.source};
}

}  // namespace

std::vector<TrackView> tracks(const Document& d, ObjectId id) {
  std::vector<TrackView> out;
  if (const Object* o = find_object(d.scene(), id))
    for (const Slot& slot : o->slots) add_tracks(d.scene(), id, slot, out);
  return out;
}

std::vector<TrackView> tracks(const Document& d, const Target& t) {
  std::vector<TrackView> out;
  Target one = t;
  const auto add = [&](int component) {
    one.component = component;
    if (auto view = track(d, one)) out.push_back(*std::move(view));
  };
  add(t.component);
  if (t.component >= 0 && out.empty()) add(-1);
  for (int i = 0; t.component < 0 && i < 3; ++i) add(i);
  return out;
}

std::vector<TrackView> tracks_on(const Document& d, ObjectId layer) {
  std::vector<TrackView> out;
  if (!find_object(d.scene(), layer)) return out;
  for (std::uint32_t i = 0; i < d.scene().objects.size(); ++i)
    for (const Slot& slot : d.scene().objects[i].slots)
      if (slot.layer == layer) add_tracks(d.scene(), {i}, slot, out);
  return out;
}

std::optional<TrackView> track(const Document& d, const Target& t) {
  const Track* track = track_of(d, t);
  return track && *track != Track{} ? std::optional(view_of(d.scene(), t, *track)) : std::nullopt;
}

const Value* value_set(const Document& d, const Target& t) {
  const Slot* slot = slot_of(d, t);
  return slot && slot->set ? &*slot->set : nullptr;
}

void each_event(const Document& d, const Target& t, Time from, Time to,
                const std::function<void(const EventView&)>& f) {
  if (const Track* track = track_of(d, t))
    track->events.each_between(from, to, [&](const Event& e) { f(view_of(d.scene(), e)); });
}

std::optional<Time> next_event(const Document& d, const Target& t, Time from) {
  const Track* track = track_of(d, t);
  const Event* e = track ? track->events.first_from(from) : nullptr;
  return e ? std::optional(e->time) : std::nullopt;
}

std::optional<Time> event_before(const Document& d, const Target& t, Time time) {
  const Track* track = track_of(d, t);
  const Event* e = track ? track->events.last_before(time) : nullptr;
  return e ? std::optional(e->time) : std::nullopt;
}

std::vector<EventView> events(const Document& d, const Target& t) {
  std::vector<EventView> out;
  each_event(d, t, earliest_time, latest_time, [&](const EventView& e) { out.push_back(e); });
  return out;
}

std::vector<FilterView> filters(const Document& d, const Target& t) {
  std::vector<FilterView> out;
  if (const Slot* slot = slot_of(d, t))
    for (const Filter& f : slot->filters)
      out.push_back({f.name, f.code != nullptr, f.parameters, f.component, f.segment, f.off});
  return out;
}

std::vector<ProcedureView> procedures(const Document& d) {
  std::vector<ProcedureView> out;
  for (const NamedProcedure& p : *d.scene().procedures) out.push_back(procedure_view(p.name, p.role, *p.code));
  return out;
}

ProcedureView procedure(const Procedure& p) { return procedure_view({}, Role::value, *p.code); }

}  // namespace betwixt
