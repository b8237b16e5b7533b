// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Live values, which are evaluated on demand: velocities in force, procedures, filters, layers.
#include <algorithm>
#include <iterator>

#include "program/collisions.h"
#include "program/compile.h"
#include "program/constant_code.h"
#include "program/integrals.h"
#include "track/operations.h"

namespace betwixt {
namespace {

using Compiled = Program::Compiled;

// Returns true if a rotation is held as quaternions: an event has one, or a velocity turns about an axis.
bool turns(const Slot& slot, Type type) {
  if (row_of(type).changes != Changes::by_turning) return false;
  bool any =
      std::holds_alternative<Quat>(row_of(type).example()) || (slot.set && std::holds_alternative<Quat>(*slot.set));
  each_track(slot, [&](const Track& t) {
    t.events.each([&](const Event& e) { any = any || std::holds_alternative<Quat>(e.value); });
  });
  each_track(slot.velocity, [&](const Track& t) {
    t.events.each([&](const Event& e) { any = any || std::holds_alternative<Vec3>(e.value); });
  });
  return any;
}

// Rates are integrated in the author's units, so colours and angles become plain vectors.
Track plain_rates(const Track& reign) {
  Track rates = reign;
  rates.events = {};
  reign.events.each([&](Event e) {
    const auto plain = [](Value& v) {
      if (const auto* c = std::get_if<Color>(&v)) v = Vec3{c->r, c->g, c->b};
      if (const auto* a = std::get_if<Angles>(&v)) v = a->xyz;
    };
    plain(e.value);
    if (e.detail->before) plain(*e.detail.edit().before);
    if (e.detail->tangent_in) plain(*e.detail.edit().tangent_in);
    if (e.detail->tangent_out) plain(*e.detail.edit().tangent_out);
    rates.events.put(std::move(e));
  });
  return rates;
}

// Divides the time of a track with a velocity track into pieces. In each, either the primary track or the velocity is
// in force.
struct Cutter {
  Compiled& compiled;
  std::uint32_t object;
  FunctionId function;
  const LivePart& part;
  const Track& primary;  // with the set value before its first event
  const Track& said;     // without it
  const Track& velocity;
  const bool moves_by_code = scripted(velocity) || spaced();
  const bool is_scripted = scripted(primary) || scripted(part.rest) || has_tweens(compiled.document.scene(), primary);
  std::vector<Piece> out{};

  std::vector<Piece> pieces() {
    add_primary({INT64_MIN}, primary);
    Track reign;
    reign.global = velocity.global, reign.arguments = velocity.arguments;
    const auto close = [&](std::optional<Time> release) {
      if (reign.events.empty()) return;
      reign.after = release ? Extrapolation::hold : velocity.after;
      add_reign(reign);
      reign.events = {};
      if (release) go_on(*release);
    };
    velocity.events.each([&](const Event& e) {
      if (e.release)
        close(e.time);
      else
        reign.events.put(e);
    });
    close(std::nullopt);
    return std::move(out);
  }

  // Returns whether the velocity may turn with the object.
  bool spaced() const {
    return function == fn::position && part.component < 0 &&
           compiled.document.scene().objects[object].find(fn::velocity_space);
  }

  void add_primary(Time from, const Track& track) {
    Piece p;
    p.from = from;
    p.scripted = is_scripted;
    if (!is_scripted && has_values(track)) p.primary = compiled.set.add(track, part.type, part.component >= 0);
    out.push_back(std::move(p));
  }

  void add_reign(const Track& reign) {
    Piece p;
    p.from = reign.events.front().time;
    const Type type = part.component >= 0 ? Type::scalar : row_of(part.type).rate.value_or(part.type);
    if (scripted(reign) || spaced()) {
      LivePart rates;
      rates.component = part.component, rates.type = type, rates.orientation = part.orientation;
      rates.velocity = true, rates.track = plain_rates(reign), rates.rest = row_of(type).example();
      Target name{{object}, function, part.component};
      name.velocity = true;
      p.integral = static_cast<std::int32_t>(compiled.integrals.size());
      compiled.integrals.push_back(
          make_integral(Live{object, function}, std::move(rates), p.from, spaced(), compiled.document.name(name)));
      return out.push_back(std::move(p));
    }
    p.reign = static_cast<std::int32_t>(compiled.reigns.size());
    compiled.reigns.emplace_back(compiled.set, compiled.set.add(plain_rates(reign), type), part.orientation);
    out.push_back(std::move(p));
  }

  // After the release, the primary track continues from the value reached to its next event. The set value plays no
  // part: if the next event is the first one, the track leads to its value, not to the one before it.
  void go_on(Time release) {
    Track rest = said;
    rest.events = {};
    std::optional<Event> last;
    said.events.each([&](const Event& e) {
      if (e.time < release)
        last = e;
      else
        rest.events.put(e);
    });
    if (is_scripted || moves_by_code || !has_values(rest)) {
      Piece held;  // no event follows, or the value is not known yet: it holds until the next event
      held.from = release;
      held.scripted = is_scripted || moves_by_code;
      out.push_back(held);
      return;
    }
    const Value there = reached(release);
    Event e;
    e.time = release;
    e.value = there;
    e.twerper = last ? last->twerper : Twerper::unset;
    if (last && last->detail->arguments != TwerperArguments{}) e.detail.edit().arguments = last->detail->arguments;
    // The author gives the value to continue from.
    if (const Event* own = rest.events.find(release); own && !own->keep) {
      Event cut = *own;
      cut.detail.edit().before = there;
      e = std::move(cut);
    }
    rest.events.put(std::move(e));
    add_primary(release, rest);
  }

