// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/events.h"

#include "base/memory.h"

namespace betwixt {

std::size_t Events::chunk_of(Time t) const {
  const auto it = std::lower_bound(chunks_.begin(), chunks_.end(), t,
                                   [](const Cow<Chunk>& c, Time time) { return c->back().time < time; });
  return static_cast<std::size_t>(it - chunks_.begin());
}

bool Events::put(Event event) {
  std::size_t c = chunks_.empty() || chunks_.back()->back().time < event.time ? chunks_.size() : chunk_of(event.time);
  if (c == chunks_.size()) {  // at the end: the usual case when a file is read
    if (chunks_.empty() || chunks_.back()->size() >= most) {
      chunks_.emplace_back();
      if (chunks_.size() > 1) chunks_.back().edit().reserve(most);
    }
    chunks_.back().edit().push_back(std::move(event));
    ++size_;
    return false;
  }
  Chunk& chunk = chunks_[c].edit();
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
  chunks_.insert(chunks_.begin() + static_cast<std::ptrdiff_t>(c) + 1, Cow<Chunk>(std::move(second)));
  return false;
}

std::size_t Events::erase(Time from, Time to) {
  std::size_t removed = 0;
  const std::size_t first = chunk_of(from);
  std::size_t last = first;
  for (; last < chunks_.size() && chunks_[last]->front().time <= to; ++last)
    removed += std::erase_if(chunks_[last].edit(), [&](const Event& e) { return e.time >= from && e.time <= to; });
  const auto at = [&](std::size_t i) { return chunks_.begin() + static_cast<std::ptrdiff_t>(i); };
  chunks_.erase(std::remove_if(at(first), at(last), [](const Cow<Chunk>& c) { return c->empty(); }), at(last));
  size_ -= removed;
  return removed;
}

const Event* Events::first_from(Time t) const {
  const std::size_t c = chunk_of(t);
  if (c == chunks_.size()) return nullptr;
  const Chunk& chunk = *chunks_[c];
  return &*std::lower_bound(chunk.begin(), chunk.end(), t, [](const Event& e, Time time) { return e.time < time; });
}

const Event* Events::last_before(Time t) const {
  const std::size_t c = chunk_of(t);
  if (c < chunks_.size() && chunks_[c]->front().time < t) {
    const Chunk& chunk = *chunks_[c];
    const auto at =
        std::lower_bound(chunk.begin(), chunk.end(), t, [](const Event& e, Time time) { return e.time < time; });
    return &*(at - 1);
  }
  return c == 0 ? nullptr : &chunks_[c - 1]->back();
}

const Event* Events::find(Time t) const {
  const std::size_t c = chunk_of(t);
  if (c == chunks_.size()) return nullptr;
  const Chunk& chunk = *chunks_[c];
  const auto at =
      std::lower_bound(chunk.begin(), chunk.end(), t, [](const Event& e, Time time) { return e.time < time; });
  return at != chunk.end() && at->time == t ? &*at : nullptr;
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
  std::size_t sum = bytes_held(chunks_);
  for (const Cow<Chunk>& c : chunks_) sum += shared_bytes<Chunk> + bytes_held(*c);
  return sum;
}

std::size_t Events::bytes_apart(const Events& edited) const {
  const auto& others = edited.chunks_;
  const std::size_t fewer = std::min(chunks_.size(), others.size());
  std::size_t front = 0, back = 0;
  while (front < fewer && chunks_[front].same(others[front])) ++front;
  while (front + back < fewer && chunks_[chunks_.size() - 1 - back].same(others[others.size() - 1 - back])) ++back;
  std::size_t sum = bytes_held(chunks_);
  for (std::size_t c = front; c < chunks_.size() - back; ++c) sum += shared_bytes<Chunk> + bytes_held(*chunks_[c]);
  return sum;
}

bool operator==(const Events& a, const Events& b) {
  if (a.size_ != b.size_) return false;
  std::vector<const Event*> x, y;
  a.each([&](const Event& e) { x.push_back(&e); });
  b.each([&](const Event& e) { y.push_back(&e); });
  return std::equal(x.begin(), x.end(), y.begin(), [](const Event* p, const Event* q) { return *p == *q; });
}

}  // namespace betwixt
