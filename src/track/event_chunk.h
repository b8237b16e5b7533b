// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Some events in order of time, in memory that several versions of a track share. A version that appends an event
// writes it behind the events of the version before, if there is room and no other version has done so. So a history of
// n appended events takes memory for n events and not for n copies. Every other change first makes a copy, unless there
// is no other owner.
#pragma once

#include <atomic>
#include <memory>
#include <new>
#include <span>

#include "track/event.h"

namespace betwixt {

class EventChunk {
 public:
  EventChunk() = default;
  EventChunk(std::span<const Event> events, std::size_t room);  // with room for at least so many

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const Event* begin() const { return memory_ ? memory_->events() : nullptr; }
  const Event* end() const { return begin() + size_; }
  const Event& front() const { return *begin(); }
  const Event& back() const { return end()[-1]; }
  std::span<const Event> all() const { return {begin(), size_}; }

  // Appends an event. A chunk without room gets twice as much, but at most `most`, which is more than its size.
  void append(Event&& event, std::size_t most);
  void insert(std::size_t at, Event event);
  // Removes the events from `first` to before `end`.
  void erase(std::size_t first, std::size_t end);
  // Returns the events for changing, none of them shared.
  std::span<Event> edit();

  bool same(const EventChunk& o) const { return memory_ == o.memory_ && size_ == o.size_; }
  // Returns the bytes of its memory. Of chunks that share memory, each has all of it.
  std::size_t bytes() const;
  // Returns the bytes that this chunk does not share with the other.
  std::size_t bytes_apart(const EventChunk& o) const;

 private:
  // The number of events that have been made, and room for more behind it. Events that are there never change while
  // several chunks own the memory.
  struct alignas(Event) Memory {
    explicit Memory(std::size_t n) : room(n) {}
    Memory(const Memory&) = delete;
    Memory& operator=(const Memory&) = delete;
    ~Memory();
    Event* events() { return reinterpret_cast<Event*>(this + 1); }
    const Event* events() const { return reinterpret_cast<const Event*>(this + 1); }
    std::atomic<std::size_t> made{0};
    const std::size_t room;
  };
  static std::shared_ptr<Memory> new_memory(std::size_t room);
  bool alone() const { return memory_.use_count() == 1; }
  void own(std::size_t room);  // copies the events to memory of its own

  std::shared_ptr<Memory> memory_;
  std::size_t size_ = 0;
};

}  // namespace betwixt
