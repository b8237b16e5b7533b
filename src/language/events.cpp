// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands that write values and events.
#include <fmt/format.h>

#include <algorithm>

#include "base/names.h"
#include "language/reader.h"
#include "procedure/lua.h"
#include "track/curve.h"

namespace betwixt {
namespace {

// Twerpers, and what else may stand behind a value: for near misses.
std::vector<std::string_view> twerper_words(const Scene& s) {
  std::vector<std::string_view> words(twerper_names.begin() + 1, twerper_names.end());
  for (const char* w : {"release", "ease-in", "ease-out", "tangent", "tangent-in", "tangent-out", "cut"})
    words.push_back(w);
  for (const NamedProcedure& p : *s.procedures)
    if (p.role == Role::twerper) words.push_back(p.name);
  return words;
}

// Would an aim's separate numbers meet an object?
bool mixes_aims(const Scene& s, const Target& t, const Value& v) {
  const Slot* slot = s.objects[t.object.index].find(t.function);
  if (!slot) return false;
  if (t.component < 0) return !slot->components.empty() && std::holds_alternative<ObjectId>(v);
  bool any = false;
  slot->track->events.each(
      [&](const Event& e) { any = any || (!e.keep && std::holds_alternative<ObjectId>(e.value)); });
  return any;
}

}  // namespace

// A twerper's word and what stands in brackets behind it.
bool Reader::twerper(Cursor& c, const Selected& to, Twerper& out, std::array<double, 4>& bezier) {
  c.space();
  const std::string_view w = c.word();
  const auto at = std::find(twerper_names.begin() + 1, twerper_names.end(), w);
  const auto& own = *s.procedures;
  const auto mine = std::find_if(own.begin(), own.end(),
                                 [&](const NamedProcedure& p) { return p.name == w && p.role == Role::twerper; });
  if (at == twerper_names.end() && mine != own.end()) {
    out = static_cast<Twerper>(first_own_twerper + (mine - own.begin()));
    std::string why;
    return fits(out, to.type(), &why) || c.fail(Code::type, why, w);
  }
  if (at == twerper_names.end()) {
    if (w.empty()) return c.fail_here(Code::name, "a twerper is missing here");
    const std::string near = did_you_mean(w, twerper_words(s));
    return c.fail(Code::name, fmt::format("there is no twerper '{}'", w.substr(0, 40)), w,
                  near.empty() && is_name(w) ? "where it is a plug-in's: --load PLUGIN" : near);
  }
  out = static_cast<Twerper>(at - twerper_names.begin());
  std::string why;
  if (!fits(out, to.type(), &why))
    return c.fail(Code::type, why, w,
                  to.type() == Type::text ? "letters turn into others by geometry: at 24f A.geometry shape(B) …" : "");
  c.space();
  const bool bracket = c.peek() == '(';
  if (out == Twerper::bezier) {
    const char* start = c.at;
    if (!bracket)
      return c.fail(Code::syntax, "bezier needs its two control points", w, "as in bezier(0.25 0.1 0.25 1)");
    if (!c.open()) return false;
    for (double& v : bezier)
      if (!c.number(v)) return false;
    if (!c.close()) return false;
    if (bezier[0] < 0 || bezier[0] > 1 || bezier[2] < 0 || bezier[2] > 1)
      return c.fail(Code::range, "the x of a bezier's control points is from 0 to 1", c.since(start));
  } else if (bracket) {
    return c.fail_here(Code::syntax, fmt::format("'{}' takes nothing in brackets", w));
  }
  return true;
}

// tangent=V, tangent-in=V, tangent-out=V: where hermite comes from and goes, per second.
bool Reader::tangent(Cursor& c, const Selected& to, std::string_view key, Event& e) {
  if (!c.accept('=')) return c.fail_here(Code::syntax, fmt::format("'=' is missing behind {}", key));
  const Type type = to.type();
  if (type != Type::scalar && type != Type::angle && type != Type::pair && type != Type::vector &&
      type != Type::rotation)
    return c.fail(Code::type, fmt::format("{} has no tangents", to_string(type)), key);
  const FunctionSpec free = unbounded(*to.spec);  // a speed may be of any size
  Value v;
  c.space();
  const char* start = c.at;
  if (!values(c).value(free, to.component, v)) return false;
  if (std::holds_alternative<Quat>(v))
    return c.fail(Code::type, "tangents of orientations mean nothing", c.since(start));
  if (key != "tangent-out") e.detail.edit().tangent_in = v;
  if (key != "tangent-in") e.detail.edit().tangent_out = v;
  return true;
}

// A value per second: angles of a rotation one by one, or the turning about an axis.
bool Reader::rate_of_change(Cursor& c, const Selected& to, Value& out) {
  const Type type = to.type();
  if (type != Type::rotation && type != Type::orientation)
    return values(c).value(unbounded(*to.spec), to.component, out);
  c.space();
  Vec3 v;
  if (c.peek_word() == "axis") {
    double angle = 0;
    c.word();
    if (!c.open()) return false;
    c.space();
    if (c.peek() == '(' || c.peek() == 'x' || c.peek() == 'y' || c.peek() == 'z') {
      if (!values(c).axis(v)) return false;
    } else {
      const char* start = c.at;
      for (int i = 0; i < 3; ++i)
        if (!c.number(v[i])) return false;
      if (v == Vec3{}) return c.fail(Code::range, "an axis needs a direction; 0 0 0 has none", c.since(start));
    }
    if (!c.angle(angle) || !c.close()) return false;
    out = angle * normalize(v);
    return true;
  }
  if (c.peek_word() == "quat")
    return c.fail_here(Code::type, "a turning speed is wanted here, not an orientation", "as in axis(0 1 0, 90deg)");
  const bool spin = c.accept_word("spin");  // about the fixed axes, as one vector
  if (!spin && c.peek() != '(' && !c.accept_word("euler"))
    return c.fail_here(Code::type, "a turning speed is wanted here", "as in axis(0 1 0, 90deg) or euler(0 90deg 0)");
  if (!c.open()) return false;
  for (int i = 0; i < 3; ++i)
    if (!c.angle(v[i])) return false;
  if (!c.close()) return false;
  out = spin || type == Type::orientation ? Value(v) : Value(Angles{v});
  return true;
}

// = "…": a value that code computes.
bool Reader::computed(Cursor& c, const Selected& to, Value& out) {
  if (!c.accept('=')) return c.fail_here(Code::syntax, "'=' is missing here");
  c.space();
  const char* start = c.at;
  if (c.peek() != '"') {
    const auto line = static_cast<std::size_t>(line_end(start, c.end) - start);
    return c.fail_here(
        Code::syntax, "behind '=' stands a procedure, in quotes",
        fmt::format("a plain value stands without '=': {}", std::string_view(start, std::min<std::size_t>(line, 60))));
  }
  std::string source;
  if (!c.text(source)) return false;
  const std::string_view about(start, static_cast<std::size_t>(c.at - start));
  switch (to.type()) {
    case Type::points:
    case Type::names:
    case Type::attachment:
    case Type::transform:
    case Type::motion:
      return c.fail(Code::type, fmt::format("{} cannot be computed", to_string(to.type())), about);
    default:
      break;
  }
  if (to.spec->name == "file" || !to.spec->words.empty() || to.spec->name == "texture" || to.spec->name == "font")
    return c.fail(Code::type, fmt::format("{} cannot be computed", to.spec->name), about);
  auto code = make_lua(Role::value, std::move(source));
  if (!code) return c.fail(code.error().code, code.error().message, about, code.error().hint);
  out = Procedure{*std::move(code)};
  return true;
}

// What stands behind a row's time: VALUE [cut VALUE] [TWERPER] [ease-in=L] [ease-out=L] [tangent…=V], or keep TWERPER.
bool Reader::event(Cursor& c, const Selected& to, Time time) {
  if (to.type() == Type::motion) return moving(c, to, time, std::nullopt);
  Event e;
  e.time = time;
  c.space();
  const char* value_at = c.at;
  const bool released = to.velocity && c.peek() == 'r' && c.accept_word("release");
  if (released) {
    e.release = true;
    e.value = 0.0;
    if (!finish(c)) return false;
  } else if (c.peek() == '=') {
    if (to.velocity) return c.fail_here(Code::type, "a velocity cannot be computed; compute the value itself");
    if (!computed(c, to, e.value)) return false;
  } else if (to.velocity && c.peek_word() != "keep") {
    if (!rate_of_change(c, to, e.value)) return false;
    c.space();
    if (c.peek() == 'c' && c.accept_word("cut")) {
      e.detail.edit().before = std::move(e.value);
      if (!rate_of_change(c, to, e.value)) return false;
    }
  } else if (c.peek() == 'k' && c.peek_word() == "keep") {
    c.word();
    e.keep = true;
    e.value = 0.0;
  } else {
    if (c.peek_word() == "release" && has_velocity(to.type()))
      return c.fail_here(Code::type, "release ends the reign of a velocity; this is no velocity",
                         fmt::format("as in at 20f {}.velocity release", to.text.substr(0, 60)));
    if (!values(c).value(*to.spec, to.component, e.value, to.targets.empty() ? 0xffff : to.targets[0].function))
      return false;
    c.space();
    if (c.peek() == 'c' && c.accept_word("cut")) {
      Value after;
      if (!values(c).value(*to.spec, to.component, after, to.targets.empty() ? 0xffff : to.targets[0].function))
        return false;
      e.detail.edit().before = std::move(e.value);
      e.value = std::move(after);
    }
  }
  const std::string_view about(value_at, static_cast<std::size_t>(c.at - value_at));
  if (!way(c, to, e)) return false;
  return put(to, std::move(e), c, about);
}

// How an event goes on: [TWERPER] [ease-in=L] [ease-out=L] [tangent…=V].
bool Reader::way(Cursor& c, const Selected& to, Event& e) {
  bool chosen = false;
  while (!c.at_line_end()) {
    const char* start = c.at;
    const std::string_view w = c.peek_word();
    if (w == "ease-in" || w == "ease-out") {
      c.word();
      if (!c.accept('='))
        return c.fail_here(Code::syntax, fmt::format("'=' is missing behind {}", w), fmt::format("as in {}=4f", w));
      Time length;
      if (!c.length(length)) return false;
      if (length < Time{}) return c.fail(Code::range, "an ease cannot be shorter than nothing", c.since(start));
      (w == "ease-in" ? e.detail.edit().ease_in : e.detail.edit().ease_out) = length;
      continue;
    }
    if (w == "tangent" || w == "tangent-in" || w == "tangent-out") {
      c.word();
      if (!tangent(c, to, w, e)) return false;
      continue;
    }
    if (chosen)
      return c.fail_here(Code::syntax,
                         fmt::format("'{}' is not expected here: this event has its twerper", w.substr(0, 40)));
    std::array<double, 4> bezier{0.25, 0.1, 0.25, 1};
    if (!twerper(c, to, e.twerper, bezier)) return false;
    if (e.twerper == Twerper::bezier) e.detail.edit().bezier = bezier;
    chosen = true;
  }
  return !e.keep || chosen || c.fail_here(Code::syntax, "keep needs a twerper, as in keep linear");
}

bool Reader::put(const Selected& to, Event event, Cursor& c, std::string_view about) {
  if (to.type() == Type::attachment && !event.keep) {
    std::vector<ObjectId> children;
    for (const Target& t : to.targets) children.push_back(t.object);
    return attachment(c, children, std::get<Attachment>(event.value), event.time, about);
  }
  if (event.release) {
    const auto before = diagnostics_.size();
    note(Severity::notice,
         fmt::format("no velocity reigns at {}: there is nothing to release",
                     format_time(event.time, Document(std::make_shared<const Scene>(s)))),
         about);
    if (diagnostics_.size() > before && releases_.size() < 10'000) {
      for (const Target& t : to.targets) releases_.push_back({t, event.time, diagnostics_.back()});
      diagnostics_.pop_back();
    }
  }
  if (to.velocity)
    for (const Target& t : to.targets) {
      const auto key = std::pair(t.object.index, t.function);
      if (velocities_.contains(key) || velocities_.size() > 10'000) continue;
      const auto before = diagnostics_.size();
      note(Severity::warning, "", about);
      if (diagnostics_.size() == before) continue;
      velocities_.emplace(key, std::move(diagnostics_.back()));
      diagnostics_.pop_back();
    }
  const bool computes = std::holds_alternative<Procedure>(event.value);
  const bool rotation = to.type() == Type::rotation && !event.keep && !to.velocity && !computes;
  for (const Target& t : to.targets) {
    if (to.spec->type == Type::aim && !event.keep && mixes_aims(s, t, event.value))
      return c.fail(Code::type,
                    fmt::format("'{}' cannot hold both objects and separate numbers",
                                Document(std::make_shared<const Scene>(s)).name(t)),
                    about, "write all of it as points (x y z)");
    if (to.velocity) break;
    if (computes && to.component < 0) {
      if (const Slot* slot = s.objects[t.object.index].find(t.function, t.layer); slot && !slot->components.empty())
        return c.fail(Code::type, "its components have tracks of their own: a procedure for the whole finds no place",
                      about, "write one for each component");
    }
    if (!rotation && to.component < 0) break;
    const auto tracks = tracks_of(s, t);
    if (tracks.empty()) continue;
    const Slot* slot = s.objects[t.object.index].find(t.function, t.layer);
    const bool orientation =
        !tracks[0]->events.empty() && std::holds_alternative<Quat>(tracks[0]->events.front().value);
    // Components of an orientation are nothing an animator would know.
    if ((to.component >= 0 && slot->components.empty() && orientation) ||
        (rotation && to.component < 0 && !slot->components.empty() && std::holds_alternative<Quat>(event.value)))
      return c.fail(Code::type,
                    fmt::format("'{}' cannot hold both orientations and separate angles",
                                Document(std::make_shared<const Scene>(s)).name(t)),
                    about, "write all of it as euler(x y z), or all as axis(…) or quat(…)");
    Sheet& sheet = source_.sheet;
    if (rotation && to.component < 0 && !tracks[0]->events.empty() &&
        orientation != std::holds_alternative<Quat>(event.value) && !sheet.warned) {
      note(Severity::warning,
           "this track mixes angles and orientations: all are read as orientations, and whole turns are lost", about,
           "write euler(x y z) for all of them, or axis(…) or quat(…)");
      sheet.warned = true;
    }
  }
  const auto& direct = source_.sheet.tracks;
  if (&to == &source_.sheet.on && !direct.empty()) {
    for (std::size_t i = 1; i < direct.size(); ++i) direct[i]->events.put(event);
    if (direct[0]->events.put(std::move(event)) && source_.sheet.fresh)
      note(Severity::warning, "an earlier row of this sheet has the same time; this one replaces it", about);
    return true;
  }
  for (const Target& t : to.targets) put_event(s, t, event);
  return true;
}

bool Reader::time_or_segment(Cursor& c, Time& from, std::optional<Time>& until) {
  const char* const start = c.at;
  if (!c.time(from)) return false;
  const auto dots = [&](const char* at) { return c.end - at >= 2 && at[0] == '.' && at[1] == '.'; };
  if (!dots(c.at)) {
    const char* const behind = c.at;
    c.space();
    if (dots(c.at)) return c.fail(Code::syntax, "no blank stands in a segment", {c.at, 2}, "as in 1f..24f");
    c.at = behind;
    return true;
  }
  c.at += 2;
  Time to;
  if (!c.time(to)) return false;
  if (to < from) return c.fail(Code::range, "this segment ends before it begins", c.since(start));
  until = to;
  return true;
}

bool Reader::one_time_only(Cursor& c, std::string_view segment) {
  return c.fail(Code::syntax, "one time stands here: only motions have a segment", segment,
                "as in wheel.motion and a row 1f..24f T(6 0)");
}

bool Reader::at(Cursor& c) {
  if (timed_) return c.fail_here(Code::syntax, "one 'at' is enough");
  std::optional<Time> until;
  c.space();
  const char* const times = c.at;
  if (!time_or_segment(c, time_, until)) return false;
  const std::string_view segment = c.since(times);
  timed_ = true;
  c.space();
  const char* start = c.at;
  const std::string_view w = c.word();
  static constexpr std::string_view timed_verbs[] = {"note",   "look",   "show",   "hide", "couple", "hang",
                                                     "attach", "detach", "letgo",  "fall", "on",     "animate",
                                                     "halt",   "kill",   "cancel", "make", "edit",   "delete"};
  if (w.empty()) return c.fail_here(Code::syntax, "a target or a command is missing here");
  if (w.find('.') != std::string_view::npos) {
    Selected to;
    if (!targets(c, w, to)) return false;
    if (!to.spec) {
      c.at = after_line(start);
      if (c.at > start && c.at[-1] == '\n') --c.at;
      return true;
    }
    if (until && to.type() == Type::motion) return moving(c, to, time_, until);
    if (until) return one_time_only(c, segment);
    return event(c, to, time_);
  }
  if (until) return one_time_only(c, segment);
  c.at = start;
  if (w == "set")
    return c.fail(Code::syntax, "'set' has no time; with 'at', write the target and its value", w,
                  "as in at 24f ball.color red");
  if (std::find(std::begin(timed_verbs), std::end(timed_verbs), w) == std::end(timed_verbs)) {
    for (const Verb& v : verbs())
      if (v.word == w) return c.fail(Code::syntax, fmt::format("'{}' has no time: it holds for the whole film", w), w);
    if (const auto why = not_yet(w); !why.empty()) return c.fail(Code::name, fmt::format("'{}' {}", w, why), w);
    const std::string near = did_you_mean(w, {std::begin(timed_verbs), std::end(timed_verbs)});
    return c.fail(Code::syntax, fmt::format("a target or a command is wanted here, not '{}'", w.substr(0, 40)), w,
                  near.empty() ? "as in at 24f ball.position (1 2 3)" : near);
  }
  return command(c);
}

bool Reader::set(Cursor& c) {
  c.space();
  const std::string_view w = c.word();
  Selected to;
  if (!targets(c, w, to)) return false;
  if (!to.spec) {
    c.at = after_line(w.data());
    if (c.at > w.data() && c.at[-1] == '\n') --c.at;
    return true;
  }
  Value v;
  c.space();
  if (to.velocity)
    return c.fail(Code::type, "a velocity holds from a time on", w, fmt::format("as in at 1f {} …", w.substr(0, 60)));
  if (c.peek() == '=') {
    if (to.component >= 0)
      return c.fail_here(Code::type, "the whole value is set, not one component of it, when code computes it",
                         fmt::format("at 1f {} = \"…\" computes one component", w.substr(0, 60)));
    if (!computed(c, to, v) || !finish(c)) return false;
    for (const Target& t : to.targets) set_value(s, t, v);
    return true;
  }
  if (to.type() == Type::motion)
    return c.fail(Code::type, "a motion is not set: it takes a segment of time", w,
                  fmt::format("as in at 1f..24f {} T(6 0)", w.substr(0, 60)));
  if (to.type() == Type::attachment)
    return c.fail(Code::type, "an attachment is not set", w, "couple A to B, attach A to B, hang A on B, detach A");
  if (!values(c).value(*to.spec, to.component, v, to.targets[0].function) || !finish(c)) return false;
  for (const Target& t : to.targets) {
    const Slot* slot = s.objects[t.object.index].find(t.function, t.layer);
    if (t.component >= 0 && slot && slot->set && std::holds_alternative<Procedure>(*slot->set))
      return c.fail(Code::type, "code computes the whole of it; it has no separate components", w);
    if (t.component >= 0 && slot && slot->set && std::holds_alternative<Quat>(*slot->set))
      return c.fail(Code::type, "an orientation has no separate angles", w,
                    "set the whole of it as euler(x y z) first");
  }
  for (const Target& t : to.targets) {
    // A live host puts something into an environment as it is now, not as it was before (R-E9).
    if (!options_.now || to.type() != Type::names) {
      set_value(s, t, v);
      continue;
    }
    Event e;
    e.time = *options_.now;
    e.value = v;
    put_event(s, t, std::move(e));
  }
  return true;
}

bool Reader::global_twerper(Cursor& c) {
  c.space();
  const std::string_view w = c.word();
  Selected to;
  if (!targets(c, w, to)) return false;
  if (!to.spec) to.spec = &built_in_functions()[fn::position];  // the rest is still read
  Twerper chosen = Twerper::unset;
  std::array<double, 4> bezier{0.25, 0.1, 0.25, 1};
  if (!c.accept_word("none") && !twerper(c, to, chosen, bezier)) return false;
  std::optional<bool> srgb;
  if (!c.at_line_end()) {
    const std::string_view key = c.peek_word();
    if (key != "in") return finish(c);
    c.word();
    if (!c.accept('=')) return c.fail_here(Code::syntax, "'=' is missing behind in");
    c.space();
    const std::string_view how = c.word();
    if (how != "light" && how != "srgb") return c.fail(Code::syntax, "colours blend in=light or in=srgb", how);
    if (to.type() != Type::color)
      return c.fail(Code::type, fmt::format("only colours blend in light or srgb; this is {}", to_string(to.type())),
                    key);
    srgb = how == "srgb";
  }
  if (!finish(c)) return false;
  for (const Target& t : to.targets)
    for (Track* track : edit_tracks(s, t)) {
      track->global = chosen;
      track->bezier = bezier;
      if (srgb) track->srgb = *srgb;
    }
  return true;
}

bool Reader::extend(Cursor& c) {
  c.space();
  const std::string_view w = c.word();
  Selected to;
  if (!targets(c, w, to)) return false;
  c.space();
  const std::string_view how = c.word();
  const auto at = std::find(extend_names.begin(), extend_names.end(), how);
  if (at == extend_names.end())
    return c.fail(Code::syntax,
                  how.empty() ? "hold, linear, cycle or bounce is missing here"
                              : fmt::format("'{}' is no way to extend a track", how.substr(0, 40)),
                  how, did_you_mean(how, {extend_names.begin(), extend_names.end()}));
  bool before = true, after = true;
  if (c.accept_word("before"))
    after = false;
  else if (c.accept_word("after"))
    before = false;
  if (!finish(c)) return false;
  const auto extend = static_cast<Extend>(at - extend_names.begin());
  for (const Target& t : to.targets)
    for (Track* track : edit_tracks(s, t)) {
      if (before) track->before = extend;
      if (after) track->after = extend;
    }
  return true;
}

bool Reader::note_command(Cursor& c) {
  if (!timed_) return c.fail_here(Code::syntax, "a note needs a time", "as in at 24f note \"…\"");
  std::string text;
  if (!c.text(text) || !finish(c)) return false;
  auto& notes = s.notes.edit();
  const auto at =
      std::upper_bound(notes.begin(), notes.end(), time_, [](Time t, const auto& n) { return t < n.first; });
  notes.insert(at, {time_, std::move(text)});
  return true;
}

bool Reader::notes(Cursor& c) {
  c.space();
  const std::string_view w = c.word();
  if (w != "on" && w != "off") return c.fail(Code::syntax, "notes are on or off", w);
  if (!finish(c)) return false;
  s.notes_shown = w == "on";
  return true;
}

bool Reader::look(Cursor& c) {
  if (!c.accept_word("through")) return c.fail_here(Code::syntax, "'through' is missing here");
  ObjectId id;
  c.space();
  const std::string_view w = c.peek_word();
  if (!values(c).object(id)) return false;
  const Kind kind = s.objects[id.index].kind;
  if (kind != Kind::camera)
    return c.fail(Code::type, fmt::format("'{}' is a {}, not a camera", w, kind_names[static_cast<std::size_t>(kind)]),
                  w);
  if (!finish(c)) return false;
  s.cuts.edit()[timed_ ? time_ : Time{INT64_MIN}] = id;
  return true;
}

bool Reader::display(Cursor& c, bool on) {
  std::string_view word;
  std::vector<ObjectId> found;
  if (!objects(c, word, found) || !finish(c)) return false;
  for (ObjectId id : found) {
    const Target t{id, fn::display, -1};
    if (!timed_) {
      set_value(s, t, on);
      continue;
    }
    Event e;
    e.time = time_;
    e.value = on;
    put_event(s, t, std::move(e));
  }
  return true;
}

}  // namespace betwixt
