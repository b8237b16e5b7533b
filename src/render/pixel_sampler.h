// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Well-distributed random numbers for the samples of a pixel: the same ones for the same pixel, sample and decision,
// for any caller and at any time.
//
// The samples of a decision are the first two coordinates of Sobol's sequence: of 2^k samples, each of 2^k equal boxes
// has one, in whatever way the square is halved. Each pixel and decision has its own flipped digits and its own order
// of samples, so that decisions are independent. Where a camera's ray goes and when is one decision of five
// coordinates.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace betwixt::traced {

using SobolColumns = std::array<std::uint32_t, 32>;
// The columns of a coordinate of Sobol's sequence, by Joe and Kuo's numbers: a polynomial and its first columns. The
// first digit of a number is its lowest bit.
constexpr SobolColumns sobol_columns(std::size_t degree, std::uint32_t polynomial, std::array<std::uint32_t, 3> begin) {
  SobolColumns v{};
  for (std::size_t k = 0; k < v.size(); ++k) {
    if (k < degree) {
      for (std::size_t j = 0; j <= k; ++j) v[k] |= (begin[k] >> (k - j) & 1) << j;
      continue;
    }
    v[k] = v[k - degree] ^ (v[k - degree] << degree);
    for (std::size_t j = 1; j < degree; ++j)
      if ((polynomial >> (degree - 1 - j) & 1) != 0) v[k] ^= v[k - j];
  }
  return v;
}
inline constexpr std::array<SobolColumns, 3> sobol_more{sobol_columns(2, 1, {1, 3, 0}), sobol_columns(3, 1, {1, 3, 1}),
                                                        sobol_columns(3, 2, {1, 1, 1})};

class PixelSampler {
 public:
  // Different blocks of a pixel's samples are independent of each other.
  PixelSampler(std::uint32_t pixel, std::uint32_t sample, std::uint32_t samples, std::uint32_t block = 0)
      : bits_(std::bit_width(samples - 1)), pixel_(hashed(std::uint64_t{block} << 32 | pixel)), sample_(sample) {}
  // Returns the sampler of the same pixel for the `segment`-th so many samples of the sequence: segments together are
  // as well-distributed as each by itself.
  PixelSampler of_segment(std::uint32_t segment) const {
    PixelSampler other = *this;
    other.first_ = segment << bits_;
    return other;
  }

  // Returns two numbers from 0 to 1, 1 excluded, for the next decision.
  std::array<double, 2> next_2d() {
    const std::uint64_t own = hashed(pixel_ + decision_++);
    const std::uint32_t i = first_ + shuffled(own);
    const auto flips = hashed(own);
    return {unit_float(reversed_bits(i) ^ static_cast<std::uint32_t>(flips)),
            unit_float(sobol_second(i) ^ static_cast<std::uint32_t>(flips >> 32))};
  }
  double next_1d() { return next_2d()[0]; }
  // Returns five numbers for one decision. The first two are those that next_2d() would return.
  std::array<double, 5> next_5d() {
    const std::uint64_t own = hashed(pixel_ + decision_);
    const std::uint32_t i = first_ + shuffled(own);
    const auto [x, y] = next_2d();
    std::array<double, 5> all{x, y};
    std::uint64_t seed = hashed(own ^ 0x5d);
    for (std::size_t d = 0; d < sobol_more.size(); ++d, seed = hashed(seed)) {
      std::uint32_t digits = 0;
      for (std::size_t k = 0; i >> k != 0; ++k) digits ^= sobol_more[d][k] & (0 - (i >> k & 1));
      all[d + 2] = scrambled(digits, static_cast<std::uint32_t>(seed));
    }
    return all;
  }

 private:
  // Flips each digit by chance, depending on those before it (Owen's scrambling, by Laine and Karras' hash). The first
  // digit is the lowest bit.
  static constexpr double scrambled(std::uint32_t x, std::uint32_t seed) {
    x += seed;
    for (const std::uint32_t factor : {0x6c50b47cU, 0xb82f1e52U, 0xc7afe638U, 0x8d22f6e6U}) x ^= x * factor;
    x = (x & 0x55555555) << 1 | (x >> 1 & 0x55555555);
    x = (x & 0x33333333) << 2 | (x >> 2 & 0x33333333);
    x = (x & 0x0f0f0f0f) << 4 | (x >> 4 & 0x0f0f0f0f);
    x = (x & 0x00ff00ff) << 8 | (x >> 8 & 0x00ff00ff);
    return unit_float(x << 16 | x >> 16);
  }
  // Every bit of the result depends on every bit of the input (splitmix64).
  static constexpr std::uint64_t hashed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
  }
  static constexpr double unit_float(std::uint32_t x) { return 0x1p-32 * x; }
  static constexpr std::uint32_t reversed_bits(std::uint32_t i) {
    std::uint32_t r = 0;
    for (std::uint32_t bit = 1U << 31; i != 0; i >>= 1, bit >>= 1) r ^= (i & 1) != 0 ? bit : 0;
    return r;
  }
  static constexpr std::uint32_t sobol_second(std::uint32_t i) {
    std::uint32_t r = 0;
    for (std::uint32_t column = 1U << 31; i != 0; i >>= 1, column ^= column >> 1) r ^= (i & 1) != 0 ? column : 0;
    return r;
  }
  // A permutation of 2^bits samples: each step is invertible.
  std::uint32_t shuffled(std::uint64_t own) const {
    const std::uint32_t all = static_cast<std::uint32_t>((std::uint64_t{1} << bits_) - 1);
    std::uint32_t i = sample_;
    for (int round = 0; round < 4; ++round, own = own << 16 | own >> 48) {
      i = (i * (static_cast<std::uint32_t>(own) | 1) + static_cast<std::uint32_t>(own >> 32)) & all;
      i ^= i >> (bits_ / 2 + 1);
    }
    return i;
  }

  int bits_;
  std::uint64_t pixel_;
  std::uint32_t sample_, first_ = 0;
  std::uint64_t decision_ = 0;
};

}  // namespace betwixt::traced
