// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The frame clock has two threads. One shows every frame at its moment, whatever hosts and the rest of the process do.
// The other makes the frames, and runs hosts' code for them. Moments are absolute, so a delay does not add up. A frame
// that is not ready at its moment is missed, and the one before stays visible. Where the film does not change, both
// threads sleep.
//
// Source: Animation Imaging Model 3.3.2, 3.3.3 (its two processes).
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

#include "server/histogram.h"
#include "server/quarantine.h"
#include "server/screen.h"
#include "server/wake_signal.h"

namespace betwixt {

// How the system schedules the clock's thread. fifo: before all ordinary threads; nice: with the largest share of them.
enum class Priority { fifo, nice, ordinary };
std::string_view to_string(Priority);

Nanos monotonic_now();

class FrameClock {
 public:
  struct Options {
    Rate rate;
    std::optional<Priority> priority;  // nullopt: the best that is permitted
    NewScreen screen;                  // empty for no screen
  };
  // What the clock shows from now on.
  struct Edition {
    Program program;
    Transport transport;
    bool look = false;   // a host has subscribed to frames
    bool large = false;  // publish() evaluates it first, so that its first frame is in time too
  };

  // Starts both threads. Errors: the screen's, machine (no thread).
  static Result<std::unique_ptr<FrameClock>> start(Options);
  ~FrameClock();
  FrameClock(const FrameClock&) = delete;
  FrameClock& operator=(const FrameClock&) = delete;

  // Replaces what the clock shows. Swaps one pointer, so the clock never waits for the caller and never sees half an
  // edition. Call it from one thread only.
  void publish(Edition);
  // Returns the frames shown since the last call, if `look` is set. Keeps the first 1024 and drops the rest. The file
  // becomes readable when there are any.
  std::vector<Shown> shown();
  int shown_file() const { return told_; }

  Priority priority() const { return priority_; }
  const std::string& why() const { return why_; }  // why the requested priority was refused; may be empty
  // Returns why the screen was lost, once.
  std::optional<Error> trouble();
  std::string stats() const;  // members of a JSON object

 private:
  explicit FrameClock(Options);
  struct Posted {
    Edition edition;
    std::optional<Evaluation> evaluation = {};  // used by the maker; freed with its program
    Posted* next = nullptr;                     // in the list of used editions
  };
  // A frame in progress. The maker begins it. The clock shows it, and counts the moments that pass without it.
  struct Making {
    Shown shown;
    Nanos deadline = 0;
    std::optional<std::int64_t> due;  // the first frame that is due after the last one counted
    bool anew = false;                // the time was set anew, so no frame has been counted yet
    std::optional<Error> lost;        // why showing the frame failed
  };
  enum class Stage { none, begun, ready };  // none, begun: owned by the maker; ready: owned by the clock

  std::optional<std::int64_t> due_after(const Program&, std::int64_t number) const;
  Time time_of(std::int64_t number) const { return options_.rate.frame(static_cast<double>(number)); }
  std::int64_t number_at(Time t) const { return options_.rate.whole(t) + 1; }  // the last frame not after t
  std::int64_t number_from(Time t) const {                                     // the first frame not before t
    const std::int64_t n = number_at(t);
    return time_of(n) == t ? n : n + 1;
  }

  // The maker thread.
  Status open_screen();
  void make_frames();
  void take_post();
  std::optional<Making> plan(Nanos now) const;
  void doze(std::optional<Nanos> until);
  void make(Making);
  void draw();
  Nanos patience(Nanos begun, bool first) const;
  void expect_cost(Nanos took);
  void lose_screen(const Error&);

  // The clock thread.
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
  std::atomic<bool> stop_{false}, over_{false};  // over: the maker thread has ended

  WakeSignal maker_, clock_;
  std::atomic<Stage> stage_{Stage::none};
  std::atomic<bool> overdue_{false};  // the clock waits until the frame is ready
  Making making_;
  std::optional<std::int64_t> counted_;  // the last frame counted; the clock writes it while a frame is in progress
  std::unique_ptr<Screen> screen_;       // the maker draws on it, then the clock shows it
  std::unique_ptr<Posted> current_;      // owned by the maker; does not change while a frame is in progress

  // Owned by the maker.
  Quarantine quarantine_;
  std::atomic<bool> news_{false};  // a late answer has come
  Transport transport_;
  bool fresh_ = false;  // the published edition has not been shown yet
  std::optional<std::int64_t> last_;
  std::array<Nanos, 3> took_{};  // for the last frames
  Nanos cost_ = 0;               // recent time to draw a frame, without the wait for answers

  Nanos early_ = 0;  // how late the clock's sleep has ended recently

  // Frames shown: a ring buffer with one writer and one reader.
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
