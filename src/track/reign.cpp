// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/reign.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace betwixt {
namespace {

constexpr double second = static_cast<double>(flicks_per_second);

Quat turn_by(Vec3 angle) {
  const double a = length(angle);
  if (a < 1e-300) return {};
  const double k = std::sin(a / 2) / a;
  return {std::cos(a / 2), k * angle.x, k * angle.y, k * angle.z};
}

// Returns the rotation over one step of a varying angular velocity: Magnus' series of fourth order, from two Gauss
// points.
Quat magnus(const CurveSet& set, const Curve& v, std::int64_t from, std::int64_t length_in_flicks, double sign) {
  const double whole = static_cast<double>(length_in_flicks), h = whole / second;
  double a[4], b[4];
  const auto at = [&](double u) { return Time{from + std::llround(u * whole)}; };
  set.evaluate(v, at(0.5 - std::sqrt(3.0) / 6), a);
  set.evaluate(v, at(0.5 + std::sqrt(3.0) / 6), b);
  const Vec3 p{a[0], a[1], a[2]}, q{b[0], b[1], b[2]};
  return turn_by(sign * h / 2 * (p + q) + (std::sqrt(3.0) / 12 * h * h) * cross(q, p));
}

const CurveDetail* detail_of(const Curve& c, std::uint32_t k) {
  const auto& all = c.columns->details;
  const auto at = std::lower_bound(all.begin(), all.end(), c.first + k,
                                   [](const CurveDetail& d, std::uint32_t event) { return d.event < event; });
  return at != all.end() && at->event == c.first + k ? &*at : nullptr;
}

// Calls f(from, to), in order, for the intervals in which a velocity is smooth, from event k to `end`: they are
// separated by the jumps and corners of its twerper. f returns whether to continue.
template <class F>
void each_piece(const CurveSet& set, const Curve& c, std::uint32_t k, std::int64_t end, F&& f) {
  const std::int64_t begin = set.event_time(c, k);
  std::vector<double> parts;  // in eased time
  const auto twerper = static_cast<Twerper>(c.columns->twerpers[c.first + k]);
  const CurveDetail *here = detail_of(c, k), *next = k + 1 < c.count ? detail_of(c, k + 1) : nullptr;
  if (here && k + 1 < c.count && !is_own(twerper)) {
    const auto steps = row_of(twerper).steps ? static_cast<int>(here->arguments[0]) : 0;
    for (int i = 1; i < steps; ++i) parts.push_back(static_cast<double>(i) / steps);
    if (row_of(twerper).stops && here->arguments.stops)
      for (const Stop& s : *here->arguments.stops) parts.push_back(s[0] / 100);
  }
  std::int64_t from = begin;
  const double length = static_cast<double>(end - begin);
  for (const double part : parts) {
    std::int64_t low = from, high = end;  // bisect for the first flick at which this part has passed
    while (high - low > 1) {
      const std::int64_t t = low + (high - low) / 2;
      (eased(static_cast<double>(t - begin) / length, here, next, length) < part ? low : high) = t;
    }
    if (high <= from || high >= end) continue;
    if (!f(from, high)) return;
    from = high;
  }
  f(from, end);
}

}  // namespace

Reign::Reign(CurveSet& set, const Curve& velocity, bool orientation)
    : v_(velocity), from_{set.span(velocity).first}, orientation_(orientation) {
  prefix_.resize(v_.count * v_.channels);
  double part[4] = {};
  for (std::uint32_t k = 1; k < v_.count; ++k) {
    set.integrate(v_, k - 1, 1, part);
    for (std::uint32_t i = 0; i < v_.channels; ++i)
      prefix_[k * v_.channels + i] = prefix_[(k - 1) * v_.channels + i] + part[i];
  }
  if (!orientation_) return;
  // Is the axis constant (whatever the twerper, since sums of parallel vectors are parallel), or does it vary?
  Vec3 axis;
  for (std::uint32_t k = 0; k < v_.count; ++k) {
    double n[4] = {};
    // The middle of each segment reveals cuts and tangents too.
    for (const std::int64_t t :
         {set.event_time(v_, k), set.event_time(v_, k) - 1,
          k > 0 ? (set.event_time(v_, k) + set.event_time(v_, k - 1)) / 2 : set.event_time(v_, k)}) {
      if (t < from_.flicks) continue;
      set.evaluate(v_, {t}, n);
      const Vec3 w{n[0], n[1], n[2]};
      if (length(axis) == 0) axis = normalize(w, {});
      one_axis_ = one_axis_ && length(cross(axis, w)) <= 1e-12 * length(w);
    }
  }
  if (one_axis_) return;
  const std::int64_t length_ = set.span(v_).second.flicks - from_.flicks;
  step_ = std::max<std::int64_t>(flicks_per_second / 30, length_ / 1'000'000 + 1);
  there_ = steps(set, 1);
  if (v_.after == Extrapolation::bounce) against_ = steps(set, -1);
}

Reign::Steps Reign::steps(const CurveSet& set, double sign) const {
  Steps out;
  Quat q;
  for (std::uint32_t k = 0; k < v_.count; ++k) {
    out.first.push_back(out.turns.size());
    const std::int64_t end = k + 1 < v_.count ? set.event_time(v_, k + 1) : set.event_time(v_, k) + 1;
    each_piece(set, v_, k, end, [&](std::int64_t from, std::int64_t to) {
      for (std::int64_t t = from; t < to; t += step_) {
        out.turns.push_back(q);
        q = normalize(magnus(set, v_, t, std::min(step_, to - t), sign) * q);
      }
      return true;
    });
  }
  return out;
}

