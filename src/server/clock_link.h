// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The server's link to its clock: publishes the newest document, passes on what the clock has shown, and reports.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>

#include "server/frame_clock.h"
#include "server/imaging.h"
#include "server/leader_follower_pool.h"

namespace betwixt {

class ClockLink {
 public:
  // `report` receives the statistics once a second; may be empty.
  ClockLink(Imaging& imaging, FrameClock& clock, LeaderFollowerPool& leaders,
            const std::function<void(const std::string&)>& report)
      : imaging_(imaging), clock_(clock), leaders_(leaders), report_(report) {}

  int shown() const { return clock_.shown_file(); }  // becomes readable when the clock has shown frames
  void begin() { clock_.publish(edition()); }
  // Takes the frames that were shown. Other threads may lead while it computes contacts.
  void hear();
  // Publishes to the clock; only one thread at a time does. For a large film another thread leads until it is done.
  // Then this thread rests as long as it worked, so that a host that keeps changing a large document does not take a
  // whole processor.
  void publish();
  // Reports on this thread, while another one leads. If the report blocks, the next ones are left out.
  void report();
  // Returns when the next report is due, or nullopt if none is.
  std::optional<Nanos> next_report() const {
    return report_ && !reporting_ ? std::optional(next_report_) : std::nullopt;
  }

 private:
  FrameClock::Edition edition();  // the newest document for the clock

  static constexpr Nanos report_time = 1'000'000'000;  // from one report to the next
  Imaging& imaging_;
  FrameClock& clock_;
  LeaderFollowerPool& leaders_;
  const std::function<void(const std::string&)>& report_;
  bool looked_ = false, publishing_ = false, reporting_ = false;
  Nanos next_report_ = monotonic_now() + report_time;
  std::uint64_t published_ = 0;
  std::set<std::string> problems_;
};

}  // namespace betwixt
