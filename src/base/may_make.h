// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How much memory a command may fill with values. Whoever makes what may be large (points, texts, names, code) says how
// many bytes it has before it is made.
#pragma once

#include <atomic>
#include <cstddef>
#include <utility>

namespace betwixt {

// Thrown out of work that would make more than it may. It is all done on copies, which go with it.
struct TooMuch {};

// What this thread makes while it lives.
class MayMake {
 public:
  // `all`: the bytes that all threads make under this limit.
  MayMake(std::atomic<std::size_t>& all, std::size_t most)
      : all_(all), most_(most), before_(std::exchange(current, this)) {}
  ~MayMake() {
    all_ -= made_;
    current = before_;
  }
  MayMake(const MayMake&) = delete;
  MayMake& operator=(const MayMake&) = delete;

  std::size_t made() const { return made_; }

  static void ask(std::size_t bytes) {
    if (current) current->add(bytes);
  }

 private:
  void add(std::size_t bytes) {
    made_ += bytes;
    if ((all_ += bytes) > most_) throw TooMuch{};
  }

  static inline thread_local MayMake* current = nullptr;
  std::atomic<std::size_t>& all_;
  const std::size_t most_;
  MayMake* const before_;
  std::size_t made_ = 0;
};

}  // namespace betwixt
