// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs work in parts, each on a thread.
#pragma once

#include <cstddef>
#include <system_error>
#include <thread>
#include <vector>

namespace betwixt {

// Calls work(0) … work(parts - 1). The first runs on this thread, and so do those for which the system has no threads.
template <class F>
void in_parallel(std::size_t parts, const F& work) {
  std::vector<std::thread> others;
  std::size_t taken = 1;
  try {
    for (; taken < parts; ++taken) others.emplace_back([&work, taken] { work(taken); });
  } catch (const std::system_error&) {
  }
  work(0);
  for (; taken < parts; ++taken) work(taken);
  for (std::thread& t : others) t.join();
}

}  // namespace betwixt
