// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The path of a fall by the laws of cartoons: the object keeps its speed during the delay, then drops, and bounces.
#pragma once

#include <vector>

#include "betwixt/time.h"
#include "betwixt/value.h"

namespace betwixt {

struct FallLaws {
  Time delay, length{10 * flicks_per_second};
  double gravity = 9.81, ground = 0, bounce = 0;
};

// The object's place at a time, and its speed just before and after.
struct FallMark {
  Time time;
  Vec3 place, in, out;
};

// Returns the events from bounce to bounce, in the world. Along the ground the speed is constant.
std::vector<FallMark> fall_path(Time start, Vec3 place, Vec3 speed, const FallLaws&);

}  // namespace betwixt
