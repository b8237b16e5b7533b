// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands that work on segments of tracks, and on many objects at once.
#include "track/operations.h"

#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "language/reader.h"
#include "track/curve.h"

namespace betwixt {
namespace {

constexpr std::size_t most_copied =
    10'000'000;  // events a script may make by copying: a few words must not fill the machine

std::string plural(std::size_t n, const char* what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); }

}  // namespace

// Does f(track, component) for all tracks of all targets, or for none: an error on the way puts everything back.
template <class F>
bool Reader::operate(Cursor& c, const Selected& on, std::string_view about, bool moves_times, F&& f, bool along) {
  if (!finish(c)) return false;
  const Scene before = s;
  std::size_t events = 0, replaced = 0;
  for (const Target& t : on.targets) {
    const Slot* slot = s.objects[t.object.index].find(t.function, t.layer);
    if (!slot) continue;
    // The velocity beside a track goes along (R-T10).
    Target velocity = t;
    velocity.velocity = true;
    std::vector<Target> both{t};
    const bool rates = !t.velocity && along && [&] {
      for (const Track* track : tracks_of(s, velocity))
        if (!track->events.empty()) return true;
      return false;
    }();
    if (rates) both.push_back(velocity);
    for (const Target& one : both) {
      const auto tracks = edit_tracks(s, one);
      const bool parts = t.component < 0 && tracks.size() > 1;
      for (std::size_t i = 0; i < tracks.size(); ++i) {
        const Result<Changed> done = f(*tracks[i], parts ? static_cast<int>(i) : -1, one.velocity);
        if (!done) {
          s = before;
          return c.fail(done.error().code, done.error().message, about, done.error().hint);
        }
        events += done->events;
        replaced += done->replaced;
      }
    }
  }
  if (events == 0) note(Severity::notice, fmt::format("there are no events of '{}' there", on.text), about);
  if (moves_times && replaced > 0) note(Severity::notice, fmt::format("{} gave way", plural(replaced, "event")), about);
  return true;
}

// TARGET A..B
bool Reader::on_segment(Cursor& c, std::string_view& word, Selected& on, Segment& segment) {
  c.space();
  word = c.word();
  return targets(c, word, on) && c.segment(segment.from, segment.to);
}

// A number for all components, or one for each.
bool Reader::operand(Cursor& c, const Selected& on, Value& out) {
  c.space();
  if (c.peek() != '(') {
    double d = 0;
    if (!values(c).scalar(d, on.spec->unit)) return false;
    out = d;
    return true;
  }
  if (on.type() == Type::scalar || on.type() == Type::angle)
    return c.fail_here(Code::type, fmt::format("one number is wanted here: this is {}", to_string(on.type())));
  Vec3 v;
  if (!values(c).vector(on.type() == Type::pair ? 2 : 3, v, on.spec->unit)) return false;
  out = v;
  return true;
}

namespace {

Value part(const Value& v, int component) {
  return component < 0 || std::holds_alternative<double>(v) ? v : Value(component_of(v, component));
}

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

}  // namespace

// One track, or the tracks of its components, of what stood before, onto another. How many events came of it.
Result<std::size_t> Reader::copy_track(const Scene& before, const Target& from, const Target& to, const Copying& how) {
  std::vector<Track> originals;
  for (const Track* t : tracks_of(before, from)) originals.push_back(*t);
  std::size_t made = 0;
  for (std::size_t k = 0; k < originals.size(); ++k) {
    if (originals[k].events.count(how.segment.from, how.segment.to) == 0) continue;
    Target place = to;
    if (originals.size() > 1) place.component = static_cast<int>(k);
    const auto tracks = edit_tracks(s, place);
    for (std::size_t i = 0; i < tracks.size(); ++i) {
      // A whole value onto tracks of components: each takes its own.
      const bool apart = tracks.size() > 1;
      const int component = apart ? static_cast<int>(i) : originals.size() > 1 ? static_cast<int>(k) : -1;
      Track source = apart ? component_of(originals[k], component) : originals[k];
      if (to.function == fn::motion)
        source = centred(source, before.objects[from.object.index].name, s.objects[to.object.index].name);
      const auto shift = how.shift ? std::optional<Value>(part(*how.shift, component)) : std::nullopt;
      const auto done = copy_segment(source, how.segment, *tracks[i], how.start, shift, how.times);
      if (!done) return done.error();
      made += done->events;
    }
  }
  return made;
}

