// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What an object hangs on at a time, by its track or by code in it.
#include <fmt/format.h>

#include <bit>

#include "program/evaluator.h"
#include "program/placing.h"

namespace betwixt {
namespace {

// Returns the source of the code that is in force from a time on.
std::string source_of(const Object& o, Time from) {
  const Slot& slot = *o.find(fn::attachment);
  const Event* event = slot.track->events.find(from);
  const Value* v = event ? &event->value : slot.set ? &*slot.set : nullptr;
  const auto* code = v ? std::get_if<Procedure>(v) : nullptr;
  return code ? code->code->source : std::string();
}

// May be a cycle.
CompiledSpan said_to_hold(const Program::Compiled& c, std::uint32_t node, Time t, Asking& asking) {
  const CompiledSpan* const said = c.span(c.nodes[node], t);
  CompiledSpan now;
  now.from = {INT64_MIN};
  if (said) now = *said;
  if (!now.computed) return now;
  const Value v = c.live_value(c.find(c.nodes[node].object, fn::attachment).live, t, asking);
  const auto* by = std::get_if<Attachment>(&v);
  if (!by || by->kind < AttachmentKind::hang || !find_object(c.document.scene(), by->parent)) return now;
  const std::uint32_t parent = c.node_of[by->parent.index];
  now.kind = by->kind, now.parent = static_cast<std::int32_t>(parent), now.one_body = c.one_body(node, parent);
  return now;
}

}  // namespace

// If code closes a cycle, each object whose code takes part in it is free, in whatever order they are evaluated.
CompiledSpan held(const Program::Compiled& c, std::uint32_t node, Time t, Asking& asking) {
  const CompiledSpan now = said_to_hold(c, node, t, asking);
  if (!now.computed || now.parent < 0) return now;
  const auto above = [&](std::int32_t at) { return said_to_hold(c, static_cast<std::uint32_t>(at), t, asking).parent; };
  const auto self = static_cast<std::int32_t>(node);
  std::int32_t seen = -1;  // detects a cycle of others (Brent 1980)
  std::size_t steps = 0;
  for (std::int32_t at = now.parent; at != self; at = above(at)) {
    if (at < 0 || at == seen) return now;
    if (std::has_single_bit(++steps)) seen = at;
  }
  const auto name = [&](std::int32_t at) -> const std::string& {
    return c.document.scene().objects[c.nodes[static_cast<std::size_t>(at)].object].name;
  };
  std::string way = name(self);
  for (std::int32_t at = now.parent; at != self && way.size() < 200; at = above(at)) way += " → " + name(at);
  asking.say({Problem::other,
              name(self) + ".attachment",
              {},
              fmt::format(": its code would make a cycle, {} → {}, so the object has no parent", way, name(self)),
              source_of(c.document.scene().objects[c.nodes[node].object], now.from)});
  CompiledSpan free;
  free.from = now.from, free.computed = true;
  return free;
}

// Takes the parents that code gives.
void Evaluator::take_hold(Asking& asking) {
  for (std::size_t k = 0; k < by_code_.size(); ++k) {
    const std::uint32_t node = compiled_.held_by_code[k];
    if (only_ && !only_->held[node]) continue;
    const CompiledSpan now = betwixt::held(compiled_, node, now_, asking);
    CompiledSpan& was = by_code_[k];
    if (!now.computed || (held_[node] == &was && was.kind == now.kind && was.parent == now.parent)) continue;
    was = now;
    held_[node] = &was;
    rearrange_ = true;
    marks_.add(node, affects::place);
  }
}

}  // namespace betwixt
