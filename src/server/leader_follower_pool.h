// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A leader/follower thread pool: its threads do one thing after another under one lock. One thread leads. When it
// starts long work, another thread takes the lead, and the first returns with its result. Short work needs no change of
// threads.
#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace betwixt {

class LeaderFollowerPool {
 public:
  using Lock = std::unique_lock<std::mutex>;
  // `round`: the step that the leader repeats, holding the lock. It releases the lock while it waits for events.
  explicit LeaderFollowerPool(std::function<void(Lock&)> round) : round_(std::move(round)) {}

  // Leads, with other threads, until stop(). Then waits 0.2 s for unfinished work and calls `give_up`, which
  // ends the process; without `give_up`, waits for the work to end. Returns false if no thread can be started. An
  // exception in a round ends the pool and is rethrown here; an exception in the work leaves beside().
  bool run(const std::function<void()>& give_up);
  // Makes the present round the last. Call it from a thread of the pool.
  void stop();
  bool stopped() const { return stop_; }
  bool leads() const { return leader_ == std::this_thread::get_id(); }  // the calling thread leads
  // Does work without the lock. Call it from a thread of the pool that holds the lock. Everything may have changed when
  // it returns.
  void beside(const std::function<void()>& work);

 private:
  static constexpr std::size_t most = 4000;  // threads, nearly all of which wait
  bool hire();
  void lead_on(Lock&);
  void serve();

  const std::function<void(Lock&)> round_;
  std::mutex mutex_;
  // Signals: a thread must take the lead; no thread waits to return; the pool ends.
  std::condition_variable lead_, back_, changed_;
  std::atomic<int> returning_{0};
  std::vector<std::thread> threads_;
  std::thread::id leader_;
  std::size_t idle_ = 0, working_ = 0;
  std::exception_ptr failed_;
  bool stop_ = false;
};

}  // namespace betwixt
