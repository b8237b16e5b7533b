// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// When something will next be seen to change: where nothing is due, nobody need wake up. (Animation Imaging Model,
// 3.3.1: an empty slot)
#include <algorithm>

#include "program/compiled.h"

namespace betwixt {
namespace {

struct Next {
  Time now;
  std::optional<Time> at;
  void may(Time t) {
    if (t > now && (!at || t < *at)) at = t;
  }
};

}  // namespace

std::optional<Time> Program::next_change(Time t) const {
  const Compiled& compiled = *code_;
  const Scene& scene = compiled.document.scene();
  if (!compiled.lives.empty()) return t;  // who knows what code looks at
  if (compiled.traces && compiled.tracing_at(t)) return t;
  Next next{t, std::nullopt};
  for (const CurveUse& use : compiled.curves) {
    const auto [first, last] = compiled.set.span(use.curve);
    const Extrapolation out = t < first ? use.curve.before : use.curve.after;
    if (first <= t && t < last) return t;
    if (out != Extrapolation::hold && first < last) return t;
    next.may(first);
  }
  for (const Moving& m : compiled.movings) {
    if ((t < m.first ? m.extend_before : t >= m.last ? m.extend_after : Extrapolation::hold) != Extrapolation::hold)
      return t;
    for (const Moving::Piece& p : m.pieces) {
      if (!p.open && p.from <= t && t < p.until) return t;
      if (!p.open) next.may(p.from);
    }
  }
  for (const auto& steps : compiled.steps)
    if (const auto change = steps->next_change(t)) {
      if (*change == t) return t;
      next.may(*change);
    }
  if (!compiled.environments.empty()) {
    const std::int64_t tick = scene.ticks.whole(t);
    for (const auto& e : compiled.environments)
      if (const auto due = e->next_due(tick)) {
        if (scene.smooth_ticks) return t;
        next.may(scene.ticks.span(static_cast<double>(*due)));
      }
  }
  for (const Siting& siting : compiled.sitings)
    for (const Siting::Change& change : siting.changes) next.may(change.from);
  for (const CompiledSpan& span : compiled.spans) next.may(span.from);
  for (const auto* cameras : {&*scene.cuts, &*scene.views})
    if (const auto cut = cameras->upper_bound(t); cut != cameras->end()) next.may(cut->first);
  for (const auto& note : *scene.notes) next.may(note.first);
  return next.at;
}

}  // namespace betwixt
