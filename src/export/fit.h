// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pieces that follow a function of time: as few as a tolerance allows.
#pragma once

#include <functional>
#include <span>

#include "betwixt/keys.h"

namespace betwixt {

using KeyValue = std::array<double, 4>;

struct Followed {
  std::size_t width = 3;
  bool turn = false;
  double tolerance = 1e-4;
  Time step;  // looked at that often at least, so that nothing passes between two looks
  std::function<KeyValue(Time)> at;
};

// `knots`: in order, from the beginning to the end, both included: where it may jump or have a corner. Other jumps are
// found, if they last for a step.
Channel follow(const Followed&, std::span<const Time> knots, const KeyOptions&);

}  // namespace betwixt
