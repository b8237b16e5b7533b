// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the pool of threads that lead in turns. A long task must not delay others, and the end does not wait for it.
#include "server/leader_follower_pool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <new>
#include <stdexcept>

namespace betwixt {
namespace {

using namespace std::chrono_literals;

TEST(LeaderFollowerPool, OthersGoOnWhileOneWorks) {
  int rounds = 0, begun = 0;
  std::vector<int> order;
  std::promise<void> others_were_there;
  auto there = others_were_there.get_future();
  LeaderFollowerPool* all = nullptr;
  LeaderFollowerPool leaders([&](LeaderFollowerPool::Lock& lock) {
    EXPECT_TRUE(lock.owns_lock());
    const int mine = ++rounds;
    if (mine == 1) {
      ++begun;
      all->beside([&] { there.wait(); });  // it ends only where somebody else gets a round meanwhile
      EXPECT_GT(rounds, 1);
      order.push_back(mine);
      return all->stop();
    }
    order.push_back(mine);
    if (mine == 50) others_were_there.set_value();
    lock.unlock();
    std::this_thread::sleep_for(1ms);
    lock.lock();
  });
  all = &leaders;
  EXPECT_TRUE(leaders.run({}));
  EXPECT_EQ(begun, 1);
  ASSERT_GE(order.size(), 50u);
  EXPECT_TRUE(std::find(order.begin() + 49, order.end(), 1) != order.end());
}

TEST(LeaderFollowerPool, ManyWorkAtOnceAndNobodyTwoRoundsAtATime) {
  std::atomic<int> inside{0};
  int done = 0, asked = 0;
  LeaderFollowerPool* all = nullptr;
  LeaderFollowerPool leaders([&](LeaderFollowerPool::Lock& lock) {
    EXPECT_EQ(++inside, 1);
    const bool works = asked < 500;
    asked += works;
    --inside;
    if (works) {
      all->beside([] { std::this_thread::sleep_for(100us); });
      EXPECT_EQ(++inside, 1);
      ++done;
      --inside;
    }
    if (done == 500) all->stop();
    lock.unlock();
    std::this_thread::yield();
    lock.lock();
  });
  all = &leaders;
  EXPECT_TRUE(leaders.run({}));
  EXPECT_EQ(done, 500);
}

// However many work, somebody leads.
TEST(LeaderFollowerPool, ManyThatWorkLongHoldUpNobody) {
  constexpr int many = 60;
  std::promise<void> led;
  auto there = led.get_future().share();
  int asked = 0, done = 0;
  LeaderFollowerPool* all = nullptr;
  LeaderFollowerPool leaders([&](LeaderFollowerPool::Lock& lock) {
    if (asked < many) {
      ++asked;
      all->beside([there] {
        EXPECT_EQ(there.wait_for(20s), std::future_status::ready);  // till all of them have asked
      });
      if (++done == many) all->stop();
      return;
    }
    if (there.wait_for(0s) != std::future_status::ready) led.set_value();
    lock.unlock();
    std::this_thread::sleep_for(1ms);
    lock.lock();
  });
  all = &leaders;
  EXPECT_TRUE(leaders.run({}));
  EXPECT_EQ(done, many);
}

TEST(LeaderFollowerPool, WhatDoesNotEndIsGivenUp) {
  std::promise<void> end;
  auto ended = end.get_future().share();
  bool given_up = false;
  int rounds = 0;
  LeaderFollowerPool* all = nullptr;
  LeaderFollowerPool leaders([&](LeaderFollowerPool::Lock&) {
    if (++rounds == 1) return all->beside([ended] { ended.wait(); });
    all->stop();
  });
  all = &leaders;
  EXPECT_TRUE(leaders.run([&] { given_up = true, end.set_value(); }));  // the server's ends the process
  EXPECT_TRUE(given_up);
}

TEST(LeaderFollowerPool, WhatIsThrownComesOut) {
  int rounds = 0;
  bool came_out = false;
  LeaderFollowerPool* all = nullptr;
  LeaderFollowerPool leaders([&](LeaderFollowerPool::Lock& lock) {
    if (++rounds == 1) {
      try {
        all->beside([] { throw std::bad_alloc(); });
      } catch (const std::bad_alloc&) {
        came_out = lock.owns_lock();
      }
      throw std::runtime_error("enough");
    }
    lock.unlock();
    std::this_thread::yield();
    lock.lock();
  });
  all = &leaders;
  EXPECT_THROW(leaders.run({}), std::runtime_error);
  EXPECT_TRUE(came_out);
}

}  // namespace
}  // namespace betwixt
