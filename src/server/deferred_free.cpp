// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/deferred_free.h"

#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace betwixt {

struct DeferredFree::Shared {
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<std::shared_ptr<const void>> taken;
  bool begun = false, ended = false;

  void serve() {
    std::unique_lock lock(mutex);
    for (;;) {
      changed.wait(lock, [&] { return ended || !taken.empty(); });
      if (taken.empty()) return;
      auto gone = std::exchange(taken, {});
      lock.unlock();
      gone.clear();
      lock.lock();
    }
  }
};

DeferredFree::DeferredFree() : shared_(std::make_shared<Shared>()) {}

DeferredFree::~DeferredFree() {
  const std::lock_guard lock(shared_->mutex);
  shared_->ended = true;
  shared_->changed.notify_all();
}

void DeferredFree::take(std::shared_ptr<const void> gone) {
  const std::lock_guard lock(shared_->mutex);
  if (!std::exchange(shared_->begun, true)) try {
      std::thread([shared = shared_] { shared->serve(); }).detach();
    } catch (const std::system_error&) {
      shared_->begun = false;
      return;
    }
  shared_->taken.push_back(std::move(gone));
  shared_->changed.notify_one();
}

}  // namespace betwixt
