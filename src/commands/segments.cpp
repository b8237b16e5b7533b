// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands that work on segments of tracks.
#include "commands/segments.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/counted.h"
#include "commands/notes.h"
#include "scene/names.h"
#include "track/curve.h"
#include "track/operations.h"

namespace betwixt {
namespace {

// Changes all tracks of one target. If one track cannot be changed, changes none.
Status each_track(Scene& s, const Target& t, bool along, const Work& work, Changed& sum) {
  const Slot* const there = s.objects[t.object.index].find(t.function, t.layer);
  if (!there) return Nothing{};
  const Slot before = *there;
  const Changed so_far = sum;
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
      const Result<Changed> done = work(*tracks[i], spec_of(s, t.function).type, parts ? static_cast<int>(i) : -1, one);
      if (!done) {
        s.objects.edit(t.object.index).slot(t.function, t.layer) = before;
        sum = so_far;
        return done.error();
      }
      sum.events += done->events, sum.replaced += done->replaced;
    }
  }
  return Nothing{};
}

// Leaves out the targets for which the command has no meaning. Fails if it has none for any target.
bool change(Command& k, const Stretch& on, const Work& work, bool along, Changed& sum) {
  if (!finish(k.cursor)) return false;
  Rollback all(k.scene);
  std::vector<Target> left_out;
  std::optional<Error> why;
  const std::size_t before = sum.events;
  for (const Target& t : on.of.targets) {
    const Status done = each_track(k.scene, t, along, work, sum);
    if (done) continue;
    if (done.error().code != ErrorCode::type) return k.cursor.fail(done.error(), on.word);
    left_out.push_back(t);
    if (!why) why = done.error();
  }
  if (why && sum.events == before) return k.cursor.fail(why->code, why->message, on.word, why->hint);
  all.keep();
  if (why) say_left_out(k, left_out, on.word, std::move(why->message));
  return true;
}

void say_changed(Command& k, const Stretch& on, const Changed& sum) {
  if (sum.events == 0)
    k.script.note(Severity::notice, fmt::format("'{}' has no events in this segment", on.of.text), on.word);
  if (sum.replaced > 0)
    k.script.note(Severity::notice, fmt::format("{} replaced", counted(sum.replaced, "event")), on.word);
}

// Returns whether the type has arithmetic: numbers and points.
bool calculable(Type type) { return has_velocity(type) || type == Type::aim || type == Type::points; }

// Reads TARGET A..B, then the rest of the command once for each such type that the pattern names.
bool change_values(Command& k, const char* changed, const std::function<bool(Stretch&, Changed&)>& rest) {
  Stretch on;
  if (!on_segment(k, on)) return false;
  Changed sum{0, 0};
  const auto one = [&](const Selected& of) {
    Stretch part{on.word, of, on.segment};
    if (of.spec && !calculable(of.spec->type))
      return k.cursor.fail(ErrorCode::type, fmt::format("{} cannot be {}", to_string(of.spec->type), changed), on.word);
    return rest(part, sum);
  };
  if (!for_each_type(k, on.of, one)) return false;
  say_changed(k, on, sum);
  return true;
}

// Reads one number for all components, or one for each. Factors have no unit.
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
    return c.fail_here(ErrorCode::type,
                       fmt::format("expected one number here: the target is {}", to_string(on.type())));
  Vec3 v;
  if (!values(k).vector(component_count(on.type()) == 2 ? 2 : 3, v)) return false;
  out = v;
  return true;
}

// Reads the segment of cues or of targets. Sets `cues` to tell which.
bool on_cues_or_segment(Command& k, Stretch& on, std::optional<Cues>& cues) {
  cues = accept_cues(k, on.word);
  return cues ? k.cursor.segment(on.segment.from, on.segment.to) : on_segment(k, on);
}

bool move(Command& k) {
  Cursor& c = k.cursor;
  Stretch on;
  Time by;
  std::optional<Cues> cues;
  if (!on_cues_or_segment(k, on, cues)) return false;
  if (!c.accept_word("by")) return c.fail_here(ErrorCode::syntax, "'by' and a length of time are missing here");
  if (!c.length(by)) return false;
  if (cues) return retime_cues(k, *cues, on.word, on.segment, [&](Time t, auto& to) { to.push_back(t + by); });
  return operate_and_say(k, on, [&](Track& t, Type, int, const Target&) { return move_segment(t, on.segment, by); });
}

