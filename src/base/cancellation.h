// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Cancellation token and time slices for long work. The client may leave, or the work may have to give way to shorter
// work. The work checks now and then whether it is still wanted; if not, it is aborted. It changes copies only, so
// nothing is left of it.
#pragma once

#include <time.h>

#include <atomic>
#include <chrono>
#include <utility>

namespace betwixt {

// Thrown to abort the work.
struct Cancelled {};

// The work of this thread, during its lifetime.
class Cancellation {
 public:
  // Aborts when one of the two flags is raised, or when the work has used more processor time than this while others
  // wait for its place; 0: no limit.
  Cancellation(const std::atomic<bool>& gone, const std::atomic<bool>& over, const std::atomic<int>& others,
               std::chrono::nanoseconds most)
      : gone_(gone),
        over_(over),
        others_(others),
        end_(most.count() > 0 ? used() + most : most),
        before_(std::exchange(current, this)) {}
  ~Cancellation() { current = before_; }
  Cancellation(const Cancellation&) = delete;
  Cancellation& operator=(const Cancellation&) = delete;

  // Call it between two pieces of any work that may take long.
  static void check() {
    if (!wanted()) throw Cancelled{};
  }
  // Like check(), for code that must not throw.
  static bool wanted() { return !current || current->goes_on(); }
  // Returns the processor time that this thread has used.
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

  static constexpr unsigned looks_a_time = 64;  // queries the system's time only once in this many calls
  static inline thread_local Cancellation* current = nullptr;
  const std::atomic<bool>&gone_, &over_;
  const std::atomic<int>& others_;
  const std::chrono::nanoseconds end_;
  Cancellation* const before_;
  unsigned looks_ = 0;
};

}  // namespace betwixt
