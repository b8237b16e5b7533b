// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Converts values made by code, filters, velocities and environments to plain events.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "commands/segments.h"
#include "program/evaluator.h"
#include "scene/names.h"

namespace betwixt {
namespace {

constexpr std::size_t most_baked = 1'000'000;  // events

// Returns the distance of a value from the linear interpolation between two others.
double off_the_way(const Value& from, const Value& to, double s, const Value& is) {
  double a[4], b[4], v[4];
  const int n = to_numbers(from, a);
  if (n == 0 || to_numbers(to, b) != n || to_numbers(is, v) != n) return is == from ? 0 : HUGE_VAL;
  if (std::holds_alternative<Quat>(from) && std::holds_alternative<Quat>(to) && std::holds_alternative<Quat>(is)) {
    const Quat p = std::get<Quat>(from), q = std::get<Quat>(to);
    const Quat way = slerp(p, dot(p, q) < 0 ? -q : q, s);
    return 2 * std::acos(std::min(1.0, std::abs(dot(way, std::get<Quat>(is)))));
  }
  double off = 0;
  for (int i = 0; i < n; ++i) off = std::max(off, std::abs(v[i] - (a[i] + s * (b[i] - a[i]))));
  return off;
}

// Returns which samples must stay so that linear interpolation is off by at most `within`. Splits at the farthest
// sample, recursively (Ramer 1972, Douglas and Peucker 1973).
std::vector<bool> needed(const std::vector<Value>& samples, double within) {
  std::vector<bool> stays(samples.size());
  std::vector<std::pair<std::size_t, std::size_t>> todo{{0, samples.size() - 1}};
  stays.front() = stays.back() = true;
  while (!todo.empty()) {
    const auto [a, b] = todo.back();
    todo.pop_back();
    double farthest = within;
    std::size_t at = 0;
    for (std::size_t i = a + 1; i < b; ++i) {
      const double off =
          off_the_way(samples[a], samples[b], static_cast<double>(i - a) / static_cast<double>(b - a), samples[i]);
      if (off > farthest) farthest = off, at = i;
    }
    if (at == 0) continue;
    stays[at] = true;
    todo.push_back({a, at}), todo.push_back({at, b});
  }
  return stays;
}

struct Baking {
  Segment segment;
  Time every;
  double within = 0;
  std::vector<Time> times() const {
    std::vector<Time> out;
    for (Time t = segment.from; t < segment.to; t = t + every) out.push_back(t);
    out.push_back(segment.to);
    return out;
  }
};

// Replaces everything that made the value of a target by a plain track.
void put_baked(Scene& s, const Target& t, const std::vector<Time>& times, const std::vector<Value>& samples,
               double within) {
  const std::vector<bool> stays = needed(samples, within);
  if (t.function == fn::position)  // the path among them is plain now
    std::erase_if(s.objects.edit(t.object.index).slots,
                  [](const Slot& slot) { return slot.function == fn::obstacles; });
  Slot& slot = s.objects.edit(t.object.index).slot(t.function);
  slot.filters.clear();
  slot.velocity = {};
  if (slot.set && std::holds_alternative<Procedure>(*slot.set)) slot.set.reset();
  static_cast<Strand&>(slot) = {};
  Track* track = edit_track(s, t);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!stays[i]) continue;
    Event e;
    e.time = times[i];
    e.value = samples[i];
    const Changes changes = row_of(spec_of(s, t.function).type).changes;
    e.twerper =
        changes != Changes::in_steps && !std::holds_alternative<bool>(e.value) ? Twerper::linear : Twerper::hold;
    track->events.put(std::move(e));
  }
}

// Returns whether baking can replace the object's attachments: code computes some of them, and none keeps or releases a
// place in the world, which depends on the time of its event.
bool bakes(const Scene& s, ObjectId id) {
  const auto all = attachments(s.objects[id.index]);
  const auto plain = [](const AttachmentSpan& a) { return !a.to.keep_world && a.to.kind != AttachmentKind::letgo; };
  return std::any_of(all.begin(), all.end(), [](const AttachmentSpan& a) { return a.computed; }) &&
         std::all_of(all.begin(), all.end(), plain);
}

