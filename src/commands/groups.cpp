// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands that work on many objects at once.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/names.h"
#include "commands/command.h"
#include "program/compiled.h"
#include "track/curve.h"
#include "track/operations.h"

namespace betwixt {
namespace {

// The order in which objects follow each other; each delay is a multiple of one length.
struct Turns {
  std::string_view from = "first";
  std::int64_t seed = -1;
  double metres = 0;  // the distance that corresponds to one length, for order by place
  Vec3 point;
};

bool turns_from(Command& k, Turns& out) {
  Cursor& c = k.cursor;
  c.space();
  static constexpr std::string_view orders[] = {"first", "last", "centre", "edges", "random"};
  if (out.metres == 0) {
    const std::string_view w = c.next_word();
    const auto known = std::find(std::begin(orders), std::end(orders), w);
    if (known == std::end(orders)) {
      const Hint near = did_you_mean(w, {std::begin(orders), std::end(orders)});
      return no_choice(c, w, "the order must be first, last, centre, edges or random N",
                       near.empty() ? "to start from a point: by 2f per 1m from (0 0 0)" : near);
    }
    out.from = *known;
    long seed = -1;
    if (out.from == "random" && !c.whole_number(0, 1'000'000'000, "the seed of random", seed)) return false;
    out.seed = seed;
    return true;
  }
  if (c.peek() == '(') return values(k).vector(3, out.point, Unit::metres);
  ObjectId id;
  if (!values(k).object(id)) return false;
  const Program program = Program::compile(Document(std::make_shared<const Scene>(k.scene)));
  out.point = program.kinematics(id, Time{}).position;
  return true;
}

std::vector<double> turns_of(const Command& k, const std::vector<ObjectId>& objects, const Turns& how) {
  std::vector<double> turn(objects.size());
  const double last = static_cast<double>(objects.size()) - 1;
  if (how.metres > 0) {
    const Program program = Program::compile(Document(std::make_shared<const Scene>(k.scene)));
    for (std::size_t i = 0; i < turn.size(); ++i)
      turn[i] = length(program.kinematics(objects[i], Time{}).position - how.point) / how.metres;
    return turn;
  }
  for (std::size_t i = 0; i < turn.size(); ++i) {
    const double n = static_cast<double>(i), off = std::abs(n - last / 2);
    turn[i] = how.from == "last" ? last - n : how.from == "centre" ? off : how.from == "edges" ? last / 2 - off : n;
  }
  if (how.seed >= 0) {  // Fisher and Yates, with a generator that is the same on every machine
    std::mt19937_64 random(static_cast<std::uint64_t>(how.seed));
    for (std::size_t i = turn.size(); i > 1; --i) std::swap(turn[i - 1], turn[random() % i]);
  }
  return turn;
}

bool stagger(Command& k) {
  auto& [s, c, time, layer, script] = k;
  Selected on;
  Time by;
  Turns how;
  const std::string_view word = c.next_word();
  if (!targets(k, word, on, Meant::any)) return false;
  if (!c.accept_word("by")) return c.fail_here(ErrorCode::syntax, "'by' and a length of time are missing here");
  if (!c.length(by)) return false;
  if (c.accept_word("per")) {
    c.space();
    const char* const start = c.at;
    if (!values(k).scalar(how.metres, Unit::metres)) return false;
    if (!(how.metres > 0)) return c.fail(ErrorCode::range, "the distance must be greater than 0", c.since(start));
    if (!c.accept_word("from"))
      return c.fail_here(ErrorCode::syntax, "'from' and a point or an object are missing here",
                         "as in by 2f per 1m from (0 0 0)");
    if (!turns_from(k, how)) return false;
  } else if (c.accept_word("from")) {
    if (!turns_from(k, how)) return false;
  } else if (c.peek_word() == "random" && !turns_from(k, how)) {
    return false;
  }
  if (!finish(c)) return false;
  std::vector<ObjectId> objects;  // all targets of one object have the same turn
  for (const Target& t : on.targets)
    if (objects.empty() || objects.back() != t.object) objects.push_back(t.object);
  const std::vector<double> turn = turns_of(k, objects, how);
  for (const double t : turn)
    if (!(std::abs(by.seconds()) * t <= longest_seconds))
      return c.fail(ErrorCode::range, "the events would be more than 146 years away", word);
  const Segment all{{INT64_MIN}, {INT64_MAX}};
  const Scene before = s;
  std::size_t whose = 0;
  for (std::size_t i = 0; i < on.targets.size(); ++i) {
    if (on.targets[i].object != objects[whose]) ++whose;
    if (!before.objects[on.targets[i].object.index].find(on.targets[i].function, on.targets[i].layer)) continue;
    for (Track* t : edit_tracks(s, on.targets[i])) {
      const auto done = move_segment(*t, all, {std::llround(static_cast<double>(by.flicks) * turn[whose])});
      if (done) continue;
      s = before;
      return c.fail(done.error().code, done.error().message, word);
    }
  }
  return true;
}

bool spread(Command& k) {
  auto& [s, c, time, layer, script] = k;
  Selected on;
  Value from, to;
  const std::string_view word = c.next_word();
  if (!targets(k, word, on)) return false;
  if (!on.spec) on.spec = &built_in_functions()[fn::position];
  if (!c.accept_word("from")) return c.fail_here(ErrorCode::syntax, "'from' and a value are missing here");
  if (!values(k).value(*on.spec, on.component, from)) return false;
  if (!c.accept_word("to")) return c.fail_here(ErrorCode::syntax, "'to' and a value are missing here");
  if (!values(k).value(*on.spec, on.component, to) || !finish(c)) return false;
  // Colours are spread in linear light, as they blend in time.
  const auto *dark = std::get_if<Color>(&from), *bright = std::get_if<Color>(&to);
  const auto way = add_scaled(to, from, -1);
  const bool turn = std::holds_alternative<Quat>(from) && std::holds_alternative<Quat>(to);
  if (!way && !turn) return c.fail(ErrorCode::type, fmt::format("{} cannot be spread", to_string(on.type())), word);
  const auto has_events = [&](const Target& t) {
    const auto tracks = tracks_of(k.scene, t);
    return std::any_of(tracks.begin(), tracks.end(), [](const Track* track) { return !track->events.empty(); });
  };
  if (std::any_of(on.targets.begin(), on.targets.end(), has_events))
    script.note(Severity::warning, "a track with events ignores its spread value", word,
                "spread sets the value of tracks without events");
  const double last = static_cast<double>(std::max<std::size_t>(on.targets.size(), 2) - 1);
  for (std::size_t i = 0; i < on.targets.size(); ++i) {
    const double k = static_cast<double>(i) / last;
    if (turn) {
      const Quat a = std::get<Quat>(from), b = std::get<Quat>(to);
      set_value(s, on.targets[i], slerp(a, dot(a, b) < 0 ? -b : b, k));
    } else if (dark && bright && k > 0 && k < 1) {
      set_value(s, on.targets[i], to_srgb((1 - k) * to_linear(*dark) + k * to_linear(*bright)));
    } else {
      set_value(s, on.targets[i], i + 1 == on.targets.size() && i > 0 ? to : *add_scaled(from, *way, k));
    }
  }
  return true;
}

constexpr Verb groups_rows[] = {
    {"stagger",
     "stagger TARGETS by LENGTH [from first|last|centre|edges|random N], or by LENGTH per METRES from POINT|NAME",
     "Makes many objects do the same, one after another.",
     "stagger wheel*.position by 6f\nstagger wheel*.rotation by 2f from centre\nstagger wheel*.color by 1f per 1m from "
     "(0 0 0)",
     Verb::layered, stagger, "TARGET; by; NUMBER; from per random; first last centre edges random"},
    {"spread", "spread TARGETS from VALUE to VALUE", "Spreads values evenly from the first object to the last.",
     "spread wheel*.position from (0 0 0) to (9 0 0)", Verb::layered, spread, "TARGET; from; NUMBER; to"},
};

}  // namespace

std::span<const Verb> groups_verbs() { return groups_rows; }

}  // namespace betwixt
