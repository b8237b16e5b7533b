// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Gives back to the system what was needed once: each thread's heap keeps that for itself. A second after it is asked
// for, so that it comes after what took the memory has freed it, too, and on a thread of its own with nobody's claim
// given up: whoever is kept waiting while it holds a heap's lock must not keep others waiting.
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
  std::thread thread_;  // from the first time on
};

}  // namespace betwixt