bool Reader::copy(Cursor& c) {
  Selected from, into;
  Segment segment;
  Time start;
  c.space();
  const std::string_view word = c.word();
  if (!targets(c, word, from) || !c.segment(segment.from, segment.to)) return false;
  if (!c.accept_word("to")) return c.fail_here(Code::syntax, "'to' and a time are missing here");
  if (!c.time(start)) return false;
  std::string_view onto = word;
  into = from;
  std::optional<Value> shift;
  long times = 1;
  while (!c.at_line_end()) {
    if (c.accept_word("on")) {
      c.space();
      onto = c.word();
      if (!targets(c, onto, into)) return false;
    } else if (c.accept_word("times")) {
      if (!c.whole_number(1, 1'000'000, "times", times)) return false;
    } else if (c.accept_word("shift")) {
      if (!from.spec) from.spec = &built_in_functions()[fn::position];
      Value v;
      const FunctionSpec free = unbounded(*from.spec);  // a shift may be of any size
      c.space();
      const char* at = c.at;
      if (!values(c).value(free, from.component, v)) return false;
      if (!add_scaled(v, v, 1))
        return c.fail(Code::type, fmt::format("{} cannot be shifted", to_string(from.type())), c.since(at));
      shift = std::move(v);
    } else {
      return c.fail_here(Code::syntax, fmt::format("'{}' is not expected here", c.peek_word().substr(0, 40)),
                         "copies take: on TARGET, shift VALUE, times N");
    }
  }
  if (!from.spec || !into.spec) return true;
  if (from.type() != into.type())
    return c.fail(Code::type,
                  fmt::format("{} cannot be copied onto {}", to_string(from.type()), to_string(into.type())), onto);
  if (from.targets.size() != into.targets.size() && from.targets.size() != 1)
    return c.fail(Code::type,
                  fmt::format("{} cannot be copied onto {}", plural(from.targets.size(), "track"),
                              plural(into.targets.size(), "track")),
                  onto);
  if (!finish(c)) return false;
  const auto source_of = [&](std::size_t i) { return from.targets[from.targets.size() == 1 ? 0 : i]; };
  std::size_t wanted = copied_;
  for (std::size_t i = 0; i < into.targets.size(); ++i)
    for (const Track* t : tracks_of(s, source_of(i)))
      wanted += t->events.count(segment.from, segment.to) * static_cast<std::size_t>(times);
  if (wanted > most_copied)
    return c.fail(Code::range, fmt::format("copying would make more than {} events", most_copied), word);
  copied_ = wanted;
  const Scene before = s;
  std::size_t made = 0;
  for (std::size_t i = 0; i < into.targets.size(); ++i) {
    Target source = source_of(i), to = into.targets[i];
    const auto put = [&](const std::optional<Value>& by) {
      return copy_track(before, source, to, {segment, start, by, static_cast<int>(times)});
    };
    Result<std::size_t> done = put(shift);
    if (done && !source.velocity && has_velocity(from.type())) {  // what goes on beside it, unshifted (R-T10)
      made += *done;
      source.velocity = to.velocity = true;
      done = put(std::nullopt);
    }
    if (!done) {
      s = before;
      return c.fail(done.error().code, done.error().message, word);
    }
    made += *done;
  }
  if (made == 0) note(Severity::notice, fmt::format("there are no events of '{}' there", from.text), word);
  lasting(before, into, word);
  return true;
}

bool Reader::move(Cursor& c) {
  Selected on;
  Segment segment;
  std::string_view word;
  Time by;
  if (!on_segment(c, word, on, segment)) return false;
  if (!c.accept_word("by")) return c.fail_here(Code::syntax, "'by' and a length of time are missing here");
  if (!c.length(by)) return false;
  const Scene before = s;
  if (!operate(c, on, word, true, [&](Track& t, int, bool) { return move_segment(t, segment, by); })) return false;
  lasting(before, on, word);
  return true;
}

