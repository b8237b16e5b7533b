// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/operations.h"

#include <algorithm>
#include <cmath>

#include "track/curve.h"

namespace betwixt {
namespace {

// The list with f applied to each point.
template <class F>
std::optional<Value> each_point(const Points& points, F&& f) {
  std::vector<Vec3> changed = *points;
  for (Vec3& p : changed) {
    const std::optional<Value> one = f(Value(p));
    if (!one) return std::nullopt;
    p = std::get<Vec3>(*one);
  }
  return Points(std::move(changed));
}

// f for each pair of numbers in a and b; b may be one number for all of them. What turns or is on or off has no such
// thing.
template <class F>
std::optional<Value> combine(const Value& a, const Value& b, F&& f) {
  if (const auto* points = std::get_if<Points>(&a); points && !std::holds_alternative<Points>(b))
    return each_point(*points, [&](const Value& p) { return combine(p, b, f); });
  for (const Value* v : {&a, &b})
    if (std::holds_alternative<Quat>(*v) || std::holds_alternative<bool>(*v)) return std::nullopt;
  double x[4], y[4];
  const int count = to_numbers(a, x), others = to_numbers(b, y);
  if (count == 0 || (others != 1 && others != count)) return std::nullopt;
  for (int i = 0; i < count; ++i) x[i] = f(x[i], y[others == 1 ? 0 : i]);
  return with_numbers(a, x);
}

// Returns a tangent times k; that of an orientation has four numbers.
std::optional<Value> steeper(const Value& v, double k) {
  if (const auto* q = std::get_if<Quat>(&v)) return Quat{k * q->w, k * q->x, k * q->y, k * q->z};
  return combine(v, Value(k), [](double x, double y) { return x * y; });
}

bool finite(const Value& v) {
  if (const auto* points = std::get_if<Points>(&v))
    return std::all_of((*points)->begin(), (*points)->end(), [](Vec3 p) { return betwixt::finite(p); });
  double n[4];
  return betwixt::finite(std::span<const double>(n, static_cast<std::size_t>(to_numbers(v, n))));
}

// Changes every value (and, if requested, tangent) of a segment by f; if one fails, none.
template <class F>
Result<Changed> change_values(Track& track, Segment s, bool tangents, const char* what, F&& f) {
  Track changed = track;
  std::optional<Error> error;
  const auto apply = [&](Value& v) {
    std::optional<Value> r = f(v);
    if (r && finite(*r))
      v = std::move(*r);
    else if (!error)
      error = r ? fail(ErrorCode::range, std::string("a value grows beyond all numbers when it is ") + what)
                : fail(ErrorCode::type, std::string("this cannot be ") + what);
  };
  Changed done;
  done.events = changed.events.edit_between(s.from, s.to, [&](Event& e) {
    if (!e.keep && !e.release) apply(e.value);
    if (!e.detail) return;
    EventDetail& d = e.detail.edit();
    if (d.before) apply(*d.before);
    if (tangents && d.tangent_in) apply(*d.tangent_in);
    if (tangents && d.tangent_out) apply(*d.tangent_out);
  });
  if (error) return *error;
  track = std::move(changed);
  return done;
}

// Removes the segment's events and inserts the changed ones, which may replace others.
Result<Changed> put_back(Track& track, Segment s, std::vector<Event> events) {
  Changed done{events.size(), 0};
  track.events.erase(s.from, s.to);
  const auto before = track.events.size();
  for (Event& e : events) track.events.put(std::move(e));
  done.replaced = before + done.events - track.events.size();
  return done;
}

// Multiplies tangents. Handles are differences of value, which do not depend on time.
bool steepen(EventDetail& d, double by) {
  bool all = true;
  const auto change = [&](std::optional<Value>& tangent, const std::optional<Time>& handle) {
    if (!tangent || handle) return;
    tangent = steeper(*tangent, by);
    all = all && (!tangent || finite(*tangent));
  };
  change(d.tangent_in, d.handle_in), change(d.tangent_out, d.handle_out);
  return all;
}

Error out_of_reach() { return fail(ErrorCode::range, "the events would end up more than 146 years away"); }

}  // namespace

std::optional<Value> add_scaled(const Value& a, const Value& b, double k) {
  return combine(a, b, [k](double x, double y) { return x + k * y; });
}

Result<Changed> copy_segment(const Track& from_track, Segment s, Track& into, Time start,
                             const std::optional<Value>& shift, int times) {
  const std::vector<Event> source = from_track.events.between(s.from, s.to);
  const Time span = s.to - s.from;
  if (!in_reach(start) || !in_reach({static_cast<std::int64_t>(std::min(
                              9e18, static_cast<double>(start.flicks) + static_cast<double>(span.flicks) * times))}))
    return out_of_reach();
  Track out = into;
  Changed done;
  for (int k = 1; k <= times; ++k) {
    const Time at{start.flicks + (k - 1) * span.flicks};
    const Event* standing = out.events.find(at);
    const bool seam = standing != nullptr;
    const Time ease_in = seam ? standing->detail->ease_in : Time{};
    done.replaced += out.events.erase(at, at + span);
    for (Event e : source) {
      e.time = at + (e.time - s.from);
      if (seam && e.time == at && (ease_in != Time{} || e.detail)) e.detail.edit().ease_in = ease_in;
      if (shift) {
        for (Value* v : {&e.value, e.detail && e.detail->before ? &*e.detail.edit().before : nullptr}) {
          if (!v || e.keep || e.release) continue;
          auto moved = add_scaled(*v, *shift, k);
          if (!moved || !finite(*moved)) return fail(ErrorCode::type, "the copies cannot be shifted by that");
          *v = std::move(*moved);
        }
      }
      out.events.put(std::move(e));
      ++done.events;
    }
  }
  into = std::move(out);
  return done;
}

Result<Changed> move_segment(Track& track, Segment s, Time by) {
  auto events = track.events.between(s.from, s.to);
  for (Event& e : events)
    if (!in_reach(e.time = e.time + by)) return out_of_reach();
  return put_back(track, s, std::move(events));
}

Result<Changed> stretch_segment(Track& track, Segment s, double factor) {
  auto events = track.events.between(s.from, s.to);
  const auto stretched = [&](Time t) { return Time{std::llround(static_cast<double>(t.flicks) * factor)}; };
  for (Event& e : events) {
    if (std::abs((e.time - s.from).seconds()) * factor > longest_seconds) return out_of_reach();
    if (!in_reach(e.time = s.from + stretched(e.time - s.from))) return out_of_reach();
    if (!e.detail) continue;
    EventDetail& d = e.detail.edit();
    if (std::max(d.ease_in, d.ease_out).seconds() * factor > longest_seconds) return out_of_reach();
    d.ease_in = stretched(d.ease_in), d.ease_out = stretched(d.ease_out);
    if (!steepen(d, 1 / factor)) return fail(ErrorCode::range, "a tangent grows beyond all numbers");
    for (auto* handle : {&d.handle_in, &d.handle_out})
      if (*handle) {
        if ((*handle)->seconds() * factor > longest_seconds) return out_of_reach();
        *handle = stretched(**handle);
      }
  }
  return put_back(track, s, std::move(events));
}

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

namespace {

// Keeps the eases and tangents outside a segment: they belong to the in-betweens beside it, which stay as they are.
void keep_outside(const Event& first, const Event& last, Event& now_first, Event& now_last) {
  if (now_first.detail || first.detail) {
    EventDetail& d = now_first.detail.edit();
    d.ease_in = first.detail->ease_in, d.tangent_in = first.detail->tangent_in, d.handle_in = first.detail->handle_in;
  }
  if (now_last.detail || last.detail) {
    EventDetail& d = now_last.detail.edit();
    d.ease_out = last.detail->ease_out, d.tangent_out = last.detail->tangent_out;
    d.handle_out = last.detail->handle_out;
  }
}

}  // namespace

Result<Changed> reverse_segment(Track& track, Segment s) {
  auto events = track.events.between(s.from, s.to);
  const auto holds = [&](const Event& e) {
    const Twerper t = track.global != Twerper::unset ? track.global : e.twerper;
    return t == Twerper::hold || std::holds_alternative<bool>(e.value) || (t == Twerper::unset && !numeric(e.value));
  };
  std::vector<Event> out;
  out.reserve(events.size());
  for (std::size_t i = events.size(); i-- > 0;) {
    Event e = events[i];
    e.time = s.from + (s.to - e.time);
    // The in-between that led to this event now starts from it.
    const Event& leader = events[i > 0 ? i - 1 : events.size() - 1];
    e.twerper = leader.twerper;
    std::optional<Value> before;
    if (!e.keep) {  // the values before and after a cut change places; a value that was held before is held after
      const bool held = i > 0 && holds(leader) && !leader.keep;
      Value after = held ? leader.value : e.detail->before.value_or(e.value);
      const bool seen = i + 1 == events.size() || !holds(events[i]);
      const bool corner =
          e.detail->before && *e.detail->before == e.value;  // a corner: neighbours do not count across it
      if (seen && (after != e.value || corner)) before = e.value;
      e.value = std::move(after);
    }
    TwerperArguments arguments = leader.detail->arguments;
    if (i > 0) reverse(e.twerper, arguments);
    if (e.detail || leader.detail || before || arguments != TwerperArguments{}) {
      EventDetail& d = e.detail.edit();
      std::swap(d.ease_in, d.ease_out);
      d.before = std::move(before);
      d.arguments = arguments;
      std::swap(d.tangent_in, d.tangent_out), std::swap(d.handle_in, d.handle_out);
      steepen(d, -1);
    }
    out.push_back(std::move(e));
  }
  if (!events.empty()) keep_outside(events.front(), events.back(), out.front(), out.back());
  return put_back(track, s, std::move(out));
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

Result<Changed> scale_segment(Track& track, Segment s, const Value& by) {
  return change_values(track, s, true, "scaled by that",
                       [&](const Value& v) { return combine(v, by, [](double x, double y) { return x * y; }); });
}

Result<Changed> translate_segment(Track& track, Segment s, const Value& by) {
  return change_values(track, s, false, "moved by that", [&](const Value& v) { return add_scaled(v, by, 1); });
}

Result<Changed> rotate_segment(Track& track, Segment s, Quat by, Vec3 centre) {
  const Mat4 turn = rotation(by);
  // Tangents turn too, but about no centre: they are differences.
  const auto turned = [&](const Value& v) -> std::optional<Value> {
    if (const auto* p = std::get_if<Vec3>(&v)) return centre + transform_vector(turn, *p - centre);
    if (const auto* q = std::get_if<Quat>(&v)) return normalize(*q * by);
    return std::nullopt;
  };
  const auto vectors = change_values(track, s, false, "rotated", [&](const Value& v) {
    const auto* points = std::get_if<Points>(&v);
    return points ? each_point(*points, turned) : turned(v);
  });
  if (!vectors) return vectors;
  track.events.edit_between(s.from, s.to, [&](Event& e) {
    if (!e.detail) return;
    EventDetail& d = e.detail.edit();
    for (auto* tangent : {&d.tangent_in, &d.tangent_out})
      if (*tangent) {
        if (auto* t = std::get_if<Vec3>(&**tangent))
          *t = transform_vector(turn, *t);
        else if (auto* q = std::get_if<Quat>(&**tangent))
          *q = *q * by;
      }
  });
  return vectors;
}

}  // namespace betwixt