bool stretch(Command& k) {
  Cursor& c = k.cursor;
  Stretch on;
  double factor = 1;
  std::optional<Cues> cues;
  if (!on_cues_or_segment(k, on, cues)) return false;
  if (!c.accept_word("by")) return c.fail_here(ErrorCode::syntax, "'by' and a factor are missing here");
  c.space();
  const char* at = c.at;
  if (!c.number(factor)) return false;
  if (!(factor > 0))
    return c.fail(ErrorCode::range,
                  on.of.spec && on.type() == Type::motion
                      ? "the factor must be greater than 0"
                      : "the factor must be greater than 0; to play backwards, use 'reverse'",
                  c.since(at));
  if (cues)
    return retime_cues(k, *cues, on.word, on.segment, [&](Time t, auto& to) {
      to.push_back(on.segment.from + time_of(static_cast<double>((t - on.segment.from).flicks) * factor));
    });
  return operate(k, on, [&](Track& t, Type, int, const Target& of) -> Result<Changed> {
    // A velocity decreases when its segment becomes longer.
    if (of.velocity)
      if (auto slower = scale_segment(t, on.segment, 1 / factor); !slower) return slower;
    return stretch_segment(t, on.segment, factor);
  });
}

// Reports segments that cannot keep their shape: they also depend on events beside the reversed segment, and have no
// tangents that could express it.
void say_bent(Command& k, const std::vector<std::string>& places, std::string_view about) {
  constexpr std::size_t most = 4;
  if (places.empty()) return;
  const std::size_t named = std::min(places.size(), most);
  std::string all =
      fmt::format("{}", fmt::join(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(named), ", "));
  if (places.size() > most) all += fmt::format(" and {} more", places.size() - most);
  k.script.note(
      Severity::warning, "these segments have another shape backwards: " + all, about,
      "their shape depends on the neighbouring events, which have changed; reverse the whole track, or bake it first");
}

bool reverse(Command& k) {
  Stretch on;
  std::optional<Cues> cues;
  if (!on_cues_or_segment(k, on, cues)) return false;
  if (cues)
    return retime_cues(k, *cues, on.word, on.segment,
                       [&](Time t, auto& to) { to.push_back(on.segment.from + (on.segment.to - t)); });
  std::vector<std::string> bent;
  const auto turn_round = [&](Track& t, Type type, int component, const Target& of) -> Result<Changed> {
    if (of.velocity && !on.of.velocity)
      return fail(ErrorCode::type, "a track with velocities cannot be reversed",
                  "clear the velocities first, or reverse the velocity alone");
    if (type == Type::motion)
      return fail(ErrorCode::type, "a motion cannot be reversed",
                  "write its inverse, which betwixt algebra --inverse prints");
    const bool part = component >= 0 || on.of.component >= 0;
    fill_in_kept(t, on.segment, type, of.velocity, part);
    for (const Segment& s : own_tangents(t, on.segment, type_of_track(type, of.velocity, part), part))
      bent.push_back(fmt::format("{} from {} to {}", target_name(k.scene, of),
                                 format_time(on.segment.from + (on.segment.to - s.to), k.scene.rate),
                                 format_time(on.segment.from + (on.segment.to - s.from), k.scene.rate)));
    return reverse_segment(t, on.segment);
  };
  if (!operate(k, on, turn_round)) return false;
  say_bent(k, bent, on.word);
  return true;
}

bool scale(Command& k) {
  return change_values(k, "scaled", [&](Stretch& on, Changed& sum) {
    Value by;
    const auto multiply = [&](Track& t, Type, int component, const Target&) {
      return scale_segment(t, on.segment, part_of(by, component));
    };
    return given_factors(k, on, by) && change(k, on, multiply, true, sum);
  });
}

bool translate(Command& k) {
  return change_values(k, "moved", [&](Stretch& on, Changed& sum) {
    Value by;
    if (!values(k).value(difference_of(on.spec()), on.of.component, by)) return false;
    for (const Target& t : on.of.targets)
      if (!reaches(k, on, t, by, "moved")) return false;
    const auto add = [&](Track& t, Type, int component, const Target&) {
      return translate_segment(t, on.segment, part_of(by, component));
    };
    return change(k, on, add, on.of.velocity, sum);
  });
}

