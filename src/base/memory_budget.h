// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A memory limit for the values of a command. Code that makes something large (points, texts, names, code, contents of
// files) calls MemoryBudget::charge with the bytes first.
#pragma once

#include <atomic>
#include <cstddef>
#include <utility>

#include "betwixt/result.h"

namespace betwixt {

// Thrown if the limit would be exceeded. Work changes copies only, so nothing is left of it.
struct OverBudget {
  std::size_t most;  // the limit
};
Error too_many_bytes(std::size_t most);

// Counts what this thread makes during its lifetime.
class MemoryBudget {
 public:
  // `all`: the bytes that all threads have made under this limit. `there`: an upper bound of the document's bytes.
  MemoryBudget(std::atomic<std::size_t>& all, std::size_t most, std::size_t there = 0)
      : all_(all), most_(most), there_(there), before_(std::exchange(current, this)) {}
  ~MemoryBudget() {
    all_ -= made_;
    current = before_;
  }
  MemoryBudget(const MemoryBudget&) = delete;
  MemoryBudget& operator=(const MemoryBudget&) = delete;

  std::size_t made() const { return made_; }

  static void charge(std::size_t bytes) {
    if (current) current->add(bytes);
  }
  // Asks for bytes that the document will keep from now on. `now` returns the document's bytes without them; it is
  // called only if the upper bound does not suffice.
  template <class Now>
  static void charge_kept(std::size_t bytes, const Now& now) {
    if (!current) return;
    current->add(bytes);
    if (current->there_ + current->made_ <= current->most_ || now() + bytes <= current->most_) return;
    current->take_back(bytes);
    throw OverBudget{current->most_};
  }

 private:
  void add(std::size_t bytes) {
    made_ += bytes;
    if ((all_ += bytes) <= most_) return;
    take_back(bytes);
    throw OverBudget{most_};
  }
  void take_back(std::size_t bytes) { made_ -= bytes, all_ -= bytes; }

  static inline thread_local MemoryBudget* current = nullptr;
  std::atomic<std::size_t>& all_;
  const std::size_t most_, there_;
  MemoryBudget* const before_;
  std::size_t made_ = 0;
};

}  // namespace betwixt
