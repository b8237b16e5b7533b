// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A fall by the laws of cartoons: the object keeps its speed during the delay, then drops, and bounces. The result is
// plain events on plain tracks. (twixt notes, G4, G52)
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/counted.h"
#include "commands/fall_path.h"
#include "commands/segments.h"
#include "program/compiled.h"
#include "program/placing.h"
#include "scene/names.h"

namespace betwixt {
namespace {

// The transformation from the values of a position's track to the world, and the part of the object's speed that is
// lost at that time. The speed of a parent that still holds the object is not lost.
struct CommandOutcome {
  Mat4 to_world;
  Vec3 origin, speed;
};

// Rounds to 11 digits: differences of places have noise beyond them, which would make the rows unreadable.
Vec3 tidied(Vec3 v, double size) {
  const double unit = std::pow(10, std::max(0.0, 11 - std::ceil(std::log10(std::max(1.0, size)))));
  for (int i = 0; i < 3; ++i)
    if (std::abs(v[i]) * unit < 1e15) v[i] = std::round(v[i] * unit) / unit + 0.0;
  return v;
}

bool let_go_at(const Object& o, Time t) {
  const auto all = attachments(o);
  return std::any_of(all.begin(), all.end(),
                     [&](const AttachmentSpan& a) { return a.from == t && a.to.kind == AttachmentKind::letgo; });
}

CommandOutcome carried(const Program& program, ObjectId id, Time t) {
  const Program::Compiled& compiled = program.compiled();
  const Kinematics now = program.kinematics(id, t);
  const auto value = [&](Time when) { return std::get<Vec3>(program.read(Target{id, fn::position}, when)); };
  CommandOutcome c{now.track_to_world, now.position - transform_vector(now.track_to_world, value(t)), {}};
  const Object& o = compiled.document.scene().objects[id.index];
  if (!let_go_at(o, t) && !o.find(fn::motion)) return c;
  Asking asking;
  const std::uint32_t node = compiled.node_of[id.index];
  // The steps of environments have no speed.
  const Mat4 around = linear_part(placement(compiled, node, t, asking).around);
  const auto place = [&](Time when) { return translation_of(placement(compiled, node, when, asking).world); };
  const auto speed = [&](int side) {
    const auto beside = [&](int steps) { return Time{t.flicks + side * steps * (flicks_per_second / 2000)}; };
    const auto slope = [&](auto&& f) {  // exact for cubics
      return side * 2000.0 / 6 * (18.0 * f(beside(1)) - 11.0 * f(t) - 9.0 * f(beside(2)) + 2.0 * f(beside(3)));
    };
    return transform_vector(around, slope(place)) - transform_vector(now.track_to_world, slope(value));
  };
  c.speed = speed(-1) - speed(1);
  return c;
}

// Returns the program of the same objects with only their own tracks: filters, layers and obstacles act on a fall, too.
Program bare(const Scene& s, const std::vector<ObjectId>& things, const Program& program) {
  Scene plain = s;
  bool any = false;
  for (const ObjectId id : things) {
    const auto adds = [](const Slot& slot) {
      return slot.function == fn::obstacles || (slot.function == fn::position && (slot.layer || !slot.filters.empty()));
    };
    if (const auto& slots = s.objects[id.index].slots; std::none_of(slots.begin(), slots.end(), adds)) continue;
    any = true;
    auto& slots = plain.objects.edit(id.index).slots;
    std::erase_if(slots, [](const Slot& slot) {
      return slot.function == fn::obstacles || (slot.function == fn::position && slot.layer);
    });
    for (Slot& slot : slots)
      if (slot.function == fn::position) slot.filters.clear();
  }
  return any ? Program::compile(Document(std::make_shared<const Scene>(std::move(plain)))) : program;
}

// Returns the speed of the object's own tracks. If a track is constant after the time, as after its last event,
// returns the speed just before it.
Vec3 pace(const Program& own, const Scene& s, ObjectId id, Time t) {
  Asking asking;
  const auto rate = [&](bool coming) {
    const auto v = own.compiled().velocity(id.index, fn::position, t, asking, coming);
    return v ? std::get<Vec3>(*v) : Vec3{};
  };
  const Slot* slot = s.objects[id.index].find(fn::position);
  const Vec3 came = rate(true);
  Vec3 goes = rate(false);
  const double nothing = 1e-9 * (1 + length(came));
  if (slot && (!slot->components.empty() || !slot->velocity.components.empty())) {
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(goes[axis]) <= nothing) goes[axis] = came[axis];
    return goes;
  }
  return length(goes) <= nothing ? came : goes;
}

// Ends velocities from `from` on, so that the fall takes over, and erases their events up to `until`.
void end_reign(Scene& s, ObjectId id, Time from, Time until) {
  for (int axis = 0; axis < 3; ++axis) {
    Target rate{id, fn::position, axis};
    rate.velocity = true;
    const Slot* slot = s.objects[id.index].find(fn::position);
    if (!slot || (slot->velocity.track->events.empty() && slot->velocity.components.empty())) return;
    Track* track = edit_track(s, rate);
    track->events.erase(from, until);
    Event release;
    release.time = from;
    release.release = true;
    track->events.put(std::move(release));
  }
}

// Ends the fall where something takes hold of the object.
FallLaws until_caught(const Object& o, Time start, FallLaws laws) {
  for (const AttachmentSpan& a : attachments(o)) {
    if (a.from <= start || (!a.computed && a.to.kind < AttachmentKind::hang)) continue;
    laws.delay = std::min(laws.delay, a.from - start);
    laws.length = std::min(laws.length, std::max(a.from - start - laws.delay, Time{1}));
  }
  return laws;
}

// Returns whether the segment has the form that `fall` writes: hermite, and a parabola.
bool falls(const Event& from, const Event& to) {
  if (from.twerper != Twerper::hermite || !from.detail->tangent_out || !to.detail->tangent_in) return false;
  const auto number = [](const Value& v) { return std::get_if<double>(&v); };
  const double *p = number(from.value), *q = number(to.value);
  const double *out = number(*from.detail->tangent_out), *in = number(*to.detail->tangent_in);
  if (!p || !q || !out || !in) return false;
  const double h = (to.time - from.time).seconds(), way = (*out + *in) / 2 * h;
  return std::abs(*q - *p - way) <= 1e-6 * (1 + std::abs(*p) + (std::abs(*out) + std::abs(*in)) * h);
}

// Returns the number of the author's own events that the fall would replace.
std::size_t displaced(const Scene& s, ObjectId id, Time from, Time until) {
  std::size_t most = 0;
  for (const Track* track : tracks_of(s, {id, fn::position})) {
    std::size_t n = 0;
    std::optional<Event> before;
    track->events.each([&](const Event& e) {
      n += e.time > from && e.time <= until && !(before && falls(*before, e));
      before = e;
    });
    most = std::max(most, n);
  }
  return most;
}

// Reads delay= gravity= ground= bounce= and for LENGTH. `grounded`: whether there is a ground=.
bool laws_of(Command& k, FallLaws& laws, bool& grounded) {
  Cursor& c = k.cursor;
  while (!c.at_line_end()) {
    const char* start = c.at;
    const std::string_view key = c.word();
    if (key == "for") {
      if (!c.lasting(laws.length)) return false;
      if (!(laws.length > Time{}))
        return c.fail(ErrorCode::range, "the length of a fall must be greater than 0", c.since(start));
      continue;
    }
    if (key != "delay" && key != "gravity" && key != "ground" && key != "bounce")
      return c.fail(ErrorCode::name,
                    fmt::format("fall has no option '{}'", key.empty() ? std::string_view(start, 1) : key),
                    c.since(start), "write delay=, gravity=, ground=, bounce= or for LENGTH");
    if (!c.accept('=')) return c.fail_here(ErrorCode::syntax, fmt::format("'=' is missing after {}", key));
    if (key == "delay") {
      if (!c.length(laws.delay)) return false;
      if (laws.delay < Time{}) return c.fail(ErrorCode::range, "a delay must not be negative", c.since(start));
      continue;
    }
    if (key == "ground") {
      grounded = true;
      if (c.accept_word("none")) {
        laws.ground = -std::numeric_limits<double>::infinity();
        continue;
      }
    }
    double& number = key == "gravity" ? laws.gravity : key == "ground" ? laws.ground : laws.bounce;
    if (!values(k).scalar(number, key == "ground" ? Unit::metres : Unit::none)) return false;
    if (key == "gravity" && !(laws.gravity > 0))
      return c.fail(ErrorCode::range, "gravity must be greater than 0", c.since(start));
    if (key == "bounce" && !(laws.bounce >= 0 && laws.bounce < 1))
      return c.fail(ErrorCode::range, "bounce must be at least 0 and less than 1", c.since(start));
  }
  return true;
}

// Fails if the position is not made of plain rows. A fall writes three components: code that computes the whole
// position would not use them, and a track that repeats would repeat the fall and change the values before it.
bool in_plain_rows(Command& k, ObjectId id, std::string_view word) {
  const Object& o = k.scene.objects[id.index];
  const Slot* slot = o.find(fn::position);
  if (!slot) return true;
  const bool whole = slot->components.empty(), set = slot->set && std::holds_alternative<Procedure>(*slot->set);
  const auto tracks = tracks_of(k.scene, {id, fn::position});
  const bool again = std::any_of(tracks.begin(), tracks.end(), [](const Track* t) {
    return t->after >= Extrapolation::cycle || t->before >= Extrapolation::cycle;
  });
  const std::string why =
      whole && (set || has_code(*slot->track))
          ? fmt::format("code computes the whole of {}.position, so its components cannot fall", o.name)
      : again ? fmt::format("the track {}.position repeats, and would repeat the fall", o.name)
              : "";
  return why.empty() || k.cursor.fail(ErrorCode::type, why, word,
                                      fmt::format("to turn it into plain rows: bake {}.position A..{}", o.name,
                                                  format_time(*k.time, k.scene.rate)));
}

// Adds notices about other motions of the falling object, and about one that is below the ground.
void say_company(Command& k, ObjectId id, double height, const FallLaws& laws, std::string_view word) {
  auto& [s, c, time, layer, script] = k;
  const Object& o = s.objects[id.index];
  for (const AttachmentSpan& a : attachments(o))
    if (a.from <= *time && *time < a.until && a.to.parent)
      script.note(Severity::notice,
                  fmt::format("{} still carries {} while it falls", s.objects[a.to.parent.index].name, o.name), word,
                  fmt::format("to let it fall freely: at {} letgo {}", format_time(*time, s.rate), o.name));
  if (const Slot* slot = o.find(fn::motion))
    if (const auto later = slot->track->events.between(*time, {INT64_MAX}); !later.empty() && later.back().time > *time)
      script.note(Severity::notice, fmt::format("{} falls during its motion, so the two are added", o.name), word,
                  "start the fall when the motion has ended");
  if (height < laws.ground)
    script.note(Severity::notice,
                fmt::format("{} is below the ground at y = {}, so it does not fall", o.name, write_number(laws.ground)),
                word, "set the ground by ground=Y");
}

// Replaces the events of one component by those of the fall.
void put_marks(Scene& s, ObjectId id, int axis, const std::vector<FallMark>& marks) {
  Track* track = edit_track(s, Target{id, fn::position, axis});
  EventDetail arrival = end_alone(*track, marks.front().time, component_track_type(Type::vector), true);
  track->events.erase(marks.front().time, marks.back().time);
  for (const FallMark& m : marks) {
    Event e;
    e.time = m.time;
    e.value = m.place[axis];
    e.twerper = Twerper::hermite;
    EventDetail& d = e.detail.edit();
    d.tangent_in = m.in[axis];
    if (&m == &marks.front()) {
      d = std::move(arrival);
      if (!d.tangent_in) d.tangent_in = m.in[axis];
    }
    d.tangent_out = m.out[axis];
    track->events.put(std::move(e));
  }
}

bool fall(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::string_view word;
  std::vector<ObjectId> things;
  if (!time) return c.fail_here(ErrorCode::syntax, "fall needs a time", "as in at 24f fall ball");
  if (!objects(k, word, things)) return false;
  FallLaws laws;
  bool grounded = false;
  if (!laws_of(k, laws, grounded)) return false;
  for (const ObjectId id : things)
    if (!in_plain_rows(k, id, word)) return false;
  const Program program = Program::compile(Document(std::make_shared<const Scene>(s)));
  const Program own = bare(s, things, program);
  for (const ObjectId id : things) {
    const Vec3 p = std::get<Vec3>(own.read({id, fn::position}, *time)), rate = pace(own, s, id, *time);
    const CommandOutcome by = carried(program, id, *time);
    const std::optional<Mat4> inward = inverse(by.to_world);
    if (!inward)
      return c.fail(ErrorCode::range,
                    fmt::format("{} cannot fall, because its parent has a scale of 0", s.objects[id.index].name), word);
    const Vec3 place = by.origin + transform_vector(by.to_world, p);
    const Vec3 speed = transform_vector(by.to_world, rate) + by.speed;
    FallLaws its = laws;  // obstacles stop it, not a height
    if (!grounded && s.objects[id.index].find(fn::obstacles)) its.ground = -std::numeric_limits<double>::infinity();
    say_company(k, id, place.y, its, word);
    std::vector<FallMark> marks = fall_path(*time, place, speed, until_caught(s.objects[id.index], *time, its));
    const double size = std::max(length(place), length(speed));
    for (FallMark& m : marks) {
      m.place = tidied(p + transform_vector(*inward, m.place - place), std::max(size, length(p)));
      m.in = tidied(transform_vector(*inward, m.in), size), m.out = tidied(transform_vector(*inward, m.out), size);
    }
    marks.front().place = p;
    const Time last = marks.back().time;
    if (const std::size_t n = displaced(s, id, *time, last); n > 0)
      script.note(Severity::notice,
                  fmt::format("the fall replaces {} of {}.position", counted(n, "event"), s.objects[id.index].name),
                  word, "set the length of the fall by for LENGTH");
    end_reign(s, id, *time, last);
    for (int axis = 0; axis < 3; ++axis) put_marks(s, id, axis, marks);
    if (auto turned = script.withheld(Severity::warning, "", word))
      script.falls.push_back({id, *time, by.to_world, by.origin, by.speed, *std::move(turned)});
  }
  return true;
}

constexpr Verb fall_rows[] = {
    {"fall", "at TIME fall A [delay=LENGTH] [gravity=9.81] [ground=0|none] [bounce=0] [for LENGTH]",
     "Makes objects fall and bounce, as plain events. `ground` is the height at which the position stops: for a ball "
     "on y = 0, its radius. An object with `obstacles` has no such height unless you set it. `bounce` is the share of "
     "the speed that is left after each bounce. `gravity` is in m/s². For `delay` "
     "the object continues as before, and then drops; `for` is the longest time of the fall, 10 s unless set.",
     "at 24f fall ball", Verb::timed, fall, "OBJECT; delay= gravity= ground= bounce= for…"},
};

// Returns the event that ends the fall inside one of its segments.
Event end_between(const Event& from, const Event& to, Time t) {
  const double h = (to.time - from.time).seconds(), d = (t - from.time).seconds();
  const double out = std::get<double>(*from.detail->tangent_out), in = std::get<double>(*to.detail->tangent_in);
  const double pull = (in - out) / h;
  Event e;
  e.time = t;
  e.value = std::get<double>(from.value) + (out + pull / 2 * d) * d;
  e.twerper = Twerper::hermite;
  e.detail.edit().tangent_in = out + pull * d;
  e.detail.edit().tangent_out = 0.0;
  return e;
}

}  // namespace

