// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads the part of a row after its time: an event's value and the interpolation that follows it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/cancellation.h"
#include "commands/command.h"
#include "scene/names.h"
#include "syntax/tokens.h"
#include "track/curve.h"

namespace betwixt {
namespace {

// Returns whether the separate numbers of an aim would meet an aim at an object.
bool mixes_aims(const Scene& s, const Target& t, const Value& v) {
  const Slot* slot = s.objects[t.object.index].find(t.function);
  if (!slot) return false;
  if (t.component < 0) return !slot->components.empty() && std::holds_alternative<ObjectId>(v);
  bool any = false;
  slot->track->events.each(
      [&](const Event& e) { any = any || (!e.keep && std::holds_alternative<ObjectId>(e.value)); });
  return any;
}

// Stores diagnostics that are reported at the end of the script if they still apply.
void withhold(Command& k, const Selected& to, const Event& event, std::string_view about) {
  Script& script = k.script;
  constexpr std::size_t most = 10'000;
  if (event.release && script.releases.size() < most)
    if (const auto d = script.withheld(Severity::notice,
                                       fmt::format("no velocity is active at {}, so there is nothing to release",
                                                   format_time(event.time, k.scene.rate)),
                                       about))
      for (const Target& t : to.targets) script.releases.push_back({t, event.time, *d});
  if (!to.velocity) return;
  for (const Target& t : to.targets) {
    const auto key = std::pair(t.object.index, t.function);
    if (script.velocities.contains(key) || script.velocities.size() > most) continue;
    if (auto d = script.withheld(Severity::warning, "", about)) script.velocities.emplace(key, *std::move(d));
  }
}

// Fails if the value cannot be on the target's track beside its present contents.
bool goes_with(Command& k, const Selected& to, const Target& t, const Event& event, std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  const bool computes = std::holds_alternative<Procedure>(event.value);
  const bool whole = to.component < 0;
  const bool rotation = to.type() == Type::rotation && !event.keep && !computes;
  const Slot* slot = s.objects[t.object.index].find(t.function, t.layer);
  if (computes && whole && slot && !slot->components.empty())
    return c.fail(ErrorCode::type, "its components have their own tracks, so code cannot compute the whole value",
                  about, "write code for each component");
  if (!rotation && whole) return true;
  const auto tracks = tracks_of(s, t);
  if (tracks.empty()) return true;
  if (!whole && slot->components.empty() && has_code(*tracks[0]))
    return c.fail(ErrorCode::type, "its rows compute the whole value by code, so a component cannot have its own row",
                  about,
                  fmt::format("to turn them into plain rows: bake {} A..B", target_name(s, {t.object, t.function})));
  const bool orientation = !tracks[0]->events.empty() && std::holds_alternative<Quat>(tracks[0]->events.front().value);
  const bool turns = std::holds_alternative<Quat>(event.value);
  // Components of an orientation would mean nothing to an animator.
  if ((!whole && slot->components.empty() && orientation) || (rotation && whole && !slot->components.empty() && turns))
    return c.fail(ErrorCode::type,
                  fmt::format("'{}' cannot have both orientations and separate angles", target_name(s, t)), about,
                  "write all rows as euler(x y z), or all as axis(…) or quat(…)");
  if (rotation && whole && !tracks[0]->events.empty() && orientation != turns && !script.sheet.warned) {
    script.note(Severity::warning,
                "this track mixes angles and orientations, so all become orientations and whole turns are lost", about,
                "write all rows as euler(x y z), or all as axis(…) or quat(…)");
    script.sheet.warned = true;
  }
  return true;
}

}  // namespace

bool has_code(const Track& track) {
  bool any = false;
  track.events.each([&](const Event& e) { any = any || std::holds_alternative<Procedure>(e.value); });
  return any;
}

// Fails if the target is the geometry of an object that cannot show a shape.
bool draws(Command& k, const Target& t, std::string_view about) {
  const Object& o = k.scene.objects[t.object.index];
  return t.function != fn::geometry || drawable(o.kind) ||
         k.cursor.fail(ErrorCode::type,
                       fmt::format("'{}' is {}, which has no visible geometry", o.name, a_kind(o.kind)), about,
                       "use an object with a shape, as in create NAME box");
}

bool focuses_elsewhere(Command& k, const Target& t, const Value& v, std::string_view about) {
  const auto* at = std::get_if<ObjectId>(&v);
  if (t.function != fn::focus || !at || !(*at == t.object)) return true;
  return k.cursor.fail(ErrorCode::name,
                       fmt::format("'{}' cannot focus on itself", k.scene.objects[t.object.index].name), about,
                       "write another object, or a distance in metres: set eye.focus 5");
}

namespace {

// Applies `keep` to an existing event: changes its twerper, eases and tangents, but not its value.
bool keep_there(Scene& s, const Target& t, const Event& event) {
  bool all = true;
  for (Track* track : edit_tracks(s, t)) {
    const Event* there = track->events.find(event.time);
    if (!there || there->keep || there->release) {
      all = false;
      continue;
    }
    Event other = *there;
    other.twerper = event.twerper;
    if (event.detail || other.detail) {
      EventDetail& d = other.detail.edit();
      d.arguments = event.detail->arguments;
      if (event.detail->ease_in > Time{}) d.ease_in = event.detail->ease_in;
      if (event.detail->ease_out > Time{}) d.ease_out = event.detail->ease_out;
      if (event.detail->tangent_in) d.tangent_in = event.detail->tangent_in, d.handle_in = event.detail->handle_in;
      if (event.detail->tangent_out) d.tangent_out = event.detail->tangent_out, d.handle_out = event.detail->handle_out;
    }
    track->events.put(std::move(other));
  }
  return all;
}

}  // namespace

bool put_row(Command& k, const Selected& to, Event event, std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  if (to.type() == Type::attachment && std::holds_alternative<Procedure>(event.value)) {
    for (const Target& t : to.targets) say_fall_ends(k, t.object, event.time, about);
  } else if (to.type() == Type::attachment && !event.keep) {
    std::vector<ObjectId> children;
    for (const Target& t : to.targets) children.push_back(t.object);
    return attachment(k, children, std::get<Attachment>(event.value), event.time, about);
  }
  if (to.spec->type == Type::shape) {
    for (const Target& t : to.targets)
      if (!draws(k, t, about)) return false;
  }
  withhold(k, to, event, about);
  for (const Target& t : to.targets) {
    if (!focuses_elsewhere(k, t, event.value, about)) return false;
    if (to.spec->type == Type::aim && !event.keep && mixes_aims(s, t, event.value))
      return c.fail(ErrorCode::type,
                    fmt::format("'{}' cannot have both objects and separate numbers", target_name(s, t)), about,
                    "write all rows as points (x y z)");
    if (to.velocity) break;
    if (!goes_with(k, to, t, event, about)) return false;
  }
  if (to.type() == Type::text && !event.keep)
    say_missing_style(k, s.objects[to.targets[0].object.index], to.targets[0].function, event.value, about);
  if (to.type() == Type::text && !event.keep)
    for (const Target& t : to.targets)
      if (!make_parts(k, t.object, t.function, event.value, about)) return false;
  const auto& direct = script.sheet.tracks;
  const bool straight = to.type() != Type::attachment;  // a plain attachment among its rows has copied the scene
  if (&to == &script.sheet.on && !direct.empty() && !event.keep && straight) {
    for (std::size_t i = 1; i < direct.size(); ++i) direct[i]->events.put(event);
    if (direct[0]->events.put(std::move(event)) && script.sheet.fresh)
      script.note(Severity::warning, "an earlier row of this sheet has the same time; this one replaces it", about);
    return true;
  }
  for (const Target& t : to.targets)
    if (Cancellation::check(); !event.keep || !keep_there(s, t, event)) put_event(s, t, event);
  return true;
}

// Reads = "…": a value that code computes.
bool computed(Command& k, const Selected& to, Value& out) {
  auto& [s, c, time, layer, script] = k;
  if (!c.accept('=')) return c.fail_here(ErrorCode::syntax, "'=' is missing here");
  c.space();
  const char* start = c.at;
  if (c.peek() != '"') {
    const auto line = static_cast<std::size_t>(line_end(start, c.end) - start);
    return c.fail_here(ErrorCode::syntax, "expected code in quotes after '='",
                       fmt::format("write a plain value without '=': {0}; write code in quotes: = \"{0}\"",
                                   std::string_view(start, std::min<std::size_t>(line, 60))));
  }
  std::string source;
  if (!c.text(source)) return false;
  const std::string_view about(start, static_cast<std::size_t>(c.at - start));
  if (to.type() == Type::attachment) {
    if (layer) return c.fail(ErrorCode::type, "a layer cannot have attachments", about);
    for (const Target& t : to.targets)
      if (!placed(s.objects[t.object.index].kind))
        return c.fail(ErrorCode::type, "layers and environments cannot have a parent or be one", about);
  }
  if (to.spec->by_script)
    return c.fail(ErrorCode::type, fmt::format("{} cannot be computed", to.spec->name), about,
                  "it is read once, with the script; code can compute all values that change while the film plays");
  if (!to.targets.empty() && !files_in_code(k, to.targets[0].function, source, about)) return false;
  auto code = make_code(k, std::move(source), !to.targets.empty());
  if (!code) return c.fail(code.error(), about);
  out = Procedure{*std::move(code)};
  return true;
}

// Reads the part of a row after its time: VALUE [cut VALUE] [TWERPER] [ease-in=L] [ease-out=L] [tangent…=V], or keep
// TWERPER.
bool event(Command& k, const Selected& to, Time when) {
  auto& [s, c, time, layer, script] = k;
  if (to.type() == Type::motion) return moving(k, to, when, std::nullopt);
  Event e;
  e.time = when;
  c.space();
  if (goes_along(c)) return along_line(k, to, when, std::nullopt);
  const char* value_at = c.at;
  const bool released = to.velocity && c.peek() == 'r' && c.accept_word("release");
  if (released) {
    e.release = true;
    e.value = 0.0;
    if (!finish(c)) return false;
  } else if (c.peek() == '=') {
    if (!computed(k, to, e.value)) return false;
  } else if (to.velocity && c.peek_word() != "keep") {
    if (!rate_of_change(k, to, e.value)) return false;
    c.space();
    if (c.peek() == 'c' && c.accept_word("cut")) {
      e.detail.edit().before = std::move(e.value);
      if (!rate_of_change(k, to, e.value)) return false;
    }
  } else if (c.peek() == 'k' && c.peek_word() == "keep") {
    c.word();
    e.keep = true;
    e.value = 0.0;
  } else {
    if (c.peek_word() == "release" && has_velocity(to.type()))
      return c.fail_here(ErrorCode::type, "'release' needs a velocity",
                         fmt::format("as in at 20f {}.velocity release", to.text.substr(0, 60)));
    if (!values(k).value(*to.spec, to.component, e.value, to.targets.empty() ? 0xffff : to.targets[0].function))
      return false;
    c.space();
    if (c.peek() == 'c' && c.accept_word("cut")) {
      Value after;
      if (!values(k).value(*to.spec, to.component, after, to.targets.empty() ? 0xffff : to.targets[0].function))
        return false;
      e.detail.edit().before = std::move(e.value);
      e.value = std::move(after);
    }
  }
  const std::string_view about(value_at, static_cast<std::size_t>(c.at - value_at));
  std::optional<Time> lasts;
  if (!way(k, to, e, &lasts)) return false;
  if (!lasts) return put_row(k, to, std::move(e), about);
  return put_for(k, to, std::move(e), *lasts, about);
}

bool time_or_segment(Cursor& c, Time& from, std::optional<Time>& until) {
  const char* const start = c.at;
  if (!c.time(from)) return false;
  const auto dots = [&](const char* at) { return c.end - at >= 2 && at[0] == '.' && at[1] == '.'; };
  if (!dots(c.at)) {
    const char* const behind = c.at;
    c.space();
    if (dots(c.at)) return c.fail(ErrorCode::syntax, "write a segment without spaces", {c.at, 2}, "as in 1f..24f");
    c.at = behind;
    return true;
  }
  c.at += 2;
  Time to;
  if (!c.time(to)) return false;
  if (to < from) return c.fail(ErrorCode::range, "this segment ends before it begins", c.since(start));
  until = to;
  return true;
}

bool one_time_only(Cursor& c, std::string_view segment) {
  return c.fail(ErrorCode::syntax, "expected one time here; only motions and moves along a line take a segment",
                segment,
                "as in 1f..24f T(6 0) in the sheet of wheel.motion, or 1f..24f along road in that of ball.position");
}

}  // namespace betwixt