void Reign::numbers(const CurveSet& set, Time time, double* out) const {
  const std::uint32_t n = v_.channels;
  const auto copy_prefix = [&](std::uint32_t k) { std::copy_n(&prefix_[k * n], n, out); };
  const auto [first, last] = set.span(v_);
  std::int64_t t = time.flicks;
  double whole = 0, sign = 1;  // whole periods, and the direction of the current one
  if (t > last.flicks) {
    const double past = static_cast<double>(t - last.flicks) / second;
    const std::int64_t period = last.flicks - first.flicks;
    if (v_.count < 2 || v_.after == Extrapolation::hold || v_.after == Extrapolation::linear || period <= 0) {
      double end[4] = {}, rate[4] = {};
      set.evaluate(v_, last, end);
      if (v_.after == Extrapolation::linear && v_.count > 1) {
        double far[4] = {};
        set.evaluate(v_, {last.flicks + flicks_per_second}, far);
        for (std::uint32_t i = 0; i < n; ++i) rate[i] = far[i] - end[i];
      }
      copy_prefix(v_.count - 1);
      for (std::uint32_t i = 0; i < n; ++i) out[i] += end[i] * past + rate[i] * past * past / 2;
      return;
    }
    const std::int64_t turns = (t - first.flicks) / period, rest = (t - first.flicks) % period;
    whole = static_cast<double>(turns);
    t = first.flicks + rest;
    if (v_.after == Extrapolation::bounce && (turns & 1)) ++whole, sign = -1, t = last.flicks - rest;
  }
  std::uint32_t low = 0, high = v_.count;
  while (high - low > 1) {
    const std::uint32_t k = (low + high) / 2;
    (set.event_time(v_, k) <= t ? low : high) = k;
  }
  double part[4] = {};
  if (low + 1 < v_.count) {
    const double h = static_cast<double>(set.event_time(v_, low + 1) - set.event_time(v_, low));
    set.integrate(v_, low, static_cast<double>(t - set.event_time(v_, low)) / h, part);
  }
  copy_prefix(low);
  for (std::uint32_t i = 0; i < n; ++i) out[i] = sign * (out[i] + part[i]) + whole * prefix_[(v_.count - 1) * n + i];
}

// Returns the rotation from the reign's beginning to t, between the first and the last event.
Quat Reign::stepped(const CurveSet& set, const Steps& all, double sign, std::int64_t t) const {
  std::uint32_t low = 0, high = v_.count;
  while (high - low > 1) {
    const std::uint32_t k = (low + high) / 2;
    (set.event_time(v_, k) <= t ? low : high) = k;
  }
  const std::int64_t end = low + 1 < v_.count ? set.event_time(v_, low + 1) : set.event_time(v_, low) + 1;
  std::size_t at = all.first[low];
  std::int64_t past = 0;
  each_piece(set, v_, low, end, [&](std::int64_t from, std::int64_t to) {
    past = t - from;
    if (t < to) return false;
    return at += static_cast<std::size_t>((to - from + step_ - 1) / step_), true;
  });
  const Quat& q = all.turns[at + static_cast<std::size_t>(past / step_)];
  return past % step_ == 0 ? q : magnus(set, v_, t - past % step_, past % step_, sign) * q;
}

Quat Reign::wandered(const CurveSet& set, Time time) const {
  const std::int64_t first = from_.flicks, last = set.span(v_).second.flicks, period = last - first;
  if (time.flicks <= last) return stepped(set, there_, 1, time.flicks);
  Quat q = stepped(set, there_, 1, last);
  if (v_.after == Extrapolation::cycle) {
    const std::int64_t gone = time.flicks - first;
    return stepped(set, there_, 1, first + gone % period) * power(q, static_cast<double>(gone / period));
  }
  if (v_.after == Extrapolation::bounce) {
    // On the way back the velocities come in reverse order: the inverse of the rotation with the reversed velocity.
    const std::int64_t gone = (time.flicks - first) / (2 * period), rest = (time.flicks - first) % (2 * period);
    const Quat home = conjugate(stepped(set, against_, -1, last));
    const Quat all = power(home * q, static_cast<double>(gone));
    if (rest <= period) return stepped(set, there_, 1, first + rest) * all;
    return stepped(set, against_, -1, last - (rest - period)) * home * q * all;
  }
  std::int64_t at = last;
  constexpr int most_steps =
      100'000;  // checkpoints; a velocity that varies without end has no more, and is constant later
  if (v_.after == Extrapolation::linear)
    for (int i = 0; at < time.flicks && i < most_steps; ++i) {
      const std::int64_t step = std::min(step_, time.flicks - at);
      q = normalize(magnus(set, v_, at, step, 1) * q);
      at += step;
    }
  double n[4] = {};
  set.evaluate(v_, {at}, n);
  return turn_by((static_cast<double>(time.flicks - at) / second) * Vec3{n[0], n[1], n[2]}) * q;
}

void Reign::sum(const CurveSet& set, Time t, double* out) const {
  if (!orientation_) return numbers(set, t, out);
  double n[4] = {};
  if (one_axis_) numbers(set, t, n);
  const Quat q = one_axis_ ? turn_by({n[0], n[1], n[2]}) : normalize(wandered(set, t));
  out[0] = q.w, out[1] = q.x, out[2] = q.y, out[3] = q.z;
}

}  // namespace betwixt
