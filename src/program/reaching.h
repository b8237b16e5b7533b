// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Chains that reach for a place: joints that turn so that the end of the last bone comes there.
#pragma once

#include <optional>
#include <vector>

#include "betwixt/math.h"

namespace betwixt {

struct Reach {
  Vec3 goal;
  std::optional<Vec3> pole;  // where the middle of the chain points to; none: where it points already
  double share = 1;          // of the straight way of the end to the goal
  Vec3 bend;                 // where a straight chain bends to
};

// The turn of a shortest way from one direction to another.
Quat shortest_turn(Vec3 from, Vec3 to);
// The places of the joints and of the end, the first of which stays; bones keep their lengths. Where the goal is too
// far or too near, the end is as near to it as can be. Two bones in closed form; more by FABRIK (Aristidou and Lasenby
// 2011) from where they are, and the rest of the way in closed form, or by halving.
std::vector<Vec3> reached(std::vector<Vec3> chain, const Reach&);

}  // namespace betwixt
