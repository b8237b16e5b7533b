// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Events sorted by time, in shared chunks: a copy is cheap, and an edit copies one chunk however long the track is.
#pragma once

#include <algorithm>
#include <vector>

#include "base/cow.h"
#include "track/event.h"

namespace betwixt {

class Events {
 public:
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const Event& front() const { return chunks_.front()->front(); }
  const Event& back() const { return chunks_.back()->back(); }

  // Inserts an event. Replaces the one at the same time, and returns whether there was one.
  bool put(Event event);
  // Removes the events with from <= time <= to. Returns how many.
  std::size_t erase(Time from, Time to);
  // The event exactly at t, or null.
  const Event* find(Time t) const;
  // Return the first at or after t, and the last before t, or null.
  const Event* first_from(Time t) const;
  const Event* last_before(Time t) const;
  std::size_t count(Time from, Time to) const;  // with from <= time <= to
  // Returns copies of them.
  std::vector<Event> between(Time from, Time to) const;

  template <class F>
  void each(F&& f) const {
    for (const auto& chunk : chunks_)
      for (const Event& e : *chunk) f(e);
  }
  // Calls f(event) for those with from <= time <= to.
  template <class F>
  void each_between(Time from, Time to, F&& f) const {
    for (std::size_t c = chunk_of(from); c < chunks_.size() && chunks_[c]->front().time <= to; ++c)
      for (const Event& e : *chunks_[c])
        if (e.time >= from && e.time <= to) f(e);
  }
  // Changes values, but no times: calls f(Event&) for from <= time <= to. Returns how many.
  template <class F>
  std::size_t edit_between(Time from, Time to, F&& f) {
    std::size_t n = 0;
    for (auto& chunk : chunks_) {
      if (chunk->back().time < from || chunk->front().time > to) continue;
      for (Event& e : chunk.edit())
        if (e.time >= from && e.time <= to) f(e), ++n;
    }
    return n;
  }
  std::size_t bytes() const;  // of its own memory, without that of values
  // Estimates the part that `edited` does not share: everything from the first to the last chunk that differs.
  std::size_t bytes_apart(const Events& edited) const;
  friend bool operator==(const Events& a, const Events& b);

 private:
  using Chunk = std::vector<Event>;
  static constexpr std::size_t most = 128;  // events in a chunk; small enough that a random insertion moves little
  std::size_t chunk_of(Time t) const;       // the first chunk that ends at or after t; chunks_.size() if none does
  std::vector<Cow<Chunk>> chunks_;
  std::size_t size_ = 0;
};

}  // namespace betwixt
