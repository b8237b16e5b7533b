// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/wake_signal.h"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace betwixt {

static_assert(sizeof(std::atomic<std::uint32_t>) == 4 && std::atomic<std::uint32_t>::is_always_lock_free);

void WakeSignal::signal() {
  if (state_.exchange(rung) == asleep) ::syscall(SYS_futex, &state_, FUTEX_WAKE_PRIVATE, 1, nullptr, nullptr, 0);
}

bool WakeSignal::wait(std::optional<std::int64_t> until) {
  std::uint32_t was = quiet;
  if (state_.compare_exchange_strong(was, asleep)) {
    const std::int64_t moment = std::max<std::int64_t>(0, until.value_or(0));
    const timespec end{moment / 1'000'000'000, moment % 1'000'000'000};
    while (state_ == asleep) {
      const long woken = ::syscall(SYS_futex, &state_, FUTEX_WAIT_BITSET_PRIVATE, asleep, until ? &end : nullptr,
                                   nullptr, FUTEX_BITSET_MATCH_ANY);
      was = asleep;
      if (woken != 0 && errno == ETIMEDOUT && state_.compare_exchange_strong(was, quiet)) return false;
    }
  }
  state_ = quiet;
  return true;
}

}  // namespace betwixt
