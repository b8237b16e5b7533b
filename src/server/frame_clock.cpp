// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/frame_clock.h"

#include <fmt/format.h>
#include <poll.h>
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

constexpr int fifo_priority = 20;    // before everything ordinary, behind what the system itself needs
constexpr Nanos earliest = 500'000;  // that it is woken before a moment
constexpr Nanos millisecond = 1'000'000, second = 1'000'000'000;

void ring(int event) {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t n = ::write(event, &one, sizeof one);
}
void hush(int event) {
  std::uint64_t ignored;
  [[maybe_unused]] const ssize_t n = ::read(event, &ignored, sizeof ignored);
}

void sleep_until(Nanos moment) {
  const timespec t{moment / second, moment % second};
  while (::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr) == EINTR) {
  }
}

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
      wake_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
      told_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}

Result<std::unique_ptr<FrameClock>> FrameClock::start(Options options) {
  std::unique_ptr<FrameClock> clock(new FrameClock(std::move(options)));
  if (clock->wake_ < 0 || clock->told_ < 0)
    return fail(ErrorCode::machine, fmt::format("no clock can be had: {}", std::strerror(errno)));
  std::promise<Status> ready;
  auto began = ready.get_future();
  try {
    clock->thread_ = std::thread([c = clock.get(), &ready] {
      if (c->options_.screen) {  // what a screen starts itself stays ordinary
        auto screen = c->options_.screen();
        if (!screen) return ready.set_value(screen.error());
        c->screen_ = *std::move(screen);
      }
      c->take_priority();
      ready.set_value(Nothing{});
      c->run();
      c->screen_.reset();
    });
  } catch (const std::system_error& e) {
    return fail(ErrorCode::machine, fmt::format("no thread can be had for the clock: {}", e.what()));
  }
  if (const Status s = began.get(); !s) return s.error();
  return clock;
}

FrameClock::~FrameClock() {
  stop_ = true;
  if (wake_ >= 0) ring(wake_);
  if (thread_.joinable()) thread_.join();
  delete post_.load();
  for (Posted* p = done_.load(); p;) delete std::exchange(p, p->next);
  for (const int file : {wake_, told_})
    if (file >= 0) ::close(file);
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
    why_ = fmt::format("fifo is not granted: {}", std::strerror(failed));
  }
  if (asked(Priority::nice)) {
    const auto self = static_cast<id_t>(::syscall(SYS_gettid));
    if (::setpriority(PRIO_PROCESS, self, -20) == 0) {
      priority_ = Priority::nice;
      return;
    }
    why_ += fmt::format("{}nice -20 is not granted: {}", why_.empty() ? "" : ", ", std::strerror(errno));
  }
}

// ---- the two threads' ways to each other

void FrameClock::publish(Edition edition) {
  for (Posted* p = done_.exchange(nullptr); p;) delete std::exchange(p, p->next);
  delete post_.exchange(new Posted{std::move(edition)});  // not null: it was never looked at
  if (dozing_.exchange(false)) ring(wake_);
}

