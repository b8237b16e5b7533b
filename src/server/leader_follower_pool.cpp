// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/leader_follower_pool.h"

#include <chrono>
#include <system_error>

namespace betwixt {
namespace {

constexpr auto end_patience = std::chrono::milliseconds(200);  // with unfinished work at the end

}  // namespace

bool LeaderFollowerPool::run(const std::function<void()>& give_up) {
  Lock lock(mutex_);
  if (!hire()) return false;
  changed_.wait(lock, [&] { return stop_; });
  const auto idle = [&] { return working_ == 0; };
  if (!changed_.wait_for(lock, end_patience, idle) && give_up) give_up();
  changed_.wait(lock, idle);
  lock.unlock();
  for (std::thread& t : threads_) t.join();
  if (failed_) std::rethrow_exception(failed_);
  return true;
}

void LeaderFollowerPool::stop() {
  stop_ = true;
  lead_.notify_all(), changed_.notify_all();
}

bool LeaderFollowerPool::hire() {
  if (threads_.size() >= most) return false;
  try {
    threads_.emplace_back([this] { serve(); });
    return true;
  } catch (const std::system_error&) {
    return false;
  }
}

void LeaderFollowerPool::serve() {
  Lock lock(mutex_);
  const auto self = std::this_thread::get_id();
  while (!stop_) {
    if (leader_ == std::thread::id()) leader_ = self;
    if (leader_ == self) {
      lead_on(lock);
      try {
        round_(lock);
      } catch (...) {  // mostly std::bad_alloc
        if (!lock.owns_lock()) lock.lock();
        failed_ = std::current_exception();
        stop();
      }
    } else {
      ++idle_;
      lead_.wait(lock);
      --idle_;
    }
  }
}

// A mutex is not fair: without this, the leader would lock it again before the threads that return with a result.
void LeaderFollowerPool::lead_on(Lock& lock) {
  back_.wait(lock, [&] { return returning_ == 0; });
}

void LeaderFollowerPool::beside(const std::function<void()>& work) {
  const bool leads = this->leads();
  if (leads && idle_ == 0 && !hire()) return work();
  if (leads) leader_ = {};
  ++working_;
  lead_.notify_one();
  mutex_.unlock();
  std::exception_ptr failed;
  try {
    work();
  } catch (...) {
    failed = std::current_exception();
  }
  ++returning_;
  mutex_.lock();
  if (--returning_ == 0) back_.notify_one();
  --working_;
  if (stop_) changed_.notify_all();  // for run(), which waits for the work to end
  if (failed) std::rethrow_exception(failed);
}

}  // namespace betwixt
