// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Functions shared by the readers and writers of motions.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "algebra/turns.h"
#include "betwixt/result.h"

namespace betwixt::algebra {

struct Unit {
  std::string_view name;
  double of;       // metres or radians
  double divisor;  // 35 mm are 35/1000 m: a division keeps the number as written
};

// A text being read, and its first error.
struct Cursor {
  std::string_view text;
  std::size_t at = 0;
  std::optional<Error> error = {};

  // Records an error at the bytes from..to. Returns false.
  bool fail(std::size_t from, std::size_t to, ErrorCode, std::string message, Hint hint = {});
  char peek() const { return at < text.size() ? text[at] : '\0'; }
};

// Returns the shortest text that reads back as the same number; zero has no sign.
std::string written(double);

// As in Factor: `rest` is the rounding error of many turns.
struct Angle {
  double radians = 0, rest = 0;
  friend bool operator==(const Angle&, const Angle&) = default;
};
Angle angle_of(Turns);
// Returns the angle of a number as written, "1e3" or "-.5", and its value; nullopt if it is too large to count.
std::optional<Angle> read_angle(std::string_view number, double value, const Unit&);
// Returns the shortest text that reads back the same, in deg, turn or rad.
std::string angle_text(Angle);

}  // namespace betwixt::algebra
