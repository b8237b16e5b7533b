// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Threads that do one thing after another under one lock. One leads; where something takes long another one leads
// meanwhile, and the first comes back with what it has worked out. What is quick costs no change of threads.
#pragma once

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace betwixt {

class Leaders {
 public:
  using Lock = std::unique_lock<std::mutex>;
  // `round`: what the leader does again and again, holding the lock; it gives it up while it waits for something to do.
  explicit Leaders(std::function<void(Lock&)> round) : round_(std::move(round)) {}

  // Leads, with other threads, until stop(). Work that is not done then is not waited for, half a second later:
  // `give_up` ends the process; where there is none, it is. False: no thread is to be had. What a round throws ends it
  // all, and is thrown here; what work throws comes out of beside().
  bool run(const std::function<void()>& give_up);
  // Of those that lead: the last round.
  void stop();
  bool stopped() const { return stop_; }
  bool leads() const { return leader_ == std::this_thread::get_id(); }  // this thread
  // Of those that lead, holding the lock: does the work without it. Everything may have changed then.
  void beside(const std::function<void()>& work);

 private:
  static constexpr std::size_t most = 4000;  // threads; nearly all of them wait
  bool hire();
  void lead_on(Lock&);
  void serve();

  const std::function<void(Lock&)> round_;
  std::mutex mutex_;
  std::condition_variable lead_, back_, changed_;  // somebody shall lead; nobody waits to come back; all ends
  std::atomic<int> returning_{0};
  std::vector<std::thread> threads_;
  std::thread::id leader_;
  std::size_t idle_ = 0, working_ = 0;
  std::exception_ptr failed_;
  bool stop_ = false;
};

}  // namespace betwixt
