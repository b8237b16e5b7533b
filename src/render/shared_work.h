// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Work that several threads share, item by item.
#pragma once

#include <atomic>
#include <limits>
#include <system_error>
#include <thread>
#include <vector>

#include "base/cancellation.h"

namespace betwixt {

// A pool of threads that take the next work item. It ends with its work, which it aborts if the work was cancelled.
class ThreadPool {
 public:
  ~ThreadPool() {
    next = std::numeric_limits<std::size_t>::max() / 2;
    for (std::thread& t : threads_) t.join();
  }
  template <class Work>
  void add(const Work& work) {
    try {
      threads_.emplace_back(work);
    } catch (const std::system_error&) {  // continue with fewer
    }
  }
  std::atomic<std::size_t> next = 0;

 private:
  std::vector<std::thread> threads_;
};

// Calls `item` for each number below `count`, in any order, from this thread and others. Each thread has what `begin`
// returns while it works.
template <class Begin, class Item>
void share_work(unsigned threads, std::size_t count, const Begin& begin, const Item& item) {
  ThreadPool pool;
  const auto work = [&] {
    [[maybe_unused]] auto own = begin();
    for (std::size_t i; (i = pool.next.fetch_add(1)) < count;) {
      Cancellation::check();
      item(i, own);
    }
  };
  for (unsigned k = 1; k < threads; ++k) pool.add(work);
  work();
}

}  // namespace betwixt
