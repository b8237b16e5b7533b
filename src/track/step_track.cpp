// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tracks of values that are not numbers.
#include <algorithm>

#include "base/memory.h"
#include "track/curve.h"

namespace betwixt {

StepTrack::StepTrack(const Track& track, Type type) : before_(track.before), after_(track.after) {
  track.events.each([&](const Event& e) {
    if (e.keep && values_.empty()) return;
    const auto twerper = static_cast<std::uint8_t>(resolve(track, e, type, false));
    if (e.detail && e.detail->before) values_.push_back(*e.detail->before);
    const std::size_t comes_to = values_.size() - (e.keep || (e.detail && e.detail->before) ? 1 : 0);
    if (!e.keep) values_.push_back(e.value);
    keys_.push_back({e.time, comes_to, values_.size() - 1, twerper, e.detail});
    if (track.global != Twerper::unset) keys_.back().detail.edit().arguments = track.arguments;
    keys_.back().ease = ease_with(static_cast<Twerper>(twerper), keys_.back().detail->arguments);
  });
}

// Returns where a time falls if the track repeats.
std::int64_t StepTrack::folded(std::int64_t t) const {
  const std::int64_t first = keys_.front().time.flicks, last = keys_.back().time.flicks;
  const Extrapolation how = t < first ? before_ : after_;
  const bool seam = t == last && how == Extrapolation::cycle && keys_.size() > 1;  // at the seam the first value holds
  const bool outside = t < first || t > last || seam;
  return outside && how >= Extrapolation::cycle ? fold(t, first, last, how == Extrapolation::bounce) : t;
}

Between StepTrack::at(Time time, const CurveSet& set) const {
  const std::int64_t t = folded(time.flicks);
  const auto next =
      std::upper_bound(keys_.begin(), keys_.end(), t, [](std::int64_t at, const Key& k) { return at < k.time.flicks; });
  if (next == keys_.begin()) return {next->comes_to, next->comes_to, 0};
  const Key& key = next[-1];
  const auto twerper = static_cast<Twerper>(key.twerper);
  if (next == keys_.end() || twerper == Twerper::hold) return {key.goes_on, key.goes_on, 0};
  const double h = static_cast<double>((next->time - key.time).flicks);
  CurveDetail from, to;
  from.ease_out = static_cast<double>(key.detail->ease_out.flicks);
  to.ease_in = static_cast<double>(next->detail->ease_in.flicks);
  const double s = eased(static_cast<double>(t - key.time.flicks) / h, &from, &to, h);
  const Ease* const ease = key.ease ? key.ease.get() : is_own(twerper) ? nullptr : ease_of(twerper);
  Between between{key.goes_on, next->comes_to, set.factor(twerper, s, ease, key.detail->arguments.stops.get())};
  between.splines = !is_own(twerper) && row_of(twerper).cubics;
  between.key = static_cast<std::size_t>(&key - keys_.data()), between.eased = s;
  return between;
}

bool StepTrack::runs_code(Time time) const {
  const std::int64_t t = folded(time.flicks);
  const auto next =
      std::upper_bound(keys_.begin(), keys_.end(), t, [](std::int64_t at, const Key& k) { return at < k.time.flicks; });
  return next != keys_.begin() && next != keys_.end() && is_own(static_cast<Twerper>(next[-1].twerper));
}

bool StepTrack::blends() const {
  for (std::size_t k = 0; k + 1 < keys_.size(); ++k)
    if (static_cast<Twerper>(keys_[k].twerper) != Twerper::hold && keys_[k].goes_on != keys_[k + 1].comes_to)
      return true;
  return false;
}

bool StepTrack::fits(const Between& w) const {
  if (w.a >= values_.size() || w.b >= values_.size()) return false;
  if (!w.splines) return true;
  if (w.key + 1 >= keys_.size()) return false;
  const auto twerper = static_cast<Twerper>(keys_[w.key].twerper);
  return !is_own(twerper) && row_of(twerper).cubics != nullptr;
}

// The weights are the values of the cubics for numbers that are 1 at one of the four and 0 at the others.
Weights StepTrack::weigh(const Between& w, const std::function<bool(const Value&, const Value&)>& alike) const {
  const auto as_here = [&](std::size_t value) { return alike(values_[w.a], values_[value]); };
  constexpr auto hold = static_cast<std::uint8_t>(Twerper::hold);
  const std::size_t k = w.key;
  const auto length = [&](std::size_t i) { return static_cast<double>((keys_[i + 1].time - keys_[i].time).flicks); };
  const auto cut = [&](std::size_t i) { return keys_[i].comes_to != keys_[i].goes_on; };
  static constexpr double one[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  Weights out{{w.a, w.a, w.b, w.b}, {}};
  Blend g;
  g.channels = 4, g.from = one[1], g.to = one[2];
  g.length = g.length_before = g.length_after = length(k);
  if (k > 0 && !cut(k) && keys_[k - 1].twerper != hold && as_here(keys_[k - 1].goes_on))
    g.before = one[0], g.length_before = length(k - 1), out.values[0] = keys_[k - 1].goes_on;
  if (k + 2 < keys_.size() && !cut(k + 1) && keys_[k + 1].twerper != hold && as_here(keys_[k + 2].comes_to))
    g.after = one[3], g.length_after = length(k + 1), out.values[3] = keys_[k + 2].comes_to;
  Cubic cubics[4];
  row_of(static_cast<Twerper>(keys_[k].twerper)).cubics(g, cubics);
  for (std::size_t i = 0; i < 4; ++i) out.weights[i] = cubics[i].at(w.eased);
  return out;
}

std::optional<Time> StepTrack::next_change(Time t) const {
  if (values_.size() < 2) return std::nullopt;  // a single value is constant
  if (keys_.size() > 1 && (t < keys_.front().time ? before_ : after_) != Extrapolation::hold) return t;
  const auto next = std::upper_bound(keys_.begin(), keys_.end(), t, [](Time at, const Key& k) { return at < k.time; });
  if (next == keys_.end()) return std::nullopt;
  const bool blends = next != keys_.begin() && static_cast<Twerper>(next[-1].twerper) != Twerper::hold;
  return blends ? t : next->time;
}

void StepTrack::activities(std::vector<Activity>& out) const {
  const std::size_t first = out.size();
  if (keys_.size() > 1 && before_ >= Extrapolation::cycle) add_activity(out, first, {INT64_MIN, keys_[0].time.flicks});
  for (std::size_t k = 0; k < keys_.size(); ++k) {
    const std::int64_t from = keys_[k].time.flicks;
    const bool blends = k + 1 < keys_.size() && static_cast<Twerper>(keys_[k].twerper) != Twerper::hold;
    add_activity(out, first, {from, blends ? keys_[k + 1].time.flicks : from});
  }
  if (keys_.size() > 1 && after_ >= Extrapolation::cycle)
    add_activity(out, first, {keys_.back().time.flicks, INT64_MAX});
}

std::size_t StepTrack::bytes() const { return bytes_held(keys_) + bytes_held(values_); }

}  // namespace betwixt
