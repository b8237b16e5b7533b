// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// reach HAND to GOAL: joints bring a hand to a goal, for a while or for good.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "commands/command.h"
#include "scene/names.h"

namespace betwixt {
namespace {

constexpr long most_bones = 64;

struct Reaching {
  std::vector<ObjectId> hands;
  Value goal, pole = ObjectId{};
  std::optional<Time> from, until, blend_in, blend_out;
  long bones = 2;
  bool bones_said = false, pole_said = false;
};

// Returns the parent of an object at a time; empty if there is none.
ObjectId holder(const Scene& s, ObjectId id, Time t) {
  ObjectId held;
  for (const AttachmentSpan& a : attachments(s.objects[id.index]))
    if (a.from <= t) held = a.to.kind >= AttachmentKind::hang ? a.to.parent : ObjectId{};
  return held;
}

// Returns whether code computes the parent, which is then not known yet.
bool held_by_code(const Scene& s, ObjectId id, Time t) {
  bool computed = false;
  for (const AttachmentSpan& a : attachments(s.objects[id.index]))
    if (a.from <= t) computed = a.computed;
  return computed;
}

// Returns the joints with which the hand reaches at a time, the nearest first.
std::vector<ObjectId> joints(const Scene& s, ObjectId hand, Time t, long bones) {
  std::vector<ObjectId> out;
  for (ObjectId at = holder(s, hand, t); at && static_cast<long>(out.size()) < bones; at = holder(s, at, t))
    out.push_back(at);
  return out;
}

bool moves_with(const Scene& s, ObjectId what, const std::vector<ObjectId>& some, Time t) {
  for (std::size_t steps = 0; what && steps <= s.objects.size(); what = holder(s, what, t), ++steps)
    if (std::find(some.begin(), some.end(), what) != some.end()) return true;
  return false;
}

// An object that reaches, and its goals with the time at which each begins.
struct Reacher {
  ObjectId hand;
  std::map<std::uint32_t, Time> goals;
  long bones = 2;
};
std::vector<Reacher> reachers(const Scene& s) {
  std::vector<Reacher> all;
  for (std::uint32_t i = 0; i < s.objects.size(); ++i) {
    const Slot* slot = s.objects[i].removed ? nullptr : s.objects[i].find(fn::reach);
    if (!slot) continue;
    Reacher r{{i}, {}, 2};
    const auto add = [&](const Value& v, Time t) {
      if (const auto* id = std::get_if<ObjectId>(&v); id && find_object(s, *id)) r.goals.emplace(id->index, t);
    };
    if (slot->set) add(*slot->set, {});
    slot->track->events.each([&](const Event& e) { add(e.value, e.time); });
    const Slot* chain = s.objects[i].find(fn::reach_chain);
    if (chain && chain->set)
      if (const auto* n = std::get_if<double>(&*chain->set)) r.bones = static_cast<long>(*n);
    all.push_back(std::move(r));
  }
  return all;
}

// Returns whether the mover of the goal itself reaches, directly or through others, for something that the hand's own
// joints move.
bool in_a_circle(const Scene& s, const std::vector<Reacher>& all, const std::vector<ObjectId>& chain, ObjectId goal,
                 Time t) {
  std::set<std::uint32_t> seen;
  std::vector<ObjectId> todo{goal};
  while (!todo.empty()) {
    const ObjectId at = todo.back();
    todo.pop_back();
    for (const Reacher& r : all) {
      if (seen.contains(r.hand.index) || !moves_with(s, at, joints(s, r.hand, t, r.bones), t)) continue;
      seen.insert(r.hand.index);
      for (const auto& [next, since] : r.goals) {
        if (moves_with(s, {next}, chain, t)) return true;
        todo.push_back({next});
      }
    }
  }
  return false;
}

// Returns why the hand cannot reach for the goal, or "" if it can.
std::string hindrance(const Scene& s, const std::vector<Reacher>& all, ObjectId hand, std::vector<ObjectId> chain,
                      ObjectId goal, Time t) {
  const std::string &name = s.objects[hand.index].name, &there = s.objects[goal.index].name;
  if (goal == hand) return fmt::format("'{}' cannot reach itself", name);
  chain.push_back(hand);
  if (moves_with(s, goal, chain, t))
    return fmt::format("'{}' cannot reach '{}', because they move together", name, there);
  if (in_a_circle(s, all, chain, goal, t))
    return fmt::format("'{0}' cannot reach '{1}', because '{1}' reaches an object that moves with '{0}'", name, there);
  return {};
}

bool can_reach(Command& k, const Reaching& r, ObjectId hand, std::string_view about) {
  Scene& s = k.scene;
  Cursor& c = k.cursor;
  const std::string& name = s.objects[hand.index].name;
  if (!placed(s.objects[hand.index].kind))
    return c.fail(ErrorCode::type, fmt::format("'{}' has no position, so it cannot reach anything", name), about);
  const Time t = r.from.value_or(Time{});
  std::vector<ObjectId> chain = joints(s, hand, t, r.bones);
  if (static_cast<long>(chain.size()) < std::max(2L, r.bones) &&
      !held_by_code(s, chain.empty() ? hand : chain.back(), t))
    return c.fail(ErrorCode::type,
                  chain.empty() ? fmt::format("'{}' has no parents that could bend", name)
                                : fmt::format("'{}' has only {} joint{} above it, but {} must bend", name, chain.size(),
                                              chain.size() == 1 ? "" : "s", std::max(2L, r.bones)),
                  about, fmt::format("as in couple {} to forearm, couple forearm to arm", name));
  const auto* goal = std::get_if<ObjectId>(&r.goal);
  if (!goal || !*goal) return true;
  const std::string why = hindrance(s, reachers(s), hand, std::move(chain), *goal, t);
  return why.empty() || c.fail(ErrorCode::name, why, about);
}

bool aimed(Command& k, FunctionId f, Value& out) { return values(k).value(built_in_functions()[f], -1, out, f); }

bool key_is_next(Cursor& c, std::string_view key) {
  return c.accept('=') || c.fail_here(ErrorCode::syntax, fmt::format("'=' is missing after {}", key));
}

bool blend(Cursor& c, std::optional<Time>& out) {
  const char* const start = c.at;
  Time length;
  if (!c.length(length)) return false;
  if (length < Time{}) return c.fail(ErrorCode::range, "a blend must not be negative", c.since(start));
  out = length;
  return true;
}

bool option(Command& k, Reaching& r) {
  Cursor& c = k.cursor;
  const char* const start = c.at;
  const std::string_view key = c.word();
  if (key == "from" || key == "until") {
    Time t;
    if (!c.time(t)) return false;
    if (key == "from" && k.time)
      return c.fail(ErrorCode::syntax, "'from' is not needed here: the reach begins at the time of the command",
                    c.since(start));
    (key == "from" ? r.from : r.until) = t;
    return true;
  }
  if (key == "blend" || key == "blend-in" || key == "blend-out") {
    std::optional<Time> length;
    if (!key_is_next(c, key) || !blend(c, length)) return false;
    if (key != "blend-out") r.blend_in = length;
    if (key != "blend-in") r.blend_out = length;
    return true;
  }
  if (key == "pole") return key_is_next(c, key) && (r.pole_said = aimed(k, fn::reach_pole, r.pole));
  if (key == "chain")
    return key_is_next(c, key) && (r.bones_said = c.whole_number(2, most_bones, "a chain's number of joints", r.bones));
  return c.fail(ErrorCode::syntax, fmt::format("'{}' is not expected here", key.substr(0, 40)), key,
                "write from TIME, until TIME, pole=POINT, chain=N or blend=LENGTH");
}

bool arguments_of_reach(Command& k, Reaching& r, std::string_view& about) {
  Cursor& c = k.cursor;
  if (!objects(k, about, r.hands)) return false;
  if (!c.accept_word("to")) return c.fail_here(ErrorCode::syntax, "'to' is missing here", "as in reach hand to ball");
  if (!aimed(k, fn::reach, r.goal)) return false;
  r.from = k.time;
  for (c.space(); !c.at_line_end(); c.space())
    if (!option(k, r)) return false;
  if (r.until && !r.from) r.from = Time{};
  if (r.until && !(*r.from < *r.until))
    return c.fail(ErrorCode::range, "a reach must end after it begins", about, "as in from 12f until 36f");
  if ((r.blend_in || r.blend_out) && !r.from)
    return c.fail(ErrorCode::syntax, "a reach without times cannot be blended", about,
                  "as in from 12f until 36f blend=6f");
  return true;
}

// Returns a quarter of a second, but at most a third of the reach's duration.
Time usual_blend(const Reaching& r) {
  const Time quarter{flicks_per_second / 4};
  return r.until ? std::min(quarter, Time{(*r.until - *r.from).flicks / 3}) : quarter;
}

void put_for_a_while(Scene& s, ObjectId hand, const Reaching& r) {
  const Target goal{hand, fn::reach}, share{hand, fn::reach_share}, pole{hand, fn::reach_pole};
  const Time from = *r.from, last = r.until.value_or(Time{INT64_MAX});
  const auto put = [&](const Target& on, Time t, Value v, Twerper twerper) {
    Event e;
    e.time = t, e.value = std::move(v), e.twerper = twerper;
    put_event(s, on, std::move(e));
  };
  for (const Target& t : {goal, share})
    for (Track* track : edit_tracks(s, t)) track->events.erase(from, last);
  const Time in = r.blend_in.value_or(usual_blend(r)), out = r.blend_out.value_or(usual_blend(r));
  const Twerper gently = *find_twerper("sine-in-out");
  put(goal, from, r.goal, Twerper::hold);
  if (r.pole_said) put(pole, from, r.pole, Twerper::hold);
  if (in > Time{}) put(share, from, 0.0, gently);
  const Time full = r.until ? std::min(from + in, *r.until) : from + in;
  put(share, full, 1.0, Twerper::hold);
  if (!r.until) return;
  put(goal, *r.until, ObjectId{}, Twerper::hold);
  if (out > Time{} && full < *r.until) {
    put(share, std::max(full, *r.until - out), 1.0, gently);
    put(share, *r.until, 0.0, Twerper::hold);
  }
}

bool reach(Command& k) {
  Reaching r;
  std::string_view about;
  if (!arguments_of_reach(k, r, about)) return false;
  for (const ObjectId hand : r.hands)
    if (!own(k, hand, about) || !can_reach(k, r, hand, about)) return false;
  for (const ObjectId hand : r.hands) {
    if (r.bones_said) set_value(k.scene, Target{hand, fn::reach_chain}, static_cast<double>(r.bones));
    if (r.from) {
      put_for_a_while(k.scene, hand, r);
      continue;
    }
    set_value(k.scene, Target{hand, fn::reach}, r.goal);
    if (r.pole_said) set_value(k.scene, Target{hand, fn::reach_pole}, r.pole);
  }
  return true;
}

constexpr Verb reaching_rows[] = {
    {"reach",
     "reach A to B [from TIME until TIME] [pole=POINT|NAME] [chain=N] [blend=LENGTH] [blend-in=LENGTH] "
     "[blend-out=LENGTH] "
     "or at TIME reach …",
     "Brings an object to a place by turning the joints above it (inverse kinematics): two, as in an arm or a leg, or "
     "N.",
     "create arm box\ncreate forearm box position=(1 0 0)\ncreate palm sphere position=(1 0 0)\n"
     "couple forearm to arm\ncouple palm to forearm\nreach palm to (1 1 0) from 12f until 36f",
     Verb::timed, reach},
};

}  // namespace

std::vector<Error> hindered_reaches(const Scene& s) {
  const std::vector<Reacher> all = reachers(s);
  std::vector<Error> out;
  std::size_t looks = 1000;
  for (const Reacher& r : all)
    for (const auto& [goal, since] : r.goals) {
      if (looks-- == 0) return out;
      std::string why = hindrance(s, all, r.hand, joints(s, r.hand, since, r.bones), {goal}, since);
      if (why.empty()) continue;
      out.push_back(fail(ErrorCode::name, std::move(why)));
      out.back().subject = s.objects[r.hand.index].name;
    }
  return out;
}

std::span<const Verb> reaching_verbs() { return reaching_rows; }

}  // namespace betwixt
