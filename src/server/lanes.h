// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where work is done that may take long. Nobody knows before how long: it begins in the first lane; what takes more
// than is given there, and keeps others from beginning, begins anew in a later one, where at least ten times as much is
// given, with less claim to a processor. So what is short never waits for what is long, and few work at a time.
//
// Some work cannot be interrupted: code is compiled, another process reads a file. If it keeps its place for too long,
// another thread takes that place, and the first one goes on with as little claim to a processor as in the last lane.
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

class Lanes {
 public:
  using Clock = std::chrono::steady_clock;
  // How long work keeps its place in each lane, by the clock on the wall.
  using Patience = std::array<std::chrono::milliseconds, 4>;
  static constexpr Patience usual{{std::chrono::milliseconds(20), std::chrono::milliseconds(100),
                                   std::chrono::seconds(2), std::chrono::seconds(5)}};

  explicit Lanes(Patience patience = usual) : patience_(patience) {}
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
  // A thread, and since when it has been at its work.
  struct Worker {
    std::thread thread;
    std::optional<Clock::time_point> since;
    int id = 0;          // of the thread, for the system
    bool late = false;   // another one has taken its place; it ends with its work
    bool ended = false;  // it only has to be joined
  };
  struct Lane {
    std::deque<Job*> waiting;
    std::list<Worker> workers;
    std::condition_variable changed;
    std::atomic<int> others{0};  // who wait
  };
  struct Terms {
    std::chrono::milliseconds most;  // 0: as long as it takes
    int nice;
  };
  static constexpr std::size_t side_by_side = 2;   // in each lane, but for those that are late
  static constexpr std::size_t most_workers = 64;  // of a lane, late ones among them
  static const std::array<Terms, 4> terms;

  void enter(std::unique_lock<std::mutex>&, std::size_t lane, Job&);
  void leave(std::size_t lane, std::deque<Job*>::iterator);
  bool staffed(std::size_t lane);
  void look_for_late(std::size_t lane);
  void serve(std::size_t lane, Worker&);
  Job::State work(Job&, std::size_t lane);

  std::mutex mutex_;
  std::array<Lane, 4> lanes_;
  const Patience patience_;
  std::atomic<bool> ended_{false};
  MemoryReturn memory_;
};

}  // namespace betwixt
