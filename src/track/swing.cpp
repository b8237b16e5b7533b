// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/swing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "track/curve.h"

namespace betwixt {
namespace {

constexpr std::int64_t most_looks = 64;  // between two events

// Returns whether any two neighbours have a number in common; only for such a track of numbers a curve is worth making.
bool rests_anywhere(const Track& track) {
  std::array<double, 4> last{}, now{};
  int count = 0;
  bool rests = false, plain = true;
  track.events.each([&](const Event& e) {
    const int n = e.keep ? 0 : to_numbers(e.value, now.data());
    plain = plain && !e.release && (e.keep || n > 0);
    for (std::size_t i = 0; i < static_cast<std::size_t>(std::min(n, count)); ++i) rests = rests || last[i] == now[i];
    last = now, count = n;
  });
  return rests && plain;
}

struct Look {
  const CurveSet& set;
  const Curve& curve;
  Rate rate;

  double number(std::uint32_t k, int i) const { return set.event_numbers(curve, k)[i]; }
  bool cut(std::uint32_t k) const {
    const auto& all = curve.columns->details;
    const auto at = std::lower_bound(all.begin(), all.end(), curve.first + k,
                                     [](const CurveDetail& d, std::uint32_t event) { return d.event < event; });
    return at != all.end() && at->event == curve.first + k && at->cut;
  }
  // Returns the range of the numbers at both ends of a segment and beside it.
  double range(std::uint32_t k, int i) const {
    double low = number(k, i), high = low;
    for (std::uint32_t j = k > 0 ? k - 1 : 0; j < std::min(k + 3, curve.count); ++j)
      low = std::min(low, number(j, i)), high = std::max(high, number(j, i));
    return high - low;
  }
  // Finds the whole frame in the segment with the largest distance, as a share of the range.
  void look(std::uint32_t k, int i, double& widest, std::optional<Swing>& out) const {
    const double rest = number(k, i), range = this->range(k, i);
    if (!(range > 0) || number(k + 1, i) != rest) return;
    const Time from{set.event_time(curve, k)}, to{set.event_time(curve, k + 1)};
    const auto first = static_cast<std::int64_t>(std::floor(rate.frame_number(from))) + 1;
    const auto frames = static_cast<std::int64_t>(std::ceil(rate.frame_number(to))) - first;
    const std::int64_t looks = std::min(frames, most_looks);
    for (std::int64_t l = 0; l < looks; ++l) {
      const Time at = rate.frame(static_cast<double>(first + l * frames / looks));
      std::array<double, 4> now{};
      set.evaluate(curve, at, now.data());
      const double away = std::abs(now[static_cast<std::size_t>(i)] - rest) / range;
      if (away <= widest) continue;
      widest = away;
      out = Swing{from, to, at, i, rest, now[static_cast<std::size_t>(i)]};
    }
  }
};

}  // namespace

std::optional<Swing> widest_swing(const Track& track, Type type, bool component, Rate rate) {
  std::optional<Swing> out;
  if (track.events.size() < 3 || row_of(type).light || number_count(type) == 0 || !rests_anywhere(track)) return out;
  if (track.global != Twerper::unset && track.global != Twerper::smooth) return out;
  CurveSet set;
  const Curve curve = set.add(track, type, component);
  if (curve.orientation) return out;
  const Look look{set, curve, rate};
  double widest = widest_follow_through;
  for (std::uint32_t k = 0; k + 1 < curve.count; ++k) {
    if (static_cast<Twerper>(curve.columns->twerpers[curve.first + k]) != Twerper::smooth) continue;
    for (int i = 0; i < curve.channels; ++i)
      if (look.number(k, i) == look.number(k + 1, i) && !look.cut(k + 1)) look.look(k, i, widest, out);
  }
  return out;
}

}  // namespace betwixt
