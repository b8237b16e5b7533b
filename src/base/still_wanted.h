// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Work for somebody who may leave before it is done, or who shall wait where others need less. Whoever does such work
// asks now and then whether it is still wanted; if not, it ends there. It is all done on copies, which go with it.
#pragma once

#include <time.h>

#include <atomic>
#include <chrono>
#include <utility>

namespace betwixt {

// Thrown out of work that is not wanted.
struct NotWanted {};

// The work that this thread does while it lives.
class StillWanted {
 public:
  // Until one of the two flags is raised; and while others wait for its place it takes no more of the processor than
  // this, 0: however much.
  StillWanted(const std::atomic<bool>& gone, const std::atomic<bool>& over, const std::atomic<int>& others,
              std::chrono::nanoseconds most)
      : gone_(gone),
        over_(over),
        others_(others),
        end_(most.count() > 0 ? used() + most : most),
        before_(std::exchange(current, this)) {}
  ~StillWanted() { current = before_; }
  StillWanted(const StillWanted&) = delete;
  StillWanted& operator=(const StillWanted&) = delete;

  // Of all work that may take long, between one piece and the next.
  static void ask() {
    if (!wanted()) throw NotWanted{};
  }
  // The same, where nothing may be thrown.
  static bool wanted() { return !current || current->goes_on(); }
  // What this thread has taken of a processor.
  static std::chrono::nanoseconds used() {
    timespec t{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return std::chrono::seconds(t.tv_sec) + std::chrono::nanoseconds(t.tv_nsec);
  }

 private:
  bool goes_on() {
    if (gone_ || over_) return false;
    return end_.count() == 0 || ++looks_ % looks_a_time != 0 || others_ == 0 || used() <= end_;
  }

  static constexpr unsigned looks_a_time = 64;  // the system is asked for the time only now and then
  static inline thread_local StillWanted* current = nullptr;
  const std::atomic<bool>&gone_, &over_;
  const std::atomic<int>& others_;
  const std::chrono::nanoseconds end_;
  StillWanted* const before_;
  unsigned looks_ = 0;
};

}  // namespace betwixt
