// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Powers of many motions at once, with SIMD. No fused multiply-add and no library sine: the bits are the same on every
// machine.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace betwixt::environments {

inline constexpr std::size_t lanes = 8;  // motions in a block

// The form of a motion, which decides how much of A to compute; the cheapest forms come first.
//
// A tick is limited by memory, so derived numbers are not stored: an axis (of length 1) and a centre (perpendicular to
// the axis) omit the axis' longest coordinate. All axes of a run are longest in the same coordinate, `major`, and
// positive there; u and v are the two after it, in the order x y z x y.
enum class Form : std::uint8_t {
  translation,  // slide x y z
  spin,         // about an axis through the origin: turns, axis u v
  screw,        // turns, axis u v, centre u v, advance
  similarity,   // the same with advance / (scale - 1), then log scale
};
// Returns the number of rows of a motion.
constexpr std::size_t rows(Form f) {
  constexpr std::array<std::size_t, 4> count{3, 3, 6, 7};
  return count[static_cast<std::size_t>(f)];
}
// The elements of A that may differ from the identity: element (r, c) of the linear part is in row 3 r + c; the last
// column follows. A spin has no last column, a translation has nothing else.
constexpr bool turns(Form f) { return f != Form::translation; }
constexpr bool shifts(Form f) { return f != Form::spin; }
constexpr std::size_t matrix_rows(Form f) { return (turns(f) ? 9 : 0) + (shifts(f) ? 3 : 0); }

// One number of each motion of a block; `turns` is a u64 in the bits of a double.
struct alignas(64) Row {
  std::array<double, lanes> of{};
};

// The number of steps by which each motion of a block begins later than its run's base.
struct alignas(16) Delays {
  std::array<std::uint16_t, lanes> of{};
};

// Consecutive blocks of one form.
struct Run {
  Form form = Form::translation;
  std::size_t major = 0;
  const Delays* delays = nullptr;
  const Row* in = nullptr;  // rows(form) for each block
  Row* out = nullptr;       // matrix_rows(form)
  std::size_t blocks = 0;
};

// Computes A = M^(step - delay), or the identity before the first step. Clamps shrinking motions at
// 1 / Power::bound, as environments do. Does not clamp numbers above Power::bound.
//
// `through`: write matrices past the caches, for sets larger than these, so that no cache line is read only to be
// overwritten. Call settle() before another thread reads them. `then`: the rows that will be read next.
void evaluate(const Run&, std::int64_t step, bool through, const Row* then);
void settle();

// The same for similarities that may have reached Power::bound: clamps like environments.
void evaluate_held(const Run&, std::int64_t step);

}  // namespace betwixt::environments