  // Returns the value at the end of the finished pieces, from a temporary live value that has only these.
  Value reached(Time t) {
    Live probe{object, function};
    LivePart so_far = part;
    so_far.type = part.value_type();
    so_far.component = -1;
    so_far.pieces = out;
    LiveStrand strand;
    strand.parts.push_back(std::move(so_far));
    probe.strands.push_back(std::move(strand));
    compiled.lives.push_back(std::move(probe));
    Asking asking;
    Value v = compiled.live_value(static_cast<std::int32_t>(compiled.lives.size()) - 1, t, asking);
    compiled.lives.pop_back();
    return v;
  }
};

// Returns the zero of the same type.
Value nothing_like(const Value& v) {
  if (std::holds_alternative<Quat>(v)) return Quat{};
  if (std::holds_alternative<bool>(v)) return v;
  return *add_scaled(v, v, -1);
}

LiveStrand strand(Compiled& compiled, std::uint32_t object, const Slot& said) {
  const Scene& scene = compiled.document.scene();
  const Slot slot = with_beginning(scene, said);
  const FunctionSpec& spec = spec_of(scene, slot.function);
  LiveStrand out;
  out.layer = slot.layer;
  std::copy_if(slot.filters.begin(), slot.filters.end(), std::back_inserter(out.filters),
               [](const Filter& f) { return !f.off; });
  // A layer that adds is zero until its first value.
  out.set = slot.set.value_or(spec.rest);
  if (slot.layer) {
    const auto mode = scene.objects[slot.layer.index].find(fn::mode);
    out.mix = mode && mode->set && *std::get<Text>(*mode->set) == "mix";
    if (!slot.set && !out.mix && numeric(out.set)) out.set = nothing_like(out.set);
  }
  if (slot.layer && !slot.set && row_of(spec.type).changes == Changes::in_steps && has_values(*slot.track))
    out.from = slot.track->events.front().time;
  bool plain = !has_events(slot.velocity) && !scripted(out.set);
  each_track(slot, [&](const Track& t) { plain = plain && !scripted(t) && !has_tweens(scene, t); });
  if (plain) {
    Slot alone = slot;
    alone.set = out.set;
    out.plain = static_cast<std::int32_t>(compiled.plains.size());
    compiled.plains.push_back(bind_track(compiled, alone));
    compiled.plains.back().coded = -1;  // its live value is asked for
    return out;
  }
  const bool orientation = turns(slot, spec.type);
  const bool parts = !slot.components.empty() || !slot.velocity.components.empty();
  const auto add = [&](const Track& primary, const Track& as_said, const Track& velocity, int component) {
    LivePart part;
    part.component = component;
    part.type = component < 0 ? spec.type : component_track_type(spec.type);
    part.orientation = orientation && component < 0;
    part.track = primary;
    if (has_tweens(scene, primary) && !scripted(primary) && all_numeric(primary))
      part.plain = compiled.set.add(primary, spec.type == Type::aim ? Type::vector : part.type, component >= 0);
    part.rest = component < 0 || scripted(out.set) ? out.set : Value(component_of(out.set, component));
    if (!velocity.events.empty())
      part.pieces = Cutter{compiled, object, slot.function, part, primary, as_said, velocity}.pieces();
    if (part.pieces.empty() && !scripted(primary) && !has_values(primary) && component >= 0) return;
    out.parts.push_back(std::move(part));
  };
  if (!parts) {
    add(*slot.track, *said.track, *slot.velocity.track, -1);
    return out;
  }
  const Strand primary = split_into_components(slot, spec.type), as_said = split_into_components(said, spec.type);
  const Strand velocity = split_into_components(slot.velocity, spec.type);
  for (std::size_t i = 0; i < primary.components.size(); ++i)
    add(*primary.components[i], *as_said.components[i], *velocity.components[i], static_cast<int>(i));
  return out;
}

}  // namespace

Binding bind_live(Compiled& compiled, std::uint32_t object, FunctionId f, const Slot* own) {
  const Scene& scene = compiled.document.scene();
  const Object& o = scene.objects[object];
  const FunctionSpec& spec = spec_of(scene, f);
  static const Slot nothing;
  Live live{object, f};
  Slot base = own ? *own : nothing;
  base.function = f;
  live.strands.push_back(strand(compiled, object, base));
  for (const Slot& slot : o.slots)
    if (slot.function == f && slot.layer && find_object(scene, slot.layer))
      live.strands.push_back(strand(compiled, object, with_constants(compiled, object, slot).value_or(slot)));
  const Value& rest = base.set.value_or(spec.rest);
  Value example = scripted(rest) ? spec.rest : rest;
  if (scripted(example)) example = row_of(spec.type).example();
  if (spec.type == Type::aim) example = ObjectId{};  // may become either at any time
  Binding b = bind_constant(compiled, f, example, spec.type);
  b.orientation = row_of(spec.type).changes == Changes::by_turning;
  if (b.orientation) b.channels = 4;
  b.live = static_cast<std::int32_t>(compiled.lives.size());
  if (collides(o, f)) {
    live.collision = static_cast<std::int32_t>(compiled.collisions.size());
    compiled.collisions.push_back(make_collision(o, b.live, compiled.document.name(Target{{object}, f, -1})));
  }
  compiled.lives.push_back(std::move(live));
  return b;
}

}  // namespace betwixt
