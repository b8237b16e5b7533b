// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Evenly scattered numbers for the samples of a pixel: the same ones for the same pixel, sample and question, whoever
// asks and when.
//
// The samples of one question lie on the first two coordinates of Sobol's sequence: of 2^k of them each of 2^k equal
// boxes, however they are cut by halves, has one. A pixel and question has its own digits flipped and its own order of
// samples, so that questions know nothing of each other.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace betwixt::traced {

class Scattered {
 public:
  Scattered(std::uint32_t pixel, std::uint32_t sample, std::uint32_t samples)
      : bits_(std::bit_width(samples - 1)), pixel_(mixed(pixel)), sample_(sample) {}

  // Two numbers from 0 to 1, 1 excluded, for the next question.
  std::array<double, 2> two() {
    const std::uint64_t own = mixed(pixel_ + question_++);
    const std::uint32_t i = shuffled(own);
    const auto flips = mixed(own);
    return {part(reversed(i) ^ static_cast<std::uint32_t>(flips)),
            part(second(i) ^ static_cast<std::uint32_t>(flips >> 32))};
  }
  double one() { return two()[0]; }

 private:
  // Every bit of the outcome hangs on every bit that goes in (splitmix64).
  static constexpr std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
  }
  static constexpr double part(std::uint32_t x) { return 0x1p-32 * x; }
  static constexpr std::uint32_t reversed(std::uint32_t i) {
    std::uint32_t r = 0;
    for (std::uint32_t bit = 1U << 31; i != 0; i >>= 1, bit >>= 1) r ^= (i & 1) != 0 ? bit : 0;
    return r;
  }
  static constexpr std::uint32_t second(std::uint32_t i) {
    std::uint32_t r = 0;
    for (std::uint32_t column = 1U << 31; i != 0; i >>= 1, column ^= column >> 1) r ^= (i & 1) != 0 ? column : 0;
    return r;
  }
  // A place of its own among 2^bits for each sample: each step can be undone.
  std::uint32_t shuffled(std::uint64_t own) const {
    const std::uint32_t all = static_cast<std::uint32_t>((std::uint64_t{1} << bits_) - 1);
    std::uint32_t i = sample_;
    for (int round = 0; round < 4; ++round, own = own << 16 | own >> 48) {
      i = (i * (static_cast<std::uint32_t>(own) | 1) + static_cast<std::uint32_t>(own >> 32)) & all;
      i ^= i >> (bits_ / 2 + 1);
    }
    return i;
  }

  const int bits_;
  const std::uint64_t pixel_;
  const std::uint32_t sample_;
  std::uint64_t question_ = 0;
};

}  // namespace betwixt::traced
