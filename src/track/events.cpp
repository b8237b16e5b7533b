// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/events.h"

#include "base/memory.h"

namespace betwixt {

Events::Place Events::place_of(Time t) const {
  const auto ends_before = [](const EventChunk& c, Time time) { return c.back().time < time; };
  const std::vector<Cow<Shelf>>& all = *shelves_;
  const auto on = std::lower_bound(all.begin(), all.end(), t,
                                   [](const Cow<Shelf>& s, Time time) { return s->back().back().time < time; });
  const auto s = static_cast<std::size_t>(on - all.begin());
  const Shelf& found = shelf(s);
  const auto c = std::lower_bound(found.begin(), found.end(), t, ends_before);
  if (c == found.end()) return {shelf_count(), 0};
  return {s, static_cast<std::size_t>(c - found.begin())};
}

// Divides a shelf that has too many chunks.
void Events::make_room(std::size_t s) {
  std::vector<Cow<Shelf>>& all = shelves_.edit();
  Shelf& full = all[s].edit();
  if (full.size() <= most_chunks) return;
  const auto half = full.begin() + most_chunks / 2;
  Shelf second(std::make_move_iterator(half), std::make_move_iterator(full.end()));
  full.erase(half, full.end());
  all.insert(all.begin() + static_cast<std::ptrdiff_t>(s) + 1, Cow<Shelf>(std::move(second)));
}

// Moves half of the last chunks to the last shelf.
void Events::put_on_shelves() {
  if (last_.size() <= most_last) return;
  std::vector<Cow<Shelf>>& all = shelves_.edit();
  if (all.empty() || all.back()->size() + most_last / 2 > most_chunks) all.emplace_back(Shelf());
  Shelf& to = all.back().edit();
  const auto half = last_.begin() + most_last / 2;
  to.insert(to.end(), std::make_move_iterator(last_.begin()), std::make_move_iterator(half));
  last_.erase(last_.begin(), half);
}

bool Events::put(Event event) {
  if (empty() || back().time < event.time) {  // at the end: the usual case when a file is read
    if (last_.empty() || last_.back().size() >= most) {
      last_.emplace_back(std::span<const Event>(), size_ > 0 ? most : 0);
      put_on_shelves();
    }
    last_.back().append(std::move(event), most);
    ++size_;
    return false;
  }
  const Place p = place_of(event.time);
  Shelf& on = edit_shelf(p.shelf);
  EventChunk& chunk = on[p.chunk];
  const auto place =
      std::lower_bound(chunk.begin(), chunk.end(), event.time, [](const Event& e, Time t) { return e.time < t; });
  const auto at = static_cast<std::size_t>(place - chunk.begin());
  if (at < chunk.size() && place->time == event.time) {
    chunk.edit()[at] = std::move(event);
    return true;
  }
  chunk.insert(at, std::move(event));
  ++size_;
  if (chunk.size() <= most) return false;
  const std::size_t middle = chunk.size() / 2;
  EventChunk second(chunk.all().subspan(middle), 0);
  chunk.erase(middle, chunk.size());
  on.insert(on.begin() + static_cast<std::ptrdiff_t>(p.chunk) + 1, std::move(second));
  if (p.shelf < shelves_->size())
    make_room(p.shelf);
  else
    put_on_shelves();
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
  if (to < from) return 0;
  std::size_t removed = 0;
  Place p = place_of(from);
  const auto earlier = [](const Event& e, Time t) { return e.time < t; };
  const auto later = [](Time t, const Event& e) { return t < e.time; };
  for (; p.shelf < shelf_count() && shelf(p.shelf)[p.chunk].front().time <= to; ++p.shelf, p.chunk = 0) {
    Shelf& on = edit_shelf(p.shelf);
    for (; p.chunk < on.size() && on[p.chunk].front().time <= to; ++p.chunk) {
      EventChunk& chunk = on[p.chunk];
      const auto first = std::lower_bound(chunk.begin(), chunk.end(), from, earlier) - chunk.begin();
      const auto end = std::upper_bound(chunk.begin(), chunk.end(), to, later) - chunk.begin();
      chunk.erase(static_cast<std::size_t>(first), static_cast<std::size_t>(end));
      removed += static_cast<std::size_t>(end - first);
    }
    std::erase_if(on, [](const EventChunk& c) { return c.empty(); });
    if (on.empty() && p.shelf == shelves_->size()) break;  // nothing is behind the last chunks
  }
  size_ -= removed;
  if (!shelves_->empty()) drop_empty();
  return removed;
}

const Event* Events::first_from(Time t) const {
  const Place p = place_of(t);
  if (p.shelf == shelf_count()) return nullptr;
  const EventChunk& chunk = shelf(p.shelf)[p.chunk];
  return &*std::lower_bound(chunk.begin(), chunk.end(), t, [](const Event& e, Time time) { return e.time < time; });
}

const Event* Events::last_before(Time t) const {
  const Place p = place_of(t);
  if (p.shelf == shelf_count()) return empty() ? nullptr : &back();
  const EventChunk& chunk = shelf(p.shelf)[p.chunk];
  if (chunk.front().time < t) {
    const auto at =
        std::lower_bound(chunk.begin(), chunk.end(), t, [](const Event& e, Time time) { return e.time < time; });
    return &*(at - 1);
  }
  if (p.chunk > 0) return &shelf(p.shelf)[p.chunk - 1].back();
  return p.shelf == 0 ? nullptr : &shelf(p.shelf - 1).back().back();
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
    for (const EventChunk& c : on) sum += c.bytes();
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
    return apart(ours, theirs,
                 [&](std::size_t i) { return i < theirs.size() ? ours[i].bytes_apart(theirs[i]) : ours[i].bytes(); });
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
