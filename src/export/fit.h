// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pieces that follow a function of time: as few as a tolerance allows.
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
  Time step;  // looked at that often at least, so that nothing passes between two looks
};
// Half a frame, and half of what may be off: the rest is for what adds up.
Followed followed(const Document&, std::size_t width, double tolerance, std::function<KeyValue(Time)> at);

// Where a jump at a time lies in a file, in seconds since the beginning: the last moment before it and the one from
// which on it is over. Floats, where options ask for them, the second one never after the jump.
std::pair<Time, Time> around_jump(Time jump, Time beginning, Time step, const KeyOptions&);

// Each once, in order, between two times, and these.
std::vector<Time> knots_between(std::vector<Time> all, Time from, Time until);
// Where channels begin something new.
void add_knots(const Channel&, std::vector<Time>& to);

// `knots`: in order, from the beginning to the end, both included: where it may jump or have a corner. Other jumps are
// found, if they last for a step.
Channel follow(const Followed&, std::span<const Time> knots, const KeyOptions&);

}  // namespace betwixt
