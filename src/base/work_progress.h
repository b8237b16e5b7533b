// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Progress of long work. The worker reports it now and then; without a WorkProgress on this thread, a report costs one
// test of a pointer.
#pragma once

#include <atomic>
#include <cstddef>
#include <utility>

namespace betwixt {

// Receives the progress of this thread during its lifetime. Any thread may read the share.
class WorkProgress {
 public:
  WorkProgress() : outer_(std::exchange(listening_, this)) {}
  ~WorkProgress() { listening_ = outer_; }
  WorkProgress(const WorkProgress&) = delete;
  WorkProgress& operator=(const WorkProgress&) = delete;

  static void report(std::size_t done, std::size_t of) {
    if (listening_ && of > 0)
      listening_->share_.store(static_cast<float>(done) / static_cast<float>(of), std::memory_order_relaxed);
  }
  float share() const { return share_.load(std::memory_order_relaxed); }  // 0 to 1

 private:
  inline static constinit thread_local WorkProgress* listening_ = nullptr;
  WorkProgress* const outer_;
  std::atomic<float> share_{0};
};

}  // namespace betwixt
