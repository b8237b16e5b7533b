// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A histogram with a precision of 3 % in fixed memory. One thread adds; any thread may read.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>

namespace betwixt {

class Histogram {
 public:
  void add(std::uint64_t value) {
    counts_[place(value)].fetch_add(1, std::memory_order_relaxed);
    if (value > largest_.load(std::memory_order_relaxed)) largest_.store(value, std::memory_order_relaxed);
  }
  std::uint64_t largest() const { return largest_.load(std::memory_order_relaxed); }
  // Returns the value that a fraction `part` of all, 0 to 1, does not exceed, or 0 if the histogram is empty.
  std::uint64_t quantile(double part) const {
    std::uint64_t all = 0;
    for (const auto& c : counts_) all += c.load(std::memory_order_relaxed);
    const auto wanted = static_cast<std::uint64_t>(std::ceil(part * static_cast<double>(all)));
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < counts_.size() && all > 0; ++i)
      if ((seen += counts_[i].load(std::memory_order_relaxed)) >= wanted && seen > 0)
        return std::min(last_of(i), largest());
    return 0;
  }

 private:
  static constexpr unsigned bits = 5;  // of each number's precision, below its highest bit
  static constexpr std::uint64_t fine = 1u << bits;
  static std::size_t place(std::uint64_t v) {
    if (v < fine) return v;
    const auto shift = static_cast<unsigned>(std::bit_width(v)) - bits - 1;
    return (shift + 1) * fine + ((v >> shift) - fine);
  }
  static std::uint64_t last_of(std::size_t i) {
    if (i < fine) return i;
    const std::uint64_t shift = i / fine - 1;
    return ((i % fine + fine + 1) << shift) - 1;
  }
  std::array<std::atomic<std::uint64_t>, (64 - bits + 1) * fine> counts_{};
  std::atomic<std::uint64_t> largest_{0};
};

}  // namespace betwixt
