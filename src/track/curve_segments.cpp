// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Finds the segment of a curve at a time, and its cubics.
#include <algorithm>

#include "track/curve.h"

namespace betwixt {
namespace {

// Estimates the last event before t, which is between the first and the last: in most tracks the events are about
// evenly spaced.
std::uint32_t guess(std::int64_t first, std::int64_t last, std::uint32_t count, std::int64_t t) {
  const double all = static_cast<double>(last) - static_cast<double>(first);
  const double part = (static_cast<double>(t) - static_cast<double>(first)) / all;
  return std::min(static_cast<std::uint32_t>(part * (count - 1)), count - 2);
}

void put_cubics(const TwerperRow& row, const Blend& g, CubicSegment& out) {
  if (row.cubics) {
    Cubic cubics[4];
    row.cubics(g, cubics);
    for (std::uint32_t i = 0; i < g.channels; ++i)
      for (std::size_t power = 0; power < 4; ++power) out.c[power][i] = cubics[i].c[power];
    return;
  }
  for (std::uint32_t i = 0; i < g.channels; ++i)
    out.c[0][i] = g.from[i], out.c[1][i] = g.to[i] - g.from[i], out.c[2][i] = out.c[3][i] = 0;
}

}  // namespace

// Tries the events next to `here`, then those next to the estimate, then bisects.
std::uint32_t CurveEvents::before(const std::int64_t* time, std::uint32_t count, std::int64_t t, std::uint32_t here) {
  if (here + 2 < count && t >= time[here + 1] && t < time[here + 2]) return here + 1;
  std::uint32_t k = guess(time[0], time[count - 1], count, t);
  for (int steps = 0; steps < 4; ++steps) {
    if (t < time[k])
      --k;
    else if (t >= time[k + 1])
      ++k;
    else
      return k;
  }
  return static_cast<std::uint32_t>(std::upper_bound(time, time + count, t) - time) - 1;
}

CurveEvents::CurveEvents(const Curve& c)
    : times(&c.columns->times[c.first]),
      values(&c.columns->values[c.values]),
      twerpers(&c.columns->twerpers[c.first]),
      first(times[0]),
      last(times[c.count - 1]),
      count(c.count),
      channels(c.channels),
      plain(!c.orientation && !c.srgb && !c.seamless && c.columns->details.empty()) {}

void CurveEvents::fetch(std::int64_t t, const CubicSegment& was) const {
  if (t < first || t >= last) return;
  const bool next = t >= was.until && static_cast<double>(t - was.until) < was.length;
  const std::uint32_t k = next ? was.event + 1 : guess(first, last, count, t), from = k > 0 ? k - 1 : 0;
  __builtin_prefetch(times + k), __builtin_prefetch(twerpers + k);
  __builtin_prefetch(values + from * channels), __builtin_prefetch(values + from * channels + 8);
}

bool CurveEvents::cubic(std::int64_t t, CubicSegment& out) const {
  if (t < first || t >= last) return false;
  const std::uint32_t k = CurveEvents::before(times, count, t, out.event);
  const auto twerper = static_cast<Twerper>(twerpers[k]);
  if (is_own(twerper) || twerper == Twerper::hold) return false;
  const TwerperRow& row = row_of(twerper);
  if (!row.cubics && row.factor) return false;
  constexpr auto hold = static_cast<std::uint8_t>(Twerper::hold);
  const auto length = [&](std::uint32_t i) { return static_cast<double>(times[i + 1] - times[i]); };
  Blend g;
  g.channels = channels;
  g.from = values + k * channels, g.to = g.from + channels;
  g.length = g.length_before = g.length_after = length(k);
  if (k > 0 && twerpers[k - 1] != hold) g.before = g.from - channels, g.length_before = length(k - 1);
  if (k + 2 < count && twerpers[k + 1] != hold) g.after = g.to + channels, g.length_after = length(k + 1);
  put_cubics(row, g, out);
  out.from = times[k], out.until = times[k + 1], out.length = g.length, out.event = k;
  return true;
}

bool CurveSet::cubic(const Curve& c, std::int64_t t, CubicSegment& out) const {
  const std::int64_t *first = &c.columns->times[c.first], *last = first + c.count - 1;
  if (c.orientation || c.srgb || t < *first || t >= *last) return false;
  const std::uint32_t k = CurveEvents::before(first, c.count, t, out.event);
  const auto twerper = static_cast<Twerper>(c.columns->twerpers[c.first + k]);
  if (is_own(twerper) || twerper == Twerper::hold) return false;
  const TwerperRow& row = row_of(twerper);
  const CurveDetail *here = detail(c, k), *next = detail(c, k + 1);
  if ((!row.cubics && row.factor) || (here && (here->ease_out > 0 || here->arguments.stops)) ||
      (next && next->ease_in > 0))
    return false;
  const Blend g = blend(c, k);
  out.from = first[k], out.until = first[k + 1], out.length = g.length, out.event = k;
  put_cubics(row, g, out);
  return true;
}

}  // namespace betwixt