bool end_fall(Scene& s, ObjectId id, Time t) {
  const auto now = tracks_of(s, {id, fn::position});
  if (now.size() != 3) return false;
  // The successive segments of all three components; the first contains the time.
  std::array<std::vector<Event>, 3> pieces;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<Event>& out = pieces[axis];
    now[axis]->events.each_between(earliest_time, t, [&](const Event& e) { out.assign(1, e); });
    bool on = !out.empty();
    now[axis]->events.each_between(t + Time{1}, latest_time, [&](const Event& e) {
      if (on = on && falls(out.back(), e); on) out.push_back(e);
    });
  }
  std::size_t length = std::min({pieces[0].size(), pieces[1].size(), pieces[2].size()});
  for (std::size_t i = 0; i < length; ++i)
    if (pieces[0][i].time != pieces[1][i].time || pieces[0][i].time != pieces[2][i].time) length = i;
  if (length < 2) return false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Track* track = edit_track(s, Target{id, fn::position, static_cast<int>(axis)});
    const auto& events = pieces[axis];
    if (events[0].time == t)
      track->events.edit_between(t, t, [](Event& e) { e.detail.edit().tangent_out = 0.0; });
    else
      track->events.put(end_between(events[0], events[1], t));
    track->events.erase(t + Time{1}, events[length - 1].time);
  }
  return true;
}

void say_turned_falls(const Scene& s, Script& script) {
  if (script.falls.empty()) return;
  const Program program = Program::compile(Document(std::make_shared<const Scene>(s)));
  for (Script::Fall& f : script.falls) {
    if (!find_object(s, f.object)) continue;
    const CommandOutcome now = carried(program, f.object, f.time);
    double off = std::max(length(now.origin - f.origin), length(now.speed - f.speed));
    for (int i = 0; i < 16; ++i) off = std::max(off, std::abs(now.to_world.m[i] - f.to_world.m[i]));
    if (off <= 1e-6 * (1 + length(f.origin) + length(f.speed))) continue;
    const std::string& name = s.objects[f.object.index].name;
    f.turned.what.message =
        fmt::format("a later line changes the parent of {} at {}, so its fall turns or moves with the parent", name,
                    format_time(f.time, s.rate));
    f.turned.what.hint = "write the fall below that line";
    script.diagnostics.push_back(std::move(f.turned));
  }
  script.falls.clear();
}

std::span<const Verb> fall_verbs() { return fall_rows; }

}  // namespace betwixt
