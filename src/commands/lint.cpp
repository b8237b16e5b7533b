// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "commands/lint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/names.h"
#include "commands/command.h"
#include "exchange/geometry.h"
#include "program/compiled.h"
#include "scene/names.h"
#include "scene/rig.h"
#include "scene/shape_blend.h"
#include "syntax/tokens.h"
#include "track/swing.h"

namespace betwixt {
namespace {

using Remarks = std::vector<Remark>;

// The most places to search for; more warnings would not help the author.
constexpr std::size_t most_places = 200;

void say(Remarks& out, const Subject& about, ErrorCode code, std::string what, Hint hint = {},
         Severity severity = Severity::notice) {
  out.push_back({{severity, fail(code, std::move(what), std::move(hint)), {}, 0}, about});
}

Subject of(ObjectId id, FunctionId f, std::optional<Time> time = std::nullopt) { return {Target{id, f, -1}, time}; }

// Warns, once for each track, about shapes that should blend but can only step.
void look_at_blends(const Scene& s, Remarks& out) {
  Program program;
  bool compiled = false;
  for (std::size_t i = 0; i < s.objects.size(); ++i) {
    const Object& o = s.objects[i];
    const Slot* slot = o.removed ? nullptr : o.find(fn::geometry);
    if (!slot || slot->track->events.size() < 2) continue;
    const Event* last = nullptr;
    bool said = false;
    slot->track->events.each([&](const Event& e) {
      const Event* from = last;
      last = &e;
      if (!from || said || e.keep || from->keep) return;
      const Twerper t = slot->track->global != Twerper::unset ? slot->track->global : from->twerper;
      if (t == Twerper::unset || t == Twerper::hold || tween(s, t)) return;
      if (!compiled) program = Program::compile(Document(std::make_shared<const Scene>(s))), compiled = true;
      const auto& code = program.compiled();
      if (!std::holds_alternative<ObjectId>(from->value) || !std::holds_alternative<ObjectId>(e.value)) return;
      const auto shape = [&](const Value& v, Time time) {
        const ObjectId id = std::get<ObjectId>(v);
        Asking asking;
        return code.shape(find_object(s, id) ? id.index : static_cast<std::uint32_t>(i), time, nullptr, asking);
      };
      std::string why;
      const Shape a = shape(from->value, from->time), b = shape(e.value, e.time);
      const bool blends = can_blend(a, b, &why), curve = !is_own(t) && row_of(t).cubics != nullptr;
      if (blends && (!curve || one_topology(a, b))) return;
      said = true;
      if (blends)
        return say(out, of({static_cast<std::uint32_t>(i)}, fn::geometry, from->time), ErrorCode::type,
                   fmt::format("{}.geometry blends linearly from {} to {}: {} needs shapes of one kind with the same "
                               "number of points, and no texts",
                               o.name, format_time(from->time, s.rate), format_time(e.time, s.rate), name_of(t)));
      say(out, of({static_cast<std::uint32_t>(i)}, fn::geometry, from->time), ErrorCode::type,
          fmt::format("{}.geometry cannot blend from {} to {}: {}; it jumps instead", o.name,
                      format_time(from->time, s.rate), format_time(e.time, s.rate), why),
          {}, Severity::warning);
    });
  }
}

// Warns, at the first one, about notes that are never visible.
void look_at_notes(const Scene& s, Remarks& out) {
  if (!s.range || s.notes->empty() || !s.notes_shown) return;
  const auto outside = [&](const auto& note) { return note.first < s.range->first || note.first > s.range->second; };
  const auto first = std::find_if(s.notes->begin(), s.notes->end(), outside);
  if (first == s.notes->end()) return;
  say(out, {{}, first->first, true}, ErrorCode::range,
      fmt::format("the note at {} is outside the range from {} to {}, so it never shows",
                  format_time(first->first, s.rate), format_time(s.range->first, s.rate),
                  format_time(s.range->second, s.rate)));
}

// Warns, once for each track, about tangents without a `hermite` and handles without an `fcurve`.
void look_at_tangents(const Scene& s, ObjectId id, const Slot& slot, const Strand& strand, Remarks& out) {
  const auto look = [&](const Track& track, int component) {
    const Event* before = nullptr;
    bool said = false;
    track.events.each([&](const Event& e) {
      const auto asks = [&](const Event* from, bool handle) {
        if (!from) return false;
        const Twerper t = track.global != Twerper::unset ? track.global : from->twerper;
        return handle ? !is_own(t) && row_of(t).numbers : t == Twerper::hermite;
      };
      const EventDetail& d = *e.detail;
      const bool tangents = (d.tangent_out && !d.handle_out) || (d.tangent_in && !d.handle_in);
      const bool handles = (d.handle_out && !asks(&e, true)) || (d.handle_in && !asks(before, true));
      const bool idle = handles || (tangents && !asks(&e, false) && !asks(before, false));
      before = &e;
      if (!idle || std::exchange(said, true)) return;
      Target t{id, slot.function, component};
      t.layer = slot.layer, t.velocity = &strand != &slot;
      say(out, {t, e.time}, ErrorCode::type,
          fmt::format("{} has a {} at {} that its twerper does not use", target_name(s, t),
                      handles ? "handle" : "tangent", format_time(e.time, s.rate)),
          handles ? "only fcurve uses handles, before and after an event"
                  : "only hermite uses tangents, before and after an event");
    });
  };
  look(*strand.track, -1);
  for (std::size_t i = 0; i < strand.components.size(); ++i) look(*strand.components[i], static_cast<int>(i));
}

// Warns about components with events of their own if code computes the whole value: their events replace the code's
// values.
void look_at_code(const Scene& s, ObjectId id, const Slot& slot, Remarks& out) {
  if (!slot.set || !std::holds_alternative<Procedure>(*slot.set)) return;
  for (std::size_t i = 0; i < slot.components.size(); ++i) {
    if (slot.components[i]->events.empty()) continue;
    Target whole{id, slot.function, -1}, part{id, slot.function, static_cast<int>(i)};
    whole.layer = part.layer = slot.layer;
    say(out, {part, std::nullopt}, ErrorCode::type,
        fmt::format("{} has events of its own, so the code of {} has no effect on it", target_name(s, part),
                    target_name(s, whole)));
  }
}

// Warns, once for each, about objects that are let go while nothing holds them.
void look_at_letting_go(const Scene& s, ObjectId id, const Object& o, Remarks& out) {
  bool held = false, said = false;
  for (const AttachmentSpan& a : attachments(o)) {
    const bool holds = a.computed || a.to.kind >= AttachmentKind::hang;
    if (!holds && !held && a.from != earliest_time && !std::exchange(said, true))
      say(out, of(id, fn::attachment, a.from), ErrorCode::type,
          fmt::format("{} is released by letgo at {}, but nothing holds it then", o.name, format_time(a.from, s.rate)));
    held = holds;
  }
}

// Warns about lens openings of orthographic cameras, which have no lens.
void look_at_lens(ObjectId id, const Object& o, Remarks& out) {
  if (o.kind == Kind::camera && o.find(fn::f_stop) && o.find(fn::camera_height))
    say(out, of(id, fn::f_stop), ErrorCode::type,
        fmt::format("{} has a height and thus no perspective, so its f-stop has no effect", o.name),
        "use lens or fov instead of height");
}

// Warns about joints that move no vertices: their number differs from the file's, or no object has that name.
void look_at_joints(const Scene& s, ObjectId id, const Object& o, Remarks& out) {
  const Slot *said = o.find(fn::joints), *file = o.find(fn::file);
  const auto* names = said && said->set ? std::get_if<Names>(&*said->set) : nullptr;
  const auto* path = file && file->set ? std::get_if<Text>(&*file->set) : nullptr;
  if (!names || !path || (*names)->empty()) return;
  const auto mesh = s.meshes->find(**path);
  const std::size_t wanted = mesh == s.meshes->end() || !mesh->second->rig ? 0 : mesh->second->rig->inverse_bind.size();
  if (wanted != (*names)->size())
    return say(out, of(id, fn::joints), ErrorCode::range,
               wanted == 0 ? fmt::format("{} has joints, but its mesh has no skin", o.name)
                           : fmt::format("{} has {} joints, but the skin of its mesh needs {}", o.name,
                                         (*names)->size(), wanted));
  for (const std::string& name : **names)
    if (!s.names.find(name))
      return say(out, of(id, fn::joints), ErrorCode::name,
                 fmt::format("{} follows '{}', which does not exist, so it stays where it is", o.name, name));
}

// Warns about obstacles that do not exist or have no shape, and about an object that has none and cannot touch them.
void look_at_obstacles(const Scene& s, ObjectId id, const Object& o, Remarks& out) {
  const Slot* said = o.find(fn::obstacles);
  if (!said) return;
  const auto warn = [&](const std::string& what) { say(out, of(id, fn::obstacles), ErrorCode::name, what); };
  if (!row_of(o.kind).extent)
    return warn(fmt::format("{} has obstacles, but no shape of its own that could touch them", o.name));
  std::set<std::string> known;
  const auto look = [&](const Value& v) {
    const auto* names = std::get_if<Names>(&v);
    for (const std::string& name : names ? **names : std::vector<std::string>()) {
      if (!known.insert(name).second) continue;
      const auto all = select(s, name);
      if (all.empty()) warn(fmt::format("'{}' is an obstacle of {}, but does not exist", name, o.name));
      for (const ObjectId one : all)
        if (!row_of(s.objects[one.index].kind).extent)
          warn(fmt::format("{} has no shape, so it is no obstacle of {}", s.objects[one.index].name, o.name));
    }
  };
  if (said->set) look(*said->set);
  said->track->events.each([&](const Event& e) { look(e.value); });
}

// Calls f for each name that the masks of a group ever have.
template <class F>
void each_mask(const Object& o, const F& f) {
  const Slot* said = o.find(fn::layer_mask);
  if (!said) return;
  const auto look = [&](const Value& v) {
    if (const auto* names = std::get_if<Names>(&v)) std::for_each((*names)->begin(), (*names)->end(), f);
  };
  if (said->set) look(*said->set);
  said->track->events.each([&](const Event& e) { look(e.value); });
}

// Warns about masks that do not exist, or that need the group which they mask.
void look_at_masks(const Scene& s, ObjectId id, const Object& o, Remarks& out) {
  std::set<std::string> known;
  each_mask(o, [&](const std::string& name) {
    if (!known.insert(name).second) return;
    const ObjectId mask = s.names.find(name);
    if (!mask)
      return say(out, of(id, fn::layer_mask), ErrorCode::name,
                 fmt::format("'{}' is a mask of {}, but does not exist", name, o.name));
    bool back = mask == id;
    each_mask(s.objects[mask.index], [&](const std::string& other) { back = back || s.names.find(other) == id; });
    if (back)
      say(out, of(id, fn::layer_mask), ErrorCode::range,
          fmt::format("{} and {} mask each other, so this mask of {} does not count", o.name, name, name));
  });
}

// Warns about a velocity-space that no velocity of the whole position uses.
void look_at_velocity_space(ObjectId id, const Object& o, Remarks& out) {
  const Slot* position = o.find(fn::velocity_space) ? o.find(fn::position) : nullptr;
  if (position && !position->velocity.components.empty())
    say(out, of(id, fn::velocity_space), ErrorCode::type,
        fmt::format("{} has velocities of components, which velocity-space does not turn", o.name),
        fmt::format("write the whole velocity, as in at 1f {}.position.velocity (2 0 0)", o.name));
}

// Returns the track of a function if only its events make the value, or nullptr.
const Track* plain_track(const Slot& slot, int component) {
  if (slot.layer || !slot.filters.empty()) return nullptr;
  return component < 0 ? &*slot.track : &*slot.components[static_cast<std::size_t>(component)];
}

// Warns, once for each track at the worst place, about tracks with equal values at two events and a large swing in
// between.
void look_at_swings(const Scene& s, ObjectId id, const Slot& slot, Remarks& out) {
  const Type whole = spec_of(s, slot.function).type;
  const int parts = static_cast<int>(slot.components.size());
  for (int part = parts > 0 ? 0 : -1; part < parts; ++part) {
    const Track* track = plain_track(slot, part);
    const Type type = part < 0 ? whole : component_track_type(whole);
    const auto swing = track ? widest_swing(*track, type, part >= 0, s.rate) : std::nullopt;
    if (!swing) continue;
    Target target{id, slot.function, part}, number = target;
    const bool single = part < 0 && component_count(whole) > 0;
    if (single) number.component = swing->number;
    const double unit = row_of(whole).angles ? pi / 180 : 1;
    const auto shown = [&](double v) { return fmt::format("{:.4g}{}", v / unit, row_of(whole).angles ? "deg" : ""); };
    say(out, {target, swing->from}, ErrorCode::range,
        fmt::format("{} overshoots to {} at {}: it is {} at both {} and {}", target_name(s, number),
                    shown(swing->value), format_time(swing->at, s.rate), shown(swing->rest),
                    format_time(swing->from, s.rate), format_time(swing->to, s.rate)),
        fmt::format("auto never overshoots: write it after the value at {}, or twerper {} auto",
                    format_time(swing->from, s.rate), target_name(s, target)));
  }
}

// Warns, once for each track, about a bspline beside another twerper. A bspline only comes near its events, while the
// other goes through them, so that the value jumps.
void look_at_torn_splines(const Scene& s, ObjectId id, const Slot& slot, Remarks& out) {
  const auto look = [&](const Track& track, int component) {
    if (track.global != Twerper::unset || track.events.size() < 3) return;
    const Event *before = nullptr, *torn = nullptr;
    track.events.each([&](const Event& e) {
      const bool differs = before && (before->twerper == Twerper::bspline) != (e.twerper == Twerper::bspline);
      if (differs && !torn && e.time != track.events.back().time) torn = &e;
      before = &e;
    });
    if (!torn) return;
    Target t{id, slot.function, component};
    t.layer = slot.layer;
    say(out, {t, torn->time}, ErrorCode::type,
        fmt::format("{} jumps at {}, where bspline meets another twerper", target_name(s, t),
                    format_time(torn->time, s.rate)),
        fmt::format("twerper {} bspline", target_name(s, t)));
  };
  look(*slot.track, -1);
  for (std::size_t i = 0; i < slot.components.size(); ++i) look(*slot.components[i], static_cast<int>(i));
}

// Warns, at the first object, about environments that contain objects but are never animated.
void look_at_idle_environments(const Scene& s, Remarks& out) {
  std::vector<std::string_view> known;
  for (std::size_t i = 0; i < s.objects.size(); ++i)
    if (s.objects[i].environment && !s.objects[i].removed) known.push_back(s.objects[i].name);
  std::map<std::string, bool> said;
  for (std::uint32_t i = 0; i < s.objects.size(); ++i) {
    const Object& o = s.objects[i];
    const auto look = [&](const Subject& about, const Value& v) {
      const auto* names = std::get_if<Names>(&v);
      for (const std::string& name : names ? **names : std::vector<std::string>()) {
        const ObjectId id = s.names.find(name);
        if ((id && s.objects[id.index].kind == Kind::environment) || !said.try_emplace(name).second) continue;
        const Hint near = did_you_mean(name, known);
        say(out, about, ErrorCode::name,
            fmt::format("'{}' is in the environment '{}', which no line animates", o.name, name),
            near.empty() ? fmt::format("as in animate {} every 1t by rotate(3deg, z)", name) : near);
      }
    };
    for (const FunctionId f : {fn::environments, fn::drive})
      if (const Slot* slot = o.removed ? nullptr : o.find(f)) {
        if (slot->set) look(of({i}, f), *slot->set);
        slot->track->events.each([&](const Event& e) { look(of({i}, f, e.time), e.value); });
      }
  }
}

// Returns the present state of a remark's subject, or nullopt if it does not exist.
std::optional<Event> state(const Scene& s, const Subject& about) {
  Event now;
  if (about.notes) {
    for (const auto& [time, note] : *s.notes)
      if (time == about.time) now.value = Text(note.text);
    return now;
  }
  const Target& t = about.target;
  const Object* o = find_object(s, t.object);
  const Slot* slot = o ? o->find(t.function, t.layer) : nullptr;
  if (!slot) return std::nullopt;
  if (!about.time && slot->set && t.component < 0) return now.value = *slot->set, now;
  for (const Track* track : tracks_of(s, t)) {
    if (track->events.empty()) continue;
    if (!about.time) return track->events.front();
    if (const Event* e = track->events.find(*about.time)) return *e;
  }
  return std::nullopt;
}

}  // namespace

std::vector<Remark> lint(const Scene& s) {
  Remarks out;
  look_at_blends(s, out);
  look_at_notes(s, out);
  for (Error& why : hindered_reaches(s)) out.push_back({{Severity::warning, std::move(why), {}, 0}, std::nullopt});
  look_at_idle_environments(s, out);
  for (std::uint32_t i = 0; i < s.objects.size(); ++i) {
    const Object& o = s.objects[i];
    if (o.removed) continue;
    look_at_letting_go(s, {i}, o, out);
    look_at_lens({i}, o, out);
    look_at_joints(s, {i}, o, out);
    look_at_obstacles(s, {i}, o, out);
    look_at_masks(s, {i}, o, out);
    look_at_velocity_space({i}, o, out);
    for (const Slot& slot : o.slots) {
      look_at_tangents(s, {i}, slot, slot, out), look_at_tangents(s, {i}, slot, slot.velocity, out);
      look_at_code(s, {i}, slot, out);
      look_at_swings(s, {i}, slot, out), look_at_torn_splines(s, {i}, slot, out);
    }
  }
  for (Remark& r : out)
    if (r.about && !r.about->notes) r.said.what.subject = s.objects[r.about->target.object.index].name;
  return out;
}

PlaceFinder::PlaceFinder(std::vector<Remark> remarks) : remarks_(std::move(remarks)), states_(remarks_.size()) {}

void PlaceFinder::look(const Scene& s, Source& source, std::string_view line) {
  line = without_indent(line);
  line = line.substr(0, line.find_last_not_of(" \t\r\n") + 1);
  for (std::size_t i = 0; i < std::min(remarks_.size(), most_places); ++i) {
    if (!remarks_[i].about) continue;
    std::optional<Event> now = state(s, *remarks_[i].about);
    if (now == states_[i]) continue;
    states_[i] = std::move(now);
    Diagnostic& d = remarks_[i].said;
    d = source.diagnose(d.severity, std::move(d.what), line);
  }
}

}  // namespace betwixt
