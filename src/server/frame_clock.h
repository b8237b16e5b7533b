// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The clock: a thread that shows every frame at its moment, whatever hosts and the rest of the process do, and a thread
// that makes them, on which hosts' code runs. Moments are absolute; nothing is ever counted, so that what is late is
// late once. A frame that is not ready at its moment is missed: the one before stands. Where nothing changes both
// sleep.
//
// Source: Animation Imaging Model 3.3.2, 3.3.3 (its two processes; R-E1, R-E14).
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "server/bell.h"
#include "server/histogram.h"
#include "server/quarantine.h"
#include "server/screen.h"

namespace betwixt {

// How the system treats the clock's thread. fifo: before all ordinary ones; nice: with the largest share of them.
enum class Priority { fifo, nice, ordinary };
std::string_view to_string(Priority);

Nanos monotonic_now();

class FrameClock {
 public:
  struct Options {
    Rate rate;
    std::optional<Priority> priority;  // none: the best that is granted
    NewScreen screen;                  // none: frames go nowhere
  };
  // What is to be shown from now on.
  struct Edition {
    Program program;
    Transport transport;
    bool look = false;  // somebody is told of frames
  };

  // Errors: the screen's, machine (no thread).
  static Result<std::unique_ptr<FrameClock>> start(Options);
  ~FrameClock();
  FrameClock(const FrameClock&) = delete;
  FrameClock& operator=(const FrameClock&) = delete;

  // One pointer is swapped: the thread never waits for us, nor sees half of it. From one thread.
  void publish(Edition);
  // Frames that were shown since, where `look` says so; at most some, the rest is lost. A file becomes readable when
  // there are any.
  std::vector<Shown> shown();
  int shown_file() const { return told_; }

  Priority priority() const { return priority_; }
  const std::string& why() const { return why_; }  // it is not what was asked for; may be empty
  // A screen that could not go on; once.
  std::optional<Error> trouble();
  std::string stats() const;  // members of a JSON object

 private:
  explicit FrameClock(Options);
  struct Posted {
    Edition edition;
    std::optional<Evaluation> evaluation = {};  // the maker's; freed with the program that it plays
    Posted* next = nullptr;                     // among those that have had their time
  };
  // A frame on its way: begun by the maker, shown by the clock, which also counts the moments that pass without it.
  struct Making {
    Shown shown;
    Nanos deadline = 0;
    std::optional<std::int64_t> due;  // the first number after the last one that was counted at which a frame is due
    bool anew = false;                // the time is another one: nothing was counted before
    std::optional<Error> lost;        // the screen, as it was shown
  };
  enum class Stage { none, begun, ready };  // none, begun: the maker's; ready: the clock's

  std::optional<std::int64_t> due_after(const Program&, std::int64_t number) const;
  Time time_of(std::int64_t number) const { return options_.rate.frame(static_cast<double>(number)); }
  std::int64_t number_at(Time t) const { return options_.rate.whole(t) + 1; }  // the last one not after t
  std::int64_t number_from(Time t) const {                                     // the first one not before t
    const std::int64_t n = number_at(t);
    return time_of(n) == t ? n : n + 1;
  }

  // The maker.
  Status open_screen();
  void make_frames();
  void take_post();
  std::optional<Making> plan(Nanos now) const;
  void doze(std::optional<Nanos> until);
  void make(Making);
  void draw();
  Nanos patience(Nanos begun) const;
  void expect_cost(Nanos took);
  void lose_screen(const Error&);

  // The clock.
  void take_priority();
  void keep_time();
  void accompany();
  bool await(Nanos moment);
  bool await_ready(std::optional<Nanos> until);
  void pass(std::int64_t number);
  void miss(std::int64_t number);
  void show();

  const Options options_;
  const Nanos period_;
  Priority priority_ = Priority::ordinary;
  std::string why_;
  int told_ = -1;  // eventfd
  std::atomic<Posted*> post_{nullptr}, done_{nullptr};
  std::atomic<bool> stop_{false}, over_{false};  // over: the maker has ended

  Bell maker_, clock_;
  std::atomic<Stage> stage_{Stage::none};
  std::atomic<bool> overdue_{false};  // the clock waits for it to be ready
  Making making_;
  std::optional<std::int64_t>
      counted_;                      // moments up to that of this number; written by the clock while there is a frame
  std::unique_ptr<Screen> screen_;   // drawn by the maker, shown by the clock when that is done
  std::unique_ptr<Posted> current_;  // the maker's; while there is a frame it stays

  // Of the maker.
  Quarantine quarantine_;
  std::atomic<bool> news_{false};  // a late answer has come
  Transport transport_;
  bool fresh_ = false;  // what is published has not been shown yet
  std::optional<std::int64_t> last_;
  std::array<Nanos, 3> took_{};  // the last frames
  Nanos cost_ = 0;               // of drawing, as of late, without waiting for answers

  Nanos early_ = 0;  // how late the clock's sleep ends, as of late

  // What was shown, on its way to the other thread: one writes, one reads.
  static constexpr std::size_t most_told = 1024;
  std::array<Shown, most_told> belt_;
  std::atomic<std::uint64_t> put_{0}, taken_{0};
  std::mutex trouble_mutex_;
  std::optional<Error> trouble_;

  std::atomic<std::uint64_t> due_{0}, made_{0}, missed_{0}, idle_{0}, wakes_{0}, untold_{0};
  Histogram late_;
  std::thread making_thread_, clock_thread_;
};

}  // namespace betwixt
