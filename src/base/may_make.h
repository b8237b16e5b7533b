// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A memory limit for the values of a command. Code that makes something large (points, texts, names, code) calls
// MayMake::ask with the bytes first.
#pragma once

#include <atomic>
#include <cstddef>
#include <utility>

namespace betwixt {

// Thrown if the limit would be exceeded. Work changes copies only, so nothing is left of it.
struct TooMuch {};

// Counts what this thread makes during its lifetime.
class MayMake {
 public:
  // `all`: the bytes that all threads have made under this limit.
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
