// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Moves of some length, as in `at 24f ball.position (3 0) for 12f`: two events, from what is there to the value.
#include <fmt/format.h>

#include "commands/command.h"
#include "language/values.h"

namespace betwixt {
namespace {

// Returns the value that a target has before its events: what is set, or the default.
Value settled_at(const Scene& s, const Target& t) {
  const Slot* const slot = s.objects[t.object.index].find(t.function);
  const Value whole = slot && slot->set ? *slot->set : spec_of(s, t.function).rest;
  return t.component < 0 ? whole : Value(component_of(whole, t.component));
}

// Calls f for each event of a target's own tracks.
template <class F>
void each_event(const Scene& s, const Target& t, const F& f) {
  const Slot* const slot = s.objects[t.object.index].find(t.function);
  if (!slot) return;
  slot->track->events.each(f);
  for (std::size_t i = 0; i < slot->components.size(); ++i)
    if (t.component < 0 || t.component == static_cast<int>(i)) slot->components[i]->events.each(f);
}

// Returns whether events say what a target does at a time.
bool has_events_by(const Scene& s, const Target& t, Time when) {
  bool any = false;
  each_event(s, t, [&](const Event& e) { any = any || e.time <= when; });
  return any;
}

// Fails if a value of this target cannot be reached in some time.
bool can_last(Command& k, const Selected& to, const Event& e, std::string_view about) {
  if (to.velocity || e.keep || e.release || e.detail->before)
    return k.cursor.fail(ErrorCode::syntax, "'for' needs a value", about, "as in at 24f ball.position (3 0) for 12f");
  if (to.type() == Type::attachment || to.type() == Type::boolean || to.type() == Type::names)
    return k.cursor.fail(ErrorCode::type, fmt::format("{} changes at once, so 'for' has no meaning", to.spec->name),
                         about, "leave out for and the length");
  return true;
}

// Warns of rows inside the time of a move, which then goes through their values.
void say_rows_between(Command& k, const Target& t, Time from, Time until, std::string_view about) {
  std::optional<Time> inside;
  each_event(k.scene, t, [&](const Event& e) {
    if (e.time > from && e.time < until && !inside) inside = e.time;
  });
  if (inside)
    k.script.note(Severity::warning,
                  fmt::format("another row lies inside this move, at {}; the move goes through its value",
                              write_time(*inside, k.scene.rate)),
                  about, "end the other move before this one begins");
}

}  // namespace

Value value_said(const Scene& s, const Object& o, FunctionId f, Time when, bool (*counts)(const Value&)) {
  const Slot* const slot = o.find(f);
  Value out = spec_of(s, f).rest;
  bool any = false;
  const auto take = [&](const Value& v) {
    if (!counts || counts(v)) out = v, any = true;
  };
  if (!slot) return out;
  if (slot->set) take(*slot->set);
  slot->track->events.each([&](const Event& e) {
    if (!e.keep && !e.release && (e.time <= when || !any)) take(e.value);
  });
  return out;
}

bool put_for(Command& k, const Selected& to, Event e, Time length, std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  if (!can_last(k, to, e, about)) return false;
  script.sheet.tracks.clear();  // they are not those of the scene after it was copied
  Rollback all(s);
  for (const Target& t : to.targets) {
    Selected one = to;
    one.targets = {t};
    say_rows_between(k, t, e.time, e.time + length, about);
    Event begin;
    begin.time = e.time, begin.twerper = e.twerper, begin.detail = e.detail;
    begin.keep = to.type() != Type::text && has_events_by(s, t, e.time);
    if (begin.keep)
      begin.value = 0.0;
    else
      begin.value =
          to.type() == Type::text ? value_said(s, s.objects[t.object.index], t.function, e.time) : settled_at(s, t);
    Event end;
    end.time = e.time + length, end.value = e.value;
    if (to.type() != Type::text) end.twerper = *find_twerper("hold");
    if (!put_row(k, one, std::move(begin), about) || !put_row(k, one, std::move(end), about)) return false;
  }
  all.keep();
  return true;
}

}  // namespace betwixt
