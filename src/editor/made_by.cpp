// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/made_by.h"

#include <fmt/format.h>

#include <algorithm>

#include "betwixt/language.h"
#include "betwixt/track.h"
#include "language/values.h"
#include "scene/document.h"
#include "track/twerpers.h"

namespace betwixt {
namespace {

// Returns the last event of a track before a time. Searches longer and longer parts, so that a long track is not read
// whole.
std::optional<EventView> event_before(const Document& d, const TrackView& track, Time t) {
  std::optional<EventView> found;
  for (Time back = d.rate().span(1); !found; back = back + back) {
    const Time from = std::max(track.first, t - back);
    each_event(d, track.target, from, t - Time{1}, [&](const EventView& e) { found = e; });
    if (from <= track.first) break;
  }
  return found;
}
std::optional<EventView> event_after(const Document& d, const TrackView& track, Time t) {
  std::optional<EventView> found;
  for (Time on = d.rate().span(1); !found; on = on + on) {
    const Time to = std::min(track.last, t + on);
    each_event(d, track.target, t + Time{1}, to, [&](const EventView& e) {
      if (!found) found = e;
    });
    if (to >= track.last) break;
  }
  return found;
}

using What = ValueSource::What;

std::string code_of(const Value* v) {
  const auto* p = v ? std::get_if<Procedure>(v) : nullptr;
  return p ? std::string(procedure(*p).source) : std::string();
}

// Tracks of values with events, without layers and velocities.
std::vector<TrackView> own_tracks(const Document& d, const Target& t) {
  std::vector<TrackView> all = tracks(d, t);
  std::erase_if(all, [](const TrackView& v) { return v.event_count == 0 || v.target.velocity || v.target.layer; });
  return all;
}

const Object* object_of(const Document& d, const Target& t) { return find_object(d.scene(), t.object); }

// Adds what else affects the value, beside the track.
void add_besides(const Document& d, const Target& t, std::vector<ValueSource>& all) {
  const Object* o = object_of(d, t);
  if (!o) return;
  for (const Slot& slot : o->slots) {
    if (slot.function != t.function) continue;
    if (slot.layer) {
      all.push_back({What::layer, d.name(slot.layer)});
      continue;
    }
    const Strand& v = slot.velocity;
    if (!v.track->events.empty() || std::ranges::any_of(v.components, [](const auto& c) { return !c->events.empty(); }))
      all.push_back({What::velocity});
    for (const Filter& f : slot.filters)
      if (!f.off) all.push_back({What::filter, f.name});
  }
}

}  // namespace

std::pair<std::optional<Time>, std::optional<Time>> events_beside(const Document& d, const Target& t, Time at) {
  std::pair<std::optional<Time>, std::optional<Time>> beside;
  for (const TrackView& v : own_tracks(d, t)) {
    if (const auto e = event_before(d, v, at)) beside.first = std::max(beside.first.value_or(e->time), e->time);
    if (const auto e = event_after(d, v, at)) beside.second = std::min(beside.second.value_or(e->time), e->time);
  }
  return beside;
}

MadeBy made_by(const Document& d, const Target& t, Time at) {
  MadeBy made;
  std::vector<ValueSource>& all = made.sources;
  const auto when = [&](Time time) { return format_time(time, d); };
  for (const TrackView& v : own_tracks(d, t)) {
    made.events = true;
    std::optional<EventView> now;
    each_event(d, v.target, at, at, [&](const EventView& e) { now = e; });
    made.event_here |= now.has_value();
    if (!now) now = event_before(d, v, at);
    if (now && made.code.empty()) made.code = code_of(now->value);
  }
  const Object* o = object_of(d, t);
  const Slot* slot = o ? o->find(t.function) : nullptr;
  if (made.event_here) {
    all.push_back({What::event_here});
  } else if (made.events) {
    const auto [before, after] = events_beside(d, t, at);
    all.push_back(before && after ? ValueSource{What::between, when(*before), when(*after)}
                  : before        ? ValueSource{What::since, when(*before)}
                                  : ValueSource{What::before, when(*after)});
  } else if (slot && slot->set) {
    made.code = code_of(&*slot->set);
    if (made.code.empty()) all.push_back({What::set});
  } else {
    made.code = code_of(&spec_of(d.scene(), t.function).rest);
  }
  if (!made.code.empty()) all.push_back({What::code});
  add_besides(d, t, all);
  made.said = !all.empty();
  return made;
}

bool in_components(const Document& d, const Target& t) {
  return std::ranges::any_of(own_tracks(d, t), [](const TrackView& v) { return v.target.component >= 0; });
}

std::string way_of_new_event(const Document& d, const Target& t, Time at) {
  static constexpr std::string_view plain[] = {"hold", "linear", "smooth", "auto", "bspline", "slerp", "squad"};
  const Type whole = spec_of(d.scene(), t.function).type;
  std::string_view unsaid = name_of(row_of(t.component < 0 ? whole : component_track_type(whole)).twerper);
  for (const TrackView& v : tracks(d, t)) {
    if (v.target.layer != t.layer || v.event_count == 0) continue;
    if (!v.twerper.empty()) return {};  // the whole track has one twerper
    unsaid = v.default_twerper;
    std::optional<EventView> before;
    each_event(d, v.target, at, at, [&](const EventView& e) { before = e; });
    if (before) return {};  // the event exists and keeps its twerper
    before = event_before(d, v, at);
    if (before && before->stops.empty() && std::ranges::find(plain, before->twerper) != std::end(plain))
      return " " + std::string(before->twerper);
    break;
  }
  return unsaid == "smooth" ? " auto" : "";
}

std::string line_of_event(const Document& d, const Target& t, Time at, const std::string& value) {
  const auto written = [&](const Value& v) {
    return write_value(v, spec_of(d.scene(), t.function), t.component, [&](ObjectId id) { return d.name(id); });
  };
  std::string before, behind = way_of_new_event(d, t, at);
  each_event(d, t, at, at, [&](const EventView& e) {
    behind.clear();
    if (e.what != EventView::What::value || !e.value) return;
    const std::string row = write_event(d, t, at), cut = e.cut_from ? written(*e.cut_from) + " cut " : "";
    const std::string start = cut + written(*e.value);
    // If both values of the event were equal, keep them equal.
    before = e.cut_from && *e.cut_from == *e.value ? value + " cut " : cut;
    if (row.starts_with(start)) behind = row.substr(start.size());
  });
  return "at " + format_time(at, d) + " " + d.name(t) + " " + before + value + behind;
}

std::string line_that_sets(const Document& d, const Target& t, Time at, const std::string& value) {
  return own_tracks(d, t).empty() ? "set " + d.name(t) + " " + value : line_of_event(d, t, at, value);
}

std::string line_that_holds(const Document& d, ObjectId id, Time at, const Attachment& to) {
  static constexpr std::string_view verbs[] = {"detach", "letgo", "hang", "attach", "couple"};
  std::string line = fmt::format("{} {}", verbs[static_cast<std::size_t>(to.kind)], d.name(id));
  if (to.kind >= AttachmentKind::hang)
    line += fmt::format(" {} {}{}", to.kind == AttachmentKind::hang ? "on" : "to", d.name(to.parent),
                        to.keep_world ? " keep-world" : "");
  const bool timed =
      to.kind == AttachmentKind::letgo || at > d.range().first || !own_tracks(d, Target(id, fn::attachment)).empty();
  return timed ? fmt::format("at {} {}", format_time(at, d), line) : line;
}

}  // namespace betwixt
