// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Motions in scripts: 1f..48f T(6.28 0) R(-1turn @ 0 1). On the track a motion is an event that lasts up to the next
// one; an empty motion fills the time without motion.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <unordered_set>

#include "betwixt/program.h"
#include "commands/command.h"
#include "scene/names.h"

namespace betwixt {
namespace {

bool moves(const Event& e) {
  const auto* m = std::get_if<Moves>(&e.value);
  return !e.keep && (std::holds_alternative<Procedure>(e.value) || (m && !(*m)->factors.empty()));
}
std::string text_of(const Value& v) {
  const auto* m = std::get_if<Moves>(&v);
  return m ? to_string(**m) : "code";
}

}  // namespace

// Reads the motion after a row's segment.
bool moving(Command& k, const Selected& to, Time from, std::optional<Time> until) {
  auto& [s, c, time, layer, script] = k;
  c.space();
  const char* start = c.at;
  if (to.velocity) return c.fail_here(ErrorCode::type, "a motion has no velocity");
  if (until && *until == from) return c.fail_here(ErrorCode::range, "a motion needs a segment longer than 0");
  Event e;
  e.time = from;
  if (c.peek() == '=') {
    if (!computed(k, to, e.value)) return false;
  } else {
    Moves value;
    if (!values(k).motion(value)) return false;
    e.value = std::move(value);
  }
  const std::string_view about = c.since(start);
  const bool rest = !moves(e);
  if (!way(k, to, e) || !finish(c)) return false;
  for (const Target& t : to.targets) {
    if (t.layer)
      return c.fail(ErrorCode::type, "a layer cannot have a motion: motions are always added to the tracks", to.text);
    const Slot* slot = s.objects[t.object.index].find(t.function);
    if (!slot) continue;
    const Event *busy = nullptr, *before = nullptr;
    std::optional<Time> end;
    slot->track->events.each([&](const Event& other) {
      if (other.time < from) before = moves(other) ? &other : nullptr;
      if (other.time >= from && before && !end) end = other.time;
      if (until && other.time > from && other.time < *until && moves(other) && !busy) busy = &other;
    });
    // A motion without an end lasts up to the next event; the new motion ends it.
    if (before && end && *end > from) busy = before;
    if (busy)
      return c.fail(ErrorCode::range,
                    fmt::format("'{}' is already in motion from {} by {}", target_name(s, t),
                                format_time(busy->time, s.rate), text_of(busy->value).substr(0, 80)),
                    about, "motions of one object must not overlap; write those at the same time as one string");
  }
  if (!until && !rest)
    script.note(Severity::notice, "this motion has no end yet; it lasts until the next row", about,
                "write a segment, as in 1f..24f");
  // An ease-in describes the arrival, so it belongs to the event at the end.
  const Time ease_in = until ? e.detail->ease_in : Time{};
  if (ease_in != Time{}) e.detail.edit().ease_in = {};
  for (const Target& t : to.targets) {
    Events& events = edit_tracks(s, t)[0]->events;
    if (until) {
      for (const Event& inside : events.between(from, *until))
        if (inside.time > from && inside.time < *until) events.erase(inside.time, inside.time);
      Event end{*until, Moves(), {}, Twerper::unset, false, false};
      if (const Event* there = events.find(*until)) end = *there;
      if (ease_in != end.detail->ease_in) end.detail.edit().ease_in = ease_in;
      events.put(std::move(end));
    }
    Event begin = e;
    if (const Event* there = events.find(from); until && there && there->detail->ease_in != Time{})
      begin.detail.edit().ease_in = there->detail->ease_in;
    events.put(std::move(begin));
  }
  return true;
}

// Reports motions that an operation on times has lengthened, shortened or left without an end.
void say_lasting(const Command& k, const Scene& before, const Selected& on, std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  struct Row {
    Time from, length;
    std::string text;
  };
  const auto rows = [](const Scene& scene, const Target& t, bool& open) {
    std::vector<Row> all;
    const Slot* slot = scene.objects[t.object.index].find(t.function);
    if (!slot) return all;
    slot->track->events.each([&](const Event& e) {
      if (open) all.back().length = e.time - all.back().from;
      open = moves(e);
      if (open) all.push_back({e.time, {}, text_of(e.value)});
    });
    return all;
  };
  for (const Target& t : on.targets) {
    if (t.function != fn::motion) continue;
    bool was_open = false, open = false;
    const std::vector<Row> was = rows(before, t, was_open), is = rows(s, t, open);
    const auto known = [&](const Row& r) {
      return std::any_of(was.begin(), was.end(),
                         [&](const Row& o) { return o.length == r.length && o.text == r.text; });
    };
    if (open && !was_open)
      return script.note(Severity::notice,
                         fmt::format("'{}' has lost its end, so the motion from {} has no effect", target_name(s, t),
                                     format_time(is.back().from, s.rate)),
                         about, "clear its beginning, too, or add a row \"\" where it should end");
    std::string otherwise;
    for (std::size_t i = 0; i + (open ? 1 : 0) < is.size() && otherwise.size() < 200; ++i)
      if (!was.empty() && !known(is[i]))
        otherwise += fmt::format("{}{} lasts from {} to {}", otherwise.empty() ? "" : ", ", is[i].text.substr(0, 80),
                                 format_time(is[i].from, s.rate), format_time(is[i].from + is[i].length, s.rate));
    if (!otherwise.empty())
      return script.note(Severity::notice,
                         fmt::format("the motions of '{}' have changed: {}", target_name(s, t), otherwise), about);
  }
}

Track centred(Track track, const std::string& from, const std::string& to) {
  if (from == to) return track;
  track.events.edit_between({INT64_MIN}, {INT64_MAX}, [&](Event& e) {
    auto* m = std::get_if<Moves>(&e.value);
    if (!m) return;
    Motion own = **m;
    for (Factor& f : own.factors)
      if (f.about == from) f.about = to;
    *m = Moves(std::move(own));
  });
  return track;
}

void keep_centres(const Command& k, const std::vector<ObjectId>& leaving, const std::vector<std::uint32_t>& speaking,
                  std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  std::set<std::string_view> names;
  std::unordered_set<std::uint32_t> leaves;
  for (const ObjectId id : leaving) names.insert(s.objects[id.index].name), leaves.insert(id.index);
  const auto stays = [&](const Motion& m) {
    return std::none_of(m.factors.begin(), m.factors.end(), [&](const Factor& f) { return names.contains(f.about); });
  };
  std::optional<Program> program;
  for (const std::uint32_t i : speaking) {
    if (s.objects[i].removed || leaves.contains(i)) continue;
    const Slot* slot = s.objects[i].find(fn::motion);
    if (!slot) continue;
    bool all = true;
    slot->track->events.each([&](const Event& e) {
      const auto* m = std::get_if<Moves>(&e.value);
      all = all && (!m || !moves(e) || stays(**m));
    });
    if (all) continue;
    if (!program) program = Program::compile(Document(std::make_shared<const Scene>(s)));
    const std::vector<Motion> placed = program->motions(ObjectId{i});
    std::size_t k = 0;
    edit_track(s, Target{ObjectId{i}, fn::motion})->events.edit_between({INT64_MIN}, {INT64_MAX}, [&](Event& e) {
      if (!moves(e)) return;
      Motion own = *std::get<Moves>(e.value);
      for (std::size_t f = 0; f < own.factors.size(); ++f)
        if (names.contains(own.factors[f].about)) {
          own.factors[f].about.clear();
          if (k < placed.size()) own.factors[f].centre = placed[k].factors[f].centre;
        }
      ++k;
      e.value = Moves(std::move(own));
    });
    script.note(
        Severity::notice,
        fmt::format("'{}' now turns about the place of the removed object", target_name(s, {ObjectId{i}, fn::motion})),
        about);
  }
}

}  // namespace betwixt
