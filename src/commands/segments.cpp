// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands that work on segments of tracks.
#include "commands/segments.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "commands/notes.h"
#include "scene/names.h"
#include "track/curve.h"
#include "track/operations.h"

namespace betwixt {
namespace {

// Does f(track, type, component, velocity) for all tracks of all targets, or for none. `along`: what goes on beside it,
// its velocity, goes along (R-T10).
using Work = std::function<Result<Changed>(Track&, Type, int component, bool velocity)>;

Status each_track(Scene& s, const Target& t, bool along, const Work& work, Changed& sum) {
  if (!s.objects[t.object.index].find(t.function, t.layer)) return Nothing{};
  Target velocity = t;
  velocity.velocity = true;
  std::vector<Target> both{t};
  const auto beside = t.velocity || !along ? std::vector<const Track*>() : tracks_of(s, velocity);
  if (std::any_of(beside.begin(), beside.end(), [](const Track* track) { return !track->events.empty(); }))
    both.push_back(velocity);
  for (const Target& one : both) {
    const auto tracks = edit_tracks(s, one);
    const bool parts = t.component < 0 && tracks.size() > 1;
    for (std::size_t i = 0; i < tracks.size(); ++i) {
      const Result<Changed> done =
          work(*tracks[i], spec_of(s, t.function).type, parts ? static_cast<int>(i) : -1, one.velocity);
      if (!done) return done.error();
      sum.events += done->events, sum.replaced += done->replaced;
    }
  }
  return Nothing{};
}

bool operate(Command& k, const Stretch& on, const Work& work, bool along = true) {
  if (!finish(k.cursor)) return false;
  Rollback all(k.scene);
  Changed sum{0, 0};
  for (const Target& t : on.of.targets)
    if (const Status done = each_track(k.scene, t, along, work, sum); !done)
      return k.cursor.fail(done.error().code, done.error().message, on.word, done.error().hint);
  all.keep();
  if (sum.events == 0)
    k.script.note(Severity::notice, fmt::format("there are no events of '{}' there", on.of.text), on.word);
  if (sum.replaced > 0)
    k.script.note(Severity::notice, fmt::format("{} gave way", plural(sum.replaced, "event")), on.word);
  return true;
}

// The same, and says what it has made of motions.
bool operate_and_say(Command& k, const Stretch& on, const Work& work, bool along = true) {
  const Scene before = k.scene;
  if (!operate(k, on, work, along)) return false;
  say_lasting(k, before, on.of, on.word);
  return true;
}

// A number for all components, or one for each. Factors have no unit.
bool given_factors(Command& k, const Stretch& on, Value& out) {
  Cursor& c = k.cursor;
  c.space();
  const bool one = std::holds_alternative<double>(row_of(on.type()).example());
  if (c.peek() != '(' || (one && values(k).translates())) {
    double d = 0;
    if (!values(k).scalar(d)) return false;
    out = d;
    return true;
  }
  if (one)
    return c.fail_here(ErrorCode::type, fmt::format("one number is wanted here: this is {}", to_string(on.type())));
  Vec3 v;
  if (!values(k).vector(component_count(on.type()) == 2 ? 2 : 3, v)) return false;
  out = v;
  return true;
}

// The segment of `notes` or of targets; whether it is that of notes.
bool on_notes_or_segment(Command& k, Stretch& on, bool& notes) {
  notes = accept_notes(k, on.word);
  return notes ? k.cursor.segment(on.segment.from, on.segment.to) : on_segment(k, on);
}

bool move(Command& k) {
  Cursor& c = k.cursor;
  Stretch on;
  Time by;
  bool notes = false;
  if (!on_notes_or_segment(k, on, notes)) return false;
  if (!c.accept_word("by")) return c.fail_here(ErrorCode::syntax, "'by' and a length of time are missing here");
  if (!c.length(by)) return false;
  if (notes) return retime_notes(k, on.word, on.segment, [&](Time t, auto& to) { to.push_back(t + by); });
  return operate_and_say(k, on, [&](Track& t, Type, int, bool) { return move_segment(t, on.segment, by); });
}

bool stretch(Command& k) {
  Cursor& c = k.cursor;
  Stretch on;
  double factor = 1;
  bool notes = false;
  if (!on_notes_or_segment(k, on, notes)) return false;
  if (!c.accept_word("by")) return c.fail_here(ErrorCode::syntax, "'by' and a factor are missing here");
  c.space();
  const char* at = c.at;
  if (!c.number(factor)) return false;
  if (!(factor > 0))
    return c.fail(ErrorCode::range,
                  on.of.spec && on.type() == Type::motion
                      ? "time is stretched by more than 0"
                      : "time is stretched by more than 0; 'reverse' turns it round",
                  c.since(at));
  if (notes)
    return retime_notes(k, on.word, on.segment, [&](Time t, auto& to) {
      to.push_back(on.segment.from + time_of(static_cast<double>((t - on.segment.from).flicks) * factor));
    });
  return operate(k, on, [&](Track& t, Type, int, bool velocity) -> Result<Changed> {
    // What takes longer goes slower.
    if (velocity)
      if (auto slower = scale_segment(t, on.segment, 1 / factor); !slower) return slower;
    return stretch_segment(t, on.segment, factor);
  });
}

bool reverse(Command& k) {
  Stretch on;
  bool notes = false;
  if (!on_notes_or_segment(k, on, notes)) return false;
  if (notes)
    return retime_notes(k, on.word, on.segment,
                        [&](Time t, auto& to) { to.push_back(on.segment.from + (on.segment.to - t)); });
  return operate(k, on, [&](Track& t, Type type, int component, bool velocity) -> Result<Changed> {
    if (velocity && !on.of.velocity)
      return fail(ErrorCode::type, "a track with velocities cannot be reversed",
                  "clear them first, or reverse the velocity alone");
    if (type == Type::motion)
      return fail(ErrorCode::type, "a motion cannot be reversed",
                  "write what undoes it: betwixt algebra --inverse tells");
    const bool part = component >= 0 || on.of.component >= 0;
    fill_in_kept(t, on.segment, type, velocity, part);
    if (!velocity) own_tangents(t, on.segment, part ? component_track_type(type) : type, part);
    return reverse_segment(t, on.segment);
  });
}

bool scale(Command& k) {
  Stretch on;
  Value by;
  if (!on_values(k, on) || !given_factors(k, on, by)) return false;
  return operate(
      k, on, [&](Track& t, Type, int component, bool) { return scale_segment(t, on.segment, part_of(by, component)); });
}

bool translate(Command& k) {
  Stretch on;
  Value by;
  if (!on_values(k, on) || !values(k).value(unbounded(on.spec()), on.of.component, by)) return false;
  for (const Target& t : on.of.targets)
    if (!reaches(k, on, t, by, "moved")) return false;
  return operate(
      k, on,
      [&](Track& t, Type, int component, bool) { return translate_segment(t, on.segment, part_of(by, component)); },
      on.of.velocity);
}

bool rotate(Command& k) {
  Cursor& c = k.cursor;
  Stretch on;
  double angle = 0;
  Vec3 axis, centre;
  if (!on_values(k, on) || !values(k).angle(angle) || !values(k).axis(axis)) return false;
  if (c.accept('@') && !values(k).vector(3, centre, Unit::metres)) return false;
  const Type type = on.of.spec ? on.type() : Type::vector;
  if (!row_of(type).rotates)
    return c.fail(ErrorCode::type,
                  fmt::format("only vectors and orientations can be rotated; this is {}", to_string(type)), on.word);
  return operate(k, on, [&](Track& t, Type, int component, bool velocity) -> Result<Changed> {
    if (component >= 0)
      return fail(ErrorCode::type,
                  "the components of this track have tracks of their own: it cannot be rotated as a whole");
    auto done = rotate_segment(t, on.segment, axis_angle(axis, angle), velocity ? Vec3{} : centre);
    if (!done && type == Type::rotation)
      return fail(ErrorCode::type, "angles cannot be rotated, orientations can",
                  "write the track with axis(…) or quat(…)");
    return done;
  });
}

// Whether what a target is at any time may follow from all that came before: where it was let go, how far its velocity
// has brought it, what a filter remembers, what comes round again.
bool needs_all_before(const Scene& s, const Target& t) {
  const Slot* const slot = s.objects[t.object.index].find(t.function, t.layer);
  if (!slot) return false;
  const Type type = spec_of(s, t.function).type;
  if (type == Type::attachment || type == Type::motion || !slot->filters.empty()) return true;
  const auto comes_round = [](const Cow<Track>& track) { return track->after != Extrapolation::hold; };
  const auto empty = [](const Cow<Track>& track) { return track->events.empty(); };
  const auto any = [](const auto& components, const auto& is) {
    return std::any_of(components.begin(), components.end(), is);
  };
  return comes_round(slot->track) || any(slot->components, comes_round) || !empty(slot->velocity.track) ||
         any(slot->velocity.components, [&](const Cow<Track>& track) { return !empty(track); });
}

// Behind `clear TARGET before`.
bool clear_before(Command& k, Stretch& on, bool notes) {
  Time t;
  if (!k.cursor.time(t)) return false;
  if (notes) return retime_notes(k, on.word, {Time{INT64_MIN}, t - Time{1}}, [](Time, auto&) {});
  std::size_t whole = 0;
  std::string left;
  std::erase_if(on.of.targets, [&](const Target& target) {
    if (!needs_all_before(k.scene, target)) return false;
    if (++whole <= 3) left += (left.empty() ? "" : ", ") + target_name(k.scene, target);
    return true;
  });
  if (whole > 3) left += fmt::format(" and {} more", whole - 3);
  if (whole > 0)
    k.script.note(Severity::notice, "left whole, as what comes later follows from all of it: " + left, on.word);
  if (on.of.targets.empty()) return finish(k.cursor);
  const auto erase = [&](Track& track, Type type, int, bool) -> Result<Changed> {
    return Changed{erase_before(track, t, row_of(type).changes), 0};
  };
  return operate(k, on, erase, false);
}

bool clear(Command& k) {
  Cursor& c = k.cursor;
  Stretch on;
  const bool notes = accept_notes(k, on.word);
  if (!notes) on.word = c.next_word();
  if (!notes && !targets(k, on.word, on.of, Meant::any)) return false;
  if (c.accept_word("before")) return clear_before(k, on, notes);
  if (!c.time(on.segment.from)) return false;
  on.segment.to = on.segment.from;
  if (c.end - c.at > 1 && c.at[0] == '.' && c.at[1] == '.') {
    const char* at = c.at;
    c.at += 2;
    if (!c.time(on.segment.to)) return false;
    if (on.segment.to < on.segment.from) return c.fail(ErrorCode::range, "this segment ends before it begins", {at, 2});
  }
  if (notes) return retime_notes(k, on.word, on.segment, [](Time, auto&) {});
  const auto erase = [&](Track& t, Type, int, bool) -> Result<Changed> {
    return Changed{t.events.erase(on.segment.from, on.segment.to), 0};
  };
  return operate_and_say(k, on, erase, false);
}

constexpr Verb segments_rows[] = {
    {"move", "move TARGET A..B by LENGTH", "Moves the events of a segment in time, or notes.",
     "move ball.position 1f..24f by 12f", Verb::layered, move},
    {"stretch", "stretch TARGET A..B by FACTOR", "Makes a segment longer or shorter.",
     "stretch ball.position 1f..24f by 2", Verb::layered, stretch},
    {"reverse", "reverse TARGET A..B", "Runs a segment backwards.", "reverse ball.position 1f..24f", Verb::layered,
     reverse},
    {"scale", "scale TARGET A..B (X Y Z)", "Multiplies the values of a segment.",
     "scale ball.position 1f..24f (1 -1 1)", Verb::layered, scale},
    {"translate", "translate TARGET A..B (X Y Z)", "Adds to the values of a segment.",
     "translate ball.position 1f..24f (0 1 0)", Verb::layered, translate},
    {"rotate", "rotate TARGET A..B ANGLE AXIS [@ (X Y Z)]", "Turns the values of a segment about an axis.",
     "rotate ball.position 1f..24f 90deg y", Verb::layered, rotate},
    {"clear", "clear TARGET A..B or clear TARGET TIME or clear TARGET before TIME",
     "Takes out the events of a segment, or of one time, or those before a time that nothing from there on needs; or "
     "notes.",
     "clear ball.position 6f..18f", Verb::layered, clear},
};

}  // namespace

const FunctionSpec& Stretch::spec() const { return of.spec ? *of.spec : built_in_functions()[fn::position]; }

bool on_segment(Command& k, Stretch& on, Meant meant) {
  Cursor& c = k.cursor;
  on.word = c.next_word();
  return targets(k, on.word, on.of, meant) && c.segment(on.segment.from, on.segment.to);
}

bool on_values(Command& k, Stretch& on) {
  if (!on_segment(k, on)) return false;
  Selected& of = on.of;
  const auto spec = [&](const Target& t) -> const FunctionSpec& { return spec_of(k.scene, t.function); };
  const auto first = std::find_if(of.targets.begin(), of.targets.end(), [&](const Target& t) {
    return has_velocity(spec(t).type);  // that is: numbers that can be calculated with
  });
  if (first == of.targets.end()) return true;
  of.spec = &spec(*first), of.component = first->component;
  std::string others;
  std::size_t count = 0;
  std::erase_if(of.targets, [&](const Target& t) {
    if (spec(t).type == of.spec->type && spec(t).unit == of.spec->unit) return false;
    if (++count <= 3) others += (others.empty() ? "" : ", ") + target_name(k.scene, t);
    return true;
  });
  if (count > 3) others += fmt::format(" and {} more", count - 3);
  if (count > 0)
    k.script.note(Severity::notice, fmt::format("left out, having other values than {}: {}", of.spec->name, others),
                  on.word);
  return true;
}

bool reaches(Command& k, const Stretch& on, const Target& t, const Value& by, const char* changed) {
  const auto tracks = tracks_of(k.scene, t);
  const auto here = [&](const Track* track) { return track->events.count(on.segment.from, on.segment.to) > 0; };
  if (t.component >= 0 || tracks.size() < 2 || std::none_of(tracks.begin(), tracks.end(), here)) return true;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const Value part = part_of(by, static_cast<int>(i));
    const auto* number = std::get_if<double>(&part);
    if (here(tracks[i]) || !number || *number == 0) continue;
    Target one = t;
    one.component = static_cast<int>(i);
    const std::string name = target_name(k.scene, one), from = format_time(on.segment.from, k.scene.rate);
    return k.cursor.fail(
        ErrorCode::type,
        fmt::format("{} has no events from {} to {}: they cannot be {}", name, from,
                    format_time(on.segment.to, k.scene.rate), changed),
        on.word,
        fmt::format("the components of this track have tracks of their own; at {} {} VALUE writes an event", from,
                    name));
  }
  return true;
}

void fill_in_kept(Track& track, Segment s, Type of_function, bool velocity, bool part) {
  bool any = false;
  track.events.each_between(s.from, s.to, [&](const Event& e) { any = any || e.keep; });
  if (!any) return;
  const Type type = velocity ? part ? Type::scalar : row_of(of_function).rate.value_or(of_function)
                    : part ? component_track_type(of_function)
                             : of_function;
  fill_in_kept(track, type, part);
}

Value part_of(const Value& v, int component) {
  return component < 0 || std::holds_alternative<double>(v) ? v : Value(component_of(v, component));
}

std::string plural(std::size_t n, const char* what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); }

std::span<const Verb> segments_verbs() { return segments_rows; }

}  // namespace betwixt
