// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands about environments: animate, halt, kill, cancel. (Animation Imaging Model, 2.2.7, 3.3.4, 5.1, 5.2)
#include <fmt/format.h>

#include <algorithm>

#include "base/cancellation.h"
#include "base/names.h"
#include "commands/command.h"

namespace betwixt {
namespace {

// Reads a length of time that is a whole number of ticks.
bool whole_ticks(Command& k, std::int64_t& out) {
  auto& [s, c, time, layer, script] = k;
  c.space();
  const char* start = c.at;
  Time l;
  if (!c.length(l)) return false;
  c.ticks_read = true;
  out = s.ticks.whole(l);
  if (s.ticks.span(static_cast<double>(out)) == l) return true;
  return c.fail(ErrorCode::range, "expected a whole number of ticks here", c.since(start),
                fmt::format("the nearest are {}t and {}t", out, out + 1));
}

// Returns the track of an environment without events, which all new ones share.
const std::shared_ptr<const Environment>& none() {
  static const auto track = std::make_shared<const Environment>();
  return track;
}

// Adds an event to the tracks of environments, creating those that do not exist. On failure changes none.
bool add_to(Command& k, const std::vector<std::string>& names, const decltype(EnvironmentEvent::what)& what,
            std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  c.ticks_read = true;
  std::optional<Scene> before;  // one name changes nothing until its event fits
  if (names.size() > 1) before = s;
  // Environments with the same history share one track.
  std::shared_ptr<const Environment> like, like_before;
  const std::uint64_t number = s.environment_events++;
  for (const std::string& name : names) {
    Cancellation::check();
    ObjectId id = s.names.find(name);
    const auto old = id ? s.objects[id.index].environment : none();
    if (!like || old != like_before) {
      Environment track = *old;
      const std::size_t known = track.problems().size();
      const Status done = track.add({tick(k), number, what}, like.get());
      if (!done) {
        if (before) s = *std::move(before);
        return c.fail(done.error().code, fmt::format("'{}': {}", name, done.error().message), about, done.error().hint);
      }
      const auto problems = track.problems();
      for (std::size_t i = known; i < problems.size(); ++i)
        script.note(problems[i].severity, fmt::format("'{}': {}", name, problems[i].what.message), about,
                    problems[i].what.hint);
      like_before = old, like = std::make_shared<const Environment>(std::move(track));
    }
    if (id) {
      s.objects.edit(id.index).environment = like;
      continue;
    }
    Object object;
    object.name = name, object.kind = Kind::environment, object.environment = like;
    add_object(s, std::move(object));
  }
  return true;
}

bool animate(Command& k) {
  auto& [s, c, time, layer, script] = k;
  const std::string_view word = c.next_word();
  if (word.empty()) return c.fail_here(ErrorCode::syntax, "the name of an environment is missing here");
  const auto names = expand_braces(with_keys(*s.tables, word));
  if (!names) return c.fail(names.error().code, names.error().message, word);
  if (!c.accept_word("every")) return c.fail_here(ErrorCode::syntax, "'every' and a length of time are missing here");
  EnvironmentEvent::Animate a;
  c.space();
  const char* start = c.at;
  if (!whole_ticks(k, a.timing.interval)) return false;
  if (a.timing.interval < 1)
    return c.fail(ErrorCode::range, "an interval must be at least one tick", c.since(start),
                  "for a faster motion, take larger steps");
  if (!c.accept_word("by"))
    return c.fail_here(ErrorCode::syntax, "'by' and a transform are missing here", "as in by rotate(10deg, z)");
  std::string_view unrounded;
  if (!values(k).transform(a.motion, &unrounded)) return false;
  if (!unrounded.empty())
    script.note(Severity::notice,
                "this matrix differs from a rotation and a translation by less than 1e-7, so it is rounded to them",
                unrounded, "translate(…) rotate(…) are exact");
  while (!c.at_line_end()) {
    start = c.at;
    const std::string_view key = c.word();
    if (key == "slower" || key == "faster") {
      std::int64_t by = 0;
      if (!whole_ticks(k, by)) return false;
      if (!c.accept_word("per"))
        return c.fail_here(ErrorCode::syntax, "'per' and a length of time are missing here",
                           fmt::format("as in {} 1t per 1s", key));
      if (!whole_ticks(k, a.timing.period)) return false;
      if (by < 1 || a.timing.period < 1)
        return c.fail(ErrorCode::range, "an interval must change by at least one tick", c.since(start));
      if (a.timing.change != 0)
        return c.fail(ErrorCode::syntax, "an interval cannot become both slower and faster", c.since(start));
      a.timing.change = key == "slower" ? by : -by;
    } else if (key == "limit") {
      if (!whole_ticks(k, a.timing.ceiling)) return false;
      if (a.timing.ceiling < 1) return c.fail(ErrorCode::range, "a limit must be at least one tick", c.since(start));
    } else if (key == "from" || key == "until") {
      std::int64_t after = 0;
      if (!whole_ticks(k, after)) return false;
      (key == "from" ? a.from : a.until) = after;
    } else if (key == "keep-phase") {
      a.keep_phase = true;
    } else {
      const Hint near = did_you_mean(key, {"slower", "faster", "limit", "from", "until", "keep-phase"});
      return c.fail(ErrorCode::syntax,
                    fmt::format("'{}' is not expected here", key.empty() ? std::string_view(start, 1) : key),
                    key.empty() ? std::string_view(start, 1) : key,
                    near.empty() ? "write slower LENGTH per LENGTH, faster LENGTH per LENGTH, limit LENGTH, from "
                                   "LENGTH, until LENGTH or keep-phase"
                                 : near);
    }
  }
  for (const std::string& name : *names) {
    const ObjectId id = s.names.find(name);
    if (id && s.objects[id.index].kind == Kind::environment) continue;
    if (id)
      return c.fail(ErrorCode::name,
                    fmt::format("'{}' is {}, not an environment", name, a_kind(s.objects[id.index].kind)), word,
                    "to put an object into an environment: set OBJECT.environments (NAME)");
    if (!free_name(k, name, word)) return false;
  }
  return add_to(k, *names, a, word);
}

template <class What>
bool to_environments(Command& k) {
  auto& [s, c, time, layer, script] = k;
  const std::string_view word = c.next_word();
  if (word.empty()) return c.fail_here(ErrorCode::syntax, "the name of an environment is missing here");
  std::vector<std::string> names;
  for (const ObjectId id : select(s, word))
    if (s.objects[id.index].kind == Kind::environment) names.push_back(s.objects[id.index].name);
  if (names.empty()) {
    if (is_pattern(word)) {
      script.names_nothing(word);
      return finish(c);
    }
    std::vector<std::string_view> known;
    for (std::size_t i = 0; i < s.objects.size(); ++i)
      if (!s.objects[i].removed && s.objects[i].kind == Kind::environment) known.push_back(s.objects[i].name);
    return c.fail(ErrorCode::name,
                  s.names.find(word) ? fmt::format("'{}' is not an environment", word)
                                     : fmt::format("there is no environment '{}'", word.substr(0, 60)),
                  word, did_you_mean(word, known));
  }
  return finish(c) && add_to(k, names, What{}, word);
}

constexpr Verb environments_rows[] = {
    {"animate",
     "animate ENV every LENGTH by TRANSFORM [slower|faster LENGTH per LENGTH] [limit LENGTH] [from LENGTH] [until "
     "LENGTH] [keep-phase]",
     "An environment: applies a transform again at every step to all objects in it. `from` and `until` count from the "
     "time of the command. `slower 1t per 30t` makes the interval 1t longer every 30t, up to `limit` (30t unless set); "
     "`faster` makes it shorter, down to 1t. If you animate an environment anew, `keep-phase` makes the first new step "
     "when the next old one would have come.",
     "animate spin every 1t by rotate(6deg, z)\nset ball.environments (spin)",
     Verb::timed | Verb::stamped | Verb::makes_thing | Verb::quick, animate, "NEW"},
    {"halt", "at TIME halt ENV", "Stops an environment where it is; `animate` continues from there.",
     "animate spin every 1t by rotate(6deg, z)\nat 60t halt spin", Verb::timed | Verb::stamped | Verb::quick,
     to_environments<EnvironmentEvent::Halt>},
    {"kill", "at TIME kill ENV",
     "Ends an environment: the objects in it stay where they are, and its name can be used again.",
     "animate spin every 1t by rotate(6deg, z)\nat 60t kill spin", Verb::timed | Verb::stamped | Verb::quick,
     to_environments<EnvironmentEvent::Kill>},
    {"cancel", "at TIME cancel ENV", "Drops the future starts and stops of an environment.",
     "animate spin every 1t by rotate(6deg, z) until 90t\nat 60t cancel spin", Verb::timed | Verb::stamped,
     to_environments<EnvironmentEvent::Cancel>},
};

}  // namespace

// Returns the tick that the command belongs to; between two ticks, the earlier one. Without a time a live host's
// commands happen now, and an author's at the beginning.
std::int64_t tick(const Command& k) {
  const Time t = k.time ? *k.time : k.script.options.now.value_or(Time{});
  return k.scene.ticks.whole(t);
}

std::span<const Verb> environments_verbs() { return environments_rows; }

}  // namespace betwixt
