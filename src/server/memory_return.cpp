// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/memory_return.h"

#include <malloc.h>

#include <chrono>
#include <system_error>

namespace betwixt {

MemoryReturn::~MemoryReturn() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void MemoryReturn::soon() {
  const std::lock_guard lock(mutex_);
  if (wanted_) return;
  wanted_ = true;
  changed_.notify_all();
  if (!thread_.joinable()) try {
      thread_ = std::thread([this] { serve(); });
    } catch (const std::system_error&) {  // no thread can be started: the next call tries again
      wanted_ = false;
    }
}

void MemoryReturn::serve() {
  std::unique_lock lock(mutex_);
  while (!ended_) {
    changed_.wait(lock, [&] { return wanted_ || ended_; });
    changed_.wait_for(lock, std::chrono::seconds(1), [&] { return ended_; });
    if (ended_) return;
    wanted_ = false;
    lock.unlock();
#ifdef __GLIBC__
    ::malloc_trim(0);
#endif
    lock.lock();
  }
}

}  // namespace betwixt
