// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The workers of a film that is being shown: they answer the questions that may take long
// (program/deferred_evaluation.h), beside the thread that makes frames.
//
// Before each frame the maker puts all quick questions into a batch. One worker answers them in turn, and the maker
// waits as long as the frame allows. If a question takes more than its share of processor time, the maker lowers that
// worker's priority and leaves it behind; a new worker continues the batch. The question is now in quarantine: slow
// workers answer it again and again, each time for the newest moment, and frames show the last answer. After three
// quick answers in a row it leaves the quarantine.
//
// Processor time decides, not the clock, so a busy machine makes no value slow. Rendered films have no quarantine:
// their values are exact.
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "program/deferred_evaluation.h"
#include "server/imaging.h"
#include "server/wake_signal.h"

namespace betwixt {

class Quarantine final : public DeferredEvaluation {
 public:
  struct Options {
    Nanos share = 2'000'000;      // processor time for one answer
    int nice = 0;                 // a worker's priority while the maker waits
    std::function<Nanos()> now;   // the monotonic clock
    std::function<void()> heard;  // a worker calls it when a late answer has come
  };
  explicit Quarantine(Options);
  ~Quarantine() override;
  Quarantine(const Quarantine&) = delete;
  Quarantine& operator=(const Quarantine&) = delete;

  // For the maker. The next frame waits for answers until this moment at most.
  void wait_until(Nanos moment) { until_ = moment; }
  Nanos waited() const { return waited_; }  // how long the last frame did
  bool ask(const Program&, Time) override;
  const Answer* answer(const Question&) const override;
  Time time() const override { return time_; }
  bool quick(const Question&) const override;
  std::vector<std::string> late() const override;
  std::vector<SlowTurn> turns() { return std::exchange(turns_, {}); }  // since the last call

  // For any thread: the quarantine as members of a JSON object.
  std::string stats() const;

 private:
  enum class Pace : std::uint8_t { unknown, quick, slow };
  static constexpr std::size_t nobody = SIZE_MAX;
  struct Item {
    Question question;
    std::size_t source = nobody;  // whose it is
    std::uint64_t edition = 0;    // of the program
    Answer answer;
    bool answered = false;          // not if it was cancelled, or memory was short
    Nanos took = 0;                 // of a processor
    std::atomic<bool> done{false};  // then it is the maker's
    std::atomic<bool> unwanted{false};
  };
  // Questions about one time. The last user frees the program, which may take long.
  struct Batch {
    Batch(Program p, Time t, std::size_t size) : program(std::move(p)), time(t), items(size) {}
    Program program;
    const Time time;
    std::vector<Item> items;
    std::atomic<std::size_t> next{0};
    std::atomic<bool> closed{false};  // the maker waits no longer
    std::atomic<int> users{1};        // the maker is one
    void leave() {
      if (--users == 0) program = {};
    }
  };
  struct Worker {
    std::mutex mutex;
    std::shared_ptr<Batch> given, at;  // the next one; the one in hand
    bool idle = true;                  // it has no batch
    WakeSignal bell;
    std::atomic<bool> slow{false};     // the maker does not wait for its answer
    std::atomic<Nanos> begun{0};       // when it began its question; 0: it has no question
    std::atomic<std::size_t> item{0};  // that question's
    std::atomic<int> id{0};            // the thread's
    std::atomic<bool> steps{false};    // its priority can be lowered and raised
    Nanos watched = 0, used = 0;       // for the maker: `begun` of a long question, and the processor time at that look
    std::thread thread;
    bool rests() {
      const std::unique_lock lock(mutex, std::try_to_lock);  // the maker waits for no slow worker
      return lock && idle;
    }
  };
  struct Source {
    Question question;
    std::uint32_t object = 0;
    FunctionId function = 0;
    Pace pace = Pace::unknown;
    bool constant = false;                // the same at all times
    bool due = true;                      // it may take long at the present time
    bool edited = false;                  // it may have become slow since the last answer
    bool known = false, current = false;  // current: of this program
    Answer answer;
    Time at;                         // the answer's
    int streak = 0;                  // of quick answers
    std::uint64_t frames = 0;        // how many showed a late answer
    std::uint64_t asked = 0;         // the turn of the last question
    std::shared_ptr<Batch> pending;  // has the open question …
    std::size_t item = 0;            // … here
  };

  void adopt(const Program&);
  void forget();
  void release(Program);
  bool gather();
  bool take(Source&, Item&, const Batch&);
  std::shared_ptr<Batch> batch_of(const std::vector<std::size_t>& sources);
  std::vector<std::size_t> quick_ones();
  bool ask_quick();
  void await(const std::shared_ptr<Batch>&);
  bool overstays(Worker&);
  void leave_behind(Worker&);
  void find_slow(Worker&);
  bool close(const std::shared_ptr<Batch>&);
  void ask_slow();
  void set_pace(Source&, Pace);
  void count_late();
  bool answered(const Source& s) const { return !s.due || (s.current && (s.constant || s.at == time_)); }
  bool late(const Source& s) const { return s.pace == Pace::slow && !answered(s); }
  bool named(const Source& s) const { return s.pace == Pace::slow && s.question.what != Question::camera; }
  std::size_t busy_slow();
  Worker* idle_worker();
  void engage();
  void step(const Worker&) const;
  static void give(Worker&, std::shared_ptr<Batch>);
  void work(Worker&);
  void serve(Worker&, Batch&);
  void work_out_item(Item&, const Batch&) const;
  std::size_t place_of(const Question&) const;
  std::string name(const Source&) const;

  const Options options_;
  Program program_;
  Time time_;
  Nanos until_ = 0, waited_ = 0;
  std::array<std::size_t, Question::kinds> first_{};  // the first source of each kind
  std::vector<Source> sources_;
  std::uint64_t turn_ = 0, edition_ = 0;
  bool left_out_ = false;  // the last frame came before all its questions were begun
  std::vector<SlowTurn> turns_;
  std::vector<std::unique_ptr<Worker>> workers_;
  WakeSignal done_;
  std::atomic<bool> over_{false};
  const std::atomic<int> nobody_{0};
  mutable std::mutex told_in_use_;
  std::string told_;
};

}  // namespace betwixt
