// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/compile.h"

#include <algorithm>

namespace betwixt {
namespace {

// Not just a track: it takes asking others, adding up, or more than one.
bool alive(const Scene& scene, const Slot& slot) {
  bool any = scripted(slot.set.value_or(spec_of(scene, slot.function).rest)) || !slot.filters.empty() ||
             has_events(slot.velocity);
  each_track(slot, [&](const Track& t) { any = any || scripted(t); });
  return any;
}

bool all_numeric(const Track& t) {
  bool all = true;
  t.events.each([&](const Event& e) {
    all = all && (e.keep || numeric(e.value)) && (!e.detail || !e.detail->before || numeric(*e.detail->before));
  });
  return all;
}

void bind_all(Program::Compiled& compiled) {
  const Scene& scene = compiled.document.scene();
  const auto functions = static_cast<FunctionId>(built_in_functions().size() + scene.defined->size());
  std::vector<FunctionId> computed;  // functions of the author's whose value at rest is code
  for (FunctionId f = 0; f < functions; ++f) {
    const FunctionSpec& spec = spec_of(scene, f);
    if (scripted(spec.rest)) computed.push_back(f);
    compiled.defaults.push_back(
        bind_constant(compiled, f, scripted(spec.rest) ? row_of(spec.type).example() : spec.rest, spec.type));
    if (!spec.shape) continue;
    for (const KindRow& row : kinds())
      if (spec.kinds & bit(row.kind)) compiled.shaping[row.kind].push_back(f);
  }
  compiled.first_binding.reserve(scene.objects.size() + 1);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    compiled.first_binding.push_back(static_cast<std::uint32_t>(compiled.bindings.size()));
    const Object& o = scene.objects[i];
    std::vector<FunctionId> own;
    for (const Slot& slot : o.slots)
      if (own.empty() || own.back() != slot.function) own.push_back(slot.function);
    if (!o.removed && !computed.empty()) {
      std::vector<FunctionId> both;
      std::set_union(own.begin(), own.end(), computed.begin(), computed.end(), std::back_inserter(both));
      own = std::move(both);
    }
    for (const FunctionId f : own) {
      const Slot* slot = o.find(f);
      bool live = slot ? alive(scene, *slot) : scripted(spec_of(scene, f).rest);
      for (const Slot& other : o.slots) live = live || (other.function == f && find_object(scene, other.layer));
      compiled.bindings.push_back(live ? bind_live(compiled, static_cast<std::uint32_t>(i), f)
                                       : bind_track(compiled, *slot));
    }
  }
  compiled.first_binding.push_back(static_cast<std::uint32_t>(compiled.bindings.size()));
}

}  // namespace

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

Binding bind_constant(Program::Compiled& compiled, FunctionId f, const Value& v, Type type) {
  Binding b;
  b.function = f;
  b.constant = v;
  if (!numeric(v)) return b;
  double n[4] = {};
  const int count = held_numbers(v, false, n);
  b.channels = static_cast<std::uint8_t>(std::min(count, row_of(type).channels));
  b.orientation = std::holds_alternative<Quat>(v);
  b.offset = static_cast<std::uint32_t>(compiled.rest.size());
  compiled.rest.insert(compiled.rest.end(), n, n + 4);  // always four: a rotation's curve may want them
  return b;
}

Binding bind_track(Program::Compiled& compiled, const Slot& slot) {
  const FunctionSpec& spec = spec_of(compiled.document.scene(), slot.function);
  Binding b = bind_constant(compiled, slot.function, slot.set.value_or(spec.rest), spec.type);
  b.first_curve = static_cast<std::uint32_t>(compiled.curves.size());
  const auto add = [&](const Track& track, Type type, std::uint32_t offset, bool component = false) {
    compiled.curves.push_back({compiled.set.add(track, type, component), offset, spec.low > -1e300 || spec.high < 1e300,
                               spec.low, spec.high});
    ++b.curves;
  };
  const auto point = [&] {
    b = bind_constant(compiled, slot.function, Vec3{}, spec.type);
    b.first_curve = static_cast<std::uint32_t>(compiled.curves.size());
  };
  for (std::size_t i = 0; i < slot.components.size(); ++i) {
    const Track& t = *slot.components[i];
    if (b.channels == 0 && has_values(t)) point();  // an aim at an object gives way to numbers
    if (has_values(t)) add(t, component_track_type(spec.type), b.offset + static_cast<std::uint32_t>(i), true);
  }
  if (!has_values(*slot.track)) return b;
  if (!all_numeric(*slot.track) || (b.channels == 0 && row_of(spec.type).channels == 0)) {
    b.steps = static_cast<std::int32_t>(compiled.steps.size());
    b.channels = 0;
    compiled.steps.emplace_back(*slot.track, spec.type);
    return b;
  }
  if (b.channels == 0) point();
  // Events that are all points of the world are a vector's; the same twerpers suit them.
  add(*slot.track, spec.type == Type::aim ? Type::vector : spec.type, b.offset);
  b.channels = compiled.curves.back().curve.channels;
  b.orientation = compiled.curves.back().curve.orientation;
  return b;
}

const Binding& Program::Compiled::find(std::uint32_t object, FunctionId f) const {
  const auto first = bindings.begin() + first_binding[object], last = bindings.begin() + first_binding[object + 1];
  const auto at = std::lower_bound(first, last, f, [](const Binding& b, FunctionId id) { return b.function < id; });
  return at != last && at->function == f ? *at : defaults[f];
}

Program Program::compile(const Document& document) {
  auto compiled = std::make_shared<Compiled>(document);
  for (const NamedProcedure& p : *document.scene().procedures)
    compiled->set.own.push_back(p.role == Role::twerper ? p.code : nullptr);
  bind_all(*compiled);
  compile_nodes(*compiled);
  Program p;
  p.code_ = std::move(compiled);
  return p;
}

const Document& Program::document() const { return code_->document; }

}  // namespace betwixt
