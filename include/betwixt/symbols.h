// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The matrix of a motion in symbolic form: each element is a sum of products.
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

// A symbol (letter) for a number of one factor. Numbers that are 0 or 1 in the string have no symbol.
struct Symbol {
  enum class Kind : std::uint8_t {
    cosine,  // c: cosine of the angle at t
    sine,    // s: sine of the angle at t
    growth,  // g, h, k: the factor at t along x, y and z; a single letter if they are equal
    axis,    // l, m, n: the unit direction
    way,     // u, v, w: the displacement at t
    centre,  // x, y, z
  };
  Kind kind = Kind::cosine;
  std::size_t factor = 0;  // counted from 0
  int along = 0;           // 0, 1, 2: x, y, z
  std::string name;        // "c", and with more than one factor "c1"
  friend bool operator==(const Symbol&, const Symbol&) = default;
};

// A product: `count` times these letters. They are indices into Symbols::letters in ascending order; a repeated index
// is a square.
struct Term {
  int count = 1;
  std::vector<std::size_t> letters;
  friend bool operator==(const Term&, const Term&) = default;
};

struct Symbols {
  std::vector<Symbol> letters;
  std::array<std::vector<Term>, 12> sums;  // the first three rows of A(t), row by row; an empty sum is 0
};

// Returns the symbolic form. The motion must pass `check`. Errors (range): an element has more than `most_terms`.
inline constexpr std::size_t most_terms = 64;
Result<Symbols> in_symbols(const Motion&);

// values_of returns the value of each letter at t. value_of returns the value of a sum, given the values of the
// letters.
std::vector<double> values_of(const Symbols&, const Motion&, double t);
double value_of(const std::vector<Term>&, std::span<const double> letters);

// Returns a sum as text, such as "(1 - c2) x2 + s2 y2", with the terms of one length grouped.
std::string to_string(const std::vector<Term>&, const Symbols&);
// Returns the definition of a letter, such as "cos 90deg t", "2^t" or "3".
std::string meaning_of(const Symbol&, const Motion&);

}  // namespace betwixt
