// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The rows of a track as columns of numbers. A million rows take longer to write than to put on a track, so their text
// is written only when somebody reads it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "betwixt/time.h"
#include "scene/functions.h"

namespace betwixt {

// Returns how many numbers a value of the type has; 0: it does not consist of numbers.
std::size_t width_of(Type);
// Makes a value of so many numbers.
Value value_of(Type, const double* numbers);

struct TrackRows {
  FunctionSpec spec;
  int component = -1;  // of the function's value; -1: all
  Type type = Type::scalar;
  Rate rate;
  std::string twerper;  // of every row; may be empty
  std::vector<Time> times;
  std::vector<double> numbers;  // width_of(type) for each time

  Value value(std::size_t row) const { return value_of(type, &numbers[row * width_of(type)]); }
  // Appends a row, indented.
  void write(std::size_t row, std::string& to) const;
  // Appends all rows, each between `before` and `behind`.
  void write_all(std::string_view before, std::string_view behind, std::string& to) const;
  std::size_t bytes() const;  // of memory
};

}  // namespace betwixt
