// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/events_apart.h"

#include <algorithm>
#include <cstdlib>

namespace betwixt {
namespace {

struct Unpaired {
  TrackEvents gone, come;

  // Returns how many events have moved so far, if this is the distance.
  std::size_t moved_by(Time by) const {
    return static_cast<std::size_t>(std::ranges::count_if(gone, [&](const auto& e) {
      const auto there = come.find(e.first + by);
      return there != come.end() && there->second == e.second;
    }));
  }

  // Returns the distance by which most events have moved, the first of `gone` among them; 0 if it has not moved.
  Time best_move(const TrackEvents::value_type& first) const {
    constexpr int most_tried = 64;  // a track may hold the same row a million times
    Time best;
    std::size_t most = 0;
    int tried = 0;
    for (const auto& [time, said] : come) {
      if (said != first.second || time == first.first) continue;
      if (++tried > most_tried) break;
      const Time by = time - first.first;
      const std::size_t count = moved_by(by);
      // One event alone has moved only from and to a time at which nothing else happened.
      if (count == 1 && (come.contains(first.first) || gone.contains(time))) continue;
      if (count > most || (count == most && std::abs(by.flicks) < std::abs(best.flicks))) most = count, best = by;
    }
    return best;
  }

  void take_moves(Time by, std::vector<EventChange>& into) {
    std::vector<std::pair<Time, std::string>> moved;
    for (const auto& [time, said] : gone) {
      const auto there = come.find(time + by);
      if (there == come.end() || there->second != said) continue;
      into.push_back({time, time + by, said, said});
      moved.emplace_back(time, said);
    }
    for (const auto& [time, said] : moved) gone.erase(time), come.erase(time + by);
  }
};

}  // namespace

std::vector<EventChange> events_apart(const TrackEvents& old, const TrackEvents& now) {
  Unpaired left;
  std::ranges::set_difference(old, now, std::inserter(left.gone, left.gone.end()));
  std::ranges::set_difference(now, old, std::inserter(left.come, left.come.end()));
  std::vector<EventChange> all;
  for (auto at = left.gone.begin(); at != left.gone.end();) {
    const Time time = at->first;
    if (const Time by = left.best_move(*at); by != Time{}) left.take_moves(by, all);
    at = left.gone.upper_bound(time);
  }
  for (const auto& [time, said] : left.gone) {
    const auto there = left.come.find(time);
    if (there == left.come.end()) {
      all.push_back({time, {}, said, {}});
    } else {
      all.push_back({time, time, said, there->second});
      left.come.erase(there);
    }
  }
  for (const auto& [time, said] : left.come) all.push_back({{}, time, {}, said});
  std::ranges::stable_sort(all, {}, [](const EventChange& e) { return e.was.value_or(e.is.value_or(Time{})); });
  return all;
}

}  // namespace betwixt
