// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The tracks of a target: one of the whole, or one for each component.
#include "scene/document.h"

namespace betwixt {
namespace {

// Returns the event of one component of a value.
Event part_of(const Event& e, int component) {
  Event part = e;
  if (!e.keep && !e.release) part.value = component_of(e.value, component);
  if (!e.detail) return part;
  EventDetail& d = part.detail.edit();
  for (auto* v : {&d.before, &d.tangent_in, &d.tangent_out})
    if (*v) *v = component_of(**v, component);
  return part;
}

void split(Strand& strand, Type type) {
  const auto n = static_cast<std::size_t>(component_count(type));
  if (strand.components.size() == n) return;
  strand.components.assign(n, {});
  if (strand.track->events.empty() && *strand.track == Track{}) return strand.track.reset();
  for (std::size_t i = 0; i < n; ++i) {
    Track t = *strand.track;
    t.events = {};
    strand.track->events.each([&](const Event& e) { t.events.put(part_of(e, static_cast<int>(i))); });
    strand.components[i] = Cow<Track>(std::move(t));
  }
  strand.track.reset();
}

const Strand& strand_of(const Slot& slot, const Target& t) { return t.velocity ? slot.velocity : slot; }
Strand& strand_of(Slot& slot, const Target& t) { return t.velocity ? slot.velocity : slot; }

}  // namespace

Strand split_into_components(const Strand& strand, Type type) {
  Strand out = strand;
  split(out, type);
  return out;
}

Track* edit_track(Scene& s, const Target& t) {
  const Type type = spec_of(s, t.function).type;
  Strand& strand = strand_of(s.objects.edit(t.object.index).slot(t.function, t.layer), t);
  if (t.component < 0) return strand.components.empty() ? &strand.track.edit() : nullptr;
  split(strand, type);
  return &strand.components[static_cast<std::size_t>(t.component)].edit();
}

std::vector<Track*> edit_tracks(Scene& s, const Target& t) {
  if (Track* one = edit_track(s, t)) return {one};
  std::vector<Track*> out;
  for (auto& c : strand_of(s.objects.edit(t.object.index).slot(t.function, t.layer), t).components)
    out.push_back(&c.edit());
  return out;
}

std::vector<const Track*> tracks_of(const Scene& s, const Target& t) {
  const Slot* slot = s.objects[t.object.index].find(t.function, t.layer);
  if (!slot) return {};
  const Strand& strand = strand_of(*slot, t);
  if (strand.components.empty()) return {&*strand.track};
  if (t.component >= 0) return {&*strand.components[static_cast<std::size_t>(t.component)]};
  std::vector<const Track*> out;
  for (const auto& c : strand.components) out.push_back(&*c);
  return out;
}

void put_event(Scene& s, const Target& t, Event e) {
  if (Track* one = edit_track(s, t)) {
    one->events.put(std::move(e));
    return;
  }
  const auto tracks = edit_tracks(s, t);
  for (std::size_t i = 0; i < tracks.size(); ++i) tracks[i]->events.put(part_of(e, static_cast<int>(i)));
}

void set_value(Scene& s, const Target& t, const Value& v) {
  const FunctionSpec& spec = spec_of(s, t.function);
  Slot& slot = s.objects.edit(t.object.index).slot(t.function, t.layer);
  slot.set = t.component < 0 ? v : with_component(slot.set.value_or(spec.rest), t.component, std::get<double>(v));
}

}  // namespace betwixt
