// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline/simplified.h"

#include <algorithm>
#include <cmath>

#include "betwixt/track.h"
#include "scene/document.h"
#include "track/curve.h"
#include "track/types.h"

namespace betwixt::studio {
namespace {

constexpr int samples_a_segment = 12;
constexpr std::size_t most_work = 100'000;  // events to read while they are tried one by one

// One track, its numbers at many times, and the events that may go.
class TrackSimplifier {
 public:
  TrackSimplifier(const Document& d, const Picked& picked) : d_(d) {
    const auto tracks = tracks_of(d.scene(), picked.target);
    const Type whole = spec_of(d.scene(), picked.target.function).type;
    const Type of = picked.target.velocity ? row_of(whole).rate.value_or(Type::text) : whole;
    component_ = picked.target.component >= 0;
    type_ = component_ ? component_track_type(of) : of;
    if (tracks.size() != 1 || tracks[0]->events.size() < 3 || row_of(type_).channels == 0) return;
    track_ = *tracks[0];
    track_.events.each([&](const Event& e) {
      const bool free = !e.keep && !(e.detail && e.detail->before) && std::ranges::binary_search(picked.times, e.time);
      all_.push_back(e), stays_.push_back(!free);
      plain_ = plain_ && !e.release && (e.keep || numeric(e.value));
    });
    stays_.front() = stays_.back() = true;
    if (!plain_) return;
    for (std::size_t i = 0; i + 1 < all_.size(); ++i)
      for (int k = 0; k < samples_a_segment; ++k)
        times_.push_back(all_[i].time + Time{(all_[i + 1].time - all_[i].time).flicks / samples_a_segment * k});
    times_.push_back(all_.back().time);
    exact_ = values_of(track_);
    double low[4] = {}, high[4] = {};
    for (std::size_t i = 0; i < exact_.size(); ++i) {
      const std::size_t c = i % channels_;
      low[c] = i < channels_ ? exact_[i] : std::min(low[c], exact_[i]);
      high[c] = i < channels_ ? exact_[i] : std::max(high[c], exact_[i]);
    }
    for (std::size_t c = 0; c < channels_; ++c) range_ = std::max(range_, high[c] - low[c]);
    if (range_ == 0) range_ = 1;
  }
  bool any() const { return plain_ && !exact_.empty(); }

  // Adds events where the difference is too large, until it is nowhere. Then tries to remove each once more.
  std::vector<Time> gone(double tolerance, double& error) {
    std::vector<bool> kept = stays_;
    for (;;) {
      const std::vector<double> off = differences(kept);
      if (!keep_more(kept, off, tolerance)) break;
    }
    std::vector<std::size_t> tried;
    for (std::size_t i = 0; i < kept.size(); ++i)
      if (kept[i] && !stays_[i]) tried.push_back(i);
    if (tried.size() * all_.size() <= most_work)
      for (const std::size_t i : tried) {
        kept[i] = false;
        if (largest(differences(kept)) > tolerance) kept[i] = true;
      }
    error = std::max(error, largest(differences(kept)));
    std::vector<Time> times;
    for (std::size_t i = 0; i < kept.size(); ++i)
      if (!kept[i]) times.push_back(all_[i].time);
    return times;
  }

 private:
  static double largest(const std::vector<double>& off) { return *std::ranges::max_element(off); }

  std::vector<double> values_of(const Track& track) {
    CurveSet set;
    for (const NamedProcedure& p : *d_.scene().procedures) set.own.push_back(p.code);
    const Curve curve = set.add(track, type_, component_);
    channels_ = curve.channels;
    std::vector<double> all;
    all.reserve(times_.size() * channels_);
    for (const Time t : times_) {
      double v[4] = {};
      set.evaluate(curve, t, v);
      all.insert(all.end(), v, v + channels_);
    }
    return all;
  }

  // The largest difference at each sample, as a share of the range.
  std::vector<double> differences(const std::vector<bool>& kept) {
    Track less = track_;
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (!kept[i]) less.events.erase(all_[i].time, all_[i].time);
    const std::vector<double> now = values_of(less);
    std::vector<double> off(times_.size());
    for (std::size_t i = 0; i < now.size(); ++i)
      off[i / channels_] = std::max(off[i / channels_], std::abs(now[i] - exact_[i]) / range_);
    return off;
  }

  // In each gap between kept events, keeps the event nearest to the worst sample. Returns whether there was any.
  bool keep_more(std::vector<bool>& kept, const std::vector<double>& off, double tolerance) const {
    bool any = false, wrong = false;
    const std::vector<bool> was = kept;
    for (std::size_t from = 0; from + 1 < all_.size();) {
      std::size_t to = from + 1;
      while (!was[to]) ++to;
      const auto first = off.begin() + static_cast<std::ptrdiff_t>(from * samples_a_segment),
                 last = off.begin() + static_cast<std::ptrdiff_t>(to * samples_a_segment + 1);
      const auto worst = std::max_element(first, last);
      if (*worst > tolerance) {
        wrong = true;
        const double place = static_cast<double>(worst - off.begin()) / samples_a_segment;
        const std::size_t nearest = std::clamp(static_cast<std::size_t>(std::llround(place)), from + 1, to);
        const std::size_t added = nearest < to ? nearest : to - 1;
        if (added > from) kept[added] = any = true;
      }
      from = to;
    }
    if (any || !wrong) return any;
    // The difference comes from a neighbour's tangent: keep the missing event that is nearest to it.
    const double place = static_cast<double>(std::ranges::max_element(off) - off.begin()) / samples_a_segment;
    std::size_t best = all_.size();
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (!kept[i] && (best == all_.size() ||
                       std::abs(static_cast<double>(i) - place) < std::abs(static_cast<double>(best) - place)))
        best = i;
    if (best < all_.size()) kept[best] = true;
    return best < all_.size();
  }

  const Document& d_;
  Track track_;
  Type type_ = Type::scalar;
  bool component_ = false, plain_ = true;
  std::vector<Event> all_;
  std::vector<bool> stays_;
  std::vector<Time> times_;
  std::vector<double> exact_;  // channels_ numbers for each time
  std::size_t channels_ = 1;
  double range_ = 0;
};

}  // namespace

Simplified simplified(const Document& d, const std::vector<EventAt>& events, double tolerance) {
  Simplified made;
  for (const Picked& p : by_track(events)) {
    TrackSimplifier track(d, p);
    if (!track.any()) continue;
    for (const Time t : track.gone(tolerance, made.error)) made.gone.push_back({p.target, t});
  }
  return made;
}

}  // namespace betwixt::studio
