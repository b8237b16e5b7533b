// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Inverse kinematics: turns the joints of a chain so that the end of the last bone reaches a goal.
#pragma once

#include <optional>
#include <vector>

#include "betwixt/math.h"

namespace betwixt {

struct IkGoal {
  Vec3 goal;
  std::optional<Vec3> pole;  // direction of the chain's bend; nullopt to keep it
  double share = 1;          // fraction of the straight path from the end to the goal
  Vec3 bend;                 // direction in which a straight chain bends
};

// Returns the shortest rotation from one direction to another.
Quat shortest_turn(Vec3 from, Vec3 to);
// Returns the positions of the joints and of the end. The first stays, and bones keep their lengths. If the goal is out
// of reach, the end comes as near as possible. Two bones have a closed form. More bones start from their present pose
// with FABRIK (Aristidou and Lasenby 2011), then a closed form or bisection finishes.
std::vector<Vec3> solve_ik(std::vector<Vec3> chain, const IkGoal&);

}  // namespace betwixt
