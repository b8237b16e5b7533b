// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The string compiler: finds the cheapest exact way that it knows from frame to frame, for any string of the plane.
//
// A_k p = d0 + B1 (d1 + B2 (d2 + ... Bm (p + c))): every factor is an offset, constant or growing with k, or a linear
// block. What remains per step is a small program of registers, and a kernel for the points. Most registers are
// sequences with a closed form in k, so any frame can be reached at once, and rounding errors do not accumulate.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "algebra/counted.h"
#include "algebra/kernels.h"
#include "betwixt/algebra.h"

namespace betwixt::algebra {

std::string letters(const Motion&);  // "TRS"
Turns planar_turns(const Factor&);   // of a rotation, anticlockwise

// A rotation, a scaling by the exponential law, both at once if it is uniform (a conformal block), or a scaling by the
// linear law.
struct Block {
  Turns turns{};                // of the whole motion
  double log_x = 0, log_y = 0;  // of the whole growth
  bool linear = false;          // the linear law: 1 + slope k/N
  double slope_x = 0, slope_y = 0;

  bool identity() const { return turns.none() && log_x == 0 && log_y == 0 && slope_x == 0 && slope_y == 0; }
  bool conformal() const { return !linear && log_x == log_y; }
  bool diagonal() const { return !linear && turns.none(); }
};

// Merges two adjacent blocks if one block can represent both. Returns whether it did.
bool merge(Block& into, const Block&);

template <class Number>
struct Offset {
  Number x{}, y{};              // constant
  Number drift_x{}, drift_y{};  // increment per step
  bool fixed() const { return drift_x == Number(0) && drift_y == Number(0); }
  bool zero() const { return fixed() && x == Number(0) && y == Number(0); }
};

// offsets[0], blocks[0], offsets[1], ... blocks[m - 1], offsets[m]. No block is the identity, and no two adjacent ones
// could be merged.
template <class Number>
struct Canonical {
  std::vector<Block> blocks;
  std::vector<Offset<Number>> offsets;
};
template <class Number>
Canonical<Number> canonical(const Motion&, std::int64_t steps);

// One register of the program. Registers are computed in order.
template <class Number>
struct Register {
  enum class Kind : std::uint8_t {
    constant,    // a
    ramp,        // a + b k; a step adds b
    geometric,   // a growth^k; a step multiplies by p
    wave,        // growth^k (a cos k angle + b sin k angle); a step is p x - q x of the step before
    sheared,     // the rotating point (a, b): a step shears it by p, q, p; the next register is its y
    second,      // y of a sheared point
    product,     // of the registers left and right, which come before it
    sum,         //
    difference,  //
  };
  Kind kind = Kind::constant;
  Number a{}, b{};
  Turns turns{};  // of the whole motion
  double log_growth = 0;
  int left = -1, right = -1;
  Number p{}, q{};
};

template <class Number>
struct Plan {
  std::int64_t steps = 1;
  Kernel kernel = Kernel::offset;
  std::vector<Register<Number>> registers;
  // The inputs of the kernel: constants, then registers.
  std::vector<Number> constants;
  std::vector<int> inputs;
  // A point p starts as rest = p + centre; its state at step k is L_k (rest + k (gain + slope rest)) + home.
  Number centre_x{}, centre_y{}, home_x{}, home_y{};
  std::vector<Block> blocks;  // L
  Number gain_x{}, gain_y{}, slope_x{}, slope_y{};
  bool whole_step = false;  // one step is the whole motion, so frames beyond it are sought

  int per_point() const { return operations_per_point(kernel); }
  int per_step() const;  // operations of the registers
};

// The set to choose from: plans that multiply the points at rest by A_k, or all plans.
enum class Family : std::uint8_t { matrix, any };
template <class Number>
Plan<Number> compile(const Motion&, std::int64_t steps, Family, std::size_t points);

// Plans the source's geometric method, for the rows of its first table. Errors (type): another string, a scaling by the
// exponential law; (range) half a turn in a step.
template <class Number>
Result<Plan<Number>> geometric(const Motion&, std::int64_t steps);

// Plans the source's method of differences: one constant A with A_k = A A_(k-1). Errors (type): there is none. With a
// single step there always is one. Rotations that are whole at every step count as none.
template <class Number>
Result<Plan<Number>> differences(const Motion&, std::int64_t steps);

}  // namespace betwixt::algebra
