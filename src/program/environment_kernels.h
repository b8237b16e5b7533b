// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Powers of many motions at once, several side by side in the registers of whatever machine this is. No
// multiply-and-add in one instruction and no library's sine: the bits are the same on every machine.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace betwixt::environments {

inline constexpr std::size_t lanes = 8;  // motions in a block

// What a motion does decides how much of A there is to work out. First come those that take the least.
enum class Form : std::uint8_t {
  translation,  // rows: first, slide x y z. The linear part of A is left as it is.
  spin,         // about an axis through the origin: first, turns, axis x y z. The last column is left as it is.
  screw,        // first, turns, axis x y z, centre x y z, advance
  similarity,   // the same with advance / (scale - 1) for the advance, and then log scale
};
constexpr std::size_t rows(Form f) {
  constexpr std::array<std::size_t, 4> count{4, 5, 9, 10};
  return count[static_cast<std::size_t>(f)];
}

// One number of each motion of a block; `first` is an i64 and `turns` a u64 in the bits of a double.
struct alignas(64) Row {
  std::array<double, lanes> of{};
};

// The affine parts of matrices: element (r, c) of all of them is m[4 r + c].
struct alignas(64) Block {
  std::array<std::array<double, lanes>, 12> m{};
};

// A = M^(step - first), the identity before `first`. `in` has rows(form) rows for each block. What shrinks is held at
// 1 / Power::bound as environments are; numbers beyond Power::bound are not looked after.
//
// `through`: matrices go to memory past the caches, for sets that are larger than these, where a line of the cache
// would be read only to be written over. Whoever lets another thread read them calls settle() before.
void evaluate(Form form, std::int64_t step, const Row* in, std::size_t blocks, Block* out, bool through);
void settle();

}  // namespace betwixt::environments
