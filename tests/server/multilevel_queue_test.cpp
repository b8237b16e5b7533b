// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the queue for work of unknown length. Short work runs before long work, and work that is no longer wanted ends.
#include "server/multilevel_queue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <future>
#include <new>
#include <thread>

#include "base/cancellation.h"

namespace betwixt {
namespace {

using namespace std::chrono_literals;

const std::atomic<bool> stays{false};
const std::atomic<int> nobody{0}, somebody{1};

// Takes so much of a processor, and can be left in between.
void toil(std::chrono::nanoseconds much) {
  const auto end = Cancellation::used() + much;
  while (Cancellation::used() < end) Cancellation::check();
}

TEST(MultilevelQueue, WhatIsShortGoesBeforeWhatIsLong) {
  MemoryReturn memory;
  MultilevelQueue lanes(memory);
  std::atomic<bool> over{false};
  std::atomic<int> begun{0};
  std::vector<std::future<bool>> long_ones;
  std::vector<std::unique_ptr<std::atomic<bool>>> gone;
  for (int i = 0; i < 40; ++i) {  // many more than there are threads, and without an end
    gone.push_back(std::make_unique<std::atomic<bool>>(false));
    long_ones.push_back(std::async(std::launch::async, [&lanes, &begun, &over, &mine = *gone.back()] {
      return lanes.run(
          [&] {
            ++begun;
            while (!over) Cancellation::check();
          },
          mine);
    }));
  }
  while (begun < 40) std::this_thread::yield();  // all have had their turn, though none is done
  int done = 0;
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(lanes.run([&] { ++done; }, stays));
  EXPECT_EQ(done, 100);
  // Who goes is let go of, whether it works or waits.
  for (int i = 0; i < 30; ++i) *gone[static_cast<std::size_t>(i)] = true;
  lanes.look();
  for (int i = 0; i < 30; ++i) EXPECT_FALSE(long_ones[static_cast<std::size_t>(i)].get());
  over = true;
  for (int i = 30; i < 40; ++i) EXPECT_TRUE(long_ones[static_cast<std::size_t>(i)].get());
}

// … but only where somebody waits for its place. No thread is overdue, so two jobs hold the places of the first lane
// until a third comes, however late that is.
TEST(MultilevelQueue, WhatIsLongGivesWayOnlyWhereSomebodyWaits) {
  MemoryReturn memory;
  MultilevelQueue lanes(memory, MultilevelQueue::Patience{1h, 1h, 1h, 1h});
  std::atomic<int> begun{0}, gave_way{0};
  EXPECT_TRUE(lanes.run([&] { ++begun, toil(100ms); }, stays));
  EXPECT_EQ(begun, 1);
  const auto work = [&] {
    ++begun;
    try {
      for (toil(20ms); gave_way == 0; toil(1ms)) {
      }
    } catch (const Cancelled&) {
      ++gave_way;
      throw;
    }
  };
  std::vector<std::future<bool>> all;
  for (int i = 0; i < 6; ++i) all.push_back(std::async(std::launch::async, [&] { return lanes.run(work, stays); }));
  for (auto& one : all) EXPECT_TRUE(one.get());
  EXPECT_EQ(begun, 1 + 6 + gave_way);
  EXPECT_LE(begun, 1 + 6 * 4);  // at most once in each lane
}

TEST(MultilevelQueue, FewWorkAtATime) {
  constexpr auto never = 1h;
  MemoryReturn memory;
  MultilevelQueue lanes(memory, MultilevelQueue::Patience{never, never, never, never});
  std::atomic<int> working{0}, most{0};
  std::vector<std::future<bool>> all;
  for (int i = 0; i < 100; ++i)
    all.push_back(std::async(std::launch::async, [&] {
      return lanes.run(
          [&] {
            most = std::max<int>(most, ++working);
            std::this_thread::sleep_for(1ms);
            --working;
          },
          stays);
    }));
  for (auto& one : all) EXPECT_TRUE(one.get());
  EXPECT_LE(most, 8);
}

// Work that never asks Cancellation, such as compiling: other work does not wait for it.
TEST(MultilevelQueue, WhatCannotBeInterruptedKeepsNobodyWaiting) {
  MemoryReturn memory;
  MultilevelQueue lanes(memory, MultilevelQueue::Patience{0ms, 0ms, 0ms, 0ms});
  std::promise<void> ends;
  const std::shared_future<void> end(ends.get_future());
  std::atomic<int> begun{0};
  std::vector<std::future<bool>> stuck;
  for (int i = 0; i < 10; ++i)
    stuck.push_back(std::async(std::launch::async, [&] { return lanes.run([&] { ++begun, end.wait(); }, stays); }));
  while (begun < 10) std::this_thread::yield();
  int done = 0;
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(lanes.run([&] { ++done; }, stays));
  EXPECT_EQ(done, 20);
  ends.set_value();
  for (auto& one : stuck) EXPECT_TRUE(one.get());
  EXPECT_EQ(begun, 10);
  EXPECT_TRUE(lanes.run([&] { ++done; }, stays));
}

TEST(MultilevelQueue, EndWithAllThatWaits) {
  MemoryReturn memory;
  MultilevelQueue lanes(memory);
  std::vector<std::future<bool>> all;
  std::atomic<int> begun{0};
  for (int i = 0; i < 20; ++i)
    all.push_back(std::async(std::launch::async, [&] {
      return lanes.run(
          [&] {
            ++begun;
            for (;;) Cancellation::check();
          },
          stays);
    }));
  while (begun == 0) std::this_thread::yield();
  lanes.end();
  for (auto& one : all) EXPECT_FALSE(one.get());
  EXPECT_FALSE(lanes.run([] {}, stays));
}

TEST(MultilevelQueue, WhatIsThrownComesOut) {
  MemoryReturn memory;
  MultilevelQueue lanes(memory);
  EXPECT_THROW(lanes.run([] { throw std::bad_alloc(); }, stays), std::bad_alloc);
  EXPECT_TRUE(lanes.run([] {}, stays));
}

// Outside of such work nobody is asked.
TEST(Cancellation, IsAboutTheWorkThatItStandsAround) {
  Cancellation::check();
  const std::atomic<bool> gone{true};
  {
    const Cancellation outer(stays, stays, somebody, 0ns);
    Cancellation::check();
    {
      const Cancellation inner(gone, stays, nobody, 0ns);
      EXPECT_THROW(Cancellation::check(), Cancelled);
    }
    Cancellation::check();
  }
  {
    const Cancellation alone(stays, stays, nobody, 1ms);
    toil(5ms);
  }
  const Cancellation short_one(stays, stays, somebody, 1ms);
  EXPECT_THROW(toil(10s), Cancelled);
}

}  // namespace
}  // namespace betwixt
