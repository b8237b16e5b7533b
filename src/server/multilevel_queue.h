// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// MultilevelQueue: a multilevel queue for work of unknown length. Each job begins in the first lane. If it uses up that
// lane's time while others wait, it is aborted and starts anew in a later lane, with at least ten times the time and a
// lower priority. So short work never waits for long work, and few jobs run at once.
//
// Some work cannot be interrupted: compiling code, or waiting for another process. If it holds its place for too long,
// a new thread takes that place, and the old one continues at the last lane's low priority.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <list>
#include <mutex>
#include <optional>
#include <thread>

#include "server/memory_return.h"

namespace betwixt {

class MultilevelQueue {
 public:
  using Clock = std::chrono::steady_clock;
  // How long a job may hold its place in each lane, in elapsed time.
  using Patience = std::array<std::chrono::milliseconds, 4>;
  static constexpr Patience usual{{std::chrono::milliseconds(20), std::chrono::milliseconds(100),
                                   std::chrono::seconds(2), std::chrono::seconds(5)}};

  // After each job, lets `memory` return what it used.
  explicit MultilevelQueue(MemoryReturn& memory, Patience patience = usual) : memory_(memory), patience_(patience) {}
  ~MultilevelQueue();
  MultilevelQueue(const MultilevelQueue&) = delete;
  MultilevelQueue& operator=(const MultilevelQueue&) = delete;

  // Runs the work on a thread of the lanes; it may start several times. Returns false if `gone` (the cancellation
  // token) was set or end() was called first. Rethrows what the work throws.
  bool run(const std::function<void()>& work, const std::atomic<bool>& gone);
  // Wakes the waiting jobs whose `gone` has been set.
  void look();
  // Cancels all work.
  void end();

 private:
  struct Job {
    const std::function<void()>* work;
    const std::atomic<bool>* gone;
    enum class State { waits, runs, done, unfinished } state = State::waits;
    std::chrono::nanoseconds used{};  // processor time of the last run
    std::exception_ptr failed;
    std::condition_variable changed;
  };
  // A thread, and since when it has run its present job.
  struct Worker {
    std::thread thread;
    std::optional<Clock::time_point> since;
    int id = 0;          // the thread's number in the system
    bool late = false;   // another thread has taken its place; it ends after its job
    bool ended = false;  // ready to be joined
  };
  struct Lane {
    std::deque<Job*> waiting;
    std::list<Worker> workers;
    std::condition_variable changed;
    std::atomic<int> others{0};  // jobs that wait; a running job reads it to see whether it may stay
  };
  struct Terms {
    std::chrono::milliseconds most;  // processor time; 0: no limit
    int nice;
  };
  static constexpr std::size_t side_by_side = 2;   // threads in each lane, without the overdue ones
  static constexpr std::size_t most_workers = 64;  // threads of a lane, with the overdue ones
  static const std::array<Terms, 4> terms;

  void enter(std::unique_lock<std::mutex>&, std::size_t lane, Job&);
  void leave(std::size_t lane, std::deque<Job*>::iterator);
  bool staffed(std::size_t lane);
  void look_for_late(std::size_t lane);
  void serve(std::size_t lane, Worker&);
  Job::State work(Job&, std::size_t lane);

  MemoryReturn& memory_;
  std::mutex mutex_;
  std::array<Lane, 4> lanes_;
  const Patience patience_;
  std::atomic<bool> ended_{false};
};

}  // namespace betwixt
