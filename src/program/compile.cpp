// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/compile.h"

#include <algorithm>

#include "base/cancellation.h"
#include "program/constant_code.h"
#include "program/on_axes.h"

namespace betwixt {
namespace {

// Returns true if the value is more than one track: it needs other values, a sum, or several tracks.
bool alive(const Scene& scene, const Slot& slot) {
  bool any = scripted(slot.set.value_or(spec_of(scene, slot.function).rest)) ||
             std::any_of(slot.filters.begin(), slot.filters.end(), [](const Filter& f) { return !f.off; }) ||
             has_events(slot.velocity);
  each_track(slot, [&](const Track& t) { any = any || scripted(t) || has_tweens(scene, t); });
  return any;
}

bool has_coded_twerpers(const Track& t) {
  bool any = t.global != Twerper::unset && is_own(t.global);
  t.events.each([&](const Event& e) { any = any || is_own(e.twerper); });
  return any;
}

// Returns the value before the first event, if no event gives one: the value set, or the default for values that do not
// blend. On a layer, returns nullopt if no value is set, so that the value below shows.
std::optional<Value> beginning(const Scene& scene, const Slot& slot, const Event& first) {
  if (slot.set || slot.layer) return slot.set;
  const FunctionSpec& spec = spec_of(scene, slot.function);
  const bool refers = std::holds_alternative<ObjectId>(first.value);
  return refers || row_of(spec.type).changes == Changes::in_steps ? std::optional(spec.rest) : std::nullopt;
}

// Converts a rotation to angles if all events are angles.
Value like_events(const Track& t, Value v) {
  bool angles = true;
  t.events.each([&](const Event& e) { angles = angles && (e.keep || std::holds_alternative<Angles>(e.value)); });
  if (const auto* q = std::get_if<Quat>(&v); q && angles) return Angles{to_angles(*q)};
  return v;
}

using Compiled = Program::Compiled;

// Records where the piece of the next object begins.
void begin_piece(CompiledFilm& compiled) {
  ObjectPiece piece;
  piece.binding = static_cast<std::uint32_t>(compiled.bindings.size());
  piece.curve = static_cast<std::uint32_t>(compiled.curves.size());
  piece.step = static_cast<std::uint32_t>(compiled.steps.size());
  piece.number = static_cast<std::uint32_t>(compiled.rest.size());
  compiled.pieces.push_back(std::move(piece));
}

// Binds the functions' defaults. Returns the author's functions whose default is code.
std::vector<FunctionId> bind_defaults(CompiledFilm& compiled) {
  const Scene& scene = compiled.document.scene();
  const auto functions = static_cast<FunctionId>(built_in_functions().size() + scene.defined->size());
  std::vector<FunctionId> computed;
  for (FunctionId f = 0; f < functions; ++f) {
    const FunctionSpec& spec = spec_of(scene, f);
    if (scripted(spec.rest)) computed.push_back(f);
    compiled.defaults.push_back(
        bind_constant(compiled, f, scripted(spec.rest) ? row_of(spec.type).example() : spec.rest, spec.type));
    if (!spec.shape) continue;
    for (const KindRow& row : kinds())
      if (spec.kinds & bit(row.kind)) compiled.shaping[row.kind].push_back(f);
  }
  return computed;
}

void bind_object(Compiled& compiled, std::uint32_t i, const std::vector<FunctionId>& computed) {
  const Scene& scene = compiled.document.scene();
  const Object& o = scene.objects[i];
  std::vector<FunctionId> own;
  bool alone = true;
  for (const Slot& slot : o.slots) {
    if (own.empty() || own.back() != slot.function) own.push_back(slot.function);
    alone = alone && !slot.layer;
  }
  if (!o.removed && !computed.empty()) {
    std::vector<FunctionId> both;
    std::set_union(own.begin(), own.end(), computed.begin(), computed.end(), std::back_inserter(both));
    own = std::move(both);
  }
  if (o.hidden) {
    const auto at = std::lower_bound(own.begin(), own.end(), fn::display);
    if (at == own.end() || *at != fn::display) own.insert(at, fn::display);
  }
  if (collides(o, fn::position) && own.front() != fn::position) own.insert(own.begin(), fn::position);
  const bool on_axes = !o.removed && position_by_axes(scene, o);
  if (on_axes) own.insert(std::lower_bound(own.begin(), own.end(), fn::placed), fn::placed);
  for (const FunctionId f : own) {
    if (f == fn::placed) {
      Slot slot;
      slot.function = f, slot.set = placed_by_axes();
      compiled.bindings.push_back(bind_live(compiled, i, f, &slot));
      alone = false;
      continue;
    }
    if (o.hidden && f == fn::display) {
      compiled.bindings.push_back(bind_constant(compiled, f, false, Type::boolean));
      continue;
    }
    const Slot* slot = o.find(f);
    const std::optional<Slot> constant = slot ? with_constants(compiled, i, *slot) : std::nullopt;
    if (constant) slot = &*constant;
    bool live = collides(o, f) || (slot ? alive(scene, *slot) : scripted(spec_of(scene, f).rest));
    for (const Slot& other : o.slots) live = live || (other.function == f && find_object(scene, other.layer));
    compiled.bindings.push_back(live                ? bind_live(compiled, i, f, slot)
                                : has_events(*slot) ? bind_track(compiled, with_beginning(scene, *slot))
                                                    : bind_track(compiled, *slot));
    alone = alone && !live;
  }
  compiled.pieces.back().columns = compiled.set.end_columns();
  compiled.pieces.back().alone = alone;
}

// Copies an object's piece from the last program, and shifts its offsets.
void share_object(CompiledFilm& compiled, const CompiledFilm& before, std::uint32_t i) {
  const ObjectPiece &from = before.pieces[i], &end = before.pieces[i + 1];
  ObjectPiece& piece = compiled.pieces.back();
  piece.columns = from.columns, piece.alone = true;
  if (from.columns) compiled.set.share(from.columns);
  const std::uint32_t numbers = piece.number - from.number;  // unsigned: wraps around if negative
  for (std::uint32_t k = from.binding; k < end.binding; ++k) {
    Binding b = before.bindings[k];
    b.offset += numbers;
    b.first_curve += piece.curve - from.curve;
    if (b.steps >= 0) b.steps += static_cast<std::int32_t>(piece.step - from.step);
    compiled.bindings.push_back(std::move(b));
  }
  for (std::uint32_t k = from.curve; k < end.curve; ++k) {
    compiled.curves.push_back(before.curves[k]);
    compiled.curves.back().offset += numbers;
  }
  compiled.steps.insert(compiled.steps.end(), before.steps.begin() + from.step, before.steps.begin() + end.step);
  compiled.rest.insert(compiled.rest.end(), before.rest.begin() + from.number, before.rest.begin() + end.number);
}

void bind_all(Compiled& compiled, const CompiledFilm* before) {
  const Scene& scene = compiled.document.scene();
  const std::vector<FunctionId> computed = bind_defaults(compiled);
  compiled.pieces.reserve(scene.objects.size() + 1);
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
    Cancellation::check();
    begin_piece(compiled);
    if (before && computed.empty() && scene.objects.same(i, before->document.scene().objects) &&
        before->pieces[i].alone)
      share_object(compiled, *before, i);
    else
      bind_object(compiled, i, computed);
  }
  begin_piece(compiled);
}

}  // namespace

