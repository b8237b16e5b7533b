// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/clock_link.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "base/cancellation.h"
#include "base/tell_user.h"

namespace betwixt {
namespace {

constexpr std::chrono::nanoseconds longest_rest = std::chrono::milliseconds(100);  // after compiling

}  // namespace

void ClockLink::hear() {
  const std::vector<Shown> all = clock_.shown();
  for (const Shown& s : all)
    for (const std::string& p : s.problems)
      if (problems_.size() < 100 && problems_.insert(p).second) tell_user(fmt::format("betwixt: warning: {}\n", p));
  imaging_.shown(all);
  if (const auto trouble = clock_.trouble())
    tell_user(fmt::format("betwixt: warning: the output of frames has stopped: {}\n", trouble->message));
}

FrameClock::Edition ClockLink::edition() {
  published_ = imaging_.version(), looked_ = imaging_.frames_wanted();
  Program film = imaging_.program();  // other threads can lead during this call
  return {std::move(film), imaging_.transport(), looked_, imaging_.large()};
}

void ClockLink::publish() {
  if (publishing_) return;
  publishing_ = true;
  while (!leaders_.stopped() && (published_ != imaging_.version() || looked_ != imaging_.frames_wanted())) {
    const auto begun = Cancellation::used();
    FrameClock::Edition next = edition();
    if (next.large)
      leaders_.beside([&] {
        clock_.publish(std::move(next));  // frees the editions that the clock has used
        std::this_thread::sleep_for(std::min(Cancellation::used() - begun, longest_rest));
      });
    else
      clock_.publish(std::move(next));
  }
  publishing_ = false;
}

void ClockLink::report() {
  const Nanos now = monotonic_now();
  if (!report_ || reporting_ || now < next_report_ || leaders_.stopped()) return;
  reporting_ = true, next_report_ = now + report_time;
  const std::string text = imaging_.statistics(now);
  leaders_.beside([&] { report_(text); });
  reporting_ = false;
}

}  // namespace betwixt
