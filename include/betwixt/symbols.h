// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The matrix of a motion in letters: each of its numbers as a sum of products.
//
// Room: algebra
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "betwixt/algebra.h"

namespace betwixt {

// A letter of one factor. What is 0 or 1 in the string needs none.
struct Symbol {
  enum class Kind : std::uint8_t {
    cosine,  // c: of the angle so far
    sine,    // s
    growth,  // g, h, k: so far, along x, y and z; one letter where they are alike
    axis,    // l, m, n: the direction, of length 1
    way,     // u, v, w: so far
    centre,  // x, y, z
  };
  Kind kind = Kind::cosine;
  std::size_t factor = 0;  // counted from 0
  int along = 0;           // 0, 1, 2: x, y, z
  std::string name;        // "c", and with more than one factor "c1"
  friend bool operator==(const Symbol&, const Symbol&) = default;
};

// count times the product of these letters, which are numbers of Symbols::letters in rising order; one that is there
// twice is its square.
struct Term {
  int count = 1;
  std::vector<std::size_t> letters;
  friend bool operator==(const Term&, const Term&) = default;
};

struct Symbols {
  std::vector<Symbol> letters;
  std::array<std::vector<Term>, 12> sums;  // the upper three rows of A(t), row by row; no terms: 0
};

// Of a motion that `check` passes. Errors (range): a number of the matrix that has more than `most_terms`.
inline constexpr std::size_t most_terms = 64;
Result<Symbols> in_symbols(const Motion&);

// What the letters are at t, and what a sum is of these.
std::vector<double> values_of(const Symbols&, const Motion&, double t);
double value_of(const std::vector<Term>&, std::span<const double> letters);

// "(1 - c2) x2 + s2 y2": what belongs to one length stands together.
std::string to_string(const std::vector<Term>&, const Symbols&);
// "cos 90deg t", "2^t", "3": what a letter stands for.
std::string meaning_of(const Symbol&, const Motion&);

}  // namespace betwixt
