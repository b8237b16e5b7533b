// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests that another thread frees discarded data.
#include "server/memory_return.h"

#include <gtest/gtest.h>

#include <future>
#include <memory>
#include <thread>
#include <utility>

namespace betwixt {
namespace {

TEST(MemoryReturn, FreesOnAThreadOfItsOwn) {
  struct Thing {
    std::promise<std::thread::id>& freed;
    ~Thing() { freed.set_value(std::this_thread::get_id()); }
  };
  std::promise<std::thread::id> first, second;
  auto all = std::make_unique<MemoryReturn>();
  auto kept = std::make_shared<Thing>(first);
  all->take(std::exchange(kept, nullptr));
  const std::thread::id there = first.get_future().get();
  EXPECT_NE(there, std::this_thread::get_id());
  all->take(std::make_shared<Thing>(second));
  all.reset();  // the thread still frees the second thing
  EXPECT_EQ(second.get_future().get(), there);
}

}  // namespace
}  // namespace betwixt
