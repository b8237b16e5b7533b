// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/event_chunk.h"

#include <algorithm>
#include <utility>

#include "base/memory.h"

namespace betwixt {

EventChunk::Memory::~Memory() { std::destroy_n(events(), made.load(std::memory_order_acquire)); }

// The events lie behind the head, in one allocation.
std::shared_ptr<EventChunk::Memory> EventChunk::new_memory(std::size_t room) {
  void* const place = ::operator new(sizeof(Memory) + room * sizeof(Event));
  return {new (place) Memory(room), [](Memory* m) {
            m->~Memory();
            ::operator delete(m);
          }};
}

EventChunk::EventChunk(std::span<const Event> events, std::size_t room) {
  if (events.empty() && room == 0) return;
  memory_ = new_memory(std::max(room, events.size()));
  for (const Event& e : events) {
    new (memory_->events() + size_) Event(e);
    memory_->made = ++size_;
  }
}

void EventChunk::own(std::size_t room) {
  if (memory_ && alone()) {
    std::atomic_thread_fence(std::memory_order_acquire);  // after the last other owner's reads
    // Events that a version appended which is gone.
    std::destroy(memory_->events() + size_, memory_->events() + memory_->made);
    memory_->made = size_;
    if (room <= memory_->room) return;
    const std::shared_ptr<Memory> larger = new_memory(room);
    for (Event& e : std::span(memory_->events(), size_)) {
      new (larger->events() + larger->made) Event(std::move(e));
      ++larger->made;
    }
    memory_ = larger;
    return;
  }
  *this = EventChunk(all(), room);
}

void EventChunk::append(Event&& event, std::size_t most) {
  std::size_t made = size_;
  // The first to append gets the place behind the last event; `made` says that it is taken before the event is there.
  // Nobody else reads it: others know only their own sizes. Only the last owner destroys it.
  if (!memory_ || size_ == memory_->room || !memory_->made.compare_exchange_strong(made, size_ + 1)) {
    own(memory_ && size_ < memory_->room ? memory_->room
                                         : std::clamp<std::size_t>(2 * size_, 2, std::max(most, size_ + 1)));
    memory_->made = size_ + 1;
  }
  new (memory_->events() + size_) Event(std::move(event));
  ++size_;
}

void EventChunk::insert(std::size_t at, Event event) {
  const std::size_t room = memory_ ? memory_->room : 0;
  own(size_ < room ? room : size_ + 1 + size_ / 2);
  Event* const all = memory_->events();
  if (at == size_) {
    new (all + at) Event(std::move(event));
  } else {
    new (all + size_) Event(std::move(all[size_ - 1]));
    std::move_backward(all + at, all + size_ - 1, all + size_);
    all[at] = std::move(event);
  }
  memory_->made = ++size_;
}

void EventChunk::erase(std::size_t first, std::size_t end) {
  if (first == end) return;
  own(size_);
  Event* const all = memory_->events();
  std::destroy(std::move(all + end, all + size_, all + first), all + size_);
  memory_->made = size_ -= end - first;
}

std::span<Event> EventChunk::edit() {
  if (empty()) return {};
  own(size_);
  return {memory_->events(), size_};
}

std::size_t EventChunk::bytes() const {
  if (!memory_) return 0;
  return in_heap(sizeof(Memory) + memory_->room * sizeof(Event)) + in_heap(sizeof(void*) * 3);
}

std::size_t EventChunk::bytes_apart(const EventChunk& o) const {
  if (memory_ != o.memory_) return bytes();
  return size_ > o.size_ ? (size_ - o.size_) * sizeof(Event) : 0;
}

}  // namespace betwixt
