// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What the readers and writers of motions share.
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
  double divisor;  // 35 mm are 35/1000 m: dividing keeps the number that is written
};

// A text that is being read, and the first thing that is wrong with it.
struct Cursor {
  std::string_view text;
  std::size_t at = 0;
  std::optional<Error> error = {};

  // Of the bytes from..to. Always false.
  bool fail(std::size_t from, std::size_t to, ErrorCode, std::string message, std::string hint = {});
  char peek() const { return at < text.size() ? text[at] : '\0'; }
};

// The shortest that reads back the same; zero has no sign.
std::string written(double);

// As a Factor holds it: what rounding takes of many turns is in the rest.
struct Angle {
  double radians = 0, rest = 0;
  friend bool operator==(const Angle&, const Angle&) = default;
};
Angle angle_of(Turns);
// Of a number as it is written, "1e3" or "-.5", and its value. None: it is beyond all counting.
std::optional<Angle> read_angle(std::string_view number, double value, const Unit&);
// The shortest that reads back the same, in deg, turn or rad.
std::string angle_text(Angle);

}  // namespace betwixt::algebra
