// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A source of random decisions for script generators. The same seed gives the same decisions.
#pragma once

#include <cstdint>
#include <random>

namespace betwixt {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}

 protected:
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  bool chance(int n) { return below(n) == 0; }
  std::mt19937_64 random_;
};

}  // namespace betwixt
