// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What an object meets during one step of its path: its own body, its obstacles, and what carries it. Evaluated at both
// ends of the step; in between, bodies move in straight lines.
#pragma once

#include <array>
#include <vector>

#include "program/bodies.h"
#include "program/placing.h"

namespace betwixt {

// The values of the function `collision`.
enum class CollisionLaw : std::uint8_t { stop, slide, bounce, mirror };

struct CollisionStep {
  static constexpr Time length{flicks_per_second / 240};

  struct Obstacle {
    Body ends[2];
    bool moves = false;
  };
  Time from, until;
  Carrier carriers[2];
  bool carried_still = false;  // the carriers of both ends are the same
  Body own[2];                 // relative to the object's place
  bool turns = true;           // the object turns or grows
  std::vector<Obstacle> obstacles;
  CollisionLaw law = CollisionLaw::stop;
  double kept = 1;  // the bounciness

  double share(std::int64_t flicks) const {
    return static_cast<double>(flicks - from.flicks) / static_cast<double>(length.flicks);
  }
  // Returns the place in the world of an object at this position.
  Vec3 in_world(Vec3 position, std::int64_t flicks) const;
  // Returns the gap between the object at a place in the world and one of its obstacles.
  Clearance gap(std::size_t obstacle, Vec3 place, std::int64_t flicks) const;
  // Returns how far the two surfaces move because the bodies turn or grow.
  double turning(std::size_t obstacle) const;
  // Returns the velocity of an obstacle's middle.
  Vec3 velocity_of(std::size_t obstacle) const;
};

// Evaluates the step of a live value's object that begins at `from`.
CollisionStep collision_step(const Program::Compiled&, const Live&, Time from, Asking&);

}  // namespace betwixt
