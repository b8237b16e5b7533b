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
//
// Memory is what a tick waits for, so of numbers that follow from others there are none: of an axis (of length 1) the
// longest coordinate is left out, and so it is of a centre (across the axis). All axes of a run are longest in the same
// coordinate, `major`, and positive there; u and v are the two after it, in the order x y z x y.
enum class Form : std::uint8_t {
  translation,  // slide x y z
  spin,         // about an axis through the origin: turns, axis u v
  screw,        // turns, axis u v, centre u v, advance
  similarity,   // the same with advance / (scale - 1) for the advance, and then log scale
};
// Numbers of a motion.
constexpr std::size_t rows(Form f) {
  constexpr std::array<std::size_t, 4> count{3, 3, 6, 7};
  return count[static_cast<std::size_t>(f)];
}
// Numbers of A that differ from those of the identity: element (r, c) of the linear part is in row 3 r + c, then comes
// the last column; a spin has none, a translation nothing else.
constexpr bool turns(Form f) { return f != Form::translation; }
constexpr bool shifts(Form f) { return f != Form::spin; }
constexpr std::size_t matrix_rows(Form f) { return (turns(f) ? 9 : 0) + (shifts(f) ? 3 : 0); }

// One number of each motion of a block; `turns` is a u64 in the bits of a double.
struct alignas(64) Row {
  std::array<double, lanes> of{};
};

// By how many steps the motions of a block begin later than the first of the run may.
struct alignas(16) Delays {
  std::array<std::uint16_t, lanes> of{};
};

// Blocks of one form, one after the other.
struct Run {
  Form form = Form::translation;
  std::size_t major = 0;
  const Delays* delays = nullptr;
  const Row* in = nullptr;  // rows(form) for each block
  Row* out = nullptr;       // matrix_rows(form)
  std::size_t blocks = 0;
};

// A = M^(step - delay), the identity before. What shrinks is held at 1 / Power::bound as environments are; numbers
// beyond Power::bound are not looked after.
//
// `through`: matrices go to memory past the caches, for sets that are larger than these, where a line of the cache
// would be read only to be written over. Whoever lets another thread read them calls settle() before. `then`: what will
// be read next.
void evaluate(const Run&, std::int64_t step, bool through, const Row* then);
void settle();

// The same of similarities that may have come to Power::bound: all that environments hold is held as they hold it.
void evaluate_held(const Run&, std::int64_t step);

}  // namespace betwixt::environments
