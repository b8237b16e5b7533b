// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where work is done that may take long. Nobody knows before how long: it begins in the first lane; what takes more
// than is given there, and keeps others from beginning, begins anew in a later one, where at least ten times as much is
// given, with less claim to a processor. So what is short never waits for what is long, and few work at a time.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "server/memory_return.h"

namespace betwixt {

class Lanes {
 public:
  Lanes() = default;
  ~Lanes();
  Lanes(const Lanes&) = delete;
  Lanes& operator=(const Lanes&) = delete;

  // Does the work on a thread of the lanes: it may be begun several times over. False: `gone` was raised, or all was
  // ended, before it was done. What it throws is thrown here.
  bool run(const std::function<void()>& work, const std::atomic<bool>& gone);
  // `gone` of somebody has been raised.
  void look();
  // Nothing is wanted any more.
  void end();

 private:
  struct Job {
    const std::function<void()>* work;
    const std::atomic<bool>* gone;
    enum class State { waits, runs, done, unfinished } state = State::waits;
    std::chrono::nanoseconds used{};  // of a processor, the last time
    std::exception_ptr failed;
    std::condition_variable changed;
  };
  struct Lane {
    std::deque<Job*> waiting;
    std::size_t idle = 0, threads = 0;
    std::condition_variable changed;
    std::atomic<int> others{0};  // who wait
  };
  struct Terms {
    std::chrono::milliseconds most;  // 0: as long as it takes
    int nice;
  };
  static constexpr std::size_t side_by_side = 2;  // in each lane
  static const std::array<Terms, 4> terms;

  void enter(std::unique_lock<std::mutex>&, std::size_t lane, Job&);
  bool staffed(std::size_t lane);
  void serve(std::size_t lane);
  Job::State work(Job&, std::size_t lane);

  std::mutex mutex_;
  std::array<Lane, 4> lanes_;
  std::vector<std::thread> threads_;
  std::atomic<bool> ended_{false};
  MemoryReturn memory_;
};

}  // namespace betwixt