void FrameClock::take_post() {
  Posted* const next = post_.exchange(nullptr);
  if (!next) return;
  if (Posted* const old = current_.release()) {  // freed by who made it: that may take long
    old->next = done_.load();
    while (!done_.compare_exchange_weak(old->next, old)) {
    }
  }
  const Transport before = std::exchange(transport_, next->edition.transport);
  if (!(transport_ == before)) last_.reset();
  current_.reset(next);
  fresh_ = true;
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

std::optional<Error> FrameClock::trouble() {
  const std::lock_guard lock(trouble_mutex_);
  return std::exchange(trouble_, std::nullopt);
}

std::string FrameClock::stats() const {
  const auto us = [](std::uint64_t ns) { return static_cast<double>(ns) / 1000; };
  return fmt::format(
      "\"class\":\"{}\",\"rate\":{},\"frames_due\":{},\"frames_made\":{},\"frames_missed\":{},\"frames_idle\":{},"
      "\"frames_untold\":{},\"wakes\":{},\"late_p50_us\":{:.1f},\"late_p99_us\":{:.1f},\"late_max_us\":{:.1f}",
      to_string(priority_), options_.rate.per_second(), due_.load(), made_.load(), missed_.load(), idle_.load(),
      untold_.load(), wakes_.load(), us(late_.quantile(0.5)), us(late_.quantile(0.99)), us(late_.largest()));
}

// ---- the thread

// True: something was published, or it is over. Only sleeps that are longer than a frame are broken off.
bool FrameClock::doze(std::optional<Nanos> until) {
  dozing_ = true;
  bool woken = stop_ || post_.load() != nullptr;
  while (!woken) {
    int wait = -1;
    if (until) {
      const Nanos left = *until - monotonic_now();
      if (left <= 0) break;
      wait = static_cast<int>(std::min<Nanos>(left / millisecond + 1, 3'600'000));
    }
    pollfd one{wake_, POLLIN, 0};
    ::poll(&one, 1, wait);
    ++wakes_;
    if (one.revents) hush(wake_);
    woken = stop_ || post_.load() != nullptr;
  }
  dozing_ = false;
  return woken;
}

std::optional<Time> FrameClock::next_change(Time after) const { return current_->edition.program.next_change(after); }

// The next frame that is due, and its moment; none: nothing will be, as things are.
std::optional<FrameClock::Plan> FrameClock::plan(Nanos now) {
  const Transport& t = current_->edition.transport;
  if (!t.running) {
    if (!fresh_) return std::nullopt;
    return Plan{number_at(t.at), t.at, now};
  }
  // The first one that can be ready in time.
  std::int64_t number = std::max(number_at(t.time(now + cost_)) + 1, last_ ? *last_ + 1 : number_at(t.at));
  if (!fresh_ && last_) {
    const std::optional<Time> change = next_change(time_of(*last_));
    if (!change) return std::nullopt;
    number = std::max(number, number_from(*change));
  }
  return Plan{number, time_of(number), t.when(time_of(number))};
}

// Frames between two that were shown: due, and so missed, or not.
void FrameClock::count_between(std::int64_t from, std::int64_t to) {
  std::uint64_t missed = 0;
  for (std::int64_t n = from; n + 1 < to;) {
    const std::optional<Time> change = next_change(time_of(n));
    if (!change) break;
    n = std::max(n + 1, number_from(*change));
    if (n < to) ++missed;
  }
  missed_ += missed, due_ += missed;
  idle_ += static_cast<std::uint64_t>(to - from - 1) - missed;
}

// Sleep ends a little late, by more the busier the machine is. Who has been granted the first place wakes so much
// earlier and looks at the clock until it is time.
void FrameClock::await(Nanos moment) {
  const Nanos wake = moment - early_;
  if (wake > monotonic_now()) {
    sleep_until(wake);
    ++wakes_;
    const Nanos late = monotonic_now() - wake;
    if (priority_ == Priority::fifo) early_ = late > early_ ? std::min(late, earliest) : early_ - (early_ - late) / 256;
  }
  while (monotonic_now() < moment) {
  }
}

void FrameClock::make(const Plan& p) {
  const bool look = current_->edition.look;
  Shown s{p.number, p.time, 0, {}};
  const auto lost = [&](const Error& why) {
    const std::lock_guard lock(trouble_mutex_);
    trouble_ = why;
    screen_.reset();
    ring(told_);
  };
  const Nanos begun = monotonic_now();
  if (look || screen_) {
    std::optional<Evaluation>& played = current_->evaluation;
    if (!played) played.emplace(current_->edition.program);
    played->to(p.time);
    s.problems = played->problems();
    if (screen_)
      if (Status drawn = screen_->draw(*played); !drawn) lost(drawn.error());
  }
  const Nanos took = monotonic_now() - begun;
  cost_ = took > cost_ ? took : cost_ - (cost_ - took) / 8;  // what it has taken of late, at most
  await(p.deadline);
  const Nanos late = std::max<Nanos>(0, monotonic_now() - p.deadline);
  s.late = late;
  if (screen_)
    if (Status done = screen_->show(s); !done) lost(done.error());
  if (current_->edition.transport.running) {
    if (last_ && p.number > *last_ + 1) count_between(*last_, p.number);
    last_ = p.number;
    late_.add(static_cast<std::uint64_t>(late));
    ++due_;
    ++(late < period_ ? made_ : missed_);
  }
  fresh_ = false;
  if (!look) return;
  const std::uint64_t at = put_.load(std::memory_order_relaxed);
  if (at - taken_.load(std::memory_order_acquire) >= most_told) {
    ++untold_;
    return;
  }
  belt_[at % most_told] = std::move(s);
  put_.store(at + 1, std::memory_order_release);
  ring(told_);
}

void FrameClock::run() {
  while (!stop_) {
    take_post();
    if (!current_) {
      doze(std::nullopt);
      continue;
    }
    const Nanos now = monotonic_now();
    const std::optional<Plan> next = plan(now);
    if (!next) {
      doze(std::nullopt);
    } else if (next->deadline - now > 2 * period_ + cost_) {
      // It is drawn shortly before, by what is published then.
      if (!doze(next->deadline - period_ - cost_) && !stop_) make(*next);
    } else {
      make(*next);
    }
  }
}

}  // namespace betwixt