// Reads ANGLE AXIS [@ CENTRE]
bool turn_values(Command& k, Stretch& on, Changed& sum) {
  Cursor& c = k.cursor;
  double angle = 0;
  Vec3 axis, centre;
  if (!values(k).angle(angle) || !values(k).axis(axis)) return false;
  if (c.accept('@') && !values(k).vector(3, centre, Unit::metres)) return false;
  const Type whole = on.of.spec ? on.type() : Type::vector;
  if (!row_of(whole).rotates)
    return c.fail(ErrorCode::type,
                  fmt::format("only vectors, points and orientations can be rotated; this is {}", to_string(whole)),
                  on.word);
  const auto turn = [&](Track& t, Type type, int component, const Target& of) -> Result<Changed> {
    if (component >= 0)
      return fail(ErrorCode::type,
                  "the components of this track have their own tracks, so it cannot be rotated as a whole");
    auto done = rotate_segment(t, on.segment, axis_angle(axis, angle), of.velocity ? Vec3{} : centre);
    if (!done && type == Type::rotation)
      return fail(ErrorCode::type, "angles cannot be rotated, orientations can",
                  "write the track with axis(…) or quat(…)");
    return done;
  };
  return change(k, on, turn, true, sum);
}

bool rotate(Command& k) {
  return change_values(k, "rotated", [&](Stretch& on, Changed& sum) { return turn_values(k, on, sum); });
}

constexpr Verb segments_rows[] = {
    {"move", "move TARGET A..B by LENGTH",
     "Moves the events of a segment in time: those of tracks, notes, steps or descriptions.",
     "move ball.position 1f..24f by 12f", Verb::layered, move, "TARGET; NUMBER; by"},
    {"stretch", "stretch TARGET A..B by FACTOR", "Makes a segment longer or shorter in time.",
     "stretch ball.position 1f..24f by 2", Verb::layered, stretch, "TARGET; NUMBER; by"},
    {"reverse", "reverse TARGET A..B", "Plays a segment backwards.", "reverse ball.position 1f..24f", Verb::layered,
     reverse},
    {"scale", "scale TARGET A..B (X Y Z)", "Multiplies the values of a segment.",
     "scale ball.position 1f..24f (1 -1 1)", Verb::layered, scale},
    {"translate", "translate TARGET A..B (X Y Z)", "Adds to the values of a segment.",
     "translate ball.position 1f..24f (0 1 0)", Verb::layered, translate},
    {"rotate", "rotate TARGET A..B ANGLE AXIS [@ (X Y Z)]", "Turns the values of a segment about an axis.",
     "rotate ball.position 1f..24f 90deg y", Verb::layered, rotate},
};

}  // namespace

const FunctionSpec& Stretch::spec() const { return of.spec ? *of.spec : built_in_functions()[fn::position]; }

bool on_segment(Command& k, Stretch& on, Meant meant) {
  Cursor& c = k.cursor;
  on.word = c.next_word();
  return targets(k, on.word, on.of, meant) && c.segment(on.segment.from, on.segment.to);
}

bool operate(Command& k, const Stretch& on, const Work& work, bool along) {
  Changed sum{0, 0};
  if (!change(k, on, work, along, sum)) return false;
  say_changed(k, on, sum);
  return true;
}

bool operate_and_say(Command& k, const Stretch& on, const Work& work, bool along) {
  const Scene before = k.scene;
  if (!operate(k, on, work, along)) return false;
  say_lasting(k, before, on.of, on.word);
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
        fmt::format("{} has no events from {} to {} that could be {}", name, from,
                    format_time(on.segment.to, k.scene.rate), changed),
        on.word,
        fmt::format("the components of this track have their own tracks; to write an event: at {} {} VALUE", from,
                    name));
  }
  return true;
}

Type type_of_track(Type of_function, bool velocity, bool part) {
  if (velocity) return part ? Type::scalar : row_of(of_function).rate.value_or(of_function);
  return part ? component_track_type(of_function) : of_function;
}

void fill_in_kept(Track& track, Segment s, Type of_function, bool velocity, bool part) {
  bool any = false;
  track.events.each_between(s.from, s.to, [&](const Event& e) { any = any || e.keep; });
  if (any) fill_in_kept(track, type_of_track(of_function, velocity, part), part);
}

FunctionSpec difference_of(FunctionSpec spec) {
  if (spec.type == Type::points) spec.type = Type::vector;
  return unbounded(spec);
}

Value part_of(const Value& v, int component) {
  return component < 0 || std::holds_alternative<double>(v) ? v : Value(component_of(v, component));
}

std::span<const Verb> segments_verbs() { return segments_rows; }

}  // namespace betwixt
