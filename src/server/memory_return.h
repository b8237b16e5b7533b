// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Returns freed memory to the system, because each thread's heap keeps it otherwise. Waits a second first, so that the
// work that used the memory has freed it. Runs on a thread of its own at ordinary priority: a low-priority thread that
// holds a heap's lock would block all others.
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

namespace betwixt {

class MemoryReturn {
 public:
  MemoryReturn() = default;
  ~MemoryReturn();
  MemoryReturn(const MemoryReturn&) = delete;
  MemoryReturn& operator=(const MemoryReturn&) = delete;

  void soon();

 private:
  void serve();

  std::mutex mutex_;
  std::condition_variable changed_;
  bool wanted_ = false, ended_ = false;
  std::thread thread_;  // started by the first call
};

}  // namespace betwixt
