// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/frame_clock.h"

#include <fmt/format.h>
#include <pthread.h>
#include <sys/eventfd.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <future>
#include <system_error>

namespace betwixt {
namespace {

constexpr int fifo_priority = 20;    // above every ordinary thread, below the system's own
constexpr Nanos earliest = 500'000;  // the most that it wakes before a moment
constexpr Nanos second = 1'000'000'000;
constexpr Nanos soon = second / 10;  // at the end, a finished frame is still shown if it is due within this time
constexpr int maker_nice = -10;      // above ordinary threads, yet it leaves a tenth of a processor to them

void ring(int event) {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t n = ::write(event, &one, sizeof one);
}
void hush(int event) {
  std::uint64_t ignored;
  [[maybe_unused]] const ssize_t n = ::read(event, &ignored, sizeof ignored);
}

// Returns the thread's number in the system.
id_t this_thread() { return static_cast<id_t>(::syscall(SYS_gettid)); }

}  // namespace

std::string_view to_string(Priority p) {
  static constexpr std::string_view names[] = {"fifo", "nice", "ordinary"};
  return names[static_cast<std::size_t>(p)];
}

Nanos monotonic_now() {
  timespec t{};
  ::clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<Nanos>(t.tv_sec) * second + t.tv_nsec;
}

FrameClock::FrameClock(Options options)
    : options_(std::move(options)),
      period_(static_cast<Nanos>(static_cast<double>(second) / options_.rate.per_second())),
      told_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
      quarantine_({period_ / 8, options_.priority != Priority::ordinary ? maker_nice : 0, monotonic_now, [this] {
                     news_ = true;
                     maker_.signal();
                   }}) {}

Result<std::unique_ptr<FrameClock>> FrameClock::start(Options options) {
  std::unique_ptr<FrameClock> clock(new FrameClock(std::move(options)));
  if (clock->told_ < 0) return fail(ErrorCode::machine, fmt::format("cannot make a timer: {}", std::strerror(errno)));
  std::promise<void> in_time;
  std::promise<Status> screen;
  auto has_priority = in_time.get_future();
  auto has_screen = screen.get_future();
  try {
    clock->clock_thread_ = std::thread([c = clock.get(), &in_time] {
      c->take_priority();
      in_time.set_value();
      c->keep_time();
    });
    has_priority.get();
    clock->making_thread_ = std::thread([c = clock.get(), &screen] {
      const Status opened = c->open_screen();
      screen.set_value(opened);
      if (opened) c->make_frames();
      c->screen_.reset();
    });
  } catch (const std::system_error& e) {
    return fail(ErrorCode::machine, fmt::format("cannot start a thread for the clock: {}", e.what()));
  }
  if (const Status s = has_screen.get(); !s) return s.error();
  return clock;
}

FrameClock::~FrameClock() {
  stop_ = true;
  maker_.signal(), clock_.signal();
  if (making_thread_.joinable()) making_thread_.join();
  over_ = true;
  clock_.signal();
  if (clock_thread_.joinable()) clock_thread_.join();
  delete post_.load();
  for (Posted* p = done_.load(); p;) delete std::exchange(p, p->next);
  if (told_ >= 0) ::close(told_);
}

void FrameClock::take_priority() {
  ::prctl(PR_SET_TIMERSLACK, 1);
  const auto asked = [&](Priority p) { return !options_.priority || options_.priority == p; };
  if (asked(Priority::fifo)) {
    sched_param how{};
    how.sched_priority = fifo_priority;
    const int failed = ::pthread_setschedparam(::pthread_self(), SCHED_FIFO | SCHED_RESET_ON_FORK, &how);
    if (failed == 0) {
      priority_ = Priority::fifo;
      return;
    }
    why_ = fmt::format("the system does not allow fifo: {}", std::strerror(failed));
  }
  if (asked(Priority::nice)) {
    if (::setpriority(PRIO_PROCESS, this_thread(), -20) == 0) {
      priority_ = Priority::nice;
      return;
    }
    why_ += fmt::format("{}the system does not allow nice -20: {}", why_.empty() ? "" : ", ", std::strerror(errno));
  }
}

Status FrameClock::open_screen() {
  if (options_.screen) {  // threads that the screen starts keep the ordinary priority
    auto screen = options_.screen();
    if (!screen) return screen.error();
    screen_ = *std::move(screen);
  }
  ::prctl(PR_SET_TIMERSLACK, 1);
  if (options_.priority != Priority::ordinary) ::setpriority(PRIO_PROCESS, this_thread(), maker_nice);  // if permitted
  return Nothing{};
}

// ---- exchange with other threads

void FrameClock::publish(Edition edition) {
  for (Posted* p = done_.exchange(nullptr); p;) delete std::exchange(p, p->next);
  auto next = std::make_unique<Posted>(Posted{std::move(edition)});
  if (next->edition.large && (next->edition.look || options_.screen)) {
    const Transport& t = next->edition.transport;
    next->evaluation.emplace(next->edition.program, quarantine_);
    next->evaluation->prepare(t.running ? t.time(monotonic_now()) : t.at);
  }
  delete post_.exchange(next.release());  // not null if the maker never took it
  maker_.signal();
}

std::vector<Shown> FrameClock::shown() {
  hush(told_);
  std::vector<Shown> out;
  std::uint64_t at = taken_.load(std::memory_order_relaxed);
  for (const std::uint64_t end = put_.load(std::memory_order_acquire); at < end; ++at)
    out.push_back(std::move(belt_[at % most_told]));
  taken_.store(at, std::memory_order_release);
  return out;
}

void FrameClock::lose_screen(const Error& why) {
  {
    const std::lock_guard lock(trouble_mutex_);
    trouble_ = why;
  }
  screen_.reset();
  ring(told_);
}

std::optional<Error> FrameClock::trouble() {
  const std::lock_guard lock(trouble_mutex_);
  return std::exchange(trouble_, std::nullopt);
}

std::string FrameClock::stats() const {
  const auto us = [](std::uint64_t ns) { return static_cast<double>(ns) / 1000; };
  return fmt::format(
      "\"class\":\"{}\",\"rate\":{},\"frames_due\":{},\"frames_made\":{},\"frames_missed\":{},\"frames_idle\":{},"
      "\"frames_untold\":{},\"wakes\":{},\"late_p50_us\":{:.1f},\"late_p99_us\":{:.1f},\"late_max_us\":{:.1f},{}",
      to_string(priority_), options_.rate.per_second(), due_.load(), made_.load(), missed_.load(), idle_.load(),
      untold_.load(), wakes_.load(), us(late_.quantile(0.5)), us(late_.quantile(0.99)), us(late_.largest()),
      quarantine_.stats());
}

// ---- the clock

// Returns the number of the next frame that is due, or nullopt if the film does not change any more.
std::optional<std::int64_t> FrameClock::due_after(const Program& program, std::int64_t number) const {
  const std::optional<Time> change = program.next_change(time_of(number));
  if (!change) return std::nullopt;
  return std::max(number + 1, number_from(*change));
}

void FrameClock::keep_time() {
  for (;;)
    if (stage_ != Stage::none) {
      accompany();
    } else if (over_) {
      return;
    } else {
      clock_.wait();
      ++wakes_;
    }
}

// Follows a frame from when it is begun until it is shown.
void FrameClock::accompany() {
  const Edition& of = current_->edition;
  const std::int64_t number = making_.shown.number;
  if (making_.anew) counted_.reset();
  bool wanted = true;
  for (auto due = making_.due; due && *due < number && wanted; due = due_after(of.program, *due)) {
    wanted = await(of.transport.when(time_of(*due)));
    if (wanted) miss(*due);
  }
  wanted = wanted && await(making_.deadline);
  overdue_ = true;
  if (stage_ != Stage::ready && of.transport.running && wanted) {
    miss(number);
    // The frame before stays visible. Each moment at which another frame should have come counts as missed.
    for (auto due = due_after(of.program, number); due; due = due_after(of.program, *due)) {
      if (await_ready(of.transport.when(time_of(*due)))) break;
      miss(*due);
    }
  }
  await_ready({});
  overdue_ = false;
  if (wanted) show();
  stage_ = Stage::none;
  maker_.signal();
}

// Waits for a moment. A sleep ends a little late, by more the busier the machine is. With fifo priority, the thread
// wakes that much earlier and then polls the clock. Returns false if the clock stops before the moment.
bool FrameClock::await(Nanos moment) {
  const Nanos wake = moment - early_;
  while (wake > monotonic_now()) {
    const bool rung = clock_.wait(wake);
    ++wakes_;
    if (stop_ && moment > monotonic_now() + soon) return false;
    if (rung) continue;
    const Nanos late = monotonic_now() - wake;
    if (priority_ == Priority::fifo) early_ = late > early_ ? std::min(late, earliest) : early_ - (early_ - late) / 256;
  }
  while (monotonic_now() < moment) {
  }
  return true;
}

// Waits for the frame. Returns false if the moment comes first.
bool FrameClock::await_ready(std::optional<Nanos> until) {
  while (stage_ != Stage::ready) {
    const bool rung = clock_.wait(until);
    ++wakes_;
    if (!rung) return stage_ == Stage::ready;
  }
  return true;
}

void FrameClock::pass(std::int64_t number) {
  if (counted_) idle_ += static_cast<std::uint64_t>(number - *counted_ - 1);
  counted_ = number;
  ++due_;
}
void FrameClock::miss(std::int64_t number) {
  pass(number);
  ++missed_;
}

void FrameClock::show() {
  Shown& s = making_.shown;
  s.late = std::max<Nanos>(0, monotonic_now() - making_.deadline);
  if (screen_)
    if (Status done = screen_->show(s); !done) making_.lost = done.error();
  if (current_->edition.transport.running) {
    late_.add(static_cast<std::uint64_t>(s.late));
    if (!counted_ || *counted_ < s.number) {
      pass(s.number);
      ++(s.late < period_ ? made_ : missed_);
    }
  }
  if (!current_->edition.look) return;
  const std::uint64_t at = put_.load(std::memory_order_relaxed);
  if (at - taken_.load(std::memory_order_acquire) >= most_told) {
    ++untold_;
    return;
  }
  belt_[at % most_told] = std::move(s);
  put_.store(at + 1, std::memory_order_release);
  ring(told_);
}

}  // namespace betwixt
