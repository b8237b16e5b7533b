// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Wakes one thread, until an absolute moment at the latest. There is no lock: who rings never keeps from running who is
// rung, whatever their priorities are. What was rung while nobody slept is heard by the next wait.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

namespace betwixt {

class Bell {
 public:
  void ring();
  // Of one thread. False: the moment (of CLOCK_MONOTONIC, in nanoseconds) has come and nobody has rung.
  bool wait(std::optional<std::int64_t> until = {});

 private:
  enum : std::uint32_t { quiet, asleep, rung };
  std::atomic<std::uint32_t> state_{quiet};
};

}  // namespace betwixt
