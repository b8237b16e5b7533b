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

// Sets the cubics of the share of the way: those of the row, the line between both ends, or the first value.
void put_cubics(Twerper t, const Blend& g, CubicSegment& out) {
  out.ramps = false, out.ease = nullptr;
  if (t == Twerper::hold) {
    // Negative zeros, so that a negative zero stays one.
    for (std::uint32_t i = 0; i < g.channels; ++i)
      out.c[0][i] = g.from[i], out.c[1][i] = out.c[2][i] = out.c[3][i] = -0.0;
    return;
  }
  if (const auto cubics_of = row_of(t).cubics) {
    Cubic cubics[4];
    cubics_of(g, cubics);
    for (std::uint32_t i = 0; i < g.channels; ++i)
      for (std::size_t power = 0; power < 4; ++power) out.c[power][i] = cubics[i].c[power];
    return;
  }
  for (std::uint32_t i = 0; i < g.channels; ++i)
    out.c[0][i] = g.from[i], out.c[1][i] = g.to[i] - g.from[i], out.c[2][i] = out.c[3][i] = 0;
}

// Whether the segment is not constant.
bool moves(Twerper t, const Blend& g) {
  return t != Twerper::hold && (row_of(t).cubics || !std::equal(g.from, g.from + g.channels, g.to));
}

// Whether put_cubics() and an ease are all that the twerper does.
bool by_cubics(Twerper t) { return !is_own(t) && (row_of(t).cubics || !row_of(t).numbers); }

}  // namespace

// Tries the events next to `here`, then those next to the estimate, then bisects.
std::uint32_t CurveEvents::before(const std::int64_t* time, std::uint32_t count, std::int64_t t, std::uint32_t here) {
  if (here + 2 < count && t >= time[here + 1] && t < time[here + 2]) return here + 1;
  std::uint32_t k = betwixt::guess(time[0], time[count - 1], count, t);
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
      columns(c.columns),
      first_event(c.first),
      first(times[0]),
      last(times[c.count - 1]),
      count(c.count),
      channels(c.channels),
      plain(!c.orientation && !c.srgb && !c.seamless && !c.detailed) {}

namespace {

constexpr std::uint32_t window = 16;  // events, in two or three cache lines

std::uint32_t window_at(std::uint32_t guess, std::uint32_t count) {
  return std::min(guess > window / 2 ? guess - window / 2 : 0, count > window ? count - window : 0);
}

}  // namespace

std::uint32_t CurveEvents::guess(std::int64_t t, const CubicSegment& was) const {
  const bool next = t >= was.until && static_cast<double>(t - was.until) < was.length && was.event + 2 < count;
  const std::uint32_t k = next ? was.event + 1 : betwixt::guess(first, last, count, t), from = window_at(k, count);
  __builtin_prefetch(times + from), __builtin_prefetch(times + from + window / 2);
  __builtin_prefetch(times + from + window - 1), __builtin_prefetch(twerpers + k);
  return k;
}

// Counts the events before t in a window about the guess, without branches; else bisects.
std::uint32_t CurveEvents::find(std::int64_t t, std::uint32_t guess) const {
  std::uint32_t from = window_at(guess, count), k = 0;
  const std::uint32_t until = std::min(from + window, count);
  if (times[from] <= t && (until == count || t < times[until])) {
    k = from - 1;
    for (std::uint32_t i = from; i < until; ++i) k += times[i] <= t;
  } else {
    for (std::uint32_t many = count; many > 1; many -= many / 2) k += times[k + many / 2] <= t ? many / 2 : 0;
  }
  const std::uint32_t before = k > 0 ? k - 1 : 0;
  __builtin_prefetch(values + before * channels), __builtin_prefetch(values + before * channels + 8);
  return k;
}

bool CurveEvents::cubic(std::uint32_t k, CubicSegment& out) const {
  const auto twerper = static_cast<Twerper>(twerpers[k]);
  if (!by_cubics(twerper)) return false;
  constexpr auto hold = static_cast<std::uint8_t>(Twerper::hold);
  const auto length = [&](std::uint32_t i) { return static_cast<double>(times[i + 1] - times[i]); };
  Blend g;
  g.channels = channels;
  g.from = values + k * channels, g.to = g.from + channels;
  g.length = g.length_before = g.length_after = length(k);
  if (k > 0 && twerpers[k - 1] != hold) g.before = g.from - channels, g.length_before = length(k - 1);
  if (k + 2 < count && twerpers[k + 1] != hold) g.after = g.to + channels, g.length_after = length(k + 1);
  put_cubics(twerper, g, out);
  if (!row_of(twerper).cubics) out.ease = columns->ease(first_event + k);
  out.moves = moves(twerper, g);
  out.from = times[k], out.until = times[k + 1], out.length = g.length, out.event = k;
  return true;
}

bool CurveSet::cubic(const Curve& c, std::int64_t t, CubicSegment& out) const {
  const std::int64_t *first = &c.columns->times[c.first], *last = first + c.count - 1;
  if (c.orientation || c.srgb || t < *first || t >= *last) return false;
  const std::uint32_t k = CurveEvents::before(first, c.count, t, out.event);
  const auto twerper = static_cast<Twerper>(c.columns->twerpers[c.first + k]);
  const CurveDetail *here = detail(c, k), *next = detail(c, k + 1);
  if (!by_cubics(twerper) || (here && here->arguments.stops)) return false;
  const Blend g = blend(c, k);
  out.from = first[k], out.until = first[k + 1], out.length = g.length, out.event = k;
  put_cubics(twerper, g, out);
  if (!row_of(twerper).cubics) out.ease = c.columns->ease(c.first + k);
  if (twerper != Twerper::hold && ((here && here->ease_out > 0) || (next && next->ease_in > 0))) {
    out.ramps = true;
    out.ease_out() = here ? here->ease_out / g.length : 0, out.ease_in() = next ? next->ease_in / g.length : 0;
  }
  return true;
}

}  // namespace betwixt
