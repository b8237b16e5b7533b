// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits pieces to a function of time: as few as the tolerance allows.
#pragma once

#include <functional>
#include <span>
#include <utility>

#include "betwixt/keys.h"

namespace betwixt {

using KeyValue = std::array<double, 4>;

struct Followed {
  std::size_t width = 3;
  bool turn = false;
  double tolerance = 1e-4;
  std::function<KeyValue(Time)> at;
  Time step;  // the largest distance of samples, so that nothing happens unnoticed between two
};
// Returns a function with steps of half a frame and half the tolerance; the rest is for errors that add up.
Followed followed(const Document&, std::size_t width, double tolerance, std::function<KeyValue(Time)> at);

// Returns the times of a jump in a file, in seconds since the beginning: the last moment before it, and the moment at
// which it is over. Floats, if the options ask for them; the second one is never after the jump.
std::pair<Time, Time> around_jump(Time jump, Time beginning, Time step, const KeyOptions&);

// Returns the times between two, each once, in order, and these two.
std::vector<Time> knots_between(std::vector<Time> all, Time from, Time until);
// Adds the times at which pieces begin.
void add_knots(const Channel&, std::vector<Time>& to);

// Fits the function. `knots`: the possible jumps and corners, in order, with the beginning and the end. Other jumps are
// found if they last for a step.
Channel follow(const Followed&, std::span<const Time> knots, const KeyOptions&);

}  // namespace betwixt
