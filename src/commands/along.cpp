// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Motion along a line: 160f..208f along road [from 0 to 1] [turned] [TWERPER]. The track holds places on the line, one
// at each end; between two places on the same line the motion follows it (track/along.h).
#include "track/along.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

#include "betwixt/program.h"
#include "commands/command.h"
#include "program/along.h"
#include "scene/kinds.h"
#include "scene/line.h"
#include "scene/names.h"

namespace betwixt {
namespace {

// The arguments of `along`.
struct Way {
  ObjectId road;
  double from = 0, to = 1;
  bool turned = false;
  Event event;  // its interpolation
};

bool share(Command& k, double& out) {
  ValueReader v = values(k);
  Cursor& c = k.cursor;
  c.space();
  const char* const start = c.at;
  return v.scalar(out) &&
         (std::abs(out) <= 1e6 ||
          c.fail(ErrorCode::range, "the share of a line must be from -1000000 to 1000000", c.since(start)));
}

// Reads the name of a line.
bool road(Command& k, const Selected& to, ObjectId& out) {
  auto& [s, c, time, layer, script] = k;
  c.space();
  const char* const start = c.at;
  if (!values(k).object(out)) return false;
  const Object& o = s.objects[out.index];
  if (!has_line(o.kind))
    return c.fail(
        ErrorCode::type, fmt::format("'{}' is {}; objects cannot move along it", o.name, a_kind(o.kind)),
        c.since(start),
        "objects move along a curve, a polyline or a flat shape: create road curve points=((0 0) (2 1) (4 0))");
  for (const Target& t : to.targets)
    if (t.object == out)
      return c.fail(ErrorCode::name, fmt::format("'{}' cannot move along itself", o.name), c.since(start));
  return true;
}

bool fits_on_line(Command& k, const Selected& to) {
  Cursor& c = k.cursor;
  const FunctionId f = to.targets.empty() ? static_cast<FunctionId>(fn::position) : to.targets[0].function;
  if (to.velocity) return c.fail_here(ErrorCode::type, "a velocity cannot follow a line; a position can");
  if (to.component >= 0)
    return c.fail_here(ErrorCode::type, "one component cannot follow a line; a whole position can");
  return f == fn::position || f == fn::rotation ||
         c.fail_here(ErrorCode::type, fmt::format("{} cannot follow a line; a position can", to.spec->name),
                     "as in 1f..48f along road in the sheet of ball.position; a rotation follows its direction");
}

// Reads ROAD [SHARE | from SHARE to SHARE] [turned] [TWERPER …], after `along`.
bool way_along(Command& k, const Selected& to, bool lasts, Way& out) {
  Cursor& c = k.cursor;
  if (!road(k, to, out.road)) return false;
  if (!lasts) {
    if (!share(k, out.from)) return false;
    out.to = out.from;
  } else if (c.accept_word("from")) {
    if (!share(k, out.from)) return false;
    if (!c.accept_word("to"))
      return c.fail_here(ErrorCode::syntax, "'to' is missing here", "as in along road from 0 to 1");
    if (!share(k, out.to)) return false;
  }
  c.space();
  const char* const start = c.at;
  out.turned = c.accept_word("turned");
  if (out.turned && !to.targets.empty() && to.targets[0].function == fn::rotation)
    return c.fail(ErrorCode::syntax, "a rotation takes no 'turned': it always turns along the line", c.since(start));
  return way(k, to, out.event) && finish(c);
}

// Puts an event at one end. If an event with another value is there already, the value before the end and the value
// after it both remain, as a cut.
void put_end(Scene& s, const Target& t, Event e, bool ends) {
  const auto tracks = edit_tracks(s, t);
  const Event* there = tracks.empty() ? nullptr : tracks[0]->events.find(e.time);
  if (there && !there->keep) {
    const Along* other = along(there->value);
    const Value came_to = there->detail->before.value_or(there->value);
    if (ends && !(there->value == e.value)) {  // the next row begins here
      Event cut = *there;
      cut.detail.edit().before = e.value;
      if (e.detail->ease_in != Time{}) cut.detail.edit().ease_in = e.detail->ease_in;
      e = std::move(cut);
    } else if (!ends && !(came_to == e.value) && (!other || there->twerper == Twerper::hold || there->detail->before)) {
      e.detail.edit().before = came_to;
      if (there->detail->ease_in != Time{}) e.detail.edit().ease_in = there->detail->ease_in;
    }
  }
  put_event(s, t, std::move(e));
}

void put_way(Scene& s, const Target& t, const Way& w, Time from, std::optional<Time> until) {
  Event begin = w.event;
  begin.time = from, begin.value = along(w.road, w.from);
  if (!until) return put_event(s, t, std::move(begin));
  if (begin.twerper == Twerper::unset) begin.twerper = *find_twerper("auto");  // never overshoots the given ends
  for (Track* track : edit_tracks(s, t))
    for (const Event& inside : track->events.between(from, *until))
      if (inside.time > from && inside.time < *until) track->events.erase(inside.time, inside.time);
  Event end;
  end.time = *until, end.value = along(w.road, w.to), end.twerper = Twerper::hold;
  if (begin.detail->ease_in != Time{}) {  // an ease-in belongs to the event at the end
    end.detail.edit().ease_in = begin.detail->ease_in;
    begin.detail.edit().ease_in = {};
  }
  put_end(s, t, std::move(end), true);
  put_end(s, t, std::move(begin), false);
}

// Makes the same targets for the rotations.
bool turned(Command& k, const Selected& to, std::string_view about, std::vector<Target>& out) {
  for (Target t : to.targets) {
    t.function = fn::rotation;
    const Slot* slot = k.scene.objects[t.object.index].find(fn::rotation, t.layer);
    if (slot && !slot->components.empty())
      return k.cursor.fail(ErrorCode::type,
                           fmt::format("the components of '{}' have their own tracks, so it cannot turn along a line",
                                       target_name(k.scene, t)),
                           about, "clear these tracks first, or leave out 'turned'");
    out.push_back(t);
  }
  return true;
}

}  // namespace

bool along_line(Command& k, const Selected& to, Time from, std::optional<Time> until) {
  auto& [s, c, time, layer, script] = k;
  c.space();
  const char* const start = c.at;
  if (!fits_on_line(k, to)) return false;
  c.word();
  if (until && *until == from)
    return c.fail(ErrorCode::range, "a move along a line needs a segment longer than 0", c.since(start));
  Way w;
  if (!way_along(k, to, until.has_value(), w)) return false;
  const std::string_view about = c.since(start);
  for (const Target& t : to.targets)
    if (const Slot* slot = s.objects[t.object.index].find(t.function, t.layer); slot && !slot->components.empty())
      return c.fail(ErrorCode::type, "its components have their own tracks, so the whole value cannot follow a line",
                    about);
  std::vector<Target> also;
  if (w.turned && !turned(k, to, about, also)) return false;
  also.insert(also.begin(), to.targets.begin(), to.targets.end());
  for (const Target& t : also) put_way(s, t, w, from, until);
  if (!script.sheet.tracks.empty()) find_tracks(s, script.sheet);  // the sheet's tracks may have been replaced
  return true;
}

bool set_along_line(Command& k, const Selected& to) {
  Cursor& c = k.cursor;
  if (!fits_on_line(k, to)) return false;
  c.space();
  const char* const start = c.at;
  c.word();
  Way w;
  if (!road(k, to, w.road) || !share(k, w.from)) return false;
  w.turned = c.accept_word("turned");
  if (!finish(c)) return false;
  std::vector<Target> also;
  if (w.turned && !turned(k, to, c.since(start), also)) return false;
  also.insert(also.begin(), to.targets.begin(), to.targets.end());
  for (const Target& t : also) set_value(k.scene, t, along(w.road, w.from));
  return true;
}

// Objects on a line that is about to be removed keep their path, as straight pieces from event to event.
void keep_ways(const Command& k, const std::vector<ObjectId>& leaving, const std::vector<std::uint32_t>& speaking,
               std::string_view about) {
  Scene& s = k.scene;
  const Scene before = s;
  std::unordered_set<std::uint32_t> leaves;
  for (const ObjectId id : leaving) leaves.insert(id.index);
  std::optional<Program> program;
  const auto kept = [&](std::uint32_t object, FunctionId f, const Value& v, Time t) -> std::optional<Value> {
    const Along* a = along(v);
    if (!a || !leaves.contains(a->road.index)) return std::nullopt;
    if (!program) program = Program::compile(Document(std::make_shared<const Scene>(before)));
    Asking asking;
    const auto place = value_along(program->compiled(), object, f, a->road, a->share, t, asking);
    return place ? *place : spec_of(s, f).rest;
  };
  for (const std::uint32_t i : speaking) {
    if (before.objects[i].removed || leaves.contains(i)) continue;
    for (const Slot& slot : before.objects[i].slots) {
      if (slot.function != fn::position && slot.function != fn::rotation) continue;
      Target target{ObjectId{i}, slot.function};
      target.layer = slot.layer;
      bool any = false;
      if (slot.set)
        if (const auto place = kept(i, slot.function, *slot.set, {})) set_value(s, target, *place), any = true;
      slot.track->events.each([&](const Event& e) {
        Event now = e;
        if (const auto place = kept(i, slot.function, e.value, e.time)) now.value = *place;
        if (e.detail->before)
          if (const auto place = kept(i, slot.function, *e.detail->before, e.time)) now.detail.edit().before = *place;
        if (now == e) return;
        any = true;
        put_event(s, target, std::move(now));
      });
      if (any)
        k.script.note(Severity::notice,
                      fmt::format("'{}' now goes straight where it followed that line", target_name(s, target)), about);
    }
  }
}

}  // namespace betwixt
