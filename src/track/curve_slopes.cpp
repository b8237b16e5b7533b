// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The extrapolation and the derivative of curves.
#include <algorithm>
#include <cmath>
#include <optional>

#include "track/curve.h"
#include "track/turns.h"

namespace betwixt {
namespace {

using Numbers = std::array<double, 4>;

// Returns whether a segment of numbers is a polynomial of its eased time: linear, or with a formula of its row.
bool straight(Twerper t, const CurveDetail* from) {
  return !is_own(t) && !row_of(t).factor && !row_of(t).cubics && !row_of(t).turn && !(from && from->arguments.stops);
}

// Returns the slope of an F-curve over a segment of length 1: towards the handle, or, if the handle is at the event,
// towards the other event's handle.
std::optional<double> handle_slope(const Blend& g, std::uint32_t i, bool after) {
  const double own = after ? g.handle_in_length : g.handle_out_length;
  const double* way = after ? g.handle_in : g.handle_out;
  if (!way) return 0;
  if (own > 0) return (after ? -1 : 1) * way[i] / own * g.length;
  return std::nullopt;
}

// Returns the slope of a bezier's factor at its end or beginning, or nullopt if it is vertical.
std::optional<double> bezier_slope(const std::array<double, 4>& b, bool after) {
  const double x1 = after ? 1 - b[2] : b[0], y1 = after ? 1 - b[3] : b[1];
  const double x2 = after ? 1 - b[0] : b[2], y2 = after ? 1 - b[1] : b[3];
  if (x1 > 0) return y1 / x1;
  if (y1 != 0) return std::nullopt;
  return x2 > 0 ? std::optional(y2 / x2) : std::nullopt;  // the near point is the end itself, so use the other one
}

}  // namespace

// Extrapolates `past` flicks beyond the first or last event at the speed of the end segment. An orientation keeps
// turning.
void CurveSet::beyond(const Curve& c, bool after, double past, double* out) const {
  const std::uint32_t end = after ? c.count - 1 : 0, k = after ? end - 1 : 0, n = c.channels;
  const double* value = &c.columns->values[c.values + end * n];
  const double h = static_cast<double>(c.columns->times[c.first + k + 1] - c.columns->times[c.first + k]);
  const auto twerper = static_cast<Twerper>(c.columns->twerpers[c.first + k]);
  std::copy_n(value, n, out);
  if (twerper == Twerper::hold) return;
  const CurveDetail *from = detail(c, k), *to = detail(c, k + 1);
  if (straight(twerper, from) && !(from && from->ease_out > 0) && !(to && to->ease_in > 0))
    return segment(c, k, after ? h + past : past, out);  // exact

  // An ease ends at rest; a vertical tangent has no slope to continue with.
  double out_part = from ? from->ease_out / h : 0, in_part = to ? to->ease_in / h : 0;
  if ((after ? in_part : out_part) > 0) return;
  const double shrink = std::max(1.0, out_part + in_part), eased_slope = 1 / (1 - (out_part + in_part) / shrink / 2);
  const TwerperRow* row = is_own(twerper) ? nullptr : &row_of(twerper);
  std::optional<double> rise = 1;
  if (twerper == Twerper::bezier && !(rise = bezier_slope(c.columns->ease(c.first + k)->arguments(), after))) return;
  if (row && !c.orientation && row->numbers) {
    const Blend g = blend(c, k);
    for (std::uint32_t i = 0; i < n; ++i) out[i] += handle_slope(g, i, after).value_or(0) * eased_slope * past / h;
    return;
  }
  const bool stops = from && from->arguments.stops;
  if (row && !c.orientation && !stops && (row->cubics || !row->factor || twerper == Twerper::bezier)) {
    Cubic cubics[4];
    const Blend g = blend(c, k);
    if (row->cubics) row->cubics(g, cubics);
    for (std::uint32_t i = 0; i < n; ++i) {
      const double* p = cubics[i].c;
      const double slope = !row->cubics ? *rise * (g.to[i] - g.from[i]) : after ? p[1] + 2 * p[2] + 3 * p[3] : p[1];
      out[i] += slope * eased_slope * past / h;
    }
    return;
  }

  // The slope by a formula that is exact for parabolas.
  const double step = (after ? -1 : 1) * h / 4096, origin = after ? h : 0;
  Numbers one{}, two{};
  segment(c, k, origin + step, one.data());
  segment(c, k, origin + 2 * step, two.data());
  if (c.orientation) {
    const Quat a = log(conjugate(quat(value)) * quat(one.data())), b = log(conjugate(quat(value)) * quat(two.data()));
    const double f = past / (2 * step);
    return store(quat(value) * exp({0, f * (4 * a.x - b.x), f * (4 * a.y - b.y), f * (4 * a.z - b.z)}), out);
  }
  for (std::uint32_t i = 0; i < n; ++i) out[i] += (-3 * value[i] + 4 * one[i] - two[i]) / (2 * step) * past;
}

void CurveSet::derivative(const Curve& c, Time time, double* out, bool coming) const {
  // Five values around the time, all in its own segment: a difference quotient that is exact for quartics.
  const std::int64_t *first = &c.columns->times[c.first], *last = first + c.count - 1;
  const std::int64_t t = time.flicks;
  const double second = static_cast<double>(flicks_per_second);
  std::fill_n(out, c.orientation ? 3 : c.channels, 0.0);
  if (c.count < 2) return;
  const bool early = coming ? t <= *first : t < *first, outside = early || (coming ? t > *last : t >= *last);
  std::array<Numbers, 5> v{};
  double h = 0, offset = 0;  // the step, and the offset of the time among the five, in steps
  if (outside) {
    const Extrapolation how = early ? c.before : c.after;
    if (how == Extrapolation::hold) return;
    h = std::max(1.0, std::min(static_cast<double>(*last - *first) / 4096, second / 1024));
    const auto step = (coming ? -1 : 1) * static_cast<std::int64_t>(h);
    h = static_cast<double>(step);
    for (int i = 0; i < 5; ++i) evaluate(c, {t + i * step}, v[static_cast<std::size_t>(i)].data());
  } else {
    const auto* behind = coming ? std::lower_bound(first, last + 1, t) : std::upper_bound(first, last + 1, t);
    const auto k = static_cast<std::uint32_t>(behind - first) - 1;
    const double length = static_cast<double>(first[k + 1] - first[k]), since = static_cast<double>(t - first[k]);
    h = length / 1024;
    const double begin = std::clamp(since - 2 * h, 0.0, length - 4 * h);
    offset = (since - begin) / h;
    for (int i = 0; i < 5; ++i) {
      auto& n = v[static_cast<std::size_t>(i)];
      segment(c, k, begin + i * h, n.data());
      if (c.srgb)
        for (double& x : n) x = to_linear(x);
    }
  }
  // Weights of the derivative of the quartic through five points, at `offset`.
  std::array<double, 5> w{};
  for (int i = 0; i < 5; ++i) {
    double below = 1, sum = 0;
    for (int j = 0; j < 5; ++j) {
      if (j == i) continue;
      below *= i - j;
      double product = 1;
      for (int m = 0; m < 5; ++m)
        if (m != i && m != j) product *= offset - m;
      sum += product;
    }
    w[static_cast<std::size_t>(i)] = sum / below / (h / second);
  }
  if (!c.orientation) {  // from differences, so that a constant has no speed at all
    for (std::size_t i = 1; i < 5; ++i)
      for (std::size_t n = 0; n < c.channels; ++n) out[n] += w[i] * (v[i][n] - v[0][n]);
    return;
  }
  // Rotations relative to the middle one, in the parent's axes.
  const Quat middle = quat(v[2].data());
  for (std::size_t i = 0; i < 5; ++i) {
    Quat q = quat(v[i].data());
    if (dot(q, middle) < 0) q = -q;
    const Quat turn = log(q * conjugate(middle));
    out[0] += 2 * w[i] * turn.x, out[1] += 2 * w[i] * turn.y, out[2] += 2 * w[i] * turn.z;
  }
}

}  // namespace betwixt