// Replaces a reach by events of rotation on the joints that bear the object.
bool bake_reach(Command& k, const Selected& on, const Baking& how, std::string_view about) {
  Scene& s = k.scene;
  Rollback rollback(s);
  const std::vector<Time> times = how.times();
  for (const Target& hand : on.targets) {
    if (hand.function != fn::reach)
      return k.cursor.fail(ErrorCode::type, "a reach must be baked on its own", about,
                           fmt::format("bake {}", target_name(s, Target{hand.object, fn::reach})));
    const Program program = Program::compile(Document(std::make_shared<const Scene>(s)));
    std::map<std::uint32_t, std::vector<Value>> turns;
    for (std::size_t i = 0; i < times.size(); ++i) {
      Asking asking;
      for (const auto& [joint, turn] : reached_turns(program.compiled(), hand.object, times[i], asking)) {
        auto& all = turns[joint.index];
        all.resize(i, turn);  // no joint bore it before
        all.push_back(turn);
      }
    }
    for (auto& [joint, all] : turns) {
      all.resize(times.size(), all.back());
      put_baked(s, Target{ObjectId{joint}, fn::rotation}, times, all, how.within);
    }
    std::erase_if(s.objects.edit(hand.object.index).slots,
                  [](const Slot& slot) { return slot.function >= fn::reach && slot.function <= fn::reach_chain; });
  }
  rollback.keep();
  return true;
}

bool bake(Command& k) {
  auto& [s, c, time, layer, script] = k;
  Selected on;
  Baking how;
  const std::string_view word = c.next_word();
  if (!targets(k, word, on, Meant::any) || !c.segment(how.segment.from, how.segment.to)) return false;
  how.every = c.rate.span(1);
  while (!c.at_line_end()) {
    const char* const start = c.at;
    const std::string_view key = c.word();
    if (key == "every") {
      if (!c.length(how.every)) return false;
      if (!(how.every > Time{})) return c.fail(ErrorCode::range, "an interval must be longer than 0", c.since(start));
    } else if (key == "within") {
      if (!c.number(how.within)) return false;
      if (how.within < 0) return c.fail(ErrorCode::range, "a tolerance must be at least 0", c.since(start));
    } else {
      return c.fail(ErrorCode::syntax, fmt::format("'{}' is not expected here", key.substr(0, 40)), key,
                    "write every LENGTH or within TOLERANCE");
    }
  }
  const double samples = (how.segment.to - how.segment.from).seconds() / how.every.seconds() + 1;
  if (!(samples * static_cast<double>(std::max<std::size_t>(on.targets.size(), 1)) <= static_cast<double>(most_baked)))
    return c.fail(ErrorCode::range, fmt::format("this would read more than {} values", most_baked), word,
                  "every LENGTH sets a longer step");
  for (const Target& t : on.targets) {
    if (t.component >= 0 || t.velocity)
      return c.fail(ErrorCode::type, "components and velocities cannot be baked; whole values can", word,
                    fmt::format("bake {}", target_name(s, Target{t.object, t.function})));
    for (const Slot& slot : s.objects[t.object.index].slots)
      if (slot.function == t.function && slot.layer)
        return c.fail(ErrorCode::type,
                      fmt::format("the layer {} is on top of {} and would count twice",
                                  s.objects[slot.layer.index].name, target_name(s, t)),
                      word);
    if (t.function != fn::reach && (t.function == fn::motion || !row_of(spec_of(s, t.function).type).computed ||
                                    (t.function == fn::attachment && !bakes(s, t.object))))
      return c.fail(ErrorCode::type, fmt::format("{} cannot be baked", to_string(spec_of(s, t.function).type)), word);
  }
  if (std::any_of(on.targets.begin(), on.targets.end(), [](const Target& t) { return t.function == fn::reach; }))
    return bake_reach(k, on, how, word);
  const Program program = Program::compile(Document(std::make_shared<const Scene>(s)));
  const std::vector<Time> times = how.times();
  std::vector<std::vector<Value>> values(on.targets.size());
  for (const Time t : times) {
    const std::vector<Value> all = program.read(on.targets, t);
    for (std::size_t i = 0; i < all.size(); ++i) values[i].push_back(all[i]);
  }
  for (std::size_t i = 0; i < on.targets.size(); ++i) put_baked(s, on.targets[i], times, values[i], how.within);
  return true;
}

constexpr Verb baking_rows[] = {
    {"bake", "bake TARGETS A..B [every LENGTH] [within TOLERANCE]",
     "Writes the values of code, filters, velocities and `reach` as plain events, one a frame or every LENGTH. They "
     "replace all events of the track, also those outside A..B. With TOLERANCE, writes as few events as possible, and "
     "no value is off by more than TOLERANCE. Its unit is that of the value; for rotations, radians.",
     "bake ball.position 1f..24f within 0.01", 0, bake, "TARGET; NUMBER; every within; NUMBER; within"},
};

}  // namespace

std::span<const Verb> baking_verbs() { return baking_rows; }

}  // namespace betwixt