Slot with_beginning(const Scene& scene, const Slot& slot) {
  Slot out = slot;
  const Type type = spec_of(scene, slot.function).type;
  if (type == Type::attachment || type == Type::motion) return out;  // these tracks define their own beginning
  const auto begin = [&](Cow<Track>& track, int component) {
    if (track->events.empty()) return;
    std::optional<Event> first;
    if (const Event& e = track->events.front(); !e.keep) first = e;
    if (!first)
      track->events.each([&](const Event& e) {
        if (!first && !e.keep) first = e;
      });
    if (!first || first->detail->before || track->before != Extrapolation::hold) return;
    std::optional<Value> v = beginning(scene, slot, *first);
    if (v && component >= 0) v = numeric(*v) ? std::optional<Value>(component_of(*v, component)) : std::nullopt;
    if (!v || *v == first->value) return;
    first->detail.edit().before = like_events(*track, *std::move(v));
    track.edit().events.put(*std::move(first));
  };
  begin(out.track, -1);
  for (std::size_t i = 0; i < out.components.size(); ++i) begin(out.components[i], static_cast<int>(i));
  return out;
}

bool all_numeric(const Track& t) {
  bool all = true;
  t.events.each([&](const Event& e) {
    all = all && (e.keep || numeric(e.value)) && (!e.detail || !e.detail->before || numeric(*e.detail->before));
  });
  return all;
}