bool Reader::stretch(Cursor& c) {
  Selected on;
  Segment segment;
  std::string_view word;
  double factor = 1;
  if (!on_segment(c, word, on, segment)) return false;
  if (!c.accept_word("by")) return c.fail_here(Code::syntax, "'by' and a factor are missing here");
  c.space();
  const char* at = c.at;
  if (!c.number(factor)) return false;
  if (!(factor > 0))
    return c.fail(Code::range,
                  on.spec && on.type() == Type::motion ? "time is stretched by more than 0"
                                                       : "time is stretched by more than 0; 'reverse' turns it round",
                  c.since(at));
  return operate(c, on, word, true, [&](Track& t, int, bool velocity) -> Result<Changed> {
    // What takes longer goes slower.
    if (velocity)
      if (auto slower = scale_segment(t, segment, 1 / factor); !slower) return slower;
    return stretch_segment(t, segment, factor);
  });
}

bool Reader::reverse(Cursor& c) {
  Selected on;
  Segment segment;
  std::string_view word;
  if (!on_segment(c, word, on, segment)) return false;
  return operate(c, on, word, true, [&](Track& t, int, bool velocity) -> Result<Changed> {
    if (velocity)
      return fail(Code::type, "a track with velocities cannot be reversed",
                  "clear them first, or reverse the velocity alone");
    if (on.type() == Type::motion)
      return fail(Code::type, "a motion cannot be reversed", "write what undoes it: betwixt algebra --inverse tells");
    return reverse_segment(t, segment);
  });
}

bool Reader::scale(Cursor& c) {
  Selected on;
  Segment segment;
  std::string_view word;
  Value by;
  if (!on_segment(c, word, on, segment)) return false;
  if (!on.spec) on.spec = &built_in_functions()[fn::position];
  Selected factors = on;  // factors have no unit
  FunctionSpec plain = *on.spec;
  plain.unit = Unit::none;
  factors.spec = &plain;
  if (!operand(c, factors, by)) return false;
  return operate(c, on, word, false,
                 [&](Track& t, int component, bool) { return scale_segment(t, segment, part(by, component)); });
}

bool Reader::translate(Cursor& c) {
  Selected on;
  Segment segment;
  std::string_view word;
  Value by;
  if (!on_segment(c, word, on, segment)) return false;
  if (!on.spec) on.spec = &built_in_functions()[fn::position];
  const FunctionSpec free = unbounded(*on.spec);
  if (!values(c).value(free, on.component, by)) return false;
  return operate(
      c, on, word, false,
      [&](Track& t, int component, bool) { return translate_segment(t, segment, part(by, component)); }, on.velocity);
}

bool Reader::rotate(Cursor& c) {
  Selected on;
  Segment segment;
  std::string_view word;
  double angle = 0;
  Vec3 axis, centre;
  if (!on_segment(c, word, on, segment) || !c.angle(angle) || !values(c).axis(axis)) return false;
  if (c.accept('@') && !values(c).vector(3, centre, Unit::metres)) return false;
  const Type type = on.spec ? on.type() : Type::vector;
  if (type != Type::vector && type != Type::orientation && type != Type::rotation && type != Type::aim)
    return c.fail(Code::type, fmt::format("only vectors and orientations can be rotated; this is {}", to_string(type)),
                  word);
  return operate(c, on, word, false, [&](Track& t, int component, bool velocity) -> Result<Changed> {
    if (component >= 0)
      return fail(Code::type, "the components of this track have tracks of their own: it cannot be rotated as a whole");
    auto done = rotate_segment(t, segment, axis_angle(axis, angle), velocity ? Vec3{} : centre);
    if (!done && type == Type::rotation)
      return fail(Code::type, "angles cannot be rotated, orientations can", "write the track with axis(…) or quat(…)");
    return done;
  });
}

