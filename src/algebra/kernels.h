// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// One step of all points: for counting, and with the vectors of the machine. kernel_steps.h has the step itself, once
// for both.
#pragma once

#include <cstddef>
#include <cstdint>

namespace betwixt::algebra {

class Counted;

enum class Kernel : std::uint8_t {
  // From the points at rest:
  offset,  // x = y + o
  scale,   // x = g y + o, per axis
  matrix,  // x = M y + o
  // In place:
  move,     // x += d, the same for all
  slide,    // x += d, each point its own
  stretch,  // x = g x + o, per axis
  turn,     // x = M x + o, M a rotation
  // A state is updated in place, and drawn with an offset:
  grow,       // y *= g
  ramp,       // y += d, each point its own
  two_term,   // y+ = 2 cos y - y-
  damped,     // y+ = 2 g cos y - g^2 y-, per axis
  conformal,  // y *= a complex number
  // The source's geometric method: rotations as three shears.
  shears,          // shear y, draw y + o
  pushed_shears,   // shear y, y += v, the same for all; draw y + o
  carried_shears,  // y += v, each point its own; shear y, draw y + o, shear v
  swung_shears,    // shear y; e += d; draw y + e
};
// Expands with(name) for each kernel.
#define BETWIXT_KERNELS(with)                                                                                 \
  with(offset) with(scale) with(matrix) with(move) with(slide) with(stretch) with(turn) with(grow) with(ramp) \
      with(two_term) with(damped) with(conformal) with(shears) with(pushed_shears) with(carried_shears)       \
          with(swung_shears)

#define BETWIXT_ONE(name) +1
inline constexpr int kernel_count = 0 BETWIXT_KERNELS(BETWIXT_ONE);
#undef BETWIXT_ONE

// The numbers of a point. For kernels in place, x and y are drawn.
template <class V>
struct Lane {
  V x{}, y{};    // the point or its state
  V u{}, v{};    // a second state
  V du{}, dv{};  // the increment of the second state
  V ox{}, oy{};  // the drawn point
};

// The arrays that a kernel uses.
struct Uses {
  bool state = true;     // writes x, y
  bool second = false;   // reads u, v
  bool written = false;  // writes u, v
  bool gain = false;     // reads du, dv
  bool drawn = true;     // writes ox, oy
  int offset = -1;       // the input that is the drawing offset of a state; -1: none
};
constexpr Uses uses(Kernel k) {
  switch (k) {
    case Kernel::offset:
    case Kernel::scale:
    case Kernel::matrix:
      return {.state = false};
    case Kernel::move:
    case Kernel::stretch:
    case Kernel::turn:
      return {.drawn = false};
    case Kernel::slide:
      return {.second = true, .drawn = false};
    case Kernel::ramp:
      return {.second = true, .offset = 0};
    case Kernel::two_term:
      return {.second = true, .written = true, .offset = 1};
    case Kernel::damped:
      return {.second = true, .written = true, .offset = 4};
    case Kernel::carried_shears:
      return {.second = true, .written = true, .offset = 2};
    case Kernel::swung_shears:
      return {.second = true, .written = true, .gain = true};
    case Kernel::conformal:
      return {.offset = 3};
    case Kernel::grow:
    case Kernel::shears:
    case Kernel::pushed_shears:
      return {.offset = 2};
  }
  return {};
}

inline constexpr int most_inputs = 6;  // of a kernel

// Structure of arrays; arrays that a kernel does not use may be empty.
template <class Number>
struct Arrays {
  Number *x = nullptr, *y = nullptr, *u = nullptr, *v = nullptr;
  const Number *du = nullptr, *dv = nullptr;
  Number *ox = nullptr, *oy = nullptr;
  std::size_t count = 0;
};

template <class Number>
Arrays<Number> part(const Arrays<Number>& a, std::size_t from, std::size_t to) {
  const auto at = [&](auto* array) { return array ? array + from : array; };
  return {at(a.x), at(a.y), at(a.u), at(a.v), at(a.du), at(a.dv), at(a.ox), at(a.oy), to - from};
}

// Steps one point after the other.
void step_plainly(Kernel, const Arrays<Counted>&, const Counted* inputs);
// Steps by vectors. Uses several threads if there are many points, at most `most_threads`; 0: as many as the machine
// has. Gives the same bits as step_plainly.
void step_all(Kernel, const Arrays<float>&, const float* inputs, unsigned most_threads = 0);
void step_all(Kernel, const Arrays<double>&, const double* inputs, unsigned most_threads = 0);

// Returns the operations (multiplications, additions) per step and point, counted by doing one.
int operations_per_point(Kernel);

}  // namespace betwixt::algebra
