// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/environment.h"
#include "scene/document.h"

namespace betwixt {
namespace {

std::vector<EnvironmentSpan> spans(const Document& d, ObjectId id, FunctionId f) {
  std::vector<EnvironmentSpan> out;
  const Object* o = find_object(d.scene(), id);
  if (!o) return out;
  for (const EnvironmentsFrom& e : environments_of(d.scene(), *o, f)) {
    if (!out.empty()) out.back().until = e.from;
    out.push_back({e.from, latest_time, {}});
    for (const Generation& g : e.all) out.back().environments.push_back(g.environment);
  }
  return out;
}

EnvironmentEventView view_of(const EnvironmentEvent& e) {
  static constexpr std::string_view words[] = {"halt", "kill", "cancel", "animate"};
  EnvironmentEventView view;
  view.tick = e.tick, view.what = words[e.what.index()];
  if (const auto* a = std::get_if<EnvironmentEvent::Animate>(&e.what)) {
    view.motion = &a->motion;
    view.interval = a->timing.interval, view.change = a->timing.change;
    view.period = a->timing.period, view.ceiling = a->timing.ceiling;
    view.keep_phase = a->keep_phase, view.from = a->from, view.until = a->until;
  }
  return view;
}

}  // namespace

void each_environment_event(const Document& d, ObjectId id, const std::function<void(const EnvironmentEventView&)>& f) {
  const Object* o = find_object(d.scene(), id);
  if (!o || !o->environment) return;
  for (std::size_t i = 0; i < o->environment->size(); ++i) f(view_of(o->environment->event(i)));
}

std::vector<EnvironmentSpan> surrounding(const Document& d, ObjectId id) { return spans(d, id, fn::environments); }
std::vector<EnvironmentSpan> driving(const Document& d, ObjectId id) { return spans(d, id, fn::drive); }

std::vector<EnvironmentsFrom> environments_of(const Scene& s, const Object& o, FunctionId f) {
  std::vector<EnvironmentsFrom> out;
  const Slot* slot = o.find(f);
  if (!slot) return out;
  const auto add = [&](Time from, const Value& v) {
    EnvironmentsFrom now{from, {}};
    const std::int64_t tick = from == earliest_time ? -Environment::furthest : s.ticks.whole(from);
    const auto* names = std::get_if<Names>(&v);  // code is asked by the program
    for (const std::string& name : names ? **names : std::vector<std::string>())
      for (const ObjectId id : select(s, name))  // an alias names many
        if (const auto& track = s.objects[id.index].environment)
          if (const auto generation = track->bind(tick)) now.all.push_back({id, *generation});
    out.push_back(std::move(now));
  };
  if (slot->set || !slot->track->events.empty()) add(earliest_time, slot->set.value_or(Names()));
  slot->track->events.each([&](const Event& e) {
    if (!e.keep) add(e.time, e.value);
  });
  return out;
}

}  // namespace betwixt
