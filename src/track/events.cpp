// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/events.h"

#include "base/memory.h"

namespace betwixt {

Events::Place Events::place_of(Time t) const {
  const auto ends_before = [](const Cow<Chunk>& c, Time time) { return c->back().time < time; };
  const std::vector<Cow<Shelf>>& all = *shelves_;
  const auto on = std::lower_bound(all.begin(), all.end(), t,
                                   [](const Cow<Shelf>& s, Time time) { return s->back()->back().time < time; });
  const auto s = static_cast<std::size_t>(on - all.begin());
  const Shelf& found = shelf(s);
  const auto c = std::lower_bound(found.begin(), found.end(), t, ends_before);
  if (c == found.end()) return {shelf_count(), 0};
  return {s, static_cast<std::size_t>(c - found.begin())};
}

// Divides a shelf that has too many chunks.
void Events::make_room(std::size_t s) {
  Shelf& full = edit_shelf(s);
  if (full.size() <= most_chunks) return;
  const auto half = full.begin() + most_chunks / 2;
  std::vector<Cow<Shelf>>& all = shelves_.edit();
  if (s == all.size()) {  // the first half of the last chunks becomes a shelf
    Shelf first(std::make_move_iterator(full.begin()), std::make_move_iterator(half));
    full.erase(full.begin(), half);
    all.emplace_back(std::move(first));
    return;
  }
  Shelf second(std::make_move_iterator(half), std::make_move_iterator(full.end()));
  full.erase(half, full.end());
  all.insert(all.begin() + static_cast<std::ptrdiff_t>(s) + 1, Cow<Shelf>(std::move(second)));
}

bool Events::put(Event event) {
  if (empty() || back().time < event.time) {  // at the end: the usual case when a file is read
    if (last_.empty() || last_.back()->size() >= most) {
      last_.emplace_back();
      if (size_ > 0) last_.back().edit().reserve(most);
    }
    last_.back().edit().push_back(std::move(event));
    ++size_;
    make_room(shelves_->size());
    return false;
  }
  const Place p = place_of(event.time);
  Shelf& on = edit_shelf(p.shelf);
  Chunk& chunk = on[p.chunk].edit();
  const auto at =
      std::lower_bound(chunk.begin(), chunk.end(), event.time, [](const Event& e, Time t) { return e.time < t; });
  if (at != chunk.end() && at->time == event.time) {
    *at = std::move(event);
    return true;
  }
  chunk.insert(at, std::move(event));
  ++size_;
  if (chunk.size() <= most) return false;
  const auto middle = chunk.begin() + static_cast<std::ptrdiff_t>(chunk.size() / 2);
  Chunk second(std::make_move_iterator(middle), std::make_move_iterator(chunk.end()));
  chunk.erase(middle, chunk.end());
  on.insert(on.begin() + static_cast<std::ptrdiff_t>(p.chunk) + 1, Cow<Chunk>(std::move(second)));
  make_room(p.shelf);
  return false;
}

void Events::drop_empty() {
  std::vector<Cow<Shelf>>& all = shelves_.edit();
  std::erase_if(all, [](const Cow<Shelf>& s) { return s->empty(); });
  if (!last_.empty() || all.empty()) return;
  last_ = *all.back();
  all.pop_back();
}

std::size_t Events::erase(Time from, Time to) {
  std::size_t removed = 0;
  Place p = place_of(from);
  for (; p.shelf < shelf_count() && shelf(p.shelf)[p.chunk]->front().time <= to; ++p.shelf, p.chunk = 0) {
    Shelf& on = edit_shelf(p.shelf);
    for (; p.chunk < on.size() && on[p.chunk]->front().time <= to; ++p.chunk)
      removed += std::erase_if(on[p.chunk].edit(), [&](const Event& e) { return e.time >= from && e.time <= to; });
    std::erase_if(on, [](const Cow<Chunk>& c) { return c->empty(); });
    if (on.empty() && p.shelf == shelves_->size()) break;  // nothing is behind the last chunks
  }
  size_ -= removed;
  if (!shelves_->empty()) drop_empty();
  return removed;
}

const Event* Events::first_from(Time t) const {
  const Place p = place_of(t);
  if (p.shelf == shelf_count()) return nullptr;
  const Chunk& chunk = *shelf(p.shelf)[p.chunk];
  return &*std::lower_bound(chunk.begin(), chunk.end(), t, [](const Event& e, Time time) { return e.time < time; });
}

const Event* Events::last_before(Time t) const {
  const Place p = place_of(t);
  if (p.shelf == shelf_count()) return empty() ? nullptr : &back();
  const Chunk& chunk = *shelf(p.shelf)[p.chunk];
  if (chunk.front().time < t) {
    const auto at =
        std::lower_bound(chunk.begin(), chunk.end(), t, [](const Event& e, Time time) { return e.time < time; });
    return &*(at - 1);
  }
  if (p.chunk > 0) return &shelf(p.shelf)[p.chunk - 1]->back();
  return p.shelf == 0 ? nullptr : &shelf(p.shelf - 1).back()->back();
}

const Event* Events::find(Time t) const {
  const Event* const at = first_from(t);
  return at && at->time == t ? at : nullptr;
}

std::size_t Events::count(Time from, Time to) const {
  std::size_t n = 0;
  each_between(from, to, [&](const Event&) { ++n; });
  return n;
}

std::vector<Event> Events::between(Time from, Time to) const {
  std::vector<Event> out;
  each_between(from, to, [&](const Event& e) { out.push_back(e); });
  return out;
}

std::size_t Events::bytes() const {
  const auto of = [](const Shelf& on) {
    std::size_t sum = bytes_held(on);
    for (const Cow<Chunk>& c : on) sum += shared_bytes<Chunk> + bytes_held(*c);
    return sum;
  };
  std::size_t sum = of(last_);
  if (!shelves_->empty()) sum += shared_bytes<std::vector<Cow<Shelf>>> + bytes_held(*shelves_);
  for (const Cow<Shelf>& s : *shelves_) sum += shared_bytes<Shelf> + of(*s);
  return sum;
}

std::size_t Events::bytes_apart(const Events& edited) const {
  // Counts the parts of `ours` from the first to the last that differ.
  const auto apart = [](const auto& ours, const auto& theirs, const auto& each) {
    const std::size_t fewer = std::min(ours.size(), theirs.size());
    std::size_t front = 0, back = 0;
    while (front < fewer && ours[front].same(theirs[front])) ++front;
    while (front + back < fewer && ours[ours.size() - 1 - back].same(theirs[theirs.size() - 1 - back])) ++back;
    std::size_t sum = bytes_held(ours);
    for (std::size_t i = front; i < ours.size() - back; ++i) sum += each(i);
    return sum;
  };
  const auto chunks = [&](const Shelf& ours, const Shelf& theirs) {
    return apart(ours, theirs, [&](std::size_t i) { return shared_bytes<Chunk> + bytes_held(*ours[i]); });
  };
  std::size_t sum = chunks(last_, edited.last_);
  if (shelves_.same(edited.shelves_)) return sum;
  static const Shelf none;
  return sum + apart(*shelves_, *edited.shelves_, [&](std::size_t i) {
           return shared_bytes<Shelf> +
                  chunks(*(*shelves_)[i], i < edited.shelves_->size() ? *(*edited.shelves_)[i] : none);
         });
}

bool operator==(const Events& a, const Events& b) {
  if (a.size_ != b.size_) return false;
  std::vector<const Event*> x, y;
  a.each([&](const Event& e) { x.push_back(&e); });
  b.each([&](const Event& e) { y.push_back(&e); });
  return std::equal(x.begin(), x.end(), y.begin(), [](const Event* p, const Event* q) { return *p == *q; });
}

}  // namespace betwixt
