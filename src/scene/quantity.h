// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The values of formulas, and of the names in them.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "betwixt/math.h"
#include "betwixt/value.h"

namespace betwixt {

// A number with its kind. Angles are in degrees and times in frames, as people write them, so that 2*45deg is 90deg to
// the last bit, whatever the rate.
struct Quantity {
  enum class Of : std::uint8_t { number, angle, length, time };
  Of of = Of::number;
  double value = 0;            // degrees, metres, seconds
  double frames = 0;           // of a time, besides its seconds
  bool counts_frames = false;  // written in frames: as a point in time it counts from frame 1
  friend bool operator==(const Quantity&, const Quantity&) = default;
};

// A value, or an element of a list.
using LetItem = std::variant<Quantity, Vec3, Color, Text>;
using LetList = std::vector<LetItem>;
using Let = std::variant<Quantity, Vec3, Color, Text, LetList>;
using Lets = std::map<std::string, Let, std::less<>>;

struct Table;  // scene/table.h

// The place among the names of a pattern: the values of i, n, i1, i2 … and the row of a table.
struct PatternPlace {
  std::size_t i = 1, n = 1;
  std::array<std::size_t, 4> ranges{};  // 0 if there is none
  const Table* table = nullptr;         // of the row; nullptr if there is none
  std::size_t row = 0;
  std::optional<std::size_t> over = {};  // the column of its times
  bool skips = false;                    // empty cells are no errors
};

}  // namespace betwixt
