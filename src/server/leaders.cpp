// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/leaders.h"

#include <chrono>
#include <system_error>

namespace betwixt {

bool Leaders::run(const std::function<void()>& give_up) {
  Lock lock(mutex_);
  if (!hire()) return false;
  changed_.wait(lock, [&] { return stop_; });
  const auto idle = [&] { return working_ == 0; };
  if (!changed_.wait_for(lock, std::chrono::milliseconds(500), idle) && give_up) give_up();
  changed_.wait(lock, idle);
  lock.unlock();
  for (std::thread& t : threads_) t.join();
  if (failed_) std::rethrow_exception(failed_);
  return true;
}

void Leaders::stop() {
  stop_ = true;
  changed_.notify_all();
}

bool Leaders::hire() {
  if (threads_.size() >= most) return false;
  try {
    threads_.emplace_back([this] { serve(); });
    return true;
  } catch (const std::system_error&) {
    return false;
  }
}

void Leaders::serve() {
  Lock lock(mutex_);
  const auto self = std::this_thread::get_id();
  while (!stop_) {
    if (leader_ == std::thread::id()) leader_ = self;
    if (leader_ == self) {
      try {
        round_(lock);
      } catch (...) {  // memory, above all
        if (!lock.owns_lock()) lock.lock();
        failed_ = std::current_exception();
        stop();
      }
    } else {
      ++idle_;
      changed_.wait(lock);
      --idle_;
    }
  }
}

void Leaders::beside(const std::function<void()>& work, bool urgent) {
  const bool leads = this->leads();
  if (leads && idle_ == 0 && !hire()) return work();
  if (leads) leader_ = {};
  ++working_;
  changed_.notify_all();
  Lock lock(mutex_, std::adopt_lock);
  changed_.wait(lock, [&] { return urgent || at_work_ < at_once || stop_; });
  lock.release();
  ++at_work_;
  mutex_.unlock();
  std::exception_ptr failed;
  try {
    work();
  } catch (...) {
    failed = std::current_exception();
  }
  mutex_.lock();
  --working_, --at_work_;
  changed_.notify_all();  // whoever waits to work, and whoever waits for the end
  if (failed) std::rethrow_exception(failed);
}

}  // namespace betwixt
