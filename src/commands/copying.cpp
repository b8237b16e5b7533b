// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// copy: repeats a segment of a track, elsewhere or several times.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/counted.h"
#include "commands/notes.h"
#include "commands/segments.h"
#include "track/curve.h"
#include "track/operations.h"

namespace betwixt {
namespace {

// The most events that a script may make by copying, because a few words could otherwise exhaust the memory.
constexpr std::size_t most_copied = 10'000'000;

struct Copying {
  Stretch from;
  Selected into;
  std::string_view onto;  // the word for it in the script
  Time start;
  std::map<Type, Value> shifts;  // by the type of the values to shift
  bool shifted = false;
  long times = 1;
  const Value* shift(Type of) const {
    const auto known = shifts.find(of);
    return known == shifts.end() ? nullptr : &known->second;
  }
  const Target& source(std::size_t i) const { return from.of.targets[from.of.targets.size() == 1 ? 0 : i]; }
};

Track component_of(const Track& track, int component) {
  Track out = track;
  out.events = {};
  track.events.each([&](Event e) {
    if (!e.keep && !e.release) e.value = component_of(e.value, component);
    if (e.detail && e.detail->before) e.detail.edit().before = component_of(*e.detail->before, component);
    out.events.put(std::move(e));
  });
  return out;
}

// Returns the number of events that copies would replace, not counting one of equal value that the first copy
// continues.
std::size_t giving_way(const Track& into, const Track& source, const Copying& how, const std::optional<Value>& by) {
  const Segment& s = how.from.segment;
  const double span = static_cast<double>((s.to - s.from).flicks) * static_cast<double>(how.times);
  const Time end{static_cast<std::int64_t>(std::min(9e18, static_cast<double>(how.start.flicks) + span))};
  const Event *standing = into.events.find(how.start), *first = source.events.find(s.from);
  const bool goes_on = standing && first &&
                       standing->value == (by ? add_scaled(first->value, *by, 1).value_or(first->value) : first->value);
  return into.events.count(how.start, end) - (goes_on ? 1 : 0);
}

// Copies one track, or the tracks of its components, as in `before`, onto another. Returns the numbers of new and of
// replaced events.
Result<Changed> copy_track(Scene& s, const Scene& before, const Target& from, const Target& to, const Copying& how,
                           const std::optional<Value>& by) {
  std::vector<Track> originals;
  for (const Track* t : tracks_of(before, from)) originals.push_back(*t);
  for (Track& t : originals)
    fill_in_kept(t, how.from.segment, spec_of(before, from.function).type, from.velocity,
                 from.component >= 0 || originals.size() > 1);
  Changed sum;
  for (std::size_t k = 0; k < originals.size(); ++k) {
    if (originals[k].events.count(how.from.segment.from, how.from.segment.to) == 0) continue;
    Target place = to;
    if (originals.size() > 1) place.component = static_cast<int>(k);
    const auto tracks = edit_tracks(s, place);
    for (std::size_t i = 0; i < tracks.size(); ++i) {
      // If a whole value goes onto tracks of components, each takes its own component.
      const bool apart = tracks.size() > 1;
      const int component = apart ? static_cast<int>(i) : originals.size() > 1 ? static_cast<int>(k) : -1;
      Track source = apart ? component_of(originals[k], component) : originals[k];
      if (to.function == fn::motion)
        source = centred(source, before.objects[from.object.index].name, s.objects[to.object.index].name);
      const auto shift = by ? std::optional<Value>(part_of(*by, component)) : std::nullopt;
      sum.replaced += giving_way(*tracks[i], source, how, shift);
      const auto done =
          copy_segment(source, how.from.segment, *tracks[i], how.start, shift, static_cast<int>(how.times));
      if (!done) return done.error();
      sum.events += done->events;
    }
  }
  return sum;
}

Type type_of(const Scene& s, const Target& t) {
  const Type whole = spec_of(s, t.function).type;
  return t.component < 0 ? whole : component_type(whole);
}

// Reads the shift for values of one type.
bool read_shift(Command& k, const Target& of, Value& out) {
  Cursor& c = k.cursor;
  const FunctionSpec free = difference_of(spec_of(k.scene, of.function));
  c.space();
  const char* at = c.at;
  if (!values(k).value(free, of.component, out)) return false;
  if (add_scaled(out, out, 1)) return true;
  return c.fail(ErrorCode::type, fmt::format("{} cannot be shifted", to_string(type_of(k.scene, of))), c.since(at));
}

// Reads the shift for each type that is copied, if it has a meaning for that type.
bool shift(Command& k, Copying& how) {
  Cursor& c = k.cursor;
  if (how.from.of.targets.empty()) {
    Value unused;
    const FunctionSpec free = difference_of(how.from.spec());
    return how.shifted = true, values(k).value(free, how.from.of.component, unused);
  }
  const char *const start = c.at, *behind = nullptr;
  const int depth = c.depth;
  std::optional<Error> why;
  std::string_view where;
  std::set<Type> tried;
  for (const Target& t : how.from.of.targets) {
    const Type type = type_of(k.scene, t);
    if (!tried.insert(type).second) continue;
    c.at = start, c.depth = depth;
    Value v;
    if (read_shift(k, t, v)) {
      behind = c.at;
      how.shifts.emplace(type, std::move(v));
      continue;
    }
    if (!why) why = c.error, where = c.where;
    c.error.reset(), c.where = {};
  }
  how.shifted = true;
  if (!behind) return c.error = std::move(why), c.where = where, false;
  return c.at = behind, c.depth = depth, true;
}

// Leaves out, and names, the targets that the shift does not fit.
void leave_out(Command& k, Copying& how) {
  if (!how.shifted || how.from.of.targets.size() < 2) return;
  Selected from = how.from.of, into = how.into;
  from.targets.clear(), into.targets.clear();
  std::vector<Target> left;
  for (std::size_t i = 0; i < how.into.targets.size(); ++i) {
    const Target source = how.source(i);
    if (!how.shift(type_of(k.scene, source)))
      left.push_back(source);
    else
      from.targets.push_back(source), into.targets.push_back(how.into.targets[i]);
  }
  if (left.empty()) return;
  say_left_out(k, left, how.from.word, "the shift has the wrong type");
  how.from.of = std::move(from), how.into = std::move(into);
}

// Reads TARGET A..B to TIME [on TARGET] [shift VALUE] [times N]
bool arguments(Command& k, Copying& how) {
  Cursor& c = k.cursor;
  if (!on_segment(k, how.from)) return false;
  if (!c.accept_word("to")) return c.fail_here(ErrorCode::syntax, "'to' and a time are missing here");
  if (!c.time(how.start)) return false;
  how.into = how.from.of, how.onto = how.from.word;
  while (!c.at_line_end()) {
    if (c.accept_word("on")) {
      how.onto = c.next_word();
      if (!targets(k, how.onto, how.into, Meant::any)) return false;
    } else if (c.accept_word("times")) {
      if (!c.whole_number(1, 1'000'000, "times", how.times)) return false;
    } else if (c.accept_word("shift")) {
      if (!shift(k, how)) return false;
    } else {
      return c.fail_here(ErrorCode::syntax, fmt::format("'{}' is not expected here", c.peek_word().substr(0, 40)),
                         "write on TARGET, shift VALUE or times N");
    }
  }
  return true;
}

bool fits(Command& k, const Copying& how) {
  const Selected &from = how.from.of, &into = how.into;
  const auto cannot = [&](const auto& one, const auto& other) {
    return k.cursor.fail(ErrorCode::type, fmt::format("{} cannot be copied onto {}", one, other), how.onto);
  };
  if (from.targets.size() != into.targets.size() && from.targets.size() != 1)
    return cannot(counted(from.targets.size(), "track"), counted(into.targets.size(), "track"));
  for (std::size_t i = 0; i < into.targets.size(); ++i) {
    const Type one = type_of(k.scene, how.source(i)), other = type_of(k.scene, into.targets[i]);
    if (one != other) return cannot(to_string(one), to_string(other));
  }
  return true;
}

// Reads A..B to T [times N]
bool copy_cues(Command& k, Cues cues, std::string_view word) {
  Cursor& c = k.cursor;
  Segment of;
  Time start;
  long times = 1;
  if (!c.segment(of.from, of.to)) return false;
  if (!c.accept_word("to")) return c.fail_here(ErrorCode::syntax, "'to' and a time are missing here");
  if (!c.time(start)) return false;
  if (c.accept_word("times") && !c.whole_number(1, 1'000'000, "times", times)) return false;
  return retime_cues(k, cues, word, of, [&](Time t, std::vector<Time>& to) {
    to.push_back(t);
    const double span = static_cast<double>((of.to - of.from).flicks);
    const double first = static_cast<double>(start.flicks) + static_cast<double>((t - of.from).flicks);
    for (long n = 0; n < times && in_reach(to.back()); ++n)
      to.push_back(time_of(first + static_cast<double>(n) * span));
  });
}

// Fails if the copies would exceed the limit of events.
bool affordable(Command& k, const Copying& how) {
  std::size_t wanted = k.script.copied;
  for (std::size_t i = 0; i < how.into.targets.size(); ++i)
    for (const Track* t : tracks_of(k.scene, how.source(i)))
      wanted += t->events.count(how.from.segment.from, how.from.segment.to) * static_cast<std::size_t>(how.times);
  if (wanted > most_copied)
    return k.cursor.fail(ErrorCode::range, fmt::format("the copies would have more than {} events", most_copied),
                         how.from.word);
  k.script.copied = wanted;
  return true;
}

bool copy(Command& k) {
  Copying how;
  std::string_view word;
  if (const std::optional<Cues> cues = accept_cues(k, word)) return copy_cues(k, *cues, word);
  if (!arguments(k, how)) return false;
  if (!how.from.of.spec || !how.into.spec) return true;
  if (!fits(k, how) || !finish(k.cursor)) return false;
  leave_out(k, how);
  if (!affordable(k, how)) return false;
  const auto shift_of = [&](const Target& t) {
    const Value* by = how.shift(type_of(k.scene, t));
    return by ? std::optional<Value>(*by) : std::nullopt;
  };
  for (std::size_t i = 0; how.shifted && i < how.into.targets.size(); ++i)
    if (const auto by = shift_of(how.source(i)); by && !reaches(k, how.from, how.source(i), *by, "shifted"))
      return false;
  Rollback all(k.scene);
  Changed sum;
  for (std::size_t i = 0; i < how.into.targets.size(); ++i) {
    Target source = how.source(i), to = how.into.targets[i];
    Result<Changed> done = copy_track(k.scene, all.before(), source, to, how, shift_of(source));
    if (done && !source.velocity && has_velocity(type_of(k.scene, source))) {  // the velocity beside it, unshifted
      sum.events += done->events, sum.replaced += done->replaced;
      source.velocity = to.velocity = true;
      done = copy_track(k.scene, all.before(), source, to, how, std::nullopt);
    }
    if (!done) return k.cursor.fail(done.error().code, done.error().message, how.from.word);
    sum.events += done->events, sum.replaced += done->replaced;
  }
  all.keep();
  if (sum.events == 0)
    k.script.note(Severity::notice, fmt::format("'{}' has no events in this segment", how.from.of.text), how.from.word);
  if (sum.replaced > 0)
    k.script.note(Severity::notice, fmt::format("{} replaced", counted(sum.replaced, "event")), how.from.word,
                  how.shifted ? "" : "a copy begins at the same value as the original; shift VALUE adds to it");
  say_lasting(k, all.before(), how.into, how.from.word);
  return true;
}

constexpr Verb copying_rows[] = {
    {"copy", "copy TARGET A..B to TIME [on TARGET] [shift VALUE] [times N]",
     "Copies a segment of a track, notes, steps or descriptions to another time, once or many times. `shift` adds "
     "VALUE to the first "
     "copy, twice VALUE to the second, and so on.",
     "copy ball.position 1f..24f to 24f shift (8 0 0) times 2", Verb::layered, copy,
     "TARGET; NUMBER; to; NUMBER; on shift times; TARGET; on shift times; TARGET; on shift times"},
};

}  // namespace

std::span<const Verb> copying_verbs() { return copying_rows; }

}  // namespace betwixt
