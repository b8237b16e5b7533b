// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Copies out of memory that another process has filled. Included only by the file that reads the wire format.
#pragma once

#include <sys/types.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>

namespace betwixt::wire {

// Copies everything out and reads no shared byte twice, because the other process may still be writing.
class Taker {
 public:
  Taker(int memory, std::uint64_t size) : memory_(memory), left_(size) {}
  template <class T>
  bool one(T& value) {
    return raw(&value, sizeof value);
  }
  template <class T>
  bool block(T& all) {
    std::uint64_t count = 0;
    if (!one(count) || count > left_ / sizeof(*all.data())) return false;
    all.resize(count);
    return raw(all.data(), count * sizeof(*all.data()));
  }
  bool done() const { return left_ == 0; }

 private:
  bool raw(void* to, std::uint64_t size) {
    if (size > left_) return false;
    left_ -= size;
    for (auto* at = static_cast<char*>(to); size > 0;) {
      const ssize_t n = ::pread(memory_, at, size, at_);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return false;
      at += n, at_ += n, size -= static_cast<std::uint64_t>(n);
    }
    return true;
  }
  int memory_;
  std::uint64_t left_;
  off_t at_ = 0;
};

}  // namespace betwixt::wire
