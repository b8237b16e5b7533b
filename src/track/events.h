// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Events sorted by time, in shared chunks: a copy is cheap, and an edit copies one chunk however long the track is. An
// event at the end copies nothing (event_chunk.h). Of a long track, all but the last chunks are on shelves, which are
// shared too.
#pragma once

#include <algorithm>
#include <vector>

#include "base/cow.h"
#include "track/event_chunk.h"

namespace betwixt {

class Events {
 public:
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const Event& front() const { return shelf(0).front().front(); }
  const Event& back() const { return shelf(shelf_count() - 1).back().back(); }

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
    for (std::size_t s = 0; s < shelf_count(); ++s)
      for (const EventChunk& chunk : shelf(s))
        for (const Event& e : chunk) f(e);
  }
  // Calls f(event) for those with from <= time <= to.
  template <class F>
  void each_between(Time from, Time to, F&& f) const {
    Place p = place_of(from);
    for (; p.shelf < shelf_count(); ++p.shelf, p.chunk = 0)
      for (const Shelf& on = shelf(p.shelf); p.chunk < on.size(); ++p.chunk) {
        if (on[p.chunk].front().time > to) return;
        for (const Event& e : on[p.chunk])
          if (e.time >= from && e.time <= to) f(e);
      }
  }
  // Changes values, but no times: calls f(Event&) for from <= time <= to. Returns how many.
  template <class F>
  std::size_t edit_between(Time from, Time to, F&& f) {
    std::size_t n = 0;
    for (std::size_t s = 0; s < shelf_count(); ++s) {
      if (shelf(s).back().back().time < from || shelf(s).front().front().time > to) continue;
      for (EventChunk& chunk : edit_shelf(s)) {
        if (chunk.back().time < from || chunk.front().time > to) continue;
        for (Event& e : chunk.edit())
          if (e.time >= from && e.time <= to) f(e), ++n;
      }
    }
    return n;
  }
  std::size_t bytes() const;  // of its own memory, without that of values
  // Estimates the part that `edited` does not share: everything from the first to the last chunk that differs.
  std::size_t bytes_apart(const Events& edited) const;
  friend bool operator==(const Events& a, const Events& b);

 private:
  using Shelf = std::vector<EventChunk>;
  struct Place {
    std::size_t shelf = 0, chunk = 0;
  };
  static constexpr std::size_t most = 128;  // events in a chunk; small enough that a random insertion moves little
  static constexpr std::size_t most_chunks = 128;  // on a shelf; half of them move to a shelf of their own
  static constexpr std::size_t most_last = 16;     // last chunks, which each version copies; half of them move away
  std::size_t shelf_count() const { return shelves_->size() + (last_.empty() ? 0 : 1); }
  const Shelf& shelf(std::size_t s) const { return s < shelves_->size() ? *(*shelves_)[s] : last_; }
  Shelf& edit_shelf(std::size_t s) { return s < shelves_->size() ? shelves_.edit()[s].edit() : last_; }
  Place place_of(Time t) const;  // the first chunk that ends at or after t; behind the last shelf if none does
  void make_room(std::size_t shelf);
  void put_on_shelves();
  void drop_empty();
  // No chunk and no shelf is empty, but for `last_`, which is empty only if all is.
  Cow<std::vector<Cow<Shelf>>> shelves_;
  Shelf last_;
  std::size_t size_ = 0;
};

}  // namespace betwixt
