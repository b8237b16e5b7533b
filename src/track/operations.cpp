// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/operations.h"

#include <algorithm>
#include <cmath>

#include "track/twerpers.h"

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
      error = r ? fail(ErrorCode::range, std::string("a value would be too large if it were ") + what)
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

Error out_of_reach() { return fail(ErrorCode::range, "the events would be more than 146 years away"); }

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
          if (!moved || !finite(*moved)) return fail(ErrorCode::type, "the copies cannot be shifted by this value");
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
    if (!steepen(d, 1 / factor)) return fail(ErrorCode::range, "a tangent would be too large");
    for (auto* handle : {&d.handle_in, &d.handle_out})
      if (*handle) {
        if ((*handle)->seconds() * factor > longest_seconds) return out_of_reach();
        *handle = stretched(**handle);
      }
  }
  return put_back(track, s, std::move(events));
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

Result<Changed> scale_segment(Track& track, Segment s, const Value& by) {
  return change_values(track, s, true, "scaled by this",
                       [&](const Value& v) { return combine(v, by, [](double x, double y) { return x * y; }); });
}

Result<Changed> translate_segment(Track& track, Segment s, const Value& by) {
  return change_values(track, s, false, "moved by this", [&](const Value& v) { return add_scaled(v, by, 1); });
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