bool has_tweens(const Scene& scene, const Track& t) {
  bool any = tween(scene, t.global) != nullptr;
  t.events.each([&](const Event& e) { any = any || tween(scene, e.twerper); });
  return any;
}

bool scripted(const Track& t) {
  bool any = false;
  t.events.each([&](const Event& e) {
    any = any || scripted(e.value) || (e.detail && e.detail->before && scripted(*e.detail->before));
  });
  return any;
}

bool has_values(const Track& t) {
  bool any = false;
  t.events.each([&](const Event& e) { any = any || !e.keep; });
  return any;
}

bool has_events(const Strand& s) {
  bool any = false;
  each_track(s, [&](const Track& t) { any = any || !t.events.empty(); });
  return any;
}

Binding bind_constant(CompiledFilm& compiled, FunctionId f, const Value& v, Type type) {
  Binding b;
  b.function = f;
  b.constant = v;
  if (!numeric(v)) return b;
  double n[4] = {};
  const int count = held_numbers(v, false, n);
  b.channels = static_cast<std::uint8_t>(std::min(count, row_of(type).channels));
  b.orientation = std::holds_alternative<Quat>(v);
  b.offset = static_cast<std::uint32_t>(compiled.rest.size());
  compiled.rest.insert(compiled.rest.end(), n, n + 4);  // always four, because a rotation's curve may need them
  return b;
}

Binding bind_track(CompiledFilm& compiled, const Slot& slot) {
  const FunctionSpec& spec = spec_of(compiled.document.scene(), slot.function);
  Binding b = bind_constant(compiled, slot.function, slot.set.value_or(spec.rest), spec.type);
  b.first_curve = static_cast<std::uint32_t>(compiled.curves.size());
  const auto add = [&](const Track& track, Type type, std::uint32_t offset, bool component = false) {
    compiled.curves.push_back({compiled.set.add(track, type, component), offset, spec.low > -1e300 || spec.high < 1e300,
                               spec.low, spec.high, has_coded_twerpers(track)});
    ++b.curves;
  };
  const auto point = [&] {
    b = bind_constant(compiled, slot.function, Vec3{}, spec.type);
    b.first_curve = static_cast<std::uint32_t>(compiled.curves.size());
  };
  bool coded = false;  // the schedule numbers these bindings
  each_track(slot, [&](const Track& t) { coded = coded || has_coded_twerpers(t); });
  const auto marked = [&] { return b.coded = coded ? 0 : -1, b; };
  for (std::size_t i = 0; i < slot.components.size(); ++i) {
    const Track& t = *slot.components[i];
    if (b.channels == 0 && has_values(t)) point();  // numbers replace an aim at an object
    if (has_values(t)) add(t, component_track_type(spec.type), b.offset + static_cast<std::uint32_t>(i), true);
  }
  if (!has_values(*slot.track)) return marked();
  if (!all_numeric(*slot.track) || (b.channels == 0 && row_of(spec.type).channels == 0)) {
    b.steps = static_cast<std::int32_t>(compiled.steps.size());
    b.channels = 0;
    compiled.steps.push_back(std::make_shared<const StepTrack>(*slot.track, spec.type));
    return marked();
  }
  if (b.channels == 0) point();
  // An aim whose events are all points is treated as a vector, which has the same twerpers.
  add(*slot.track, spec.type == Type::aim ? Type::vector : spec.type, b.offset);
  b.channels = compiled.curves.back().curve.channels;
  b.orientation = compiled.curves.back().curve.orientation;
  return marked();
}

Program Program::compile(const Document& document) { return compile(document, {}); }

Program Program::compile(const Document& document, const Program& before) {
  auto compiled = std::make_shared<Compiled>(document);
  const Scene& scene = document.scene();
  // Pieces can be shared only if functions and procedures are the same.
  const CompiledFilm* shared = before.code_.get();
  if (shared && (!shared->document.scene().defined.same(scene.defined) ||
                 !shared->document.scene().procedures.same(scene.procedures)))
    shared = nullptr;
  for (const NamedProcedure& p : *scene.procedures)
    compiled->set.own.push_back(p.role == Role::twerper ? p.code : nullptr);
  bind_all(*compiled, shared);
  compile_nodes(*compiled, shared);
  Program p;
  p.code_ = std::move(compiled);
  return p;
}

const Document& Program::document() const { return code_->document; }

}  // namespace betwixt
