// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The stops of a gradient as they are written: "#f60, #fc0 40%, first/50%, transparent".
#pragma once

#include <string_view>
#include <vector>

#include "betwixt/gradient.h"
#include "betwixt/result.h"
#include "betwixt/value.h"

namespace betwixt {

struct WrittenStop {
  enum class Of : std::uint8_t { color, first, second } of = Of::color;
  Color color;  // sRGB
  double opacity = 1, at = 0;
};

// Returns the stops in order, each with its place: what has none is evenly between its neighbours. If `wrong` is given,
// it becomes the part of the text that the error is about. Errors: name (no colour), syntax, range (fewer than two or
// more than `most_stops`; places that go back).
Result<std::vector<WrittenStop>> read_stops(std::string_view, std::string_view* wrong = nullptr);

// Returns the stops with these colours in linear light; for a text that is wrong, those two.
std::vector<Gradient::Stop> stops_of(std::string_view written, Vec3 first, Vec3 second);

}  // namespace betwixt
