// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Wakes one thread, at an absolute moment at the latest. There is no lock, so the thread that rings never blocks the
// thread that waits, whatever their priorities are. If the bell rings while no thread waits, the next wait returns at
// once.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

namespace betwixt {

class WakeSignal {
 public:
  void signal();
  // Waits for a ring. Only one thread may call it. Returns false if the moment (CLOCK_MONOTONIC, in nanoseconds) comes
  // first.
  bool wait(std::optional<std::int64_t> until = {});

 private:
  enum : std::uint32_t { quiet, asleep, rung };
  std::atomic<std::uint32_t> state_{quiet};
};

}  // namespace betwixt
