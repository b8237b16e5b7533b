// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/memory_return.h"

#include <malloc.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace betwixt {

using Clock = std::chrono::steady_clock;

struct MemoryReturn::Shared {
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<std::shared_ptr<const void>> taken;
  std::optional<Clock::time_point> due;  // when memory is to be returned
  bool begun = false, ended = false;

  // Returns false if no thread can be started; the next call tries again.
  static bool begin(const std::shared_ptr<Shared>& shared) {
    if (!shared->begun) try {
        std::thread([shared] { shared->serve(); }).detach();
        shared->begun = true;
      } catch (const std::system_error&) {
      }
    return shared->begun;
  }

  void serve() {
    std::unique_lock lock(mutex);
    for (;;) {
      changed.wait(lock, [&] { return ended || due || !taken.empty(); });
      if (due) changed.wait_until(lock, *due, [&] { return ended || !taken.empty(); });
      if (ended && taken.empty()) return;
      const bool returns = due && Clock::now() >= *due;
      if (returns) due.reset();
      auto gone = std::exchange(taken, {});
      lock.unlock();
      gone.clear();
#ifdef __GLIBC__
      if (returns) ::malloc_trim(0);
#endif
      lock.lock();
    }
  }
};

MemoryReturn::MemoryReturn() : shared_(std::make_shared<Shared>()) { Shared::begin(shared_); }

MemoryReturn::~MemoryReturn() {
  const std::lock_guard lock(shared_->mutex);
  shared_->ended = true;
  shared_->changed.notify_all();
}

void MemoryReturn::take(std::shared_ptr<const void> gone) {
  const std::lock_guard lock(shared_->mutex);
  if (!Shared::begin(shared_)) return;
  shared_->taken.push_back(std::move(gone));
  shared_->changed.notify_one();
}

void MemoryReturn::soon() {
  const std::lock_guard lock(shared_->mutex);
  if (shared_->due || !Shared::begin(shared_)) return;
  shared_->due = Clock::now() + std::chrono::seconds(1);
  shared_->changed.notify_one();
}

}  // namespace betwixt
