// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What the readers and writers of motions share.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

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
// The same with its unit, deg, turn or rad, whichever makes it shortest.
std::string angle_text(double radians);

}  // namespace betwixt::algebra
