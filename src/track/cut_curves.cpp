// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Keeps the shape of a curve where events leave it: tangents in place of in-betweens that look at neighbours.
#include <cmath>

#include "track/curve.h"
#include "track/operations.h"

namespace betwixt {

namespace {

bool computed(const Track& track) {
  bool any = false;
  track.events.each([&](const Event& e) { any = any || std::holds_alternative<Procedure>(e.value); });
  return any;
}

// Stores the twerper in each event, since the later ones will have others.
void say_each(Track& track) {
  if (track.global == Twerper::unset) return;
  track.events.edit_between(Time{INT64_MIN}, Time{INT64_MAX}, [&](Event& e) {
    e.twerper = track.global;
    if (track.arguments != TwerperArguments{}) e.detail.edit().arguments = track.arguments;
  });
  track.global = Twerper::unset;
}

// Returns the track without eases, which affect the timing and not the path.
Track without_eases(Track track) {
  track.events.edit_between(Time{INT64_MIN}, Time{INT64_MAX}, [](Event& e) {
    if (e.detail) e.detail.edit().ease_in = e.detail.edit().ease_out = {};
  });
  return track;
}

// Returns whether an in-between depends on the neighbours of its events.
bool looks_beside(Twerper t, bool orientation) {
  if (is_own(t)) return false;
  return orientation ? t == Twerper::squad || t == Twerper::bspline : row_of(t).cubics && t != Twerper::hermite;
}

// Converts the in-between of two events to tangents; returns false if no tangents can express it.
bool as_tangents(const CurveSet& set, const Curve& curve, Event& from, Event& to) {
  CubicSegment g;
  if (!set.cubic(curve, from.time.flicks, g)) return false;
  const double rate = static_cast<double>(flicks_per_second) / g.length;
  double out[4] = {}, in[4] = {};
  for (std::size_t i = 0; i < curve.channels; ++i)
    out[i] = rate * g.c[1][i], in[i] = rate * (g.c[1][i] + 2 * g.c[2][i] + 3 * g.c[3][i]);
  from.twerper = Twerper::hermite;
  from.detail.edit().tangent_out = with_numbers(from.value, out), from.detail.edit().handle_out.reset();
  to.detail.edit().tangent_in = with_numbers(to.value, in), to.detail.edit().handle_in.reset();
  return true;
}

}  // namespace

std::vector<Segment> own_tangents(Track& track, Segment s, Type type, bool component) {
  const std::size_t n = track.events.count(s.from, s.to);
  if (n < 2 || n == track.events.size() || row_of(type).changes == Changes::in_steps) return {};
  Track all = track;
  say_each(all);
  auto inside = all.events.between(s.from, s.to);
  const bool code = computed(track);
  CurveSet set;
  const Curve curve = code ? Curve{} : set.add(without_eases(all), type, component);
  std::vector<Segment> bent;
  bool changed = false;
  const auto own = [&](std::size_t i) {
    Event &from = inside[i], &to = inside[i + 1];
    const Twerper how = resolve(all, from, type, curve.orientation);
    if (from.keep || to.keep || !looks_beside(how, curve.orientation)) return;
    const bool tangents = !code && how != Twerper::bspline && row_of(type).tangents;
    if (tangents && as_tangents(set, curve, from, to))
      changed = true;
    else if (bent.empty() || bent.back().from != from.time)
      bent.push_back({from.time, to.time});
  };
  // Neighbours across a cut or a hold do not count.
  const auto holds = [&](const Event& e) { return resolve(all, e, type, curve.orientation) == Twerper::hold; };
  const Event* const before = all.events.last_before(s.from);
  const bool after = all.events.back().time > s.to;
  if (before && !inside.front().detail->before && !holds(*before)) own(0);
  if (after && !inside.back().detail->before && !holds(inside.back())) own(n - 2);
  if (!changed) return bent;
  track = std::move(all);
  for (Event& e : inside) track.events.put(std::move(e));
  return bent;
}

namespace {

constexpr Time ever_before{INT64_MIN}, ever_after{INT64_MAX};

// Converts a segment to tangents: that of `from`, and that at the part u of the segment.
void as_hermite(const CubicSegment& g, double u, Event& from, std::optional<Value>& arrival, std::size_t channels) {
  const double rate = static_cast<double>(flicks_per_second) / g.length;
  double out[4] = {}, in[4] = {};
  for (std::size_t i = 0; i < channels; ++i)
    out[i] = rate * g.c[1][i], in[i] = rate * (g.c[1][i] + 2 * g.c[2][i] * u + 3 * g.c[3][i] * u * u);
  from.twerper = Twerper::hermite;
  from.detail.edit().tangent_out = with_numbers(from.value, out);
  arrival = with_numbers(from.value, in);
}

}  // namespace

EventDetail end_alone(Track& track, Time t, Type type, bool component) {
  const Event* there = track.events.find(t);
  EventDetail arrival = there ? *there->detail : EventDetail{};
  arrival.ease_out = {}, arrival.tangent_out.reset(), arrival.handle_out.reset();
  if (track.events.empty() || !(track.events.front().time < t) || !row_of(type).tangents || computed(track))
    return arrival;
  say_each(track);
  fill_in_kept(track, type, component);
  CurveSet set;
  const Curve curve = set.add(track, type, component);
  std::vector<Event> before = track.events.between(ever_before, t - Time{1});
  const auto twerper = [&](std::size_t i) { return resolve(track, before[i], type, curve.orientation); };
  const auto looks_about = [&](std::size_t i) {  // whether it depends on its neighbours
    return !is_own(twerper(i)) && row_of(twerper(i)).cubics && twerper(i) != Twerper::hermite;
  };
  if (track.events.back().time < t) {  // the extrapolation
    Event& last = before.back();
    if (track.after == Extrapolation::hold) last.twerper = Twerper::hold;
    if (track.after == Extrapolation::linear) {
      double slope[4] = {};
      set.derivative(curve, t, slope);
      last.twerper = Twerper::hermite;
      last.detail.edit().tangent_out = arrival.tangent_in = with_numbers(last.value, slope);
    }
    track.events.put(last);
    return arrival;
  }
  // Twerpers that use neighbours reach at most the second event from t, but a B-spline does not go through its events.
  std::size_t first = before.size() - 1;
  if (!there && first > 0 && looks_about(first - 1)) --first;
  while (twerper(first) == Twerper::bspline && first > 0 && twerper(first - 1) == Twerper::bspline) --first;
  for (std::size_t i = first; i < before.size(); ++i) {
    CubicSegment g;
    const Twerper how = twerper(i);
    const bool last = i + 1 == before.size(), spline = how == Twerper::bspline;
    if (!looks_about(i) && !(how == Twerper::hermite && last)) continue;
    if (!set.cubic(curve, before[i].time.flicks, g)) continue;
    if (spline) {  // the value of the curve, not that of its control point
      double at[4] = {};
      for (std::size_t k = 0; k < curve.channels; ++k) at[k] = g.c[0][k];
      const Value seen = with_numbers(before[i].value, at);
      if (i == first && first > 0 && !before[i].detail->before) before[i].detail.edit().before = before[i].value;
      before[i].value = seen;
    }
    const double u = last ? static_cast<double>((t - before[i].time).flicks) / g.length : 1;
    std::optional<Value> slope;
    as_hermite(g, u, before[i], slope, curve.channels);
    (last ? arrival.tangent_in : before[i + 1].detail.edit().tangent_in) = std::move(slope);
  }
  for (Event& e : before) track.events.put(std::move(e));
  return arrival;
}

void fill_in_kept(Track& track, Type type, bool component) {
  std::vector<Event> kept;
  Track valued = track;
  valued.events = {};
  track.events.each([&](const Event& e) { e.keep ? kept.push_back(e) : void(valued.events.put(e)); });
  if (kept.empty() || valued.events.empty() || computed(track)) return;
  bool numbers = row_of(type).changes != Changes::in_steps;
  valued.events.each([&](const Event& e) { numbers = numbers && numeric(e.value); });
  CurveSet set;
  const Curve through = numbers ? set.add(valued, type, component) : Curve{};
  const Value& like = valued.events.front().value;
  for (Event& e : kept) {
    e.keep = false;
    if (!numbers) {  // the last value
      e.value = like;
      valued.events.each_between(ever_before, e.time, [&](const Event& said) { e.value = said.value; });
    } else {
      double n[4] = {};
      set.evaluate(through, e.time, n);
      if (row_of(type).light)
        for (int i = 0; i < (component ? 1 : 3); ++i) n[i] = to_srgb(n[i]);
      e.value = through.orientation ? Value(Quat{n[0], n[1], n[2], n[3]}) : with_numbers(like, n);
    }
    track.events.put(std::move(e));
  }
}

std::size_t erase_before(Track& track, Time t, Changes changes) {
  constexpr int neighbours = 2;  // events before an in-between that it depends on, at most: smooth, bspline and squad
  std::vector<std::pair<Time, bool>> until;
  track.events.each_between(ever_before, t, [&](const Event& e) { until.emplace_back(e.time, e.keep); });
  std::size_t first = until.size();  // the first event that is kept
  for (int n = changes == Changes::in_steps ? 0 : neighbours; n >= 0 && first > 0; --n) {
    --first;
    while (first > 0 && until[first].second) --first;  // its value depends on those before
  }
  return first == 0 ? 0 : track.events.erase(ever_before, until[first - 1].first);
}

}  // namespace betwixt
