// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// When the picture will next change, so that the clock can sleep until then. (Animation Imaging Model, 3.3.1: an empty
// slot)
#include <algorithm>

#include "program/traces.h"

namespace betwixt {
namespace {

struct Next {
  Time now;
  std::optional<Time> at;
  void may(Time t) {
    if (t > now && (!at || t < *at)) at = t;
  }
};

// Reports when a video that the drawable shows changes.
void add_video(const CompiledFilm& c, const Drawable& d, Next& next) {
  const VideoUse& use = c.video_uses[static_cast<std::size_t>(d.video)];
  const auto number = [&](std::uint32_t offset) { return c.rest[offset]; };
  const double at = use.begin.value_or(number(use.at)), speed = std::abs(number(use.speed));
  const auto* const video = d.texture->varies() ? nullptr : c.video(d.texture->constant);
  const bool ends = video && number(use.loop) == 0 && speed > 0;
  if (use.timed || speed == 0 || (ends && next.now.seconds() > at + video->video->seconds() / speed)) return;
  next.may(std::max(from_seconds(at), next.now + Time{1}));
}

}  // namespace

std::optional<Time> Program::next_change(Time t) const {
  const Compiled& compiled = *code_;
  const Scene& scene = compiled.document.scene();
  if (!compiled.lives.empty()) return t;  // code may change at any time
  if (scene.appearance.grade.grain > 0) return t;
  if (compiled.traces && tracing_at(compiled, t)) return t;
  Next next{t, std::nullopt};
  for (const Drawable& d : compiled.drawables)
    if (d.video >= 0) add_video(compiled, d, next);
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
  if (compiled.changing_at(t)) return t;
  if (const auto note = scene.notes->upper_bound(t); note != scene.notes->end()) next.may(note->first);
  return next.at;
}

namespace {

// Reports the events of a repeated track wherever they recur, in both directions of a bounce. Reports some other times
// too.
template <class May>
void again(std::span<const std::int64_t> times, Time after, Time until, May&& may) {
  const std::int64_t length = times.empty() ? 0 : times.back() - times.front();
  if (length <= 0 || (after.flicks < times.back() && until.flicks > times.front())) return;
  for (const std::int64_t t : times)
    for (const std::int64_t there : {t - times.front(), times.back() - t}) {
      const std::int64_t past = (after.flicks - times.front() - there) % length;
      for (std::int64_t at = after.flicks - past; at <= until.flicks; at += length) may(Time{at});
    }
}

}  // namespace

std::vector<Time> Program::discontinuities(Time after, Time until) const {
  const Compiled& compiled = *code_;
  const Scene& scene = compiled.document.scene();
  std::vector<Time> all;
  const auto may = [&](Time t) {
    if (after < t && t <= until) all.push_back(t);
  };
  // Reports the elements of `times`, which are sorted; `time_of` returns an element's time.
  const auto each_of = [&](const auto& times, auto&& time_of) {
    auto at =
        std::upper_bound(times.begin(), times.end(), after, [&](Time t, const auto& one) { return t < time_of(one); });
    for (; at != times.end() && time_of(*at) <= until; ++at) may(time_of(*at));
  };
  for (const CurveUse& use : compiled.curves) {  // includes layers, which are not in the schedule
    const Curve& curve = use.curve;
    const std::span times(curve.columns->times.data() + curve.first, curve.count);
    each_of(times, [](std::int64_t t) { return Time{t}; });
    if (curve.before >= Extrapolation::cycle || curve.after >= Extrapolation::cycle) again(times, after, until, may);
  }
  std::vector<Activity> activities;
  for (const auto& steps : compiled.steps) steps->activities(activities);
  for (const Activity& a : activities) may({a.from}), may({a.until});
  for (const auto* edges : {&compiled.schedule.begins, &compiled.schedule.ends})
    each_of(*edges, [](const Schedule::Edge& e) { return Time{e.time}; });
  for (const auto* cameras : {&*scene.cuts, &*scene.views})
    each_of(*cameras, [](const auto& cut) { return cut.first; });
  for (const auto& [from, way] : *scene.cut_ways) may(from + way.length);
  constexpr std::int64_t most_ticks = 1'000'000;  // four hours of 60 a second
  const std::int64_t first = scene.ticks.whole(after) + 1;
  if (!compiled.environments.empty() && !scene.smooth_ticks)
    for (std::int64_t tick = first; tick < first + most_ticks; ++tick) {
      const Time t = scene.ticks.span(static_cast<double>(tick));
      if (t > until) break;
      may(t);
    }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace betwixt