bool Reader::clear(Cursor& c) {
  Selected on;
  Segment segment;
  c.space();
  const std::string_view word = c.word();
  if (!targets(c, word, on) || !c.time(segment.from)) return false;
  segment.to = segment.from;
  if (c.end - c.at > 1 && c.at[0] == '.' && c.at[1] == '.') {
    const char* at = c.at;
    c.at += 2;
    if (!c.time(segment.to)) return false;
    if (segment.to < segment.from) return c.fail(Code::range, "this segment ends before it begins", {at, 2});
  }
  const Scene before = s;
  const auto erase = [&](Track& t, int, bool) -> Result<Changed> {
    return Changed{t.events.erase(segment.from, segment.to), 0};
  };
  if (!operate(c, on, word, false, erase, false)) return false;
  lasting(before, on, word);
  return true;
}

bool Reader::stagger(Cursor& c) {
  Selected on;
  Time by;
  long seed = -1;
  c.space();
  const std::string_view word = c.word();
  if (!targets(c, word, on)) return false;
  if (!c.accept_word("by")) return c.fail_here(Code::syntax, "'by' and a length of time are missing here");
  if (!c.length(by)) return false;
  if (c.accept_word("random") && !c.whole_number(0, 1'000'000'000, "the seed of random", seed)) return false;
  if (on.targets.size() > 1 && std::abs(by.seconds()) * static_cast<double>(on.targets.size()) > longest_seconds)
    return c.fail(Code::range, "the events would end up more than 146 years away", word);
  std::vector<std::int64_t> turn(on.targets.size());
  for (std::size_t i = 0; i < turn.size(); ++i) turn[i] = static_cast<std::int64_t>(i);
  if (seed >= 0) {  // Fisher and Yates, by a generator that is the same everywhere
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    for (std::size_t i = turn.size(); i > 1; --i) std::swap(turn[i - 1], turn[random() % i]);
  }
  const Segment all{{INT64_MIN}, {INT64_MAX}};
  if (!finish(c)) return false;
  const Scene before = s;
  for (std::size_t i = 0; i < on.targets.size(); ++i) {
    if (!before.objects[on.targets[i].object.index].find(on.targets[i].function, on.targets[i].layer)) continue;
    for (Track* t : edit_tracks(s, on.targets[i])) {
      const auto done = move_segment(*t, all, {by.flicks * turn[i]});
      if (done) continue;
      s = before;
      return c.fail(done.error().code, done.error().message, word);
    }
  }
  return true;
}

bool Reader::spread(Cursor& c) {
  Selected on;
  Value from, to;
  c.space();
  const std::string_view word = c.word();
  if (!targets(c, word, on)) return false;
  if (!on.spec) on.spec = &built_in_functions()[fn::position];
  if (!c.accept_word("from")) return c.fail_here(Code::syntax, "'from' and a value are missing here");
  if (!values(c).value(*on.spec, on.component, from)) return false;
  if (!c.accept_word("to")) return c.fail_here(Code::syntax, "'to' and a value are missing here");
  if (!values(c).value(*on.spec, on.component, to) || !finish(c)) return false;
  const auto way = add_scaled(to, from, -1);
  const bool turn = std::holds_alternative<Quat>(from) && std::holds_alternative<Quat>(to);
  if (!way && !turn) return c.fail(Code::type, fmt::format("{} cannot be spread", to_string(on.type())), word);
  const auto has_events = [&](const Target& t) {
    const auto tracks = tracks_of(s, t);
    return std::any_of(tracks.begin(), tracks.end(), [](const Track* track) { return !track->events.empty(); });
  };
  if (std::any_of(on.targets.begin(), on.targets.end(), has_events))
    note(Severity::warning, "values of tracks that have events are not seen", word,
         "spread lays out the values that hold without events");
  const double last = static_cast<double>(std::max<std::size_t>(on.targets.size(), 2) - 1);
  for (std::size_t i = 0; i < on.targets.size(); ++i) {
    const double k = static_cast<double>(i) / last;
    if (turn) {
      const Quat a = std::get<Quat>(from), b = std::get<Quat>(to);
      set_value(s, on.targets[i], slerp(a, dot(a, b) < 0 ? -b : b, k));
    } else {
      set_value(s, on.targets[i], i + 1 == on.targets.size() && i > 0 ? to : *add_scaled(from, *way, k));
    }
  }
  return true;
}

}  // namespace betwixt
