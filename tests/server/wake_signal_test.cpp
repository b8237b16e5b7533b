// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A wake-up must have effect exactly once, whether it comes before or during the sleep.
#include "server/wake_signal.h"

#include <gtest/gtest.h>

#include <thread>

#include "server/frame_clock.h"

namespace betwixt {
namespace {

TEST(WakeSignal, IsHeardOnce) {
  WakeSignal bell;
  bell.signal(), bell.signal();
  EXPECT_TRUE(bell.wait());
  EXPECT_FALSE(bell.wait(0));
  const Nanos moment = monotonic_now() + 20'000'000;
  EXPECT_FALSE(bell.wait(moment));
  EXPECT_GE(monotonic_now(), moment);
  EXPECT_FALSE(bell.wait(-1));
}

// Two threads in turns: a ring that gets lost would stop them for good.
TEST(WakeSignal, NoRingIsLost) {
  WakeSignal ping, pong;
  std::atomic<int> n{0};
  std::thread other([&] {
    for (int i = 0; i < 100'000; ++i) {
      while (n <= 2 * i) ping.wait();
      ++n, pong.signal();
    }
  });
  for (int i = 0; i < 100'000; ++i) {
    ++n, ping.signal();
    while (n <= 2 * i + 1) pong.wait();
  }
  other.join();
  EXPECT_EQ(n, 200'000);
}

}  // namespace
}  // namespace betwixt
