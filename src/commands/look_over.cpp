// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "commands/look_over.h"

#include <fmt/format.h>

#include <algorithm>

#include "commands/command.h"
#include "exchange/geometry.h"
#include "program/compiled.h"
#include "scene/names.h"
#include "scene/rig.h"
#include "scene/shape_blend.h"

namespace betwixt {
namespace {

void say(Diagnostics& out, ErrorCode code, std::string what, std::string hint = {}) {
  out.push_back({Severity::notice, fail(code, std::move(what), std::move(hint)), {}, 0});
}

// Shapes that are asked to blend but can only step: said once for each track.
void look_at_blends(const Scene& s, Diagnostics& out) {
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
      if (t == Twerper::unset || t == Twerper::hold) return;
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
        return say(
            out, ErrorCode::type,
            fmt::format("{}.geometry goes straight from {} to {}: {} is a curve through shapes of one kind, with "
                        "as many points, and not through texts",
                        o.name, format_time(from->time, s.rate), format_time(e.time, s.rate), name_of(t)));
      out.push_back(
          {Severity::warning,
           fail(ErrorCode::type, fmt::format("{}.geometry cannot blend from {} to {}: {}; it steps instead", o.name,
                                             format_time(from->time, s.rate), format_time(e.time, s.rate), why)),
           {},
           0});
    });
  }
}

// Notes that nobody will ever see: said once, of the first.
void look_at_notes(const Scene& s, Diagnostics& out) {
  if (!s.range || s.notes->empty() || !s.notes_shown) return;
  const auto outside = [&](const auto& note) { return note.first < s.range->first || note.first > s.range->second; };
  const auto first = std::find_if(s.notes->begin(), s.notes->end(), outside);
  if (first == s.notes->end()) return;
  say(out, ErrorCode::range,
      fmt::format("the note at {} is outside the range, {} to {}: it never plays", format_time(first->first, s.rate),
                  format_time(s.range->first, s.rate), format_time(s.range->second, s.rate)));
}

// Tangents that no `hermite` asks for, handles that no `fcurve` does: said once for each track.
void look_at_tangents(const Scene& s, ObjectId id, const Slot& slot, const Strand& strand, Diagnostics& out) {
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
      say(out, ErrorCode::type,
          fmt::format("{} has a {} at {} that nothing asks for", target_name(s, t), handles ? "handle" : "tangent",
                      format_time(e.time, s.rate)),
          handles ? "fcurve takes handles, before an event and behind it"
                  : "hermite takes tangents, before an event and behind it");
    });
  };
  look(*strand.track, -1);
  for (std::size_t i = 0; i < strand.components.size(); ++i) look(*strand.components[i], static_cast<int>(i));
}

// Components with events of their own, of what code computes as a whole: it does not reach them.
void look_at_code(const Scene& s, ObjectId id, const Slot& slot, Diagnostics& out) {
  if (!slot.set || !std::holds_alternative<Procedure>(*slot.set)) return;
  for (std::size_t i = 0; i < slot.components.size(); ++i) {
    if (slot.components[i]->events.empty()) continue;
    Target whole{id, slot.function, -1}, part{id, slot.function, static_cast<int>(i)};
    whole.layer = part.layer = slot.layer;
    say(out, ErrorCode::type,
        fmt::format("{} has events of its own: the code of {} does not reach it", target_name(s, part),
                    target_name(s, whole)));
  }
}

// Things that are let go while nothing holds them: said once for each.
void look_at_letting_go(const Scene& s, const Object& o, Diagnostics& out) {
  bool held = false, said = false;
  for (const AttachmentSpan& a : attachments(o)) {
    const bool holds = a.computed || a.to.kind >= AttachmentKind::hang;
    if (!holds && !held && a.from != from_the_beginning && !std::exchange(said, true))
      say(out, ErrorCode::type,
          fmt::format("{} is let go at {}, where nothing holds it", o.name, format_time(a.from, s.rate)));
    held = holds;
  }
}

// Lenses of cameras that have none.
void look_at_lens(const Object& o, Diagnostics& out) {
  if (o.kind == Kind::camera && o.find(fn::f_stop) && o.find(fn::camera_height))
    say(out, ErrorCode::type,
        fmt::format("{} has a height, so it sees without perspective and its f-stop blurs nothing", o.name),
        "lens or fov in place of height");
}

// Joints that move no vertices: their number is another than the file's, or nothing has such a name.
void look_at_joints(const Scene& s, const Object& o, Diagnostics& out) {
  const Slot *said = o.find(fn::joints), *file = o.find(fn::file);
  const auto* names = said && said->set ? std::get_if<Names>(&*said->set) : nullptr;
  const auto* path = file && file->set ? std::get_if<Text>(&*file->set) : nullptr;
  if (!names || !path || (*names)->empty()) return;
  const auto mesh = s.meshes->find(**path);
  const std::size_t wanted = mesh == s.meshes->end() || !mesh->second->rig ? 0 : mesh->second->rig->inverse_bind.size();
  if (wanted != (*names)->size())
    return say(out, ErrorCode::range,
               wanted == 0
                   ? fmt::format("{} has joints, but its mesh has no skin that follows them", o.name)
                   : fmt::format("{} has {} joints, but its mesh follows {}", o.name, (*names)->size(), wanted));
  for (const std::string& name : **names)
    if (!s.names.find(name))
      return say(out, ErrorCode::name, fmt::format("{} follows '{}', which is not there: it stays", o.name, name));
}

}  // namespace

void look_over(const Scene& s, Diagnostics& out) {
  look_at_blends(s, out);
  look_at_notes(s, out);
  for (std::string& why : hindered_reaches(s))
    out.push_back({Severity::warning, fail(ErrorCode::name, std::move(why)), {}, 0});
  for (std::uint32_t i = 0; i < s.objects.size(); ++i) {
    const Object& o = s.objects[i];
    if (o.removed) continue;
    look_at_letting_go(s, o, out);
    look_at_lens(o, out);
    look_at_joints(s, o, out);
    for (const Slot& slot : o.slots)
      look_at_tangents(s, {i}, slot, slot, out), look_at_tangents(s, {i}, slot, slot.velocity, out),
          look_at_code(s, {i}, slot, out);
  }
}

}  // namespace betwixt
